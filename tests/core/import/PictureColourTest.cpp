// Tests textures in every colour space. The colours sent to a printer must equal those that lcms2
// computes directly from the texture's profile.
#include "TestProfiles.h"

#include "base/ColourNote.h"
#include "base/Error.h"
#include "base/Png.h"
#include "base/WideGamut.h"
#include "import/trusted/ReadPhotos.h"
#include "import/trusted/ReadPictures.h"
#include "sheet/prepress/PrinterColour.h"

#include <QBuffer>
#include <QColorSpace>
#include <QImageReader>
#include <QTemporaryDir>
#include <QtEndian>
#include <QtTest>

#include <cstdio>
#include <jpeglib.h>
#include <lcms2.h>
#include <tiffio.h>
#include <zlib.h>

using namespace dipwright;

namespace {

// Patches in rows of eight. JPEG's compression does not mix patches of this size.
constexpr int side = 16;
constexpr int patches = 64;
using Device = std::array<uchar, 4>; // uses only as many channels as the colour space has

enum class Kind { Grey = 1, Rgb = 3, Cmyk = 4 };

Device patch(Kind kind, int number) {
    const int a = number % 4;
    const int b = number / 4 % 4;
    const int c = number / 16;
    switch (kind) {
    case Kind::Grey:
        return {uchar(4 * number), 0, 0, 0};
    case Kind::Rgb:
        return {uchar(60 + 50 * a), uchar(60 + 50 * b), uchar(60 + 50 * c), 0};
    case Kind::Cmyk:
        break;
    }
    return {uchar(60 * a), uchar(60 * b), uchar(60 * c), uchar(20 * a)};
}

QByteArray greyProfile() {
    cmsToneCurve* curve = cmsBuildGamma(nullptr, 2.2); // near sRGB's curve, but different
    cmsHPROFILE profile = cmsCreateGrayProfile(cmsD50_xyY(), curve);
    cmsFreeToneCurve(curve);
    cmsUInt32Number size = 0;
    cmsSaveProfileToMem(profile, nullptr, &size);
    QByteArray bytes(qsizetype(size), '\0');
    cmsSaveProfileToMem(profile, bytes.data(), &size);
    cmsCloseProfile(profile);
    return bytes;
}

QByteArray profileOf(Kind kind) {
    return kind == Kind::Grey  ? greyProfile()
           : kind == Kind::Rgb ? QColorSpace(QColorSpace::AdobeRgb).iccProfile()
                               : simpleCmykProfile(0.02);
}

QByteArray pixels(Kind kind) {
    QByteArray bytes;
    for (int y = 0; y < 8 * side; ++y) {
        for (int x = 0; x < 8 * side; ++x) {
            const Device device = patch(kind, y / side * 8 + x / side);
            bytes.append(reinterpret_cast<const char*>(device.data()), int(kind));
        }
    }
    return bytes;
}

QImage image(Kind kind, const QByteArray& bytes) {
    return QImage(reinterpret_cast<const uchar*>(bytes.constData()), 8 * side, 8 * side,
                  8 * side * int(kind),
                  kind == Kind::Grey ? QImage::Format_Grayscale8 : QImage::Format_RGB888)
        .copy();
}

QByteArray bigEndian(quint32 number) {
    QByteArray bytes(4, '\0');
    qToBigEndian(number, bytes.data());
    return bytes;
}

// Returns an iCCP chunk. `packed` is the compressed profile, which follows the chunk's name and
// method.
QByteArray profileChunk(const QByteArray& packed) {
    const QByteArray chunk = QByteArray("iCCPown\0\0", 9) + packed;
    const auto sum =
        crc32(0, reinterpret_cast<const uchar*>(chunk.constData()), uInt(chunk.size()));
    return bigEndian(quint32(chunk.size() - 4)) + chunk + bigEndian(quint32(sum));
}

QByteArray pngWith(Kind kind, const QByteArray& packed) {
    QBuffer png;
    image(kind, pixels(kind)).save(&png, "png");
    constexpr int header = 8 + 25; // signature and IHDR
    return QByteArray(png.data()).insert(header, profileChunk(packed));
}

QByteArray packed(const QByteArray& profile) {
    return qCompress(profile).mid(4); // qCompress() puts a length first
}

QByteArray pngFile(Kind kind, const QByteArray& profile) {
    return pngWith(kind, packed(profile));
}

// Returns a JPEG file with the profile in parts of `most` bytes. Part `without`, counted from 1, is
// left out; 0 leaves out none.
QByteArray jpegFile(Kind kind, const QByteArray& profile, int most = 65000, int without = 0) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* memory = nullptr;
    unsigned long length = 0;
    jpeg_mem_dest(&jpeg, &memory, &length);
    jpeg.image_width = jpeg.image_height = 8 * side;
    jpeg.input_components = int(kind);
    jpeg.in_color_space = kind == Kind::Grey  ? JCS_GRAYSCALE
                          : kind == Kind::Rgb ? JCS_RGB
                                              : JCS_CMYK;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 100, TRUE);
    if (kind == Kind::Cmyk) {
        jpeg_set_colorspace(&jpeg, JCS_YCCK); // as Photoshop does, with its marker
    }
    jpeg_start_compress(&jpeg, TRUE);
    const int parts = int((profile.size() + most - 1) / most);
    for (int part = 0; part < parts; ++part) {
        if (part + 1 == without) {
            continue;
        }
        const QByteArray marker = QByteArray("ICC_PROFILE\0", 12) + char(part + 1) + char(parts) +
                                  profile.mid(part * most, most);
        jpeg_write_marker(&jpeg, JPEG_APP0 + 2, reinterpret_cast<const uchar*>(marker.constData()),
                          uint(marker.size()));
    }
    QByteArray bytes = pixels(kind);
    for (char& value : bytes) {
        value =
            kind == Kind::Cmyk ? char(255 - uchar(value)) : value; // inverted, as Photoshop does
    }
    while (jpeg.next_scanline < jpeg.image_height) {
        auto* row = reinterpret_cast<uchar*>(bytes.data()) +
                    jpeg.next_scanline * jpeg.image_width * uint(kind);
        jpeg_write_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_compress(&jpeg);
    const QByteArray file(reinterpret_cast<const char*>(memory), qsizetype(length));
    jpeg_destroy_compress(&jpeg);
    std::free(memory);
    return file;
}

