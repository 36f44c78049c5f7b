// Summarises the numerical error of the painted film by zone and finds the places to check. Private
// to this folder: a Verdict holds the result.
#pragma once

#include "accuracy/tolerance/Zones.h"
#include "accuracy/verdict/Verdict.h"
#include "dip/LaidFilm.h"

#include <vector>

namespace dipwright {

// The numerical error of the painted film in a zone.
struct ZoneError {
    Zone zone = Zone::C;
    double limit = 0;        // of the zone, mm
    double area = 0;         // mm² of the body that are painted and compared
    double percentile95 = 0; // numerical error that 95 % of that area do not exceed, mm
    double far = 0;          // share of that area whose numerical error exceeds the limit
};

struct PlacesToCheck {
    std::vector<ZoneError> zones; // only painted zones, A first
    std::vector<PlaceToCheck> places;
    double area = 0; // of all places to check, mm²
};

// `pointErrors`: NumericalErrorEstimate::pointErrors; empty if the error is not known. `zones`:
// null if the whole body is in zone C.
PlacesToCheck placesToCheck(const LaidFilm& laid, const std::vector<float>& pointErrors,
                            const ZonedBody* zones, const ToleranceSettings& settings);

} // namespace dipwright
