// Profiles in use: taken over into projects, read and written.
#pragma once

#include "settings/FilmSettings.h"
#include "settings/InkSettings.h"
#include "settings/Profile.h"

#include <QJsonObject>
#include <QString>
#include <optional>

namespace dipwright {

// "printer", "film", "tank": in files and on the command line.
QString profileKindName(ProfileKind kind);
// Throws Error on another word.
ProfileKind profileKindOf(const QString& name);
ProfileKind kindOf(const Profile& profile);
const QString& nameOf(const Profile& profile);

struct Project;
// Takes a profile over into a project, content and effect: all that a film's profile
// says of the film; a printer's resolution and ink limit; a tank's barriers.
void applyProfile(Project& project, const Profile& profile);
// The project's film as a profile: its own, nameless where there is none, with all that a profile
// says of the film as the project has it now. What a profile may leave to the project stays as the
// profile has it.
FilmProfile filmProfileOf(const Project& project);

// Whether the film that is dipped has the swell, growth or relaxation that was measured. Else they
// are guessed: none were, or somebody has changed them since.
bool hasMeasuredSwell(const FilmSettings& film, const ProjectProfiles& profiles);
bool hasMeasuredGrowth(const FilmSettings& film, const ProjectProfiles& profiles);
bool hasMeasuredRelaxation(const FilmSettings& film, const ProjectProfiles& profiles);
// Whether the ink thins as a step wedge on this film told.
bool hasMeasuredInk(const InkSettings& ink, const ProjectProfiles& profiles);

// A sentence where the film has expired by today, else empty.
QString expiryWarning(const std::optional<FilmProfile>& film);

// Sets one value by its path in the file ("scale", "edges.left"), parts of an array joined by x or
// ;. Throws Error naming the path when it is unknown or out of range; the profile is then as it
// was.
void setByPath(Profile& profile, const QString& path, const QString& value);

// A profile file: {"format":"dipwright-profile","version":1,"kind":…,"name":…,…}. Unknown keys are
// ignored. `profileFromJson` checks every value and throws Error naming `where` and the path; a
// newer version is refused.
QJsonObject toJson(const Profile& profile);
Profile profileFromJson(const QJsonObject& json, const QString& where);

} // namespace dipwright