QByteArray tiffFile(Kind kind, const QByteArray& profile, const QString& path, int bits) {
    TIFF* tiff = TIFFOpen(qPrintable(path), "w");
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 8 * side);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 8 * side);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, int(kind));
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC,
                 kind == Kind::Grey  ? PHOTOMETRIC_MINISBLACK
                 : kind == Kind::Rgb ? PHOTOMETRIC_RGB
                                     : PHOTOMETRIC_SEPARATED);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
    if (!profile.isEmpty()) {
        TIFFSetField(tiff, TIFFTAG_ICCPROFILE, std::uint32_t(profile.size()), profile.constData());
    }
    const QByteArray bytes = pixels(kind);
    const int row = 8 * side * int(kind);
    for (int y = 0; y < 8 * side; ++y) {
        std::vector<quint16> words;
        for (const char value : bytes.mid(y * row, row)) {
            words.push_back(bits == 16 ? quint16(uchar(value) * 257) : quint16(uchar(value)));
        }
        std::vector<uchar> octets(words.begin(), words.end());
        TIFFWriteScanline(
            tiff, bits == 16 ? static_cast<void*>(words.data()) : static_cast<void*>(octets.data()),
            std::uint32_t(y));
    }
    TIFFClose(tiff);
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// Returns a picture of one colour with this profile.
QByteArray webpFile(const QColor& colour, const QByteArray& profile) {
    QImage picture(8, 8, QImage::Format_RGB32);
    picture.fill(colour);
    QBuffer plain;
    picture.save(&plain, "webp", 100); // lossless
    const auto littleEndian = [](qsizetype number) {
        QByteArray bytes(4, '\0');
        qToLittleEndian(quint32(number), bytes.data());
        return bytes;
    };
    const auto chunk = [&](const char* kind, const QByteArray& content) {
        return kind + littleEndian(content.size()) + content + QByteArray(content.size() % 2, '\0');
    };
    const QByteArray sides("\7\0\0\7\0\0", 6); // width and height, each minus one
    const QByteArray chunks = chunk("VP8X", QByteArray("\x20\0\0\0", 4) + sides) +
                              chunk("ICCP", profile) + plain.data().mid(12);
    return "RIFF" + littleEndian(chunks.size() + 4) + "WEBP" + chunks;
}

QByteArray fileOf(const QImage& picture, const char* format) {
    QBuffer file;
    picture.save(&file, format);
    return file.data();
}

// Returns the error's sentence if reading fails, otherwise an empty text.
QString refusal(const QByteArray& file) {
    try {
        readPictures({{file, QStringLiteral("odd picture")}});
        return QString();
    } catch (const Error& error) {
        return error.sentence();
    }
}

