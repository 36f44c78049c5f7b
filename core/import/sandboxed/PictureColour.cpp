#include "import/sandboxed/PictureColour.h"

#include "base/ColourNote.h"
#include "base/Error.h"
#include "base/InkPicture.h"
#include "base/WideGamut.h"
#include "import/sandboxed/PictureFile.h"

#include <QCoreApplication>
#include <QtEndian>

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <jpeglib.h>
#include <lcms2.h>
#include <map>
#include <memory>
#include <tiffio.h>
#include <webp/mux_types.h>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::Texture)
};

constexpr qsizetype largestProfile = 16 << 20; // bytes

[[noreturn]] void throwCutOff(const QString& where) {
    throw Error(Text::tr("The picture is damaged: its ICC profile is incomplete; save it again"),
                where);
}

[[noreturn]] void throwNotFit(const QString& where) {
    throw Error(Text::tr("The picture's ICC profile is damaged or does not match its pixels; save "
                         "the picture again as sRGB"),
                where);
}

// Returns the profile in chunk iCCP of a PNG file (ISO/IEC 15948): name, 0, method 0, zlib stream.
// It is read here because libpng drops an RGB profile in a grey picture.
QByteArray profileOfPng(const QByteArray& file, const QString& where) {
    const auto chunk = pngChunk(file, "iCCP");
    if (!chunk) {
        return {};
    }
    const qsizetype stream = chunk->indexOf('\0') + 2;
    // qUncompress() expects a length first; it allocates more if that is too small.
    QByteArray packed(4, '\0');
    qToBigEndian(quint32(4096), packed.data());
    const QByteArray profile = stream < 2 ? QByteArray() : qUncompress(packed + chunk->mid(stream));
    if (profile.isEmpty()) {
        throwNotFit(where);
    }
    return profile;
}

// Returns the profile in the segments APP2 of a JPEG file (ICC.1, annex B.4): "ICC_PROFILE", 0,
// number from 1, count, part. Some programs number from 0 or give no count; libjpeg refuses such
// files.
QByteArray profileOfJpeg(const QByteArray& file, const QString& where) {
    std::map<int, QByteArray> parts;
    int count = 0;
    for (auto marker = nextJpegMarker(file, 0); marker && marker->kind != jpegScan;
         marker = nextJpegMarker(file, marker->end)) {
        const QByteArray& segment = marker->segment;
        if (marker->kind == 0xe2 && segment.size() >= 14 &&
            segment.startsWith(QByteArrayView("ICC_PROFILE\0", 12))) {
            parts[uchar(segment[12])] = segment.mid(14);
            count = std::max(count, int(uchar(segment[13])));
        }
    }
    const int first = parts.contains(0) ? 0 : 1;
    const int end = first + std::max(count, int(parts.size()));
    QByteArray profile;
    for (int number = first; number < end; ++number) {
        if (!parts.contains(number)) {
            throwCutOff(where);
        }
        profile += parts[number];
    }
    return profile;
}

// Returns the profile of a WebP file, whose header says whether it has one.
QByteArray profileOfWebp(const QByteArray& file, const QString& where) {
    const auto profile = webpChunk(file, "ICCP", ICCP_FLAG);
    if (profile && profile->isEmpty()) {
        throwCutOff(where);
    }
    return profile.value_or(QByteArray());
}

// A TIFF file in memory, open for libtiff.
class TiffFile {
public:
    explicit TiffFile(const QByteArray& bytes) : bytes_(bytes) {
        TIFFSetErrorHandler(nullptr); // errors are reported by this program instead
        TIFFSetWarningHandler(nullptr);
        tiff_.reset(TIFFClientOpen("picture", "rm", this, read, write, seek, close, size, nullptr,
                                   nullptr));
    }
    TiffFile(const TiffFile&) = delete;
    TiffFile& operator=(const TiffFile&) = delete;

