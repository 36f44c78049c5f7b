// A profile's values by their path in its file ("scale", "edges.left"), as editors use them.
#pragma once

#include "project/Field.h"
#include "settings/Profile.h"

#include <QJsonObject>

namespace dipwright {

// A nameless one with the values that stand for “nothing measured yet”.
Profile newProfile(ProfileKind kind);

// In the order of the file, its name first.
QStringList profilePaths(ProfileKind kind);
// These throw Error for a path that the kind of profile has not.
FieldRule profileRule(ProfileKind kind, const QString& path);
QJsonValue profileValue(const Profile& profile, const QString& path);
// Throws Error when the value breaks the rule; the profile is then as it was.
void setProfileValue(Profile& profile, const QString& path, const QJsonValue& value);

// The film's file without what the number of a job is not made of (Field::uncountedWhenUsual).
QJsonObject countedValues(const FilmProfile& film);

} // namespace dipwright