// Converts colours of a profile to Lab, relative to white. Black point compensation makes a
// difference for inks only.
constexpr cmsUInt32Number exact = cmsFLAGS_NOOPTIMIZE | cmsFLAGS_BLACKPOINTCOMPENSATION;
class ToLab {
public:
    ToLab(const QByteArray& profile, cmsUInt32Number format) {
        cmsHPROFILE from =
            cmsOpenProfileFromMem(profile.constData(), cmsUInt32Number(profile.size()));
        cmsHPROFILE lab = cmsCreateLab4Profile(nullptr);
        transform_ = cmsCreateTransform(from, format, lab, TYPE_Lab_DBL,
                                        INTENT_RELATIVE_COLORIMETRIC, exact);
        cmsCloseProfile(lab);
        cmsCloseProfile(from);
    }
    ~ToLab() { cmsDeleteTransform(transform_); }
    ToLab(const ToLab&) = delete;
    ToLab& operator=(const ToLab&) = delete;

    cmsCIELab of(const void* device) const {
        cmsCIELab lab;
        cmsDoTransform(transform_, device, &lab, 1);
        return lab;
    }

private:
    cmsHTRANSFORM transform_;
};

cmsUInt32Number format(Kind kind) {
    return kind == Kind::Grey ? TYPE_GRAY_8 : kind == Kind::Rgb ? TYPE_RGB_8 : TYPE_CMYK_8;
}

// Returns the printer's colour, computed directly from the texture's colour space.
Device direct(const Device& device, Kind kind, const QByteArray& profile,
              const QByteArray& printer) {
    cmsHPROFILE from = cmsOpenProfileFromMem(profile.constData(), cmsUInt32Number(profile.size()));
    cmsHPROFILE to = cmsOpenProfileFromMem(printer.constData(), cmsUInt32Number(printer.size()));
    cmsHTRANSFORM transform =
        cmsCreateTransform(from, format(kind), to, TYPE_RGB_8, INTENT_RELATIVE_COLORIMETRIC, exact);
    Device result{};
    cmsDoTransform(transform, device.data(), result.data(), 1);
    cmsDeleteTransform(transform);
    cmsCloseProfile(from);
    cmsCloseProfile(to);
    return result;
}

} // namespace

class PictureColourTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QByteArray file(const QString& type, Kind kind, const QByteArray& profile) const {
        return type == "png"    ? pngFile(kind, profile)
               : type == "jpeg" ? jpegFile(kind, profile)
                                : tiffFile(kind, profile, folder_.filePath("texture.tiff"),
                                           type == "tiff16" ? 16 : 8);
    }

private slots:
    void printerColour_ofTexture_matchesItsOwnProfile_data();
    void printerColour_ofTexture_matchesItsOwnProfile();
    void readPictures_colourBeyondSrgb_isKept();
    void readPictures_profileOfAnotherColourSpace_isRefused();
    void readPictures_truncatedCmyk_isRefused();
    void readPictures_truncated_isRefused_data();
    void readPictures_truncated_isRefused();
    void readPhotoFile_truncated_isRefused();
    void readPictures_bytesAfterThePicture_areIgnored();
    void readPictures_damagedProfile_isRefused_data();
    void readPictures_damagedProfile_isRefused();
    void readPictures_greyPngWithRgbProfile_usesTheProfile();
    void readPictures_jpegFillBytes_profileIsFound();
    void readPictures_jpegProfilePartNumbers_profileIsFound();
    void readPictures_webp_usesTheProfile();
    void readPictures_labTiff_keepsTheColours_data();
    void readPictures_labTiff_keepsTheColours();
    void readPictures_oddTiff_isRefused_data();
    void readPictures_oddTiff_isRefused();
    void colourNote_cmykWithoutProfile_isReported();
    void colourNote_coloursBeyondTheWorkingSpace_areReported();
};

void PictureColourTest::printerColour_ofTexture_matchesItsOwnProfile_data() {
    QTest::addColumn<QString>("type");
    QTest::addColumn<int>("channels");
    QTest::addColumn<QByteArray>("printer");
    QTest::addColumn<int>(
        "reached"); // least number of patches that must lie within the printer's gamut
    const QByteArray wide = QColorSpace(QColorSpace::AdobeRgb).iccProfile();
    QTest::newRow("wide printer, grey") << "png" << int(Kind::Grey) << wide << patches;
    QTest::newRow("wide printer, wide picture") << "png" << int(Kind::Rgb) << wide << patches;
    QTest::newRow("wide printer, cmyk") << "tiff16" << int(Kind::Cmyk) << wide << patches / 2;
    for (const Kind kind : {Kind::Grey, Kind::Rgb, Kind::Cmyk}) {
        for (const char* type : {"png", "jpeg", "tiff", "tiff16"}) {
            if (kind != Kind::Cmyk || qstrcmp(type, "png") != 0) {
                QTest::addRow("%s of %d", type, int(kind))
                    << QString(type) << int(kind) << paleRgbProfile() << 8;
            }
        }
    }
}

