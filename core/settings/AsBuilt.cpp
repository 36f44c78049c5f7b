#include "settings/AsBuilt.h"

#include <set>
#include <utility>

namespace dipwright {
namespace {

std::optional<bool> isAlike(const AsBuilt& built, const BuiltPlace& place,
                            const QStringList& dips) {
    const auto part = std::size_t(place.part) - 1;
    return part < built.parts.size() ? isDippedAlike(built.parts[part], place.dip, dips)
                                     : std::nullopt;
}

} // namespace

std::optional<bool> isDippedAlike(const BuiltPart& part, int dip, const QStringList& dips) {
    if (part.dips.isEmpty()) {
        return std::nullopt;
    }
    const QString key = part.dips.split(u' ').value(dip - 1);
    return !key.isEmpty() && key == dips.value(dip - 1);
}

AsBuilt withTankRun(AsBuilt built, std::vector<TankTime> times) {
    const int run = built.times.empty() ? 1 : built.times.back().run + 1;
    for (TankTime& time : times) {
        time.run = run;
        built.times.push_back(std::move(time));
    }
    while (built.times.size() > mostTankTimes) {
        const int oldest = built.times.front().run;
        std::erase_if(built.times, [&](const TankTime& time) { return time.run == oldest; });
    }
    return built;
}

AsBuilt dippedAlike(AsBuilt built, const QStringList& dips) {
    std::erase_if(built.places, [&](const BuiltPlace& place) {
        return place.dip > dips.size() || !isAlike(built, place, dips).value_or(true);
    });
    return built;
}

BuiltPartCounts countParts(const AsBuilt& built, int dip, const QStringList& dips) {
    BuiltPartCounts parts;
    std::set<int> counted;
    for (const BuiltPlace& place : built.places) {
        if (place.dip == dip && dip <= dips.size() && counted.insert(place.part).second) {
            const std::optional<bool> alike = isAlike(built, place, dips);
            ++(!alike ? parts.unknown : *alike ? parts.alike : parts.otherwise);
        }
    }
    return parts;
}

} // namespace dipwright
