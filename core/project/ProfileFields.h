// Gives editors access to a profile's values by their path in its file ("scale", "edges.left").
#pragma once

#include "project/Field.h"
#include "settings/Profile.h"

#include <QJsonObject>

namespace dipwright {

// Returns a profile without a name, with the values that apply before anything is measured.
Profile newProfile(ProfileKind kind);

// Returns the paths in the order of the file, the name first.
QStringList profilePaths(ProfileKind kind);
// The following functions throw Error for a path that this kind of profile does not have.
FieldRule profileRule(ProfileKind kind, const QString& path);
QJsonValue profileValue(const Profile& profile, const QString& path);
// Throws Error if the value breaks the rule; the profile then does not change.
void setProfileValue(Profile& profile, const QString& path, const QJsonValue& value);

// Returns the contents of the film's file, without the default values that do not count for the job
// number (Field::notHashedIfDefault).
QJsonObject countedValues(const FilmProfile& film);

} // namespace dipwright
