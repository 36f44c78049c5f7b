// Tells whether a tank and its machine can carry out a dip.
#pragma once

#include <QStringList>

namespace dipwright {

struct Project;
struct Immersion;

// Returns a sentence for each limit of the project's tank profile that the dip exceeds: its walls,
// its floor, and the reach and the speeds of its machine. The middle of the film floats over the
// middle of the tank. Empty if the project has no tank profile. `project` must have a model. Throws
// Error if the dip's path cannot be travelled.
QStringList tankFaults(const Project& project, const Immersion& immersion);

} // namespace dipwright
