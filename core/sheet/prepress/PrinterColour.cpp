#include "sheet/prepress/PrinterColour.h"

#include "base/Error.h"
#include "base/InkPicture.h"
#include "base/WideGamut.h"
#include "parallel/ParallelFor.h"
#include "texture/LinearLight.h"

#include <QColorSpace>
#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <lcms2.h>
#include <vector>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::PrinterColour)
};

struct CloseProfile {
    void operator()(void* profile) const { cmsCloseProfile(profile); }
};
using ProfileHandle = std::unique_ptr<void, CloseProfile>;

struct DeleteTransform {
    void operator()(void* transform) const { cmsDeleteTransform(transform); }
};
using TransformHandle = std::unique_ptr<void, DeleteTransform>;

TransformHandle required(cmsHTRANSFORM transform, const QString& where) {
    if (!transform) {
        throw Error(Text::tr("This ICC profile cannot be used for printing; choose the printer's "
                             "output profile"),
                    where);
    }
    return TransformHandle(transform);
}

constexpr cmsUInt32Number cmsIntent(RenderingIntent intent) {
    switch (intent) {
    case RenderingIntent::Perceptual:
        return INTENT_PERCEPTUAL;
    case RenderingIntent::RelativeColorimetric:
        return INTENT_RELATIVE_COLORIMETRIC;
    case RenderingIntent::Saturation:
        return INTENT_SATURATION;
    case RenderingIntent::AbsoluteColorimetric:
        break;
    }
    return INTENT_ABSOLUTE_COLORIMETRIC;
}

QImage withAlphaOf(const QImage& picture, const QImage& opaque) {
    if (!picture.hasAlphaChannel()) {
        return opaque;
    }
    const QImage alpha = picture.convertToFormat(QImage::Format_Alpha8);
    QImage result = opaque.convertToFormat(QImage::Format_RGBA8888);
    for (int y = 0; y < result.height(); ++y) {
        uchar* pixel = result.scanLine(y);
        for (int x = 0; x < result.width(); ++x) {
            pixel[4 * x + 3] = alpha.constScanLine(y)[x];
        }
    }
    return result;
}

// The transforms for pictures in one colour space.
struct FromPicture {
    TransformHandle toPrinter;
    TransformHandle wanted; // to Lab
};

// Returns the amount of black alone for each grey in sRGB. Paper and full black are its ends, as
// with black point compensation. `densities` are those of the amounts of black.
std::array<uchar, 256> blackOfGreys(const std::array<float, 256>& densities) {
    std::array<uchar, 256> amounts{};
    const double darkest = std::pow(10, -double(densities.back()));
    for (std::size_t grey = 0; grey < amounts.size(); ++grey) {
        const double light = darkest + (1 - darkest) * linearFromSrgb(double(grey) / 255);
        const auto above =
            std::lower_bound(densities.begin(), densities.end(), float(-std::log10(light)) - 1e-5F);
        amounts[grey] = uchar(std::min<std::ptrdiff_t>(above - densities.begin(), 255));
    }
    amounts[0] = 255;
    return amounts;
}

QImage opaque(const QImage& picture) {
    return picture.convertToFormat(isWide(picture) ? QImage::Format_RGBX64 : QImage::Format_RGB888);
}

} // namespace

struct PrinterColour::Data {
    QByteArray icc;
    ProfileHandle printer;
    bool cmyk = false;
    FromPicture fromSrgb;     // RGB888
    FromPicture fromWide;     // RGBX64
    TransformHandle toScreen; // from printer colours to sRGB, relative to the paper
    TransformHandle printed;  // from printer colours to Lab
    KeptInks kept = KeptInks::None;
    QString space;                     // iccIdentity() of `icc`
    TransformHandle rgbLink, cmykLink; // by the device link, from RGB888 or four bytes; may be null
    std::array<uchar, 256> blackOfGrey{}; // amounts of black alone; only if black is kept

    int channels() const { return cmyk ? 4 : 3; }
    const FromPicture& from(const QImage& opaque) const {
        return isWide(opaque) ? fromWide : fromSrgb;
    }