    TIFF* get() const { return tiff_.get(); }
    // Returns a tag of one number; 0 if the file is not TIFF or has no such tag.
    template <typename Number>
    Number number(ttag_t tag) const {
        Number value = 0;
        if (tiff_) {
            TIFFGetFieldDefaulted(tiff_.get(), tag, &value);
        }
        return value;
    }

private:
    static TiffFile& self(thandle_t handle) { return *static_cast<TiffFile*>(handle); }
    static tmsize_t read(thandle_t handle, void* target, tmsize_t count) {
        TiffFile& file = self(handle);
        count = std::clamp<tmsize_t>(tmsize_t(file.bytes_.size()) - file.at_, 0, count);
        std::memcpy(target, file.bytes_.constData() + file.at_, std::size_t(count));
        file.at_ += count;
        return count;
    }
    static tmsize_t write(thandle_t, void*, tmsize_t) { return -1; }
    static toff_t seek(thandle_t handle, toff_t offset, int from) {
        TiffFile& file = self(handle);
        const tmsize_t base = from == SEEK_SET   ? 0
                              : from == SEEK_CUR ? file.at_
                                                 : tmsize_t(file.bytes_.size());
        file.at_ = std::clamp<tmsize_t>(base + tmsize_t(offset), 0, tmsize_t(file.bytes_.size()));
        return toff_t(file.at_);
    }
    static int close(thandle_t) { return 0; }
    static toff_t size(thandle_t handle) { return toff_t(self(handle).bytes_.size()); }

    struct Close {
        void operator()(TIFF* tiff) const { TIFFClose(tiff); }
    };
    const QByteArray& bytes_;
    tmsize_t at_ = 0;
    std::unique_ptr<TIFF, Close> tiff_;
};

QByteArray profileOfTiff(const QByteArray& file) {
    const TiffFile tiff(file);
    std::uint32_t length = 0;
    void* profile = nullptr;
    if (!tiff.get() || !TIFFGetField(tiff.get(), TIFFTAG_ICCPROFILE, &length, &profile)) {
        return {};
    }
    return {static_cast<const char*>(profile), qsizetype(length)};
}

// Whether the first directory of a TIFF file (TIFF 6.0, section 2) has the profile's tag. libtiff
// ignores the tag if its data is missing.
bool claimsProfile(const QByteArray& file) {
    const bool isLittle = file.startsWith('I');
    const auto number = [&]<typename Number>(qsizetype at, Number) -> Number {
        if (at < 0 || at + qsizetype(sizeof(Number)) > file.size()) {
            return 0;
        }
        return isLittle ? qFromLittleEndian<Number>(file.constData() + at)
                        : qFromBigEndian<Number>(file.constData() + at);
    };
    const auto directory = qsizetype(number(4, quint32()));
    const int entries = number(directory, quint16());
    for (int entry = 0; entry < entries; ++entry) {
        if (number(directory + 2 + 12 * qsizetype(entry), quint16()) == TIFFTAG_ICCPROFILE) {
            return true;
        }
    }
    return false;
}

bool isTiff(const QByteArray& file) {
    return file.startsWith(QByteArrayView("II*\0", 4)) ||
           file.startsWith(QByteArrayView("MM\0*", 4));
}

// Returns how many of a pixel's samples are its colour; 0 for kinds of TIFF that are not read.
int coloursOf(int photometric) {
    switch (photometric) {
    case PHOTOMETRIC_MINISWHITE:
    case PHOTOMETRIC_MINISBLACK:
    case PHOTOMETRIC_PALETTE:
        return 1;
    case PHOTOMETRIC_RGB:
    case PHOTOMETRIC_YCBCR:
    case PHOTOMETRIC_CIELAB:
    case PHOTOMETRIC_ICCLAB:
        return 3;
    case PHOTOMETRIC_SEPARATED:
        return 4;
    default:
        return 0;
    }
}

// Whether a pixel's only sample beside its colour is transparency.
bool hasTransparency(const TiffFile& tiff) {
    std::uint16_t count = 0;
    const std::uint16_t* kinds = nullptr;
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_EXTRASAMPLES, &count, &kinds);
    return count == 1 && kinds[0] != EXTRASAMPLE_UNSPECIFIED;
}

// Whether a colour map has 8-bit values instead of 16-bit ones, as some old programs write.
bool hasNarrowColourMap(const TiffFile& tiff) {
    std::array<std::uint16_t*, 3> map{};
    if (!TIFFGetField(tiff.get(), TIFFTAG_COLORMAP, &map[0], &map[1], &map[2])) {
        return false;
    }
    const int size = 1 << tiff.number<std::uint16_t>(TIFFTAG_BITSPERSAMPLE);
    std::uint16_t most = 0;
    for (const std::uint16_t* channel : map) {
        most = std::max(most, *std::max_element(channel, channel + size));
    }
    return most > 0 && most < 256;
}

