// Names that come with the program in files (profiles, solvers, samples, colour maps), in the
// user's language. What is stored and looked up stays as it is.
#pragma once

#include <QString>

namespace dipwright {

// A name of the user's own is shown as it is.
QString shownName(const QString& name);
// The same for an identifier, such as "turtle" or "lagoon".
QString shownTitle(const QString& identifier);

} // namespace dipwright
