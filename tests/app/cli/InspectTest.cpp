// Tests `inspect film` and `inspect part` through the command line, with JPEG photos like those of
// a camera.
#include "CliProcess.h"
#include "TankPhoto.h"
#include "TestFiles.h"

#include <QBuffer>
#include <QImage>
#include <QImageReader>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <tiffio.h>

using namespace dipwright::test;

namespace {

const GrowingFilm film;

QByteArray number(quint32 value, int bytes) {
    QByteArray text;
    for (int i = 0; i < bytes; ++i) {
        text.append(char(value >> (8 * i)));
    }
    return text;
}

QByteArray entry(quint16 tag, quint16 type, quint32 count, quint32 value) {
    return number(tag, 2) + number(type, 2) + number(count, 4) + number(value, 4);
}

// Returns a JPEG with the tags of a camera: orientation, time and focal length. If the orientation
// is not 1, a fill byte and a comment precede the tags. In that case libexif does not find the
// tags.
QByteArray cameraFile(const QImage& picture, int orientation, const QByteArray& taken) {
    QByteArray tags = "II" + number(42, 2) + number(8, 4);
    tags += number(2, 2) + entry(0x0112, 3, 1, quint32(orientation)) + entry(0x8769, 4, 1, 38) +
            number(0, 4);
    tags += number(2, 2) + entry(0x9003, 2, 20, 68) + entry(0xa405, 3, 1, 32) + number(0, 4);
    tags += taken.leftJustified(20, '\0');
    const QByteArray segment = QByteArray("Exif\0\0", 6) + tags;
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    picture.save(&buffer, "JPEG", 85);
    const auto length = quint16(segment.size() + 2);
    const QByteArray comment("\xff\xff\xfe\0\7words", 10);
    return buffer.data().left(2) + (orientation == 1 ? QByteArray() : comment) + "\xff\xe1" +
           char(length >> 8) + char(length & 255) + segment + buffer.data().mid(2);
}

// Writes a TIFF as a raster image processor does, in cyan, magenta, yellow and black.
void writeCmykTiff(const QImage& picture, const QString& path) {
    TIFF* file = TIFFOpen(qPrintable(path), "w");
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, picture.width());
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, picture.height());
    TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 4);
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_SEPARATED);
    TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(file, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
    for (int y = 0; y < picture.height(); ++y) {
        QByteArray line(4 * picture.width(), '\0');
        for (int x = 0; x < picture.width(); ++x) {
            line[4 * x + 3] = char(255 - qGray(picture.pixel(x, y)));
        }
        TIFFWriteScanline(file, line.data(), quint32(y));
    }
    TIFFClose(file);
}

} // namespace

class InspectTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(folder_.isValid());
        qputenv("DIPWRIGHT_PROFILE_PATH", path("profiles").toLocal8Bit());
        for (const int seconds : times_) {
            const QImage picture = tankPhoto(film, seconds, 0);
            // The second photo is stored mirrored, with the matching orientation tag.
            const bool isFlipped = seconds == times_[1];
            const QByteArray taken = QTime(14, 0).addSecs(seconds).toString("hh:mm:ss").toLatin1();
            writeFile(path(photoName(seconds)),
                      cameraFile(isFlipped ? picture.mirrored(true, false) : picture,
                                 isFlipped ? 2 : 1, "2026:11:22 " + taken));
            photos_ << path(photoName(seconds));
        }
    }

    void calibrate_filmAndCardPages_areWritten() {
        for (const char* page : {"film", "card"}) {
            const QString name = path(QString::fromLatin1(page));
            QCOMPARE(cli({"calibrate", page, "--to", name + ".pdf"}).exitCode, 0);
            QCOMPARE(cli({"calibrate", page, "--to", name + ".png", "--paper", "A4"}).exitCode, 0);
            QVERIFY(bytesOf(name + ".pdf").startsWith("%PDF"));
            QCOMPARE(QImageReader(name + ".png").size(), QSize(4961, 7016));
        }
        const Outcome small = cli({"calibrate", "film", "--to", path("s.pdf"), "--paper", "A5"});
        QCOMPARE(small.exitCode, 1);
        QCOMPARE(small.errorLines().size(), 1);
    }

    void inspectFilm_cameraTimes_measuresSwellAndGrowth() {
        QStringList arguments{"inspect", "film"};
        arguments << photos_ << "--out" << path("out") << "--laid"
                  << "2026-11-22T14:00:00"
                  << "--profile"
                  << "Measured film"
                  << "--lot"
                  << "L7"
                  << "--water-temperature"
                  << "28";
        const Outcome outcome = cli(arguments);
        QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
        qInfo("%s", outcome.out.constData());
        const QJsonObject found =
            QJsonDocument::fromJson(bytesOf(path("out/film-watch.json"))).object();
        const auto value = [&](const char* key, int part) {
            return found.value(QLatin1String(key)).toArray().at(part).toDouble();
        };
        QCOMPARE(found.value("date").toString(), QStringLiteral("2026-11-22"));
        QVERIFY(std::abs(value("swell", 0) / film.swellX - 1) < 0.001);
        QVERIFY(std::abs(value("swell", 1) / film.swellY - 1) < 0.001);
        QVERIFY(std::abs(value("growth_per_s", 0) / film.rate - 1) < 0.05);
        QVERIFY(std::abs(value("growth_limit", 0) / film.limit - 1) < 0.05);
        QVERIFY(!QImage(path("out/unevenness.png")).isNull());
        QVERIFY(bytesOf(path("out/unevenness.csv")).count('\n') > 300);
        if (qEnvironmentVariableIsSet("DIPWRIGHT_PICTURES")) {
            const QString pictures = qEnvironmentVariable("DIPWRIGHT_PICTURES") + "/";
            QFile::copy(path("out/unevenness.png"), pictures + "unevenness.png");
            QFile::copy(photos_.first(), pictures + "tank.jpg");
        }
        const QByteArray profile = cli({"profile", "show", "film", "Measured film"}).out;
        QVERIFY2(profile.contains("\"swell_off\""), profile.constData());
        QVERIFY(profile.contains("L7"));
    }

    // A copy of a photo would look like film that does not grow.
    void inspectFilm_samePhotoTwice_isRefused() {
        const QString copy = path("copy.jpg");
        QVERIFY(QFile::copy(photos_.first(), copy));
        const Outcome outcome = cli({"inspect", "film", photos_.first(), copy, "--out",
                                     path("none"), "--time", "30", "--time", "60"});
        QCOMPARE(outcome.exitCode, 1);
        QCOMPARE(outcome.errorLines().size(), 1);
        QVERIFY2(outcome.err.contains("give each photo only once"), outcome.err.constData());
        QVERIFY(!QFileInfo::exists(path("none")));
    }

    void inspectFilm_noClearTimes_isRefused() {
        for (const QStringList& times :
             {QStringList(),
              QStringList{"--laid", "2026-11-22T14:00:00+05:00"}, // cameras state no zone
              QStringList{"--laid", "2026-11-22T14:00:00", "--time", "3"}}) {
            const Outcome outcome = cli(QStringList{"inspect", "film"} + photos_ + times +
                                        QStringList{"--out", path("none")});
            QCOMPARE(outcome.exitCode, 2);
            QVERIFY(!QFileInfo::exists(path("none")));
        }
    }

    void inspectFilm_badPhoto_isRefusedInOneSentence_data() {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("cut off") << bytesOf(photos_.first()).left(4000);
        QTest::newRow("no picture") << QByteArray("once upon a time");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("HEIF") << QByteArray::fromHex("0000001866747970686569630000000068656963") +
                                     QByteArray(200, 'x');
        QTest::newRow("no board") << encoded(QImage(800, 600, QImage::Format_Grayscale8), "PNG");
        QImage vast(12'000, 9'000, QImage::Format_Grayscale8);
        vast.fill(128);
        QTest::newRow("100 megapixels") << encoded(vast, "JPEG");
        const QImage whole(photos_.first());
        QTest::newRow("half a board") << encoded(
            whole.copy(whole.width() * 2 / 5, 0, whole.width() * 3 / 5, whole.height()), "PNG");
        QTest::newRow("mirrored") << encoded(QImage(photos_.first()).mirrored(true, false), "PNG");
    }

    void inspectFilm_badPhoto_isRefusedInOneSentence() {
        QFETCH(QByteArray, bytes);
        writeFile(path("bad.jpg"), bytes);
        const Outcome outcome = cli({"inspect", "film", path("bad.jpg"), "--out", path("bad-out"),
                                     "--profile", "Never written"});
        qInfo("%s", outcome.err.constData());
        QCOMPARE(outcome.exitCode, 1);
        QCOMPARE(outcome.errorLines().size(), 1);
        QVERIFY(!QFileInfo::exists(path("bad-out")));
        QVERIFY(!cli({"profile", "list"}).out.contains("Never written"));
    }

    // The photo shows places on a ball. The camera has a focal length of 1000 pixels and is 300 mm
    // away.
    void inspectPart_pairsTable_reportsFigures() {
        QByteArray table("photo,x_px,y_px,x_mm,y_mm,z_mm\n");
        for (int i = 0; i < 16; ++i) {
            const double up = -60 + 8 * i, around = 2.4 * i;
            const double x = std::cos(around) * std::cos(up / 57.3) * 35;
            const double y = std::sin(up / 57.3) * 35;
            const double z = std::sin(around) * std::cos(up / 57.3) * 35;
            const double off = i % 2 == 0 ? 1 : -1; // pixels of error
            table += "1," + QByteArray::number(800 + 1000 * x / (z + 300) + off) + "," +
                     QByteArray::number(600 + 1000 * y / (z + 300) - off) + "," +
                     QByteArray::number(x) + "," + QByteArray::number(y) + "," +
                     QByteArray::number(z) + "\n";
        }
        writeFile(path("pairs.csv"), table);
        // For a photo that cannot be read, the program prints one sentence and writes nothing.
        QImage vast(12'000, 9'000, QImage::Format_Grayscale8);
        vast.fill(128);
        for (const QByteArray& bytes :
             {bytesOf(photos_.first()).left(4000), QByteArray("once upon a time"), QByteArray(),
              encoded(vast, "JPEG")}) {
            writeFile(path("bad-part.jpg"), bytes);
            const Outcome bad = cli({"inspect", "part", path("bad-part.jpg"), "--pairs",
                                     path("pairs.csv"), "--out", path("part")});
            qInfo("%s", bad.err.constData());
            QCOMPARE(bad.exitCode, 1);
            QCOMPARE(bad.errorLines().size(), 1);
            QVERIFY(!QFileInfo::exists(path("part")));
        }
        // Photos with 16 bits and CMYK photos are read.
        writeFile(path("deep-part.png"),
                  encoded(QImage(photos_.first()).convertToFormat(QImage::Format_RGBX64), "PNG"));
        writeCmykTiff(QImage(photos_.first()), path("cmyk-part.tiff"));
        for (const char* photo : {"deep-part.png", "cmyk-part.tiff"}) {
            QCOMPARE(cli({"inspect", "part", path(QString::fromLatin1(photo)), "--pairs",
                          path("pairs.csv"), "--out", path("other-part")})
                         .exitCode,
                     0);
        }
        const QStringList arguments{"inspect", "part", photos_.first(), "--out", path("part")};
        QCOMPARE(cli(arguments).exitCode, 2); // the table of pairs is missing
        const Outcome outcome = cli(arguments + QStringList{"--pairs", path("pairs.csv")});
        QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
        qInfo("%s", outcome.out.constData());
        const QJsonObject figures = QJsonDocument::fromJson(bytesOf(path("part/part-view.json")))
                                        .object()
                                        .value("figures")
                                        .toObject();
        QCOMPARE(figures.value("count").toInt(), 16);
        QVERIFY(figures.value("mean_px").toDouble() < std::sqrt(2.0));
        QCOMPARE(QImage(path("part/part-photo-1.png")).size(), QSize(1600, 1200));
        QCOMPARE(bytesOf(path("part/part-pairs.csv")).count('\n'), 17);
    }

    void inspectFilm_16BitPhoto_isRead() {
        writeFile(path("deep.png"),
                  encoded(QImage(photos_.first()).convertToFormat(QImage::Format_RGBX64), "PNG"));
        const Outcome outcome = cli({"inspect", "film", path("deep.png"), "--out", path("deep")});
        QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    }

    void inspectFilm_cmykPhoto_isRead() {
        writeCmykTiff(QImage(photos_.first()), path("cmyk.tiff"));
        const Outcome outcome = cli({"inspect", "film", path("cmyk.tiff"), "--out", path("cmyk")});
        QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    }

private:
    static QByteArray encoded(const QImage& picture, const char* format) {
        QBuffer buffer;
        buffer.open(QIODevice::WriteOnly);
        picture.save(&buffer, format);
        return buffer.data();
    }
    static QString photoName(int seconds) { return QStringLiteral("photo-%1.jpg").arg(seconds); }
    QString path(const QString& name) const { return folder_.filePath(name); }

    const QList<int> times_{40, 70, 110, 190};
    QStringList photos_;
    QTemporaryDir folder_;
};

QTEST_MAIN(InspectTest)
#include "InspectTest.moc"
