// Tests pictures of every format, read by the sandboxed reader.
#include "import/trusted/ReadPictures.h"
#include "base/ColourNote.h"
#include "base/Error.h"
#include "base/Png.h"
#include "base/WideGamut.h"
#include "import/trusted/ReadPhotos.h"

#include <QImageReader>
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

QByteArray bigEndian(quint32 number) {
    QByteArray bytes(4, '\0');
    qToBigEndian(number, bytes.data());
    return bytes;
}

constexpr int pngHeader = 33, pngEnd = 12; // bytes before the second and of the last chunk

QByteArray pngChunk(const QByteArray& kindAndData) {
    const auto sum =
        crc32(0, reinterpret_cast<const Bytef*>(kindAndData.constData()), uInt(kindAndData.size()));
    return bigEndian(quint32(kindAndData.size() - 4)) + kindAndData + bigEndian(quint32(sum));
}

// Returns EXIF data with an orientation and the time at which a photo was taken.
QByteArray exif(char orientation) {
    const QByteArray turn("\1\x12\0\3\0\0\0\1\0?\0\0", 12);
    return QByteArray("MM\0\x2a\0\0\0\x08\0\2", 10) + QByteArray(turn).replace('?', orientation) +
           QByteArray("\x87\x69\0\4\0\0\0\1\0\0\0\x26\0\0\0\0", 16) +
           QByteArray("\0\1\x90\3\0\2\0\0\0\x14\0\0\0\x38\0\0\0\0", 18) +
           QByteArray("2026:11:22 14:03:07\0", 20);
}

QByteArray withExif(QByteArray file, const QString& format, char orientation) {
    const QByteArray data = exif(orientation);
    if (format == QStringLiteral("jpg")) {
        const QByteArray segment = QByteArray("Exif\0\0", 6) + data;
        return file.insert(2, "\xff\xe1" + bigEndian(quint32(segment.size() + 2)).mid(2) + segment);
    }
    if (format == QStringLiteral("png")) { // programs write it on either side of the pixels
        return file.insert(orientation % 2 ? pngHeader : file.size() - pngEnd,
                           pngChunk("eXIf" + data));
    }
    const auto chunk = [](const char* kind, const QByteArray& content) {
        QByteArray length(4, '\0');
        qToLittleEndian(quint32(content.size()), length.data());
        return kind + length + content;
    };
    const QByteArray sides("\x2f\0\0\x27\0\0", 6); // width and height, each minus one
    return chunk("RIFF", "WEBP" + chunk("VP8X", QByteArray("\x08\0\0\0", 4) + sides) +
                             file.mid(12) + chunk("EXIF", data));
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
    void readPhotoFile_exif_isFollowed();
    void readPictureFile_unreadColourSpace_isTold();
    void readPictures_pixelLimit_appliesToAllTogether();
    void pictureCount_widePictures_countTwice();

private:
    static void formats();
    QString written(const QString& format) const;
    QString saved(const QByteArray& bytes, const QString& format) const;

    const QStringList withExifHere{QStringLiteral("jpg"), QStringLiteral("png"),
                                   QStringLiteral("webp")};

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

QString ReadPicturesTest::saved(const QByteArray& bytes, const QString& format) const {
    QFile file(folder_.filePath(QStringLiteral("other.") + format));
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() ? file.fileName()
                                                                                : QString();
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
    for (const QString& format : withExifHere) {
        const QByteArray plain = contents(written(format));
        for (const char orientation : {'\1', '\6'}) { // upright; to be turned by 90°
            const QImage read =
                readPictureFile(saved(withExif(plain, format, orientation), format));
            QCOMPARE(read.size(), slope().size());
            QCOMPARE(colourNoteText(read, "logo").startsWith("logo is to be shown turned"),
                     orientation != '\1');
        }
    }
}

void ReadPicturesTest::readPhotoFile_exif_isFollowed() {
    for (const QString& format : withExifHere) {
        const QByteArray plain = contents(written(format));
        for (char orientation = 1; orientation <= 8; ++orientation) {
            const QString path = saved(withExif(plain, format, orientation), format);
            const Photo photo = readPhotoFile(path, {});
            QCOMPARE(photo.taken, QDateTime(QDate(2026, 11, 22), QTime(14, 3, 7)));
            // Qt itself turns JPEG.
            QImageReader jpeg(
                saved(withExif(contents(written("jpg")), QStringLiteral("jpg"), orientation),
                      QStringLiteral("jpg")));
            jpeg.setAutoTransform(true);
            const QImage expected = jpeg.read().convertToFormat(QImage::Format_RGBA8888);
            QCOMPARE(photo.picture.size(), expected.size());
            QVERIFY(difference(photo.picture, expected) <= 10);
        }
    }
}

void ReadPicturesTest::readPictureFile_unreadColourSpace_isTold() {
    const auto read = [&](const QByteArray& primariesAndTransfer) {
        const QByteArray plain = contents(written(QStringLiteral("png")));
        const QByteArray chunk = pngChunk("cICP" + primariesAndTransfer + QByteArray("\0\1", 2));
        const QString png =
            saved(QByteArray(plain).insert(pngHeader, chunk), QStringLiteral("png"));
        return colourNoteText(readPictureFile(png), "flag.png");
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
