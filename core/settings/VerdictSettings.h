// From when on a job is no longer simply to be printed, as in the project file's "verdict". The
// limits for position are those of the zones (settings/ToleranceSettings.h).
#pragma once

#include "base/Units.h"

#include <cstdint>

namespace dipwright {

// What is to be done with a sheet; the later the worse. NotJudged: nobody asked how certain it is.
enum class Advice : std::uint8_t { NotJudged, Print, LookFirst, DoNotPrint };

// Above a limit the job is to be looked at first, above `spoiltTimes` the limit not to be printed.
// Shares are 0 … 1; 1 asks for nothing. The usual values are ours: several times what ordinary
// bodies come to (docs/film-validation.md, "The verdict").
struct VerdictSettings {
    double air = 0.005;      // of the body's surface, kept dry by trapped air
    double pale = 0.02;      // of the painted area, where the ink cannot make up for the stretch
    double unreached = 0.05; // of the body's surface, painted by neither of two dips
    double narrow = 0.3;     // of the overlap of two dips, narrower than they may lie off
    double zoneBare = 0.02;  // of a marked zone, painted by no dip
    double damaged = 0.05;   // of the painted area, by film that tore or was let go of
    Millimetres edge{5};     // at least so far the painted film stays from the film's edge
    Advice noPicture = Advice::LookFirst; // a model of one plain colour, without artwork
    Advice changedModel = Advice::Print;  // a model that was put right, or lacks something
    Advice guessedFilm = Advice::Print;   // a film whose swell nobody has measured
    bool operator==(const VerdictSettings&) const = default;
};
inline constexpr double spoiltTimes = 5;

} // namespace dipwright
