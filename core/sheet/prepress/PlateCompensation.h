// Each of a printer's four inks made up for where the film stretches, by its own law
// (docs/film-model.md, "Ink"). After separation: what is to show is an amount of each ink, and so
// is what is printed.
#pragma once

#include "settings/InkSettings.h"
#include "sheet/prepress/PrinterColour.h"
#include "texture/Thinning.h"

#include <array>
#include <cstdint>
#include <vector>

namespace dipwright {

// How dense an ink is by its amount comes from the printer's ICC profile: −log10 of the light that
// it lets through alone, red, green or blue of wide colour's primaries, of black all three. Const
// members may be used from several threads.
class PlateCompensation {
public:
    // The colour must be in CMYK.
    PlateCompensation(const PrinterColour& colour, const InkSettings& settings);

    // The amount, 0 … 255, to print of ink `ink` so that `wanted` shows where the film's area has
    // grown by `areaStretch`: at most full ink, and no more than the density limit but for what was
    // wanted.
    std::uint8_t printed(int ink, std::uint8_t wanted, float areaStretch) const;
    // The amount of it, 0 … 255, that is as dense on film that is not stretched.
    double shown(int ink, double printed, float areaStretch) const;
    // Whether what is shown is visibly paler than `wanted`.
    bool fallsShort(int ink, std::uint8_t wanted, std::uint8_t printed, float areaStretch) const;

private:
    struct OneInk {
        Thinning law;
        std::array<float, 256> densities; // never falling
        std::vector<float> printed;       // amounts by wanted amount and by the stretch's step

        float density(double amount) const;
        double amount(float density) const;
    };
    void fill(OneInk& ink, float limit) const;

    std::vector<OneInk> inks_;
};

} // namespace dipwright