// Returns the size of a picture that is stored in rows, with 8 or 16 bits per sample. Returns
// nothing if it is stored otherwise or has fewer than `least` samples per pixel.
std::optional<QSize> rowsOf(const TiffFile& tiff, int least) {
    const auto samples = tiff.number<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL);
    const auto bits = tiff.number<std::uint16_t>(TIFFTAG_BITSPERSAMPLE);
    if (samples < least || (bits != 8 && bits != 16) || TIFFIsTiled(tiff.get()) ||
        tiff.number<std::uint16_t>(TIFFTAG_PLANARCONFIG) != PLANARCONFIG_CONTIG) {
        return std::nullopt;
    }
    const QSize size(int(tiff.number<std::uint32_t>(TIFFTAG_IMAGEWIDTH)),
                     int(tiff.number<std::uint32_t>(TIFFTAG_IMAGELENGTH)));
    return size.isEmpty() ? std::nullopt : std::optional(size);
}

// Calls take(samples) for each pixel with its samples in 16 bits; 8-bit samples are multiplied by
// 257. Returns false if the file ends too early.
template <typename Take>
bool forTiffPixels(const TiffFile& tiff, QSize size, const Take& take) {
    const std::size_t samples = tiff.number<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL);
    const auto bits = tiff.number<std::uint16_t>(TIFFTAG_BITSPERSAMPLE);
    const std::size_t rowBytes = std::size_t(size.width()) * samples * bits / 8;
    std::vector<uchar> row(std::size_t(TIFFScanlineSize(tiff.get())));
    if (row.size() < rowBytes) {
        return false;
    }
    std::vector<quint16> pixel(samples);
    for (int y = 0; y < size.height(); ++y) {
        if (TIFFReadScanline(tiff.get(), row.data(), std::uint32_t(y), 0) != 1) {
            return false;
        }
        for (std::size_t x = 0; x < std::size_t(size.width()); ++x) {
            for (std::size_t sample = 0; sample < samples; ++sample) {
                const std::size_t at = x * samples + sample;
                if (bits == 16) {
                    std::memcpy(&pixel[sample], &row[2 * at], 2); // libtiff has swapped the bytes
                } else {
                    pixel[sample] = quint16(row[at] * 257);
                }
            }
            take(pixel);
        }
    }
    return true;
}

std::optional<InkPicture> inksOfTiff(const QByteArray& file) {
    const TiffFile tiff(file);
    const std::optional<QSize> size =
        tiff.number<std::uint16_t>(TIFFTAG_PHOTOMETRIC) == PHOTOMETRIC_SEPARATED ? rowsOf(tiff, 4)
                                                                                 : std::nullopt;
    if (!size) {
        return std::nullopt;
    }
    InkPicture picture{*size, {}};
    picture.inks.reserve(std::size_t(size->width()) * std::size_t(size->height()));
    const bool whole = forTiffPixels(tiff, *size, [&](const std::vector<quint16>& samples) {
        picture.inks.push_back({samples[0], samples[1], samples[2], samples[3]});
    });
    return whole ? std::optional(std::move(picture)) : std::nullopt;
}

bool isLab(int photometric) {
    return photometric == PHOTOMETRIC_CIELAB || photometric == PHOTOMETRIC_ICCLAB;
}

// Returns a* or b* from a 16-bit sample, of CIELab (TIFF 6.0, section 23; signed) or of the
// supplement's ICCLab (offset by 128).
float chromaOf(quint16 number, int bits, bool isIcc) {
    if (bits == 8) {
        const int byte = number / 257;
        return float(isIcc ? byte - 128 : int(qint8(byte)));
    }
    return isIcc ? float(number) / 256 - 128 : float(qint16(number)) / 256;
}

struct JpegErrors {
    jpeg_error_mgr manager; // must be first, because libjpeg accesses only this part
    std::jmp_buf back;
};

