// Tests pictures of every format, read by the sandboxed reader.
#include "import/trusted/ReadPictures.h"
#include "base/ColourNote.h"
#include "base/Error.h"
#include "base/Png.h"
#include "base/WideGamut.h"

#include <QBuffer>
#include <QImageWriter>
#include <QTemporaryDir>
#include <QtEndian>
#include <QtTest>
#include <zlib.h>

using namespace dipwright;

namespace {

// Returns a smooth gradient, so that lossy formats lose little. Its corners differ.
QImage slope() {
    QImage picture(48, 40, QImage::Format_RGBA8888);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            picture.setPixelColor(x, y, QColor(40 + 4 * x, 30 + 5 * y, 90));
        }
    }
    return picture;
}

// Returns the largest difference of any channel, 0 … 255.
int difference(const QImage& a, const QImage& b) {
    int largest = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int i = 0; i < 4 * a.width(); ++i) {
            largest = std::max(largest, std::abs(a.constScanLine(y)[i] - b.constScanLine(y)[i]));
        }
    }
    return largest;
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class ReadPicturesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void readPictureFile_everyFormat_isRead_data() { formats(); }
    void readPictureFile_everyFormat_isRead();
    void readPictureFile_truncated_isRefusedOrPartlyRead_data() { formats(); }
    void readPictureFile_truncated_isRefusedOrPartlyRead();
    void readPictureFile_turnedByExif_isTold();
    void readPictureFile_unreadColourSpace_isTold();
    void readPictures_pixelLimit_appliesToAllTogether();
    void pictureCount_widePictures_countTwice();

private:
    static void formats();
    QString written(const QString& format) const;

    QTemporaryDir folder_;
};

void ReadPicturesTest::formats() {
    QTest::addColumn<QString>("format");
    QTest::addColumn<int>("loss");
    QTest::newRow("PNG") << "png" << 0;
    QTest::newRow("BMP") << "bmp" << 0;
    QTest::newRow("TIFF") << "tiff" << 0;
    QTest::newRow("JPEG") << "jpg" << 4;
    QTest::newRow("WebP") << "webp" << 8;
}

QString ReadPicturesTest::written(const QString& format) const {
    QString path = folder_.filePath(QStringLiteral("slope.") + format);
    QImageWriter writer(path);
    writer.setQuality(100);
    return writer.write(slope().convertToFormat(QImage::Format_RGB32)) ? path : QString();
}

void ReadPicturesTest::readPictureFile_everyFormat_isRead() {
    QFETCH(QString, format);
    QFETCH(int, loss);
    const QString path = written(format);
    QVERIFY(!path.isEmpty());
    const QImage read = readPictureFile(path);
    QCOMPARE(read.format(), QImage::Format_RGBA8888);
    QCOMPARE(read.size(), slope().size());
    const int differs = difference(read, slope());
    QVERIFY2(differs <= loss,
             qPrintable(QStringLiteral("channels differ by %1 of 255, expected %2 or less")
                            .arg(differs)
                            .arg(loss)));
}

// A truncated file gives an error with its name, or the part of the picture that it contains. It
// never crashes the program.
void ReadPicturesTest::readPictureFile_truncated_isRefusedOrPartlyRead() {
    QFETCH(QString, format);
    const QByteArray whole = contents(written(format));
    QVERIFY(!whole.isEmpty());
    const QString path = folder_.filePath(QStringLiteral("cut.") + format);
    int refused = 0;
    for (const qsizetype length : {qsizetype(0), qsizetype(1), qsizetype(20), whole.size() / 4,
                                   whole.size() / 2, whole.size() - 1}) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(whole.first(length));
        file.close();
        try {
            QCOMPARE(readPictureFile(path).size(), slope().size());
        } catch (const Error& error) {
            QVERIFY2(error.sentence().contains(QStringLiteral("cut.") + format),
                     qPrintable(error.sentence()));
            ++refused;
        }
    }
    QVERIFY(refused >= 3);
}

// The pixels stay as they are stored, but the picture tells that a viewer would turn them.
void ReadPicturesTest::readPictureFile_turnedByExif_isTold() {
    const QByteArray plain = contents(written(QStringLiteral("jpg")));
    for (const char orientation : {'\1', '\6'}) { // upright; to be turned by 90°
        QByteArray exif("\xff\xe1\0\x22"
                        "Exif\0\0MM\0\x2a\0\0\0\x08"
                        "\0\1\1\x12\0\3\0\0\0\1\0?\0\0\0\0\0\0",
                        36);
        exif[29] = orientation;
        QFile file(folder_.filePath("exif.jpg"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray(plain).insert(2, exif)); // after the marker of the start
        file.close();
        const QImage read = readPictureFile(file.fileName());
        QCOMPARE(read.size(), slope().size());
        QCOMPARE(colourNoteText(read, "logo.jpg").startsWith("logo.jpg is to be shown turned"),
                 orientation != '\1');
    }
}

void ReadPicturesTest::readPictureFile_unreadColourSpace_isTold() {
    const auto read = [&](const QByteArray& primariesAndTransfer) {
        QByteArray chunk = "cICP" + primariesAndTransfer + QByteArray("\0\1", 2), file;
        const auto number = [](quint32 value) {
            QByteArray bytes(4, '\0');
            qToBigEndian(value, bytes.data());
            return bytes;
        };
        chunk = number(4) + chunk +
                number(quint32(crc32(0, reinterpret_cast<const Bytef*>(chunk.constData()),
                                     uInt(chunk.size()))));
        QBuffer buffer(&file);
        buffer.open(QIODevice::WriteOnly);
        slope().save(&buffer, "png");
        QFile png(folder_.filePath("cicp.png"));
        png.open(QIODevice::WriteOnly);
        constexpr int signatureAndHeader = 33; // bytes
        png.write(file.insert(signatureAndHeader, chunk));
        png.close();
        return colourNoteText(readPictureFile(png.fileName()), "flag.png");
    };
    QVERIFY(read("\x0c\x0d").startsWith("flag.png names its colour space in a cICP chunk")); // P3
    QCOMPARE(read("\x01\x0d"), QString());                                                   // sRGB
}

void ReadPicturesTest::readPictures_pixelLimit_appliesToAllTogether() {
    QImage plain(5000, 5000, QImage::Format_Mono);
    plain.fill(1);
    const PackedPicture packed{pngBytes(plain.convertToFormat(QImage::Format_RGBA8888), {}),
                               QStringLiteral("plain.png")};
    QCOMPARE(readPictures({packed, packed}).size(), std::size_t(2));
    QVERIFY_EXCEPTION_THROWN(readPictures({packed, packed, packed}), Error);
}

void ReadPicturesTest::pictureCount_widePictures_countTwice() {
    const auto countFour = [](const QImage& picture) {
        PictureCount count;
        for (int i = 0; i < 4; ++i) { // the pixel limit is four such pictures
            count.add(picture, 0, {});
        }
    };
    QImage picture(4096, 4096, QImage::Format_RGBA8888);
    countFour(picture);
    picture = QImage(4096, 4096, QImage::Format_RGBA64);
    picture.setColorSpace(wideSpace());
    QVERIFY(isWide(picture));
    QVERIFY_EXCEPTION_THROWN(countFour(picture), Error);
}

QTEST_GUILESS_MAIN(ReadPicturesTest)
#include "ReadPicturesTest.moc"
