#include "accuracy/verdict/BareZones.h"

#include <array>

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

} // namespace dipwright
