// Compensates each of a printer's four inks for the stretch of the film, by the ink's own law
// (docs/film-model.md, "Ink"). The compensation is done after the separation, and changes the
// amount of each ink. Printed amounts are those of one pass; all passes lie on one another.
#pragma once

#include "settings/InkSettings.h"
#include "sheet/prepress/PrinterColour.h"
#include "texture/Thinning.h"

#include <array>
#include <cstdint>
#include <vector>

namespace dipwright {

// The printer's ICC profile gives the density of each amount of ink: −log10 of the light that this
// ink alone lets through. The light is the red, green or blue primary of wide colour; for black it
// is all three. Const members may be used from several threads.
class PlateCompensation {
public:
    // `colour` must be CMYK.
    PlateCompensation(const PrinterColour& colour, const InkSettings& settings);

    // Returns the amount to print of ink `ink`, 0 … 255, so that film whose area has grown by
    // `areaStretch` looks like the amount `wanted` on unstretched film. Never more than full ink.
    // Keeps the density within the ink limit unless `wanted` itself is denser.
    std::uint8_t printed(int ink, std::uint8_t wanted, float areaStretch) const;
    // Returns the amount with `share`, 0 … 1, of the density of `amount`.
    std::uint8_t faded(int ink, std::uint8_t amount, float share) const;
    // Returns the amount, 0 … 255, that has the same density on unstretched film as `printed` has
    // on this stretched film.
    double shown(int ink, double printed, float areaStretch) const;
    // Tells whether the result of printing `printed` is visibly paler than `wanted`.
    bool fallsShort(int ink, std::uint8_t wanted, std::uint8_t printed, float areaStretch) const;

private:
    struct InkTable {
        Thinning law;
        std::array<float, 256> densities; // never decreasing
        std::vector<float> printed;       // amounts; the steps of the stretch vary fastest

        float density(double amount) const;
        double amount(float density) const;
    };
    void fill(InkTable& ink, float limit) const;

    float passes_;
    std::vector<InkTable> inks_;
};

} // namespace dipwright