    // Converts a row of an opaque picture to the printer's bytes.
    std::vector<uchar> printerRow(const QImage& opaque, int y) const {
        std::vector<uchar> row(std::size_t(opaque.width()) * std::size_t(channels()));
        const auto width = cmsUInt32Number(opaque.width());
        if (rgbLink) {
            const QImage srgb =
                inSrgb(opaque.copy(0, y, opaque.width(), 1)).convertToFormat(QImage::Format_RGB888);
            cmsDoTransform(rgbLink.get(), srgb.constBits(), row.data(), width);
        } else {
            cmsDoTransform(from(opaque).toPrinter.get(), opaque.constScanLine(y), row.data(),
                           width);
        }
        if (kept != KeptInks::None) {
            keepBlack(opaque, y, row);
        }
        return row;
    }
    // Prints the greys of a row in black alone.
    void keepBlack(const QImage& opaque, int y, std::vector<uchar>& row) const {
        const auto keep = [&](const auto* pixel, int step, int perByte) {
            for (std::size_t at = 0; at < row.size(); at += 4, pixel += step) {
                if (pixel[0] == pixel[1] && pixel[1] == pixel[2]) {
                    row[at] = row[at + 1] = row[at + 2] = 0;
                    row[at + 3] = blackOfGrey[std::size_t(pixel[0] / perByte)];
                }
            }
        };
        if (isWide(opaque)) {
            keep(reinterpret_cast<const quint16*>(opaque.constScanLine(y)), 4, 257);
        } else {
            keep(opaque.constScanLine(y), 3, 1);
        }
    }
    void takeLink(const QByteArray& link, const QString& where);
};

void PrinterColour::Data::takeLink(const QByteArray& link, const QString& where) {
    // The header's class, input space and output space (ICC.1, 7.2).
    const QByteArray from = link.mid(16, 4);
    const bool isLink = link.mid(12, 4) == "link" && (from == "RGB " || from == "CMYK") &&
                        link.mid(20, 4) == "CMYK";
    const ProfileHandle profile(
        isLink ? cmsOpenProfileFromMem(link.constData(), cmsUInt32Number(link.size())) : nullptr);
    const cmsUInt32Number pixels = from == "CMYK" ? TYPE_CMYK_8 : TYPE_RGB_8;
    TransformHandle transform(profile
                                  ? cmsCreateTransform(profile.get(), pixels, nullptr, TYPE_CMYK_8,
                                                       INTENT_PERCEPTUAL, cmsFLAGS_NOCACHE)
                                  : nullptr);
    if (!transform) {
        throw Error(Text::tr("This file is not an ICC device link from RGB or CMYK to CMYK, or it "
                             "is damaged; choose another file"),
                    where);
    }
    (from == "CMYK" ? cmykLink : rgbLink) = std::move(transform);
}

PrinterColour::PrinterColour(const QByteArray& iccProfile, RenderingIntent intent, bool blackPoint,
                             const QString& where)
    : data_(std::make_unique<Data>()) {
    Data& d = *data_;
    d.icc = iccProfile;
    d.printer.reset(
        cmsOpenProfileFromMem(iccProfile.constData(), cmsUInt32Number(iccProfile.size())));
    if (!d.printer) {
        throw Error(
            Text::tr("This file is not an ICC profile, or it is damaged; choose another file"),
            where);
    }
    // Compares the header's bytes. cmsGetColorSpace() would return an enumeration that has no value
    // for unknown bytes.
    const QByteArray space = iccProfile.mid(16, 4);
    if (space != "RGB " && space != "CMYK") {
        throw Error(Text::tr("This ICC profile does not belong to an RGB or CMYK printer; choose "
                             "the printer's output profile"),
                    where);
    }
    d.cmyk = space == "CMYK";
    const ProfileHandle screen(cmsCreate_sRGBProfile());
    const QByteArray wideIcc = wideSpace().iccProfile();
    const ProfileHandle wide(
        cmsOpenProfileFromMem(wideIcc.constData(), cmsUInt32Number(wideIcc.size())));
    const ProfileHandle lab(cmsCreateLab4Profile(nullptr));
    const cmsUInt32Number device = d.cmyk ? TYPE_CMYK_8 : TYPE_RGB_8;
    // Without lcms2's one-pixel cache, several threads may use a transform at the same time.
    const cmsUInt32Number blackPointFlag = blackPoint ? cmsFLAGS_BLACKPOINTCOMPENSATION : 0u;
    const cmsUInt32Number relative = INTENT_RELATIVE_COLORIMETRIC;
    const auto way = [&](const ProfileHandle& from, cmsUInt32Number pixels, cmsUInt32Number flags) {
        return FromPicture{required(cmsCreateTransform(from.get(), pixels, d.printer.get(), device,
                                                       cmsIntent(intent), flags | blackPointFlag),
                                    where),
                           required(cmsCreateTransform(from.get(), pixels, lab.get(), TYPE_Lab_DBL,
                                                       relative, flags),
                                    where)};
    };
    d.fromSrgb = way(screen, TYPE_RGB_8, cmsFLAGS_NOCACHE);
    // NOOPTIMIZE, because optimised lookup tables are too coarse for 16 bits.
    d.fromWide = way(wide, TYPE_RGBA_16, cmsFLAGS_NOCACHE | cmsFLAGS_NOOPTIMIZE);
    d.toScreen = required(cmsCreateTransform(d.printer.get(), device, screen.get(), TYPE_RGB_8,
                                             relative, cmsFLAGS_NOCACHE),
                          where);
    d.printed = required(cmsCreateTransform(d.printer.get(), device, lab.get(), TYPE_Lab_DBL,
                                            relative, cmsFLAGS_NOCACHE),
                         where);
    d.space = iccIdentity(iccProfile);
}