void PictureColourTest::printerColour_ofTexture_matchesItsOwnProfile() {
    QFETCH(QString, type);
    QFETCH(int, channels);
    const auto kind = Kind(channels);
    const QByteArray profile = profileOf(kind);
    QFETCH(QByteArray, printer);
    QFETCH(int, reached);
    const QByteArray written = file(type, kind, profile);
    const QImage texture = readPictures({{written, QStringLiteral("texture")}}).front();
    const QImage stored =
        kind == Kind::Rgb ? QImage::fromData(written) : QImage(); // JPEG loses a little
    QCOMPARE(texture.size(), QSize(8 * side, 8 * side));
    const QImage sent =
        PrinterColour(printer, RenderingIntent::RelativeColorimetric, false, "pale").rgb(texture);
    const ToLab meant(profile, format(kind));
    const ToLab printed(printer, TYPE_RGB_8);
    int judged = 0;
    double largest = 0;
    for (int number = 0; number < patches; ++number) {
        const QPoint middle(number % 8 * side + side / 2, number / 8 * side + side / 2);
        Device device = patch(kind, number);
        if (!stored.isNull()) {
            const QRgb numbers = stored.pixel(middle);
            device = {uchar(qRed(numbers)), uchar(qGreen(numbers)), uchar(qBlue(numbers)), 0};
        }
        const cmsCIELab wanted = meant.of(device.data());
        const Device reference = direct(device, kind, profile, printer);
        const cmsCIELab best = printed.of(reference.data());
        if (cmsDeltaE(&wanted, &best) > 1) {
            continue; // out of the printer's gamut
        }
        const QColor pixel = sent.pixelColor(middle);
        const Device found{uchar(pixel.red()), uchar(pixel.green()), uchar(pixel.blue()), 0};
        const cmsCIELab lab = printed.of(found.data());
        largest = std::max(largest, double(cmsDeltaE(&best, &lab)));
        ++judged;
    }
    QVERIFY2(judged >= reached,
             qPrintable(QStringLiteral("%1 patches within the gamut, expected %2 or more")
                            .arg(judged)
                            .arg(reached)));
    qInfo() << judged << "patches, largest difference" << largest;
    QVERIFY2(
        largest <= 1,
        qPrintable(QStringLiteral("largest difference ΔE %1, expected 1 or less").arg(largest)));
}

// Adobe RGB's green lies outside sRGB. A printer that can print this green gets it.
void PictureColourTest::readPictures_colourBeyondSrgb_isKept() {
    const QByteArray adobe = QColorSpace(QColorSpace::AdobeRgb).iccProfile();
    QImage picture(8, 8, QImage::Format_RGB888);
    picture.fill(QColor(20, 230, 20));
    picture.setColorSpace(QColorSpace::AdobeRgb);
    const QImage texture = readPictures({{pngBytes(picture, {}), QStringLiteral("green")}}).front();
    QVERIFY(isWide(texture));
    const auto colour = [](const QByteArray& printer) {
        return PrinterColour(printer, RenderingIntent::RelativeColorimetric, false, "printer");
    };
    QCOMPARE(colour(adobe).rgb(texture).pixelColor(4, 4), QColor(20, 230, 20));
    QCOMPARE(colour(adobe).gamutWarning(texture).share, 0.0);
    QCOMPARE(colour(QColorSpace(QColorSpace::SRgb).iccProfile()).gamutWarning(texture).share, 1.0);
    // After saving and reading again, the texture has the same bits.
    const QImage again = readPictures({{pngBytes(texture, {}), QStringLiteral("saved")}}).front();
    QVERIFY(again == texture);
    // A picture within sRGB is stored with 8 bits.
    picture.fill(QColor(200, 120, 90));
    picture.setColorSpace(QColorSpace::AdobeRgb);
    const QImage brown = readPictures({{pngBytes(picture, {}), QStringLiteral("brown")}}).front();
    QCOMPARE(brown.format(), QImage::Format_RGBA8888);
}

void PictureColourTest::readPictures_profileOfAnotherColourSpace_isRefused() {
    try {
        readPictures({{pngFile(Kind::Rgb, simpleCmykProfile(0.02)), QStringLiteral("odd.png")}});
        QFAIL("an RGB picture with a CMYK profile was read, expected a refusal");
    } catch (const Error& error) {
        QVERIFY2(error.sentence().contains("odd.png") && error.sentence().contains("ICC profile"),
                 qPrintable(error.sentence()));
    }
}

