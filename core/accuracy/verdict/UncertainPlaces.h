// The painted film by how far it may be off for numerical reasons, zone by zone, and the places of
// it to look at. Private to this folder: a Verdict has what comes of it.
#pragma once

#include "accuracy/tolerance/Zones.h"
#include "accuracy/verdict/Verdict.h"
#include "dip/LaidFilm.h"

#include <vector>

namespace dipwright {

// How far the painted film of a zone may be off.
struct ZoneError {
    Zone zone = Zone::C;
    double limit = 0;        // of the zone, mm
    double area = 0;         // mm² of the body that are painted and compared
    double percentile95 = 0; // of that area, mm
    double far = 0;          // share of that area that may be off by more than the limit
};

struct UncertainPlaces {
    std::vector<ZoneError> zones; // those that are painted, A first
    std::vector<UncertainPlace> places;
    double area = 0; // of all such places, mm²
};

// `pointsOffBy`: as CertaintyEstimate has it; empty: nothing is known of it. `zones` null: all of
// the body is in zone C.
UncertainPlaces uncertainPlaces(const LaidFilm& laid, const std::vector<float>& pointsOffBy,
                                const ZonedBody* zones, const ToleranceSettings& settings);

} // namespace dipwright
