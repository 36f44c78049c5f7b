// From the colours of film images to those of a printer by its ICC profile (lcms2), and what that
// will look like.
#pragma once

#include <QByteArray>
#include <QImage>
#include <memory>

namespace dipwright {

// How colours that the printer cannot make are dealt with (ICC.1, rendering intents).
enum class RenderingIntent { Perceptual, RelativeColorimetric, Saturation, AbsoluteColorimetric };

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

    // Pictures here are in sRGB or wide (base/WideColour.h).

    // A picture in the printer's RGB, Format_RGBA8888 or RGB888 as it has alpha or not. RGB
    // printers only.
    QImage rgb(const QImage& picture) const;
    // An opaque one in the printer's CMYK: four bytes a pixel, 0 no ink … 255 full, rows without
    // padding. CMYK printers only.
    QByteArray cmyk(const QImage& picture) const;

    // The picture as the print will look, in sRGB; keeps alpha.
    QImage softProof(const QImage& picture) const;
    // Colours whose print differs from them by more than `tolerance` (CIE ΔE 1976).
    GamutWarning gamutWarning(const QImage& picture, double tolerance = 5) const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace dipwright
