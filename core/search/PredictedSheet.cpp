#include "search/PredictedSheet.h"

#include "accuracy/tolerance/Zones.h"
#include "accuracy/verdict/Verdict.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dipwright {
namespace {

constexpr double million = 1e6;
// The cells of two films that are compared differ at least by this factor.
constexpr double leastRatio = 1.25;
// A prediction of more doublings means only that the cells are far from sufficient.
constexpr double mostDoublings = 12;

// Returns the value that at most the share `share` of the values exceed.
double exceededBy(std::vector<float>& values, double share) {
    const auto nth = values.begin() + std::ptrdiff_t((1 - share) * double(values.size() - 1));
    std::nth_element(values.begin(), nth, values.end());
    return double(*nth);
}

} // namespace

double workOf(std::size_t points, double steps) {
    return double(points) * steps / million;
}

double predictedDoublings(const std::vector<PlaceMove>& moves, const ComparedFilms& films,
                          const ToleranceSettings& tolerance) {
    if (!(films.job.cell > 0) || films.coarse.cell < leastRatio * films.finer.cell) {
        return 0;
    }
    // An error of first order is proportional to the cell.
    const double perCell = 1 / (films.coarse.cell - films.finer.cell);
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
        excess = std::max({excess, films.job.cell * most / allowedError(Zone(zone), tolerance),
                           films.job.cell * far / tolerance.limits[zone].value()});
    }
    // The work grows with the cube of the ratio of the cells.
    return std::clamp(3 * std::log2(std::max(excess, 1.0)), 0.0, mostDoublings);
}

} // namespace dipwright