void PictureColourTest::readPictures_truncatedCmyk_isRefused() {
    const QByteArray profile = simpleCmykProfile(0.02);
    for (const QString& type : {QString("jpeg"), QString("tiff")}) {
        const QByteArray whole = file(type, Kind::Cmyk, profile);
        const QByteArray most = whole.first(whole.size() - 200);
        bool isRead = true;
        try {
            readPictures({{most, QStringLiteral("cut")}});
        } catch (const Error&) {
            isRead = false;
        }
        QVERIFY2(!isRead, qPrintable(type));
    }
}

void PictureColourTest::readPictures_truncated_isRefused_data() {
    QTest::addColumn<QByteArray>("whole");
    const QImage picture = image(Kind::Rgb, pixels(Kind::Rgb));
    QTest::newRow("jpeg") << jpegFile(Kind::Rgb, {});
    QTest::newRow("grey jpeg") << jpegFile(Kind::Grey, {});
    QTest::newRow("bmp, 24 bit") << fileOf(picture, "bmp");
    QTest::newRow("bmp, palette") << fileOf(picture.convertToFormat(QImage::Format_Indexed8),
                                            "bmp");
    QTest::newRow("bmp, 1 bit") << fileOf(picture.convertToFormat(QImage::Format_Mono), "bmp");
}

void PictureColourTest::readPictures_truncated_isRefused() {
    QFETCH(QByteArray, whole);
    QCOMPARE(refusal(whole), QString());
    for (const int percent : {50, 90, 99}) {
        const QString sentence = refusal(whole.first(whole.size() * percent / 100));
        QVERIFY2(sentence.contains("incomplete") && sentence.contains("odd picture"),
                 qPrintable(sentence));
    }
}

void PictureColourTest::readPhotoFile_truncated_isRefused() {
    const QByteArray whole = jpegFile(Kind::Rgb, {});
    const auto photo = [&](const QByteArray& bytes) {
        QFile file(folder_.filePath("photo.jpg"));
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
            throw Error(QStringLiteral("the photo is not written"), file.fileName());
        }
        file.close();
        return readPhotoFile(file.fileName());
    };
    QCOMPARE(photo(whole).picture.size(), QSize(8 * side, 8 * side));
    QCOMPARE(photo(whole + "a film \xff\xda of more").picture.size(), QSize(8 * side, 8 * side));
    try {
        photo(whole.first(whole.size() / 2));
        QFAIL("a truncated photo was read, expected a refusal");
    } catch (const Error& error) {
        QVERIFY2(error.sentence().contains("camera"), qPrintable(error.sentence()));
    }
}

// Phones append videos and other pictures, whose bytes may look like JPEG markers.
void PictureColourTest::readPictures_bytesAfterThePicture_areIgnored() {
    const QByteArray picture = jpegFile(Kind::Rgb, {});
    QCOMPARE(refusal(picture + "a film \xff\xda of more"), QString());
    QCOMPARE(refusal(picture + picture.first(picture.size() / 2)), QString());
    QCOMPARE(refusal(fileOf(image(Kind::Rgb, pixels(Kind::Rgb)), "bmp") + "more"), QString());
}

void PictureColourTest::readPictures_damagedProfile_isRefused_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QString>("says");
    const QByteArray adobe = profileOf(Kind::Rgb), whole = packed(adobe);
    const QString damaged = QStringLiteral("damaged");
    QTest::newRow("png, cut off") << pngWith(Kind::Rgb, whole.first(whole.size() / 2)) << damaged;
    QTest::newRow("png, damaged stream") << pngWith(Kind::Rgb, "zzzz" + whole.mid(4)) << damaged;
    QTest::newRow("png, profile with only a name")
        << pngFile(Kind::Rgb, adobe).replace(QByteArray("own\0\0", 5), "owned") << damaged;
    QTest::newRow("png in colour, grey profile") << pngFile(Kind::Rgb, greyProfile()) << damaged;
    QTest::newRow("png, huge profile") << pngFile(Kind::Rgb, adobe + QByteArray(17 << 20, ' '))
                                       << QStringLiteral("larger than 16 MB");
    for (const int without : {1, 2, 3}) {
        QTest::addRow("jpeg without part %d", without)
            << jpegFile(Kind::Rgb, adobe, int(adobe.size() / 3 + 1), without) << damaged;
    }
    QTest::newRow("cmyk jpeg without a part")
        << jpegFile(Kind::Cmyk, profileOf(Kind::Cmyk), 60000, 2) << damaged;
    QTest::newRow("webp, cut off") << webpFile(Qt::green, adobe.first(adobe.size() / 2)) << damaged;
    QTest::newRow("webp, cmyk profile") << webpFile(Qt::green, profileOf(Kind::Cmyk)) << damaged;
}

