// Summarises the numerical error of the painted film by zone and finds the places to check. Private
// to this folder; Verdict.h gives the result to others.
#pragma once

#include "accuracy/tolerance/Zones.h"
#include "accuracy/verdict/Verdict.h"
#include "dip/LaidFilm.h"

#include <vector>

namespace dipwright {

// The numerical error of the painted film in a zone, of all bodies or of one.
struct ZoneError {
    Zone zone = Zone::C;
    QString body = {};  // name of the one body; empty: of all
    double limit = 0;   // limit of the zone, mm
    double area = 0;    // mm² of the zone that are painted and compared
    double unknown = 0; // share of the painted zone that is not compared
    // 95 % of the painted zone has at most this numerical error, mm: what is not compared counts as
    // worse. If it is more than mostUnknownArea, 95 % of the compared area.
    double percentile95 = 0;
    double far = 0; // share of `area` whose numerical error exceeds the limit
};

struct PlacesToCheck {
    std::vector<ZoneError> zones; // only painted zones, A first
    // The same zones of each separate body of which at least leastPlaceArea is painted there; empty
    // if the model has only one body.
    std::vector<ZoneError> zonesOfBodies;
    std::vector<PlaceToCheck> places;
    double area = 0; // total area of all places to check, mm²
};

// Finds the places to check. `pointErrors` is NumericalErrorEstimate::pointErrors; empty if the
// error is not known.
PlacesToCheck placesToCheck(const LaidFilm& laid, const std::vector<float>& pointErrors,
                            const JudgedSurface& surface, const ToleranceSettings& settings);

} // namespace dipwright
