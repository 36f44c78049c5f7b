#include "sheet/prepress/PlateCompensation.h"

#include "parallel/ParallelFor.h"
#include "texture/Ink.h"
#include "texture/StretchPlane.h"

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

constexpr int steps = 256; // tabulated values of the stretch; linear in between
constexpr FilmInk inkOrder[4] = {FilmInk::Cyan, FilmInk::Magenta, FilmInk::Yellow, FilmInk::Black};

float stretchAt(int step) {
    return areaStretchOf(std::uint16_t(step * 65535 / steps));
}

float stepOf(float areaStretch) {
    return float(stretchCode(areaStretch)) * steps / 65535;
}

} // namespace

float PlateCompensation::InkTable::density(double amount) const {
    const int below = std::clamp(int(amount), 0, 254);
    const auto share = float(amount - below);
    return densities[std::size_t(below)] +
           share * (densities[std::size_t(below) + 1] - densities[std::size_t(below)]);
}

// Returns the smallest amount with at least this density; full ink if there is none.
double PlateCompensation::InkTable::amount(float density) const {
    const auto above = std::lower_bound(densities.begin(), densities.end(), density);
    if (above == densities.begin() || above == densities.end()) {
        return above == densities.end() ? 255 : 0;
    }
    const float low = *(above - 1);
    return double(above - densities.begin()) - 1 + double((density - low) / (*above - low));
}

PlateCompensation::PlateCompensation(const PrinterColour& colour, const InkSettings& settings)
    : passes_(float(settings.printedPasses())) {
    for (int ink = 0; ink < 4; ++ink) {
        inks_.push_back({Thinning(settings.law, inkOrder[ink]), colour.inkDensities(ink), {}});
    }
    parallelFor(0, 4, [&](int ink) { fill(inks_[std::size_t(ink)], float(settings.limit)); });
}

void PlateCompensation::fill(InkTable& ink, float limit) const {
    ink.printed.reserve(256 * (steps + 1));
    for (int wanted = 0; wanted < 256; ++wanted) {
        const float shows = ink.densities[std::size_t(wanted)];
        for (int step = 0; step <= steps; ++step) {
            if (shows <= 0) {
                ink.printed.push_back(
                    float(wanted)); // without density there is nothing to compensate
                continue;
            }
            const float density = shows * ink.law.byShown(std::log(shows), stretchAt(step));
            const auto amount =
                float(ink.amount(std::min(density / passes_, std::max(limit, shows))));
            const bool isMore = passes_ == 1 && density > shows;
            ink.printed.push_back(isMore ? std::max(amount, float(wanted)) : amount);
        }
    }
}

std::uint8_t PlateCompensation::printed(int ink, std::uint8_t wanted, float areaStretch) const {
    const float step = stepOf(areaStretch);
    const int below = std::min(int(step), steps - 1);
    const float* const amounts =
        &inks_[std::size_t(ink)].printed[std::size_t(wanted) * (steps + 1) + std::size_t(below)];
    const float amount = amounts[0] + (step - float(below)) * (amounts[1] - amounts[0]);
    return std::uint8_t(std::lround(amount));
}

std::uint8_t PlateCompensation::faded(int ink, std::uint8_t amount, float share) const {
    const InkTable& one = inks_[std::size_t(ink)];
    return share < 1 ? std::uint8_t(std::lround(one.amount(share * one.density(amount)))) : amount;
}

double PlateCompensation::shown(int ink, double printed, float areaStretch) const {
    const InkTable& one = inks_[std::size_t(ink)];
    const float density = passes_ * one.density(printed);
    return density > 0 ? one.amount(density / one.law.byPrinted(std::log(density), areaStretch))
                       : printed;
}

bool PlateCompensation::fallsShort(int ink, std::uint8_t wanted, std::uint8_t printed,
                                   float areaStretch) const {
    const InkTable& one = inks_[std::size_t(ink)];
    return one.density(wanted) - one.density(shown(ink, printed, areaStretch)) > visibleDensity;
}

} // namespace dipwright