void PictureColourTest::readPictures_damagedProfile_isRefused() {
    QFETCH(QByteArray, file);
    QFETCH(QString, says);
    const QString sentence = refusal(file);
    QVERIFY2(sentence.contains(says) && sentence.contains("profile"), qPrintable(sentence));
}

void PictureColourTest::readPictures_greyPngWithRgbProfile_usesTheProfile() {
    const QByteArray adobe = profileOf(Kind::Rgb);
    const auto read = [](const QByteArray& file) {
        return readPictures({{file, QStringLiteral("dropped")}}).front();
    };
    const QImage grey = image(Kind::Grey, pixels(Kind::Grey));
    const auto inColour = [&](const QByteArray& profile) {
        QByteArray file = fileOf(grey.convertToFormat(QImage::Format_RGB888), "png");
        const qsizetype place = file.indexOf("IDAT") - 4;
        return read(profile.isEmpty() ? file : file.insert(place, profileChunk(packed(profile))));
    };
    const QImage wanted = inColour(adobe);
    QVERIFY(wanted != inColour({}));
    QCOMPARE(read(pngFile(Kind::Grey, adobe)), wanted);
}

void PictureColourTest::readPictures_jpegFillBytes_profileIsFound() {
    const QByteArray plain = jpegFile(Kind::Cmyk, profileOf(Kind::Cmyk));
    const QByteArray filled = QByteArray(plain).insert(2, "\xff\xff\xff");
    const QImage wanted = readPictures({{plain, QStringLiteral("plain")}}).front();
    QVERIFY(readPictures({{filled, QStringLiteral("filled")}}).front() == wanted);
    QVERIFY(wanted != readPictures({{jpegFile(Kind::Cmyk, {}), QStringLiteral("none")}}).front());
}

void PictureColourTest::readPictures_jpegProfilePartNumbers_profileIsFound() {
    const auto read = [](const QByteArray& file) {
        return readPictures({{file, QStringLiteral("numbered")}}).front();
    };
    const QByteArray usual = jpegFile(Kind::Rgb, profileOf(Kind::Rgb));
    const QByteArray name("ICC_PROFILE\0", 12);
    for (const QByteArray& numbers : {QByteArray("\0\1", 2), QByteArray("\0\0", 2),
                                      QByteArray("\1\0", 2), QByteArray("\1\1", 2)}) {
        const QByteArray file = QByteArray(usual).replace(name + "\1\1", name + numbers);
        QCOMPARE(read(file), read(usual));
    }
    QVERIFY(read(usual) != read(jpegFile(Kind::Rgb, {})));
}

void PictureColourTest::readPictures_webp_usesTheProfile() {
    if (!QImageReader::supportedImageFormats().contains("webp")) {
        return; // Qt's WebP plugin is not installed everywhere
    }
    const QColor green(20, 230, 20);
    const QByteArray adobe = profileOf(Kind::Rgb);
    const QImage texture = readPictures({{webpFile(green, adobe), QStringLiteral("webp")}}).front();
    QVERIFY(isWide(texture));
    QCOMPARE(PrinterColour(adobe, RenderingIntent::RelativeColorimetric, false, "printer")
                 .rgb(texture)
                 .pixelColor(4, 4),
             green);
}

namespace {

using Lab = std::array<double, 3>;

// Returns a picture whose halves have the two colours, in TIFF's or ICC's encoding of Lab.
QByteArray labTiff(const Lab& left, const Lab& right, int bits, bool isIcc, const QString& path) {
    constexpr int width = 8;
    TIFF* tiff = TIFFOpen(qPrintable(path), "w");
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, width);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 3);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, isIcc ? PHOTOMETRIC_ICCLAB : PHOTOMETRIC_CIELAB);
    for (int y = 0; y < width; ++y) {
        std::vector<quint16> words;
        std::vector<uchar> octets;
        for (int x = 0; x < width; ++x) {
            const Lab& lab = x < width / 2 ? left : right;
            for (int channel = 0; channel < 3; ++channel) {
                const double value = lab[std::size_t(channel)];
                const double shifted = isIcc && channel > 0 ? value + 128 : value;
                octets.push_back(uchar(int(std::lround(channel == 0 ? value * 2.55 : shifted))));
                words.push_back(quint16(int(std::lround(
                    channel == 0 ? value / 100 * (isIcc ? 65280 : 65535) : shifted * 256))));
            }
        }
        TIFFWriteScanline(
            tiff, bits == 16 ? static_cast<void*>(words.data()) : static_cast<void*>(octets.data()),
            std::uint32_t(y));
    }
    TIFFClose(tiff);
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

