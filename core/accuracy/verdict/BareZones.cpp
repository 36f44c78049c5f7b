#include "accuracy/verdict/BareZones.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>

namespace dipwright {

void addBareZoneReasons(ReasonList& found, std::span<const Zone> zones,
                        std::span<const std::uint8_t> painted, double limit) {
    std::array<double, zoneCount> all{}, bare{};
    for (std::size_t place = 0; place < zones.size(); ++place) {
        const auto zone = std::size_t(zones[place]);
        all[zone] += 1;
        bare[zone] += painted[place] ? 0 : 1;
    }
    for (const Zone zone : {Zone::A, Zone::B}) {
        const double count = all[std::size_t(zone)];
        found.addShare(VerdictReason::Kind::ZoneBare,
                       count > 0 ? bare[std::size_t(zone)] / count : 0, limit, zone);
    }
}

void addBareBodyReasons(ReasonList& found, const SeparateBodies& bodies,
                        std::span<const SurfacePoint> places, std::span<const std::uint8_t> painted,
                        double least) {
    std::vector<double> all(std::size_t(bodies.names.size())), covered(all.size());
    for (std::size_t place = 0; place < places.size(); ++place) {
        const std::uint32_t body = bodies.ofTriangle[places[place].triangle];
        all[body] += 1;
        covered[body] += painted[place] ? 1 : 0;
    }
    std::vector<std::size_t> largestFirst(all.size());
    std::iota(largestFirst.begin(), largestFirst.end(), std::size_t(0));
    std::ranges::stable_sort(largestFirst, std::greater(), [&](std::size_t i) { return all[i]; });
    std::vector<VerdictReason> bare;
    for (const std::size_t body : largestFirst) {
        const double share = all[body] > 0 ? covered[body] / all[body] : 1;
        if (share < least) {
            bare.push_back({VerdictReason::Kind::BodyBare, Advice::CheckFirst, share, least});
            bare.back().body = bodies.names[qsizetype(body)];
        }
    }
    found.addOfBodies(std::move(bare));
}

} // namespace dipwright