// Has no local objects with destructors, since libjpeg may jump out. Photoshop and programs like it
// write inverted inks and mark the file with an Adobe marker.
bool decodeInks(jpeg_decompress_struct& jpeg, JpegErrors& errors, const QByteArray& file,
                InkPicture& picture, std::vector<uchar>& row) {
    if (setjmp(errors.back)) { // NOLINT(cert-err52-cpp): the only way that libjpeg has
        return false;
    }
    jpeg_mem_src(&jpeg, reinterpret_cast<const uchar*>(file.constData()),
                 static_cast<unsigned long>(file.size()));
    jpeg_read_header(&jpeg, TRUE);
    if (jpeg.num_components != 4) {
        return false;
    }
    jpeg.out_color_space = JCS_CMYK;
    jpeg_start_decompress(&jpeg);
    picture.size = {int(jpeg.output_width), int(jpeg.output_height)};
    picture.inks.resize(std::size_t(jpeg.output_width) * jpeg.output_height);
    row.resize(std::size_t(jpeg.output_width) * 4);
    const bool reversed = jpeg.saw_Adobe_marker != FALSE;
    std::size_t pixel = 0;
    while (jpeg.output_scanline < jpeg.output_height) {
        JSAMPROW start = row.data();
        jpeg_read_scanlines(&jpeg, &start, 1);
        for (std::size_t at = 0; at < row.size(); at += 4, ++pixel) {
            for (std::size_t ink = 0; ink < 4; ++ink) {
                const int value = row[at + ink];
                picture.inks[pixel][ink] = quint16((reversed ? 255 - value : value) * 257);
            }
        }
    }
    return jpeg.err->num_warnings == 0; // an incomplete file continues in grey, with a warning
}

std::optional<InkPicture> inksOfJpeg(const QByteArray& file) {
    JpegErrors errors;
    jpeg_decompress_struct jpeg{};
    jpeg.err = jpeg_std_error(&errors.manager);
    errors.manager.error_exit = [](j_common_ptr failed) {
        std::longjmp(reinterpret_cast<JpegErrors*>(failed->err)->back, 1);
    };
    errors.manager.output_message = [](j_common_ptr) {};
    jpeg_create_decompress(&jpeg);
    InkPicture picture;
    std::vector<uchar> row;
    const bool whole = decodeInks(jpeg, errors, file, picture, row);
    jpeg_destroy_decompress(&jpeg);
    return whole ? std::optional(std::move(picture)) : std::nullopt;
}

struct CloseProfile {
    void operator()(void* profile) const { cmsCloseProfile(profile); }
};
struct DeleteTransform {
    void operator()(void* transform) const { cmsDeleteTransform(transform); }
};
using ProfileHandle = std::unique_ptr<void, CloseProfile>;
using Transform = std::unique_ptr<void, DeleteTransform>;

// Colour space of the result. `Open` keeps colours outside wide, as values below 0 or above 1.
enum class Target { Srgb, Wide, Open };

ProfileHandle profileFrom(const QByteArray& bytes) {
    return ProfileHandle(cmsOpenProfileFromMem(bytes.constData(), cmsUInt32Number(bytes.size())));
}

Transform transformTo(Target target, const QByteArray& profile, cmsUInt32Number pixels,
                      const QString& where) {
    const bool wide = target != Target::Srgb;
    const cmsUInt32Number numbers = target == Target::Srgb   ? TYPE_RGBA_8
                                    : target == Target::Wide ? TYPE_RGBA_16
                                                             : TYPE_RGB_FLT;
    const cmsUInt32Number blackPoint =
        T_COLORSPACE(pixels) == PT_CMYK ? cmsFLAGS_BLACKPOINTCOMPENSATION : 0U;
    const ProfileHandle from = profileFrom(profile);
    const ProfileHandle to =
        wide ? profileFrom(wideSpace().iccProfile()) : ProfileHandle(cmsCreate_sRGBProfile());
    Transform transform(from ? cmsCreateTransform(from.get(), pixels, to.get(), numbers,
                                                  INTENT_RELATIVE_COLORIMETRIC,
                                                  cmsFLAGS_HIGHRESPRECALC | blackPoint)
                             : nullptr);
    if (!transform) {
        throwNotFit(where);
    }
    return transform;
}

QByteArrayView spaceOf(const QByteArray& profile) {
    return profile.size() < 20 ? QByteArrayView() : QByteArrayView(profile).sliced(16, 4);
}

QImage emptyTexture(QSize size, Target target) {
    const bool wide = target == Target::Wide;
    QImage texture(size, wide ? QImage::Format_RGBA64 : QImage::Format_RGBA8888);
    if (texture.isNull()) {
        throw std::bad_alloc();
    }
    texture.fill(Qt::white); // lcms2 writes colours and leaves alpha unchanged
    if (wide) {
        texture.setColorSpace(wideSpace());
    }
    return texture;
}

