// The profiles at hand: those that come with the program, and the user's own in a folder of files.
#pragma once

#include "settings/Profile.h"

#include <vector>

namespace dipwright {

struct ProfileEntry {
    ProfileKind kind;
    QString name;
    QString path; // of its file; one of the program's own begins with ":"
    bool isUsers() const { return !path.startsWith(QLatin1Char(':')); }
};

// Reads files when asked; keeps none. A user's profile stands in for the program's of the same
// name.
class ProfileLibrary {
public:
    // DIPWRIGHT_PROFILE_PATH, or "profiles" in the user's folder for program data. Of the latter,
    // those are found too that earlier versions of the command line have kept elsewhere.
    static QString standardFolder();

    explicit ProfileLibrary(const QString& userFolder = standardFolder());

    // By name, the user's and the program's together. Files that are no profiles are passed over.
    std::vector<ProfileEntry> profiles(ProfileKind kind) const;
    bool contains(ProfileKind kind, const QString& name) const;
    // Throws Error when there is none of that name, or its file is damaged.
    Profile profile(ProfileKind kind, const QString& name) const;

    // Nothing where there is none of that name. Throws Error when its file is damaged.
    std::optional<Profile> found(ProfileKind kind, const QString& name) const;

    // Writes a user's profile whole or not at all, over one of the same name. `known` is what was
    // found under that name when the profile was read: where another program has changed it since,
    // ChangedFile is thrown and nothing written. Throws Error.
    void save(const Profile& profile, const std::optional<Profile>& known) const;
    // The same whatever is there.
    void replace(const Profile& profile) const;
    // Removes a user's profile; the program's own of that name comes back. Throws Error.
    void remove(ProfileKind kind, const QString& name) const;

private:
    QString pathFor(const Profile& profile) const;

    QString folder_;
};

// One profile as a file of its own, for another machine. Throws Error.
Profile importProfile(const QString& path);
void exportProfile(const Profile& profile, const QString& path);

} // namespace dipwright
