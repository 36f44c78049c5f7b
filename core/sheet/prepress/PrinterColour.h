// From the colours of film images to those of a printer by its ICC profile (lcms2), and what that
// will look like.
#pragma once

#include "settings/RenderingIntent.h"

#include <QByteArray>
#include <QImage>
#include <array>
#include <memory>

namespace dipwright {

// What of a picture the printer cannot make.
struct GamutWarning {
    QImage mask;      // Format_Grayscale8, the picture's size: 255 where a colour is out of reach
    double share = 0; // of the picture's opaque pixels, 0 … 1
};

// One printer's colour space. Const members may be used from several threads.
class PrinterColour {
public:
    // `iccProfile`: the file of an RGB or CMYK device. `blackPoint`: compensated. Throws Error,
    // naming `where`, for anything else.
    PrinterColour(const QByteArray& iccProfile, RenderingIntent intent, bool blackPoint,
                  const QString& where);
    ~PrinterColour();

    bool isCmyk() const;
    QString description() const; // as the profile calls itself
    const QByteArray& iccProfile() const;

    // Pictures here are in sRGB or wide (base/WideGamut.h).

    // A picture in the printer's RGB, Format_RGBA8888 or RGB888 as it has alpha or not. RGB
    // printers only.
    QImage rgb(const QImage& picture) const;
    // An opaque one in the printer's CMYK: four bytes a pixel, 0 no ink … 255 full, rows without
    // padding. CMYK printers only.
    QByteArray cmyk(const QImage& picture) const;

    // How dense each amount, 0 … 255, of one of the four inks (cyan, magenta, yellow, black) is
    // alone: −log10 of the light it lets through of what bare paper does, red, green or blue of
    // wide colour's primaries, of black all of it; never falling. CMYK printers only.
    std::array<float, 256> inkDensities(int ink) const;

    // The picture as the print will look, in sRGB; keeps alpha.
    QImage softProof(const QImage& picture) const;
    // What four bytes of ink a pixel look like in print, in sRGB. CMYK printers only.
    QImage screen(const QByteArray& cmyk, QSize size) const;
    // Colours whose print differs from them by more than `tolerance` (CIE ΔE 1976).
    GamutWarning gamutWarning(const QImage& picture, double tolerance = 5) const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace dipwright