cmsUInt32Number numbersOf(const InkPicture&, const QByteArray&) {
    return TYPE_CMYK_16;
}
cmsUInt32Number numbersOf(const QImage&, const QByteArray& profile) {
    return spaceOf(profile) == "GRAY" ? TYPE_GRAY_16 : TYPE_RGB_16;
}
cmsUInt32Number numbersOf(const LabPicture&, const QByteArray&) {
    return TYPE_Lab_FLT;
}

// Converts one row at a time, to avoid a second copy of a large picture in 16 bits.
void convertRow(cmsHTRANSFORM transform, const InkPicture& picture, int y, QImage& row, Target) {
    const auto width = std::size_t(row.width());
    cmsDoTransform(transform, &picture.inks[std::size_t(y) * width], row.bits(),
                   cmsUInt32Number(width));
}
void convertRow(cmsHTRANSFORM transform, const LabPicture& picture, int y, QImage& row, Target) {
    const auto width = std::size_t(row.width());
    cmsDoTransform(transform, &picture.colours[std::size_t(y) * width], row.bits(),
                   cmsUInt32Number(width));
}
void convertRow(cmsHTRANSFORM transform, const QImage& picture, int y, QImage& row, Target target) {
    const bool grey = T_COLORSPACE(cmsGetTransformInputFormat(transform)) == PT_GRAY;
    const auto width = std::size_t(row.width());
    const QImage source = picture.copy(0, y, row.width(), 1).convertToFormat(QImage::Format_RGBA64);
    const auto* pixel = reinterpret_cast<const quint16*>(source.constBits());
    std::vector<quint16> numbers;
    for (std::size_t x = 0; x < width; ++x) {
        numbers.insert(numbers.end(), pixel + 4 * x, pixel + 4 * x + (grey ? 1 : 3));
    }
    uchar* to = row.bits();
    cmsDoTransform(transform, numbers.data(), to, cmsUInt32Number(width));
    for (std::size_t x = 0; x < width; ++x) { // lcms2 leaves alpha unchanged
        const quint16 alpha = pixel[4 * x + 3];
        if (target == Target::Wide) {
            reinterpret_cast<quint16*>(to)[4 * x + 3] = alpha;
        } else {
            to[4 * x + 3] = uchar((alpha + 128) / 257);
        }
    }
}

// Throws if the profile is for grey but the picture is not.
void requireKind(const QImage& picture, const QByteArray& profile, const QString& where) {
    if (spaceOf(profile) == "GRAY" && !picture.allGray()) {
        throwNotFit(where);
    }
}

QSize sizeOf(const InkPicture& picture) {
    return picture.size;
}
QSize sizeOf(const QImage& picture) {
    return picture.size();
}
QSize sizeOf(const LabPicture& picture) {
    return picture.size;
}

// A row in floating point, to find colours outside a colour space. Empty for inks and grey, whose
// colours cannot be far outside.
struct OpenRow {
    cmsUInt32Number numbers = 0;
    std::vector<float> values;
};
OpenRow openRow(const InkPicture&, const QByteArray&, int) {
    return {};
}
OpenRow openRow(const LabPicture& picture, const QByteArray&, int y) {
    const auto width = std::size_t(picture.size.width());
    const float* first = picture.colours[std::size_t(y) * width].data();
    return {TYPE_Lab_FLT, {first, first + 3 * width}};
}
OpenRow openRow(const QImage& picture, const QByteArray& profile, int y) {
    if (spaceOf(profile) != "RGB ") {
        return {};
    }
    constexpr float full = 65535;
    const QImage source =
        picture.copy(0, y, picture.width(), 1).convertToFormat(QImage::Format_RGBA64);
    const auto* pixel = reinterpret_cast<const quint16*>(source.constBits());
    OpenRow row{TYPE_RGB_FLT, {}};
    for (int x = 0; x < picture.width(); ++x, pixel += 4) {
        row.values.insert(row.values.end(), {pixel[0] / full, pixel[1] / full, pixel[2] / full});
    }
    return row;
}

// Whether a row has a colour at an end of the wide space's range. Only the originals of such
// colours can be outside the range.
bool touchesWideEnds(const QImage& texture, int y) {
    const auto* pixel = reinterpret_cast<const quint16*>(texture.constScanLine(y));
    for (int x = 0; x < texture.width(); ++x, pixel += 4) {
        const auto [least, most] = std::minmax({pixel[0], pixel[1], pixel[2]});
        if (least != most && (least == 0 || most == 65535)) {
            return true;
        }
    }
    return false;
}

