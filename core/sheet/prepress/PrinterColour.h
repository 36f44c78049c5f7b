// Converts film images to a printer's colours by its ICC profile (lcms2), and predicts how the
// print will look.
#pragma once

#include "settings/Profile.h"

#include <QByteArray>
#include <QImage>
#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace dipwright {

// The part of a picture that the printer cannot reproduce.
struct GamutWarning {
    QImage mask;      // Format_Grayscale8, the picture's size: 255 where a colour is out of gamut
    double share = 0; // share of the picture's opaque pixels, 0 … 1
};

// The colour space of one printer. Const members may be used from several threads.
class PrinterColour {
public:
    // `iccProfile` is the file of an RGB or CMYK device. `blackPoint` turns on black point
    // compensation. Throws Error, naming `where`, if the file is not such a profile.
    PrinterColour(const QByteArray& iccProfile, RenderingIntent intent, bool blackPoint,
                  const QString& where);
    // Takes ICC profile, intent, black point, kept inks and device link from a printer profile. An
    // RGB printer ignores the last two. Throws Error also if the device link does not lead from RGB
    // or CMYK to CMYK.
    PrinterColour(const PrinterProfile& printer, const QString& where);
    ~PrinterColour();

    bool isCmyk() const;
    QString description() const; // the profile's own name
    const QByteArray& iccProfile() const;

    // Pictures below are in sRGB or wide colour (base/WideGamut.h).

    // Converts a picture to the printer's RGB: Format_RGBA8888 if the picture has alpha, else
    // RGB888. RGB printers only.
    QImage rgb(const QImage& picture) const;
    // Converts an opaque picture to the printer's CMYK: four bytes per pixel, 0 no ink … 255 full,
    // rows without padding. CMYK printers only.
    QByteArray cmyk(const QImage& picture) const;

    // Converts amounts of ink in the space `space` (base/InkPicture.h) to the printer's. `amounts`
    // has four bytes per pixel. By the device link, if it is for CMYK. Otherwise amounts in the
    // printer's own space stay as they are, in another space only those of pixels in one of the
    // kept inks. `separated` holds the printer's amounts for the same colours; the other pixels get
    // these. CMYK printers only.
    void convertInks(std::span<std::uint8_t> amounts, const QString& space,
                     std::span<const std::uint8_t> separated) const;

    // Returns the density of each amount, 0 … 255, of one ink alone (cyan, magenta, yellow, black).
    // The density is −log10 of the light relative to bare paper. The light is the red, green or
    // blue primary of wide colour; for black it is the luminance. Never decreasing. CMYK printers
    // only.
    std::array<float, 256> inkDensities(int ink) const;

    // Returns the picture as the print will look, in sRGB. Keeps alpha.
    QImage softProof(const QImage& picture) const;
    // Returns how a picture of four bytes of ink per pixel looks in print, in sRGB. CMYK printers
    // only.
    QImage screen(const QByteArray& cmyk, QSize size) const;
    // Finds colours that differ in print by more than `tolerance` (CIE ΔE 1976).
    GamutWarning gamutWarning(const QImage& picture, double tolerance = 5) const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace dipwright