PrinterColour::PrinterColour(const PrinterProfile& printer, const QString& where)
    : PrinterColour(printer.iccProfile, printer.intent, printer.blackPoint, where) {
    if (!isCmyk()) {
        return;
    }
    if (!printer.deviceLink.isEmpty()) {
        data_->takeLink(printer.deviceLink, where);
    }
    if (printer.keptInks != KeptInks::None) {
        data_->kept = printer.keptInks;
        data_->blackOfGrey = blackOfGreys(inkDensities(3));
    }
}

PrinterColour::~PrinterColour() = default;

bool PrinterColour::isCmyk() const {
    return data_->cmyk;
}

QString PrinterColour::description() const {
    std::vector<char> text(256, '\0');
    cmsGetProfileInfoASCII(data_->printer.get(), cmsInfoDescription, "en", "US", text.data(),
                           cmsUInt32Number(text.size() - 1));
    return QString::fromLatin1(text.data());
}

const QByteArray& PrinterColour::iccProfile() const {
    return data_->icc;
}

QImage PrinterColour::rgb(const QImage& picture) const {
    Q_ASSERT(!isCmyk());
    const QImage source = opaque(picture);
    QImage result(source.size(), QImage::Format_RGB888); // holds printer colours
    uchar* const bits = result.bits();
    parallelFor(0, source.height(), [&, stride = result.bytesPerLine()](int y) {
        const std::vector<uchar> row = data_->printerRow(source, y);
        std::copy(row.begin(), row.end(), bits + y * stride);
    });
    return withAlphaOf(picture, result);
}

QByteArray PrinterColour::cmyk(const QImage& picture) const {
    Q_ASSERT(isCmyk());
    const QImage source = opaque(picture);
    const qsizetype stride = qsizetype(source.width()) * 4;
    QByteArray result(stride * source.height(), Qt::Uninitialized);
    char* const bytes = result.data();
    parallelFor(0, source.height(), [&](int y) {
        const std::vector<uchar> row = data_->printerRow(source, y);
        std::copy(row.begin(), row.end(), bytes + y * stride);
    });
    return result;
}

void PrinterColour::convertInks(std::span<std::uint8_t> amounts, const QString& space,
                                std::span<const std::uint8_t> separated) const {
    Q_ASSERT(isCmyk() && amounts.size() == separated.size());
    if (data_->cmykLink) {
        std::vector<std::uint8_t> linked(amounts.size());
        cmsDoTransform(data_->cmykLink.get(), amounts.data(), linked.data(),
                       cmsUInt32Number(amounts.size() / 4));
        std::copy(linked.begin(), linked.end(), amounts.begin());
        return;
    }
    if (space == data_->space) {
        return;
    }
    for (std::size_t at = 0; at < amounts.size(); at += 4) {
        const auto pixel = amounts.subspan(at, 4);
        const auto inks = 4 - std::count(pixel.begin(), pixel.end(), 0);
        const bool isPure = inks == 1 && (pixel[3] != 0 || data_->kept == KeptInks::Pure);
        const bool isBare = inks == 0;
        if (data_->kept == KeptInks::None || !(isPure || isBare)) {
            std::copy_n(separated.begin() + std::ptrdiff_t(at), 4, pixel.begin());
        }
    }
}