// Returns the share of pixels of a wide texture whose original colours were visibly outside its
// space.
template <typename Picture>
double clippedShare(const Picture& picture, const QByteArray& profile, const QImage& texture,
                    const QString& where) {
    constexpr float visible = 0.02F; // share of a channel's range, gamma-encoded
    const cmsUInt32Number numbers = openRow(picture, profile, 0).numbers;
    if (numbers == 0) {
        return 0;
    }
    const Transform open = transformTo(Target::Open, profile, numbers, where);
    std::vector<float> colours(3 * std::size_t(texture.width()));
    qint64 beyond = 0;
    for (int y = 0; y < texture.height(); ++y) {
        if (!touchesWideEnds(texture, y)) {
            continue;
        }
        const OpenRow row = openRow(picture, profile, y);
        cmsDoTransform(open.get(), row.values.data(), colours.data(),
                       cmsUInt32Number(texture.width()));
        for (std::size_t at = 0; at < colours.size(); at += 3) {
            const auto [least, most] = std::minmax({colours[at], colours[at + 1], colours[at + 2]});
            beyond += least < -visible || most > 1 + visible;
        }
    }
    return double(beyond) / (double(texture.width()) * texture.height());
}

template <typename Picture>
QImage converted(const Picture& picture, const QByteArray& profile, const QString& where,
                 Target target) {
    const Transform transform = transformTo(target, profile, numbersOf(picture, profile), where);
    QImage texture = emptyTexture(sizeOf(picture), target);
    QImage row = emptyTexture({texture.width(), 1}, target);
    for (int y = 0; y < texture.height(); ++y) {
        convertRow(transform.get(), picture, y, row, target);
        std::copy_n(row.constBits(), row.bytesPerLine(), texture.scanLine(y));
    }
    return texture;
}

// Whether a row has a colour at an end of sRGB's range. Only the originals of such colours can be
// outside the range.
bool touchesEnds(const uchar* row, int width) {
    for (const uchar* pixel = row; pixel < row + qsizetype(width) * 4; pixel += 4) {
        const auto [least, most] = std::minmax({pixel[0], pixel[1], pixel[2]});
        if (least != most && (least == 0 || most == 255)) {
            return true;
        }
    }
    return false;
}

template <typename Picture>
QImage widerWhereNeeded(const Picture& picture, const QByteArray& profile, const QString& where) {
    QImage texture = converted(picture, profile, where, Target::Srgb);
    const Transform toWide = transformTo(Target::Wide, profile, numbersOf(picture, profile), where);
    QImage row = emptyTexture({texture.width(), 1}, Target::Wide);
    for (int y = 0; y < texture.height(); ++y) {
        if (touchesEnds(texture.constScanLine(y), texture.width())) {
            convertRow(toWide.get(), picture, y, row, Target::Wide);
            if (!fitsInSrgb(row)) {
                texture = QImage(); // freed first, as memory is scarce
                texture = converted(picture, profile, where, Target::Wide);
                const ColourNote note{false, clippedShare(picture, profile, texture, where)};
                return note.isEmpty() ? texture : withColourNote(texture, note);
            }
        }
    }
    return texture;
}

QImage withResolutionOf(const QImage& picture, QImage texture) {
    texture.setDotsPerMeterX(picture.dotsPerMeterX());
    texture.setDotsPerMeterY(picture.dotsPerMeterY());
    return texture;
}

} // namespace

QByteArray embeddedProfile(const QByteArray& file, const QString& where) {
    const QByteArray profile = file.startsWith("\x89PNG")        ? profileOfPng(file, where)
                               : file.startsWith("\xff\xd8\xff") ? profileOfJpeg(file, where)
                               : file.startsWith("RIFF")         ? profileOfWebp(file, where)
                               : isTiff(file)                    ? profileOfTiff(file)
                                                                 : QByteArray();
    if (profile.isEmpty() && isTiff(file) && claimsProfile(file)) {
        throwCutOff(where);
    }
    if (profile.size() > largestProfile) {
        throw Error(
            Text::tr(
                "The picture's ICC profile is larger than %1 MB; save the picture again as sRGB")
                .arg(largestProfile >> 20),
            where);
    }
    return profile;
}

