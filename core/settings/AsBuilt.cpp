#include "settings/AsBuilt.h"

#include <utility>

namespace dipwright {

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

} // namespace dipwright
