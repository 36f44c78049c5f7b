#include "search/PredictedSheet.h"

#include "accuracy/tolerance/Zones.h"
#include "accuracy/verdict/FinerFilm.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dipwright {
namespace {

// The cells of two films that are compared differ at least by this factor.
constexpr double leastRatio = 1.25;

// Returns the least value that at most the share `share` of the values exceed.
double exceededBy(std::vector<float>& values, double share) {
    const auto mayExceed = std::ptrdiff_t(share * double(values.size()));
    const auto nth = values.end() - 1 - mayExceed;
    std::nth_element(values.begin(), nth, values.end());
    return double(*nth);
}

// Returns how often the work is doubled if the cells become smaller by the factor `ratio`: it grows
// with the cube.
double doublingsFor(double ratio) {
    return std::clamp(3 * std::log2(std::max(ratio, 1.0)), 0.0, mostDoublings);
}

} // namespace

double predictedDoublings(const std::vector<PlaceMove>& moves, const ComparedCells& cells,
                          const ToleranceSettings& tolerance) {
    if (!(cells.job > 0) || cells.coarse < leastRatio * cells.finer) {
        return 0;
    }
    // An error of first order is proportional to the cell.
    const double perCell = 1 / (cells.coarse - cells.finer);
    std::array<std::vector<float>, zoneCount> byZone;
    for (const PlaceMove& move : moves) {
        byZone[std::size_t(move.zone)].push_back(move.distance);
    }
    double excess = 0; // error with the job's first cells, relative to what is allowed
    for (std::size_t zone = 0; zone < zoneCount; ++zone) {
        if (byZone[zone].empty()) {
            continue;
        }
        const double most = exceededBy(byZone[zone], 1 - zoneShareWithin) * perCell;
        const double far = exceededBy(byZone[zone], mostFarOffArea) * perCell;
        excess = std::max({excess, cells.job * most / allowedError(Zone(zone), tolerance),
                           cells.job * far / tolerance.limits[zone].value()});
    }
    return doublingsFor(excess);
}

double neededDoublings(const Verdict& verdict, const DippedFilm& film) {
    using Kind = VerdictReason::Kind;
    const double own = film.grid.leastSpacing();
    double ratio = own / wantedCell(verdict, film).value_or(own);
    for (const VerdictReason& reason : verdict.reasons) {
        if (reason.kind == Kind::Refined) {
            return doublingsFor(own / reason.value);
        }
        if (reason.kind == Kind::OffByMuch && reason.limit > 0) {
            ratio = std::max(ratio, reason.value / reason.limit);
        }
    }
    return doublingsFor(ratio);
}

} // namespace dipwright