bool isMisreadTiff(const QByteArray& file) {
    const TiffFile tiff(file);
    if (!isTiff(file) || !tiff.get()) {
        return false;
    }
    const int photometric = tiff.number<std::uint16_t>(TIFFTAG_PHOTOMETRIC);
    const int samples = tiff.number<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL);
    const int colours = coloursOf(photometric);
    const bool isTransparent =
        photometric == PHOTOMETRIC_RGB && samples == 4 && hasTransparency(tiff);
    const bool isInPlanes =
        tiff.number<std::uint16_t>(TIFFTAG_PLANARCONFIG) == PLANARCONFIG_SEPARATE && samples > 1;
    return !(samples == colours || isTransparent) ||
           tiff.number<std::uint16_t>(TIFFTAG_BITSPERSAMPLE) > (isInPlanes ? 8 : 16) ||
           tiff.number<std::uint16_t>(TIFFTAG_SAMPLEFORMAT) != SAMPLEFORMAT_UINT ||
           (photometric == PHOTOMETRIC_PALETTE && hasNarrowColourMap(tiff));
}

QImage inkPictureOf(const InkPicture& picture, const QByteArray& profile) {
    QImage amounts = inkPicture(picture.size, iccIdentity(profile));
    if (amounts.isNull()) {
        throw std::bad_alloc();
    }
    auto pixel = picture.inks.begin();
    for (int y = 0; y < amounts.height(); ++y) {
        uchar* to = amounts.scanLine(y);
        for (int x = 0; x < amounts.width(); ++x, ++pixel) {
            to = std::transform(pixel->begin(), pixel->end(), to,
                                [](quint16 ink) { return uchar((ink + 128) / 257); });
        }
    }
    return amounts;
}

bool isOfInks(const QByteArray& profile) {
    return spaceOf(profile) == "CMYK";
}

std::optional<InkPicture> readInks(const QByteArray& file) {
    return isTiff(file)                      ? inksOfTiff(file)
           : file.startsWith("\xff\xd8\xff") ? inksOfJpeg(file)
                                             : std::nullopt;
}

bool isOfLab(const QByteArray& file) {
    return isTiff(file) && isLab(TiffFile(file).number<std::uint16_t>(TIFFTAG_PHOTOMETRIC));
}

std::optional<LabPicture> readLab(const QByteArray& file) {
    const TiffFile tiff(file);
    const std::optional<QSize> size = rowsOf(tiff, 3);
    if (!size) {
        return std::nullopt;
    }
    const int bits = tiff.number<std::uint16_t>(TIFFTAG_BITSPERSAMPLE);
    const bool isIcc = tiff.number<std::uint16_t>(TIFFTAG_PHOTOMETRIC) == PHOTOMETRIC_ICCLAB;
    const float full = isIcc && bits == 16 ? 65280 : 65535; // value of L* = 100
    LabPicture picture{*size, {}};
    picture.colours.reserve(std::size_t(size->width()) * std::size_t(size->height()));
    const bool whole = forTiffPixels(tiff, *size, [&](const std::vector<quint16>& samples) {
        picture.colours.push_back({100 * float(samples[0]) / full,
                                   chromaOf(samples[1], bits, isIcc),
                                   chromaOf(samples[2], bits, isIcc)});
    });
    return whole ? std::optional(std::move(picture)) : std::nullopt;
}

QImage textureOf(const LabPicture& picture, const QString& where) {
    const ProfileHandle lab(cmsCreateLab4Profile(nullptr)); // D50
    cmsUInt32Number size = 0;
    cmsSaveProfileToMem(lab.get(), nullptr, &size);
    QByteArray profile(qsizetype(size), '\0');
    cmsSaveProfileToMem(lab.get(), profile.data(), &size);
    return widerWhereNeeded(picture, profile, where);
}

QImage textureOf(const InkPicture& picture, const QByteArray& profile, const QString& where) {
    return widerWhereNeeded(picture, profile, where);
}

QImage textureOf(const QImage& picture, const QByteArray& profile, const QString& where) {
    if (profile == wideSpace().iccProfile()) { // a texture that was stored in wide colour
        QImage texture = picture.convertToFormat(QImage::Format_RGBA64);
        texture.setColorSpace(wideSpace());
        return texture;
    }
    requireKind(picture, profile, where);
    return withResolutionOf(picture, widerWhereNeeded(picture, profile, where));
}

QImage srgbOf(const QImage& picture, const QByteArray& profile, const QString& where) {
    requireKind(picture, profile, where);
    return withResolutionOf(picture, converted(picture, profile, where, Target::Srgb));
}

} // namespace dipwright