double differenceFrom(const Lab& wanted, const QColor& shown) {
    const cmsHPROFILE screen = cmsCreate_sRGBProfile();
    const cmsHPROFILE lab = cmsCreateLab4Profile(nullptr);
    const cmsHTRANSFORM look =
        cmsCreateTransform(screen, TYPE_RGB_8, lab, TYPE_Lab_DBL, INTENT_RELATIVE_COLORIMETRIC, 0);
    const uchar rgb[3] = {uchar(shown.red()), uchar(shown.green()), uchar(shown.blue())};
    cmsCIELab seen;
    cmsDoTransform(look, rgb, &seen, 1);
    cmsDeleteTransform(look);
    cmsCloseProfile(screen);
    cmsCloseProfile(lab);
    const cmsCIELab meant{wanted[0], wanted[1], wanted[2]};
    return cmsDeltaE(&seen, &meant);
}

} // namespace

void PictureColourTest::readPictures_labTiff_keepsTheColours_data() {
    QTest::addColumn<int>("bits");
    QTest::addColumn<bool>("isIcc");
    QTest::newRow("8 bits") << 8 << false;
    QTest::newRow("16 bits") << 16 << false;
    QTest::newRow("8 bits, ICC encoding") << 8 << true;
    QTest::newRow("16 bits, ICC encoding") << 16 << true;
}

void PictureColourTest::readPictures_labTiff_keepsTheColours() {
    QFETCH(int, bits);
    QFETCH(bool, isIcc);
    const QTemporaryDir folder;
    const Lab brown{45, 22, 30}, blue{60, -8, -28};
    const QImage texture =
        readPictures({{labTiff(brown, blue, bits, isIcc, folder.filePath("lab.tif")), "lab"}})
            .front();
    QCOMPARE(texture.size(), QSize(8, 8));
    const double left = differenceFrom(brown, texture.pixelColor(1, 4));
    const double right = differenceFrom(blue, texture.pixelColor(6, 4));
    QVERIFY2(left < 1, qPrintable(QStringLiteral("brown: ΔE %1, expected < 1").arg(left)));
    QVERIFY2(right < 1, qPrintable(QStringLiteral("blue: ΔE %1, expected < 1").arg(right)));
}

namespace {

struct TiffKind {
    int photometric = PHOTOMETRIC_RGB, samples = 3, bits = 8;
    QList<int> extras = {}; // kinds of the samples beside the colour
    int planes = PLANARCONFIG_CONTIG, format = SAMPLEFORMAT_UINT;
    int mostOfMap = 0; // largest value of the colour map, if there is one
};

QByteArray tiffOf(const TiffKind& kind, const QString& path) {
    constexpr int width = 8;
    TIFF* tiff = TIFFOpen(qPrintable(path), "w");
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, width);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, kind.bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, kind.samples);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, kind.planes);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, kind.photometric);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, kind.format);
    if (!kind.extras.isEmpty()) {
        const std::vector<std::uint16_t> extras(kind.extras.begin(), kind.extras.end());
        TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, int(extras.size()), extras.data());
    }
    if (kind.mostOfMap > 0) {
        const std::vector<std::uint16_t> map(256, std::uint16_t(kind.mostOfMap));
        TIFFSetField(tiff, TIFFTAG_COLORMAP, map.data(), map.data(), map.data());
    }
    std::vector<uchar> row(std::size_t(TIFFScanlineSize(tiff)), 100);
    for (int plane = 0; plane < (kind.planes == PLANARCONFIG_SEPARATE ? kind.samples : 1);
         ++plane) {
        for (int y = 0; y < width; ++y) {
            TIFFWriteScanline(tiff, row.data(), std::uint32_t(y), std::uint16_t(plane));
        }
    }
    TIFFClose(tiff);
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

Q_DECLARE_METATYPE(TiffKind)

