#include "search/PlaceWeights.h"

#include "accuracy/tolerance/Zones.h"

#include <algorithm>

namespace dipwright {
namespace {

// A place needs no ink if its reflectance is at least this in each of red, green and blue. The sRGB
// value 254 of 255 is a reflectance of 0.991.
constexpr float blankFrom = 0.98f;

} // namespace

std::vector<float> placeWeights(const SearchSubject& subject,
                                const std::array<double, zoneCount>& zoneWeights,
                                const std::vector<SurfacePoint>& places,
                                const std::vector<LinearColour>& colours) {
    std::vector<float> weights(places.size(), 1.f);
    if (!subject.tolerance.marks.empty()) {
        ZonedBody zoned(subject.model);
        zoned.setMarks(subject.tolerance.marks);
        std::transform(places.begin(), places.end(), weights.begin(),
                       [&](const SurfacePoint& place) {
                           return float(zoneWeights[std::size_t(zoned.at(place))]);
                       });
    }
    for (std::size_t place = 0; subject.mask && place < places.size(); ++place) {
        weights[place] = subject.mask->covers(places[place]) ? 0 : weights[place];
    }
    if (subject.isWhitePrinted) {
        return weights;
    }
    std::vector<float> inked = weights;
    for (std::size_t place = 0; place < places.size(); ++place) {
        if (colours[place].minCoeff() >= blankFrom) {
            inked[place] = 0;
        }
    }
    const bool isAnyInked =
        std::any_of(inked.begin(), inked.end(), [](float weight) { return weight > 0; });
    return isAnyInked ? inked : weights;
}

} // namespace dipwright
