// Identifies dips, so that errors measured on dipped parts are only used for the same dip
// (docs/inspection.md, "As built").
#pragma once

#include "settings/AsBuilt.h"

#include <QString>
#include <QStringList>

namespace dipwright {

struct Project;

// Returns a key for each dip of the project: 16 hexadecimal digits of a SHA-256. It depends on the
// model's triangles, the pose and path, and the settings of film and process, but not on
// values that this film or path does not use. It does not depend on the solver, its points and
// steps, which only change the numerical error. The fields of later versions of the program do not
// change the key as long as they have their default values.
QStringList dipKeys(const Project& project);

// Returns the measured parts by which the next sheets may be corrected: dippedAlike() for the
// project's dips.
AsBuilt partsDippedAlike(const Project& project);

} // namespace dipwright