// Each of these was read in wrong colours or without its transparency.
void PictureColourTest::readPictures_oddTiff_isRefused_data() {
    QTest::addColumn<TiffKind>("kind");
    QTest::addColumn<bool>("isRefused");
    const auto row = [](const char* name, bool isRefused, const TiffKind& kind) {
        QTest::newRow(name) << kind << isRefused;
    };
    constexpr int grey = PHOTOMETRIC_MINISBLACK, rgb = PHOTOMETRIC_RGB;
    const QList<int> alpha{EXTRASAMPLE_UNASSALPHA}, unknown{EXTRASAMPLE_UNSPECIFIED};
    row("RGB", false, {});
    row("RGB, 16 bits", false, {rgb, 3, 16});
    row("RGB in planes", false, {rgb, 3, 8, {}, PLANARCONFIG_SEPARATE});
    row("RGB, 16 bits in planes", true, {rgb, 3, 16, {}, PLANARCONFIG_SEPARATE});
    row("RGB, 32 bits", true, {rgb, 3, 32});
    row("RGB, floating point", true, {rgb, 3, 32, {}, PLANARCONFIG_CONTIG, SAMPLEFORMAT_IEEEFP});
    row("RGB, signed", true, {rgb, 3, 8, {}, PLANARCONFIG_CONTIG, SAMPLEFORMAT_INT});
    row("RGB and alpha", false, {rgb, 4, 8, alpha});
    row("RGB and alpha, 16 bits", false, {rgb, 4, 16, alpha});
    row("RGB and a channel", true, {rgb, 4, 8, unknown});
    row("RGB and two channels", true, {rgb, 5, 8, alpha + unknown});
    row("grey", false, {grey, 1, 16});
    row("grey and alpha", true, {grey, 2, 8, alpha});
    row("grey and alpha, 16 bits", true, {grey, 2, 16, alpha});
    row("CMYK", false, {PHOTOMETRIC_SEPARATED, 4, 8});
    row("CMYK and alpha", true, {PHOTOMETRIC_SEPARATED, 5, 8, alpha});
    row("CMYK and a channel", true, {PHOTOMETRIC_SEPARATED, 5, 8, unknown});
    row("three inks", true, {PHOTOMETRIC_SEPARATED, 3, 8});
    row("Lab and alpha", true, {PHOTOMETRIC_CIELAB, 4, 8, alpha});
    TiffKind indexed{PHOTOMETRIC_PALETTE, 1, 8};
    indexed.mostOfMap = 65535;
    row("colour map", false, indexed);
    indexed.mostOfMap = 255;
    row("colour map of 8 bits", true, indexed);
}

void PictureColourTest::readPictures_oddTiff_isRefused() {
    QFETCH(TiffKind, kind);
    QFETCH(bool, isRefused);
    const QString sentence = refusal(tiffOf(kind, folder_.filePath("odd.tif")));
    QVERIFY2(sentence.contains("extra channels") == isRefused, qPrintable(sentence));
    QVERIFY2(sentence.isEmpty() != isRefused, qPrintable(sentence));
}

void PictureColourTest::colourNote_cmykWithoutProfile_isReported() {
    const auto noteOf = [](const QByteArray& file) {
        return colourNoteText(readPictures({{file, QStringLiteral("inks")}}).front(), "Inks");
    };
    const QTemporaryDir folder;
    for (const QByteArray& file :
         {jpegFile(Kind::Cmyk, {}), tiffFile(Kind::Cmyk, {}, folder.filePath("inks.tif"), 8)}) {
        const QImage texture = readPictures({{file, QStringLiteral("inks")}}).front();
        QVERIFY2(noteOf(file).contains("CMYK"), qPrintable(noteOf(file)));
        // The note stays when the project stores the picture as PNG.
        QVERIFY(noteOf(pngBytes(texture, {})).contains("CMYK"));
    }
    QVERIFY(noteOf(jpegFile(Kind::Cmyk, profileOf(Kind::Cmyk))).isEmpty());
    QVERIFY(noteOf(jpegFile(Kind::Rgb, {})).isEmpty());
}

// Fills a quarter of the picture with ProPhoto's green primary, which no device can show.
void PictureColourTest::colourNote_coloursBeyondTheWorkingSpace_areReported() {
    QImage picture(8, 8, QImage::Format_RGB32);
    picture.fill(QColor(120, 100, 90));
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            picture.setPixelColor(x, y, QColor(0, 255, 0));
        }
    }
    picture.setColorSpace(QColorSpace::ProPhotoRgb);
    const QImage texture = readPictures({{fileOf(picture, "png"), QStringLiteral("wide")}}).front();
    QVERIFY(std::abs(colourNote(texture).clipped - 0.25) < 1e-9);
    const QString said = colourNoteText(texture, "The texture");
    QVERIFY2(said.contains("25"), qPrintable(said));
    const QImage again = readPictures({{pngBytes(texture, {}), QStringLiteral("kept")}}).front();
    QCOMPARE(colourNoteText(again, "The texture"), said);
    picture.setColorSpace(QColorSpace::AdobeRgb); // the working space contains all of it
    const QImage held = readPictures({{fileOf(picture, "png"), QStringLiteral("held")}}).front();
    QVERIFY(colourNoteText(held, "The texture").isEmpty());
}

QTEST_GUILESS_MAIN(PictureColourTest)
#include "PictureColourTest.moc"