std::array<float, 256> PrinterColour::inkDensities(int ink) const {
    Q_ASSERT(isCmyk() && ink >= 0 && ink < 4);
    constexpr double leastLight = 1e-4;
    // An RGB profile in linear light with the primaries of wide colour (BT.2020).
    const cmsCIExyY white{0.3127, 0.3290, 1};
    const cmsCIExyYTRIPLE primaries{{0.708, 0.292, 1}, {0.170, 0.797, 1}, {0.131, 0.046, 1}};
    const std::unique_ptr<cmsToneCurve, void (*)(cmsToneCurve*)> linear(
        cmsBuildGamma(nullptr, 1), [](cmsToneCurve* curve) { cmsFreeToneCurve(curve); });
    cmsToneCurve* curves[3] = {linear.get(), linear.get(), linear.get()};
    const ProfileHandle light(cmsCreateRGBProfile(&white, &primaries, curves));
    const TransformHandle shown = required(
        cmsCreateTransform(data_->printer.get(), TYPE_CMYK_8, light.get(), TYPE_RGB_FLT,
                           INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOCACHE | cmsFLAGS_NOOPTIMIZE),
        description());
    std::array<float, 256> densities{};
    double bare = 1;
    for (int amount = 0; amount < 256; ++amount) {
        std::array<uchar, 4> inks{};
        inks[std::size_t(ink)] = uchar(amount);
        std::array<float, 3> rgb{};
        cmsDoTransform(shown.get(), inks.data(), rgb.data(), 1);
        const double through =
            ink < 3 ? double(rgb[std::size_t(ink)])
                    : 0.2627 * double(rgb[0]) + 0.6780 * double(rgb[1]) + 0.0593 * double(rgb[2]);
        bare = amount == 0 ? std::max(through, leastLight) : bare;
        const double density = -std::log10(std::max(through / bare, leastLight));
        densities[std::size_t(amount)] =
            std::max(float(density), amount == 0 ? 0.0f : densities[std::size_t(amount) - 1]);
    }
    return densities;
}

QImage PrinterColour::softProof(const QImage& picture) const {
    const QImage source = opaque(picture);
    QImage proof(source.size(), QImage::Format_RGB888);
    uchar* const bits = proof.bits();
    parallelFor(0, source.height(), [&, stride = proof.bytesPerLine()](int y) {
        const std::vector<uchar> row = data_->printerRow(source, y);
        cmsDoTransform(data_->toScreen.get(), row.data(), bits + y * stride,
                       cmsUInt32Number(source.width()));
    });
    return withAlphaOf(picture, proof);
}

QImage PrinterColour::screen(const QByteArray& cmyk, QSize size) const {
    Q_ASSERT(isCmyk() && cmyk.size() == qsizetype(size.width()) * size.height() * 4);
    QImage shown(size, QImage::Format_RGB888);
    uchar* const bits = shown.bits();
    parallelFor(0, size.height(), [&, stride = shown.bytesPerLine()](int y) {
        cmsDoTransform(data_->toScreen.get(), cmyk.constData() + qsizetype(y) * size.width() * 4,
                       bits + y * stride, cmsUInt32Number(size.width()));
    });
    return shown;
}

GamutWarning PrinterColour::gamutWarning(const QImage& picture, double tolerance) const {
    const QImage source = opaque(picture);
    const QImage alpha = picture.convertToFormat(QImage::Format_Alpha8);
    const auto width = std::size_t(source.width());
    GamutWarning warning;
    warning.mask = QImage(source.size(), QImage::Format_Grayscale8);
    warning.mask.fill(0);
    std::vector<cmsCIELab> wanted(width);
    std::vector<cmsCIELab> printed(width);
    qint64 counted = 0;
    qint64 outside = 0;
    for (int y = 0; y < source.height(); ++y) {
        const std::vector<uchar> row = data_->printerRow(source, y);
        cmsDoTransform(data_->from(source).wanted.get(), source.constScanLine(y), wanted.data(),
                       cmsUInt32Number(width));
        cmsDoTransform(data_->printed.get(), row.data(), printed.data(), cmsUInt32Number(width));
        for (std::size_t x = 0; x < width; ++x) {
            if (alpha.constScanLine(y)[x] == 0) {
                continue;
            }
            ++counted;
            if (cmsDeltaE(&wanted[x], &printed[x]) > tolerance) {
                warning.mask.scanLine(y)[x] = 255;
                ++outside;
            }
        }
    }
    warning.share = counted > 0 ? double(outside) / double(counted) : 0;
    return warning;
}

} // namespace dipwright
