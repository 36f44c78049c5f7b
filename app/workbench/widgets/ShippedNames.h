// Translates names of shipped files (profiles, solvers, samples, colour maps) for display. Stored
// names and lookups stay untranslated.
#pragma once

#include <QString>

namespace dipwright {

// Returns the user's own names unchanged.
QString shownName(const QString& name);
// Translates an identifier such as "turtle" or "lagoon" for display.
QString shownTitle(const QString& identifier);

} // namespace dipwright
