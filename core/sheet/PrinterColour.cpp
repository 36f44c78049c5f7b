#include "sheet/PrinterColour.h"

#include "base/Error.h"

#include <QColorSpace>
#include <QCoreApplication>
#include <algorithm>
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
        throw Error(
            Text::tr("The ICC profile cannot be used for printing, choose the printer's output "
                     "profile"),
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

} // namespace

struct PrinterColour::Data {
    QByteArray icc;
    ProfileHandle printer;
    bool cmyk = false;
    TransformHandle toPrinter; // from sRGB
    TransformHandle toScreen;  // from the printer, to sRGB, relative to the paper
    TransformHandle wanted;    // from sRGB, to Lab
    TransformHandle printed;   // from the printer, to Lab

    int channels() const { return cmyk ? 4 : 3; }

    // One row of opaque sRGB as the printer's bytes.
    std::vector<uchar> printerRow(const uchar* rgb, int width) const {
        std::vector<uchar> row(std::size_t(width) * std::size_t(channels()));
        cmsDoTransform(toPrinter.get(), rgb, row.data(), cmsUInt32Number(width));
        return row;
    }
};

PrinterColour::PrinterColour(const QByteArray& iccProfile, RenderingIntent intent, bool blackPoint,
                             const QString& where)
    : data_(std::make_unique<Data>()) {
    Data& d = *data_;
    d.icc = iccProfile;
    d.printer.reset(
        cmsOpenProfileFromMem(iccProfile.constData(), cmsUInt32Number(iccProfile.size())));
    if (!d.printer) {
        throw Error(Text::tr("This is not an ICC profile, or it is damaged"), where);
    }
    // The header's word, and not cmsGetColorSpace: that returns an enumeration, of which any other
    // word is no value.
    const QByteArray space = iccProfile.mid(16, 4);
    if (space != "RGB " && space != "CMYK") {
        throw Error(
            Text::tr("The ICC profile is not of an RGB or CMYK printer, choose the printer's "
                     "output profile"),
            where);
    }
    d.cmyk = space == "CMYK";
    const ProfileHandle screen(cmsCreate_sRGBProfile());
    const ProfileHandle lab(cmsCreateLab4Profile(nullptr));
    const cmsUInt32Number device = d.cmyk ? TYPE_CMYK_8 : TYPE_RGB_8;
    // Without the one-pixel cache a transform may be used by several threads at once.
    const cmsUInt32Number flags =
        cmsFLAGS_NOCACHE | (blackPoint ? cmsFLAGS_BLACKPOINTCOMPENSATION : 0u);
    const cmsUInt32Number relative = INTENT_RELATIVE_COLORIMETRIC;
    d.toPrinter = required(cmsCreateTransform(screen.get(), TYPE_RGB_8, d.printer.get(), device,
                                              cmsIntent(intent), flags),
                           where);
    d.toScreen = required(cmsCreateTransform(d.printer.get(), device, screen.get(), TYPE_RGB_8,
                                             relative, cmsFLAGS_NOCACHE),
                          where);
    d.wanted = required(cmsCreateTransform(screen.get(), TYPE_RGB_8, lab.get(), TYPE_Lab_DBL,
                                           relative, cmsFLAGS_NOCACHE),
                        where);
    d.printed = required(cmsCreateTransform(d.printer.get(), device, lab.get(), TYPE_Lab_DBL,
                                            relative, cmsFLAGS_NOCACHE),
                         where);
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
    QImage result = picture.convertToFormat(QImage::Format_RGB888);
    result.setColorSpace(QColorSpace()); // its numbers are the printer's from here on
    for (int y = 0; y < result.height(); ++y) {
        const std::vector<uchar> row = data_->printerRow(result.constScanLine(y), result.width());
        std::copy(row.begin(), row.end(), result.scanLine(y));
    }
    return withAlphaOf(picture, result);
}

QByteArray PrinterColour::cmyk(const QImage& picture) const {
    Q_ASSERT(isCmyk());
    const QImage source = picture.convertToFormat(QImage::Format_RGB888);
    QByteArray result;
    result.reserve(qsizetype(source.width()) * source.height() * 4);
    for (int y = 0; y < source.height(); ++y) {
        const std::vector<uchar> row = data_->printerRow(source.constScanLine(y), source.width());
        result.append(reinterpret_cast<const char*>(row.data()), qsizetype(row.size()));
    }
    return result;
}

QImage PrinterColour::softProof(const QImage& picture) const {
    QImage proof = picture.convertToFormat(QImage::Format_RGB888);
    for (int y = 0; y < proof.height(); ++y) {
        const std::vector<uchar> row = data_->printerRow(proof.constScanLine(y), proof.width());
        cmsDoTransform(data_->toScreen.get(), row.data(), proof.scanLine(y),
                       cmsUInt32Number(proof.width()));
    }
    return withAlphaOf(picture, proof);
}

GamutWarning PrinterColour::gamutWarning(const QImage& picture, double tolerance) const {
    const QImage source = picture.convertToFormat(QImage::Format_RGBA8888);
    const QImage opaque = source.convertToFormat(QImage::Format_RGB888);
    const auto width = std::size_t(source.width());
    GamutWarning warning;
    warning.mask = QImage(source.size(), QImage::Format_Grayscale8);
    warning.mask.fill(0);
    std::vector<cmsCIELab> wanted(width);
    std::vector<cmsCIELab> printed(width);
    qint64 counted = 0;
    qint64 outside = 0;
    for (int y = 0; y < source.height(); ++y) {
        const std::vector<uchar> row = data_->printerRow(opaque.constScanLine(y), source.width());
        cmsDoTransform(data_->wanted.get(), opaque.constScanLine(y), wanted.data(),
                       cmsUInt32Number(width));
        cmsDoTransform(data_->printed.get(), row.data(), printed.data(), cmsUInt32Number(width));
        for (std::size_t x = 0; x < width; ++x) {
            if (source.constScanLine(y)[4 * x + 3] == 0) {
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
