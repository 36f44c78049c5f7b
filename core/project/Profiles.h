// Applies profiles to projects, and reads and writes their file format.
#pragma once

#include "settings/FilmSettings.h"
#include "settings/InkSettings.h"
#include "settings/Profile.h"

#include <QJsonObject>
#include <QString>
#include <optional>

namespace dipwright {

// Returns "printer", "film" or "tank", as in files and on the command line.
QString profileKindName(ProfileKind kind);
// Returns the kind with this name. Throws Error for any other word.
ProfileKind profileKindOf(const QString& name);
ProfileKind kindOf(const Profile& profile);
const QString& nameOf(const Profile& profile);

struct Project;
// Stores a profile in a project and applies its values: all values of a film, the resolution and
// ink limit of a printer, the barriers of a tank.
void applyProfile(Project& project, const Profile& profile);
// Returns the project's film profile (without a name if there is none) with the project's present
// film values. Values that a profile may leave to the project stay as in the profile.
FilmProfile filmProfileOf(const Project& project);

// The next three say whether the film's swell, growth or relaxation is the measured one. If not, it
// is a guess: it was never measured, or was changed afterwards.
bool hasMeasuredSwell(const FilmSettings& film, const ProjectProfiles& profiles);
bool hasMeasuredGrowth(const FilmSettings& film, const ProjectProfiles& profiles);
bool hasMeasuredRelaxation(const FilmSettings& film, const ProjectProfiles& profiles);
// Whether the ink's law was measured by a step wedge on this film.
bool hasMeasuredInk(const InkSettings& ink, const ProjectProfiles& profiles);

// Returns a sentence if the film has expired; otherwise empty.
QString expiryWarning(const std::optional<FilmProfile>& film);

// Sets one value by its path in the file ("scale", "edges.left"), parts of an array separated by x
// or ;. Throws Error naming the path if it is unknown or the value is out of range; the profile
// then does not change.
void setByPath(Profile& profile, const QString& path, const QString& value);

// A profile file: {"format":"dipwright-profile","version":1,"kind":…,"name":…,…}. Unknown keys are
// kept. `profileFromJson` checks every value and throws Error naming `where` and the path. It
// refuses newer versions.
QJsonObject toJson(const Profile& profile);
Profile profileFromJson(const QJsonObject& json, const QString& where);

} // namespace dipwright
