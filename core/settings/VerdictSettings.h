// The limits of the verdict on a job, as in the project file's "verdict". Each zone has its own
// limit for position (settings/ToleranceSettings.h).
#pragma once

#include "base/Units.h"

#include <cstdint>

namespace dipwright {

// The verdict on a sheet; a later value is worse. NotJudged: its numerical error was not computed.
enum class Advice : std::uint8_t { NotJudged, Print, CheckFirst, DoNotPrint };

// Above a limit the verdict is "check first", above `doNotPrintFactor` the limit "do not print".
// Shares are 0 … 1; 1 disables a limit. The defaults are our own choice: several times the values
// of ordinary bodies (docs/film-validation.md, "The verdict").
struct VerdictSettings {
    double air = 0.005;      // share of the body's surface that trapped air keeps dry
    double pale = 0.02;      // share of the painted area where ink cannot make up for the stretch
    double unreached = 0.05; // share of the body's surface that neither of two dips paints
    // share of the overlap of two dips that is narrower than their registration error
    double narrow = 0.3;
    double zoneBare = 0.02;    // share of a marked zone that no dip paints
    double leastPainted = 0.1; // share of the surface that the only dip should paint
    double damaged = 0.05;     // share of the painted area under torn or released film
    Millimetres edge{5};       // least distance of the painted film from the film's edge
    // The verdict on a model of one plain colour, without artwork.
    Advice noPicture = Advice::CheckFirst;
    Advice changedModel = Advice::Print; // verdict on a model that was repaired
    // The verdict on a model of which the import left something out, or cannot show it as its file
    // means it, such as a missing texture.
    Advice incompleteModel = Advice::CheckFirst;
    Advice guessedFilm = Advice::Print;      // verdict on a film whose swell was not measured
    Advice expiredFilm = Advice::CheckFirst; // verdict on a film after the expiry date of its lot
    bool operator==(const VerdictSettings&) const = default;
};
inline constexpr double doNotPrintFactor = 5;

} // namespace dipwright
