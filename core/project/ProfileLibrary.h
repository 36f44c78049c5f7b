// Finds, reads and writes profiles: those shipped with the program and the user's own files.
#pragma once

#include "base/Error.h"
#include "settings/Profile.h"

#include <QStringList>
#include <optional>
#include <vector>

namespace dipwright {

// A profile in the library.
struct ProfileEntry {
    ProfileKind kind;
    QString name;
    QString path;            // of its file; begins with ":" if shipped with the program
    QStringList others = {}; // paths of further files in the folder that have the same name
    bool isUsers() const { return !path.startsWith(QLatin1Char(':')); }
};

// Returns what to tell the user if several files have the name of this profile.
std::optional<Error> severalFiles(const ProfileEntry& entry);

// Reads files on each call and caches nothing. A user's profile replaces a shipped one of the same
// name.
class ProfileLibrary {
public:
    // Returns DIPWRIGHT_PROFILE_PATH, or "profiles" in the user's folder for program data. With the
    // latter, profiles are also found where earlier versions of the command line kept them.
    static QString standardFolder();

    explicit ProfileLibrary(const QString& userFolder = standardFolder());

    // Returns the user's and the shipped profiles, sorted by name. Skips files that are not
    // profiles.
    std::vector<ProfileEntry> profiles(ProfileKind kind) const;
    bool contains(ProfileKind kind, const QString& name) const;
    // Throws Error if there is no profile of that name, or its file is damaged.
    Profile profile(ProfileKind kind, const QString& name) const;

    // Returns nothing if there is no profile of that name. Throws Error if its file is damaged.
    std::optional<Profile> found(ProfileKind kind, const QString& name) const;
    // Throws severalFiles() if there are several files of this name. The functions below do this,
    // too.
    void requireOneFile(ProfileKind kind, const QString& name) const;

    // Writes a user's profile by an atomic write and replaces one of the same name. `known` is the
    // result of found() when the profile was read. If another program has changed the profile since
    // then, throws ChangedFile and writes nothing. Throws Error if it cannot be written.
    void save(const Profile& profile, const std::optional<Profile>& known) const;
    // Writes the profile without comparing it with the present one.
    void replace(const Profile& profile) const;
    // Removes a user's profile; a shipped one of that name reappears. Throws Error.
    void remove(ProfileKind kind, const QString& name) const;

private:
    QString pathFor(const Profile& profile) const;

    QString folder_;
};

// Reads a profile from a file that exportProfile() wrote. Throws Error.
Profile importProfile(const QString& path);
// Writes a profile to a separate file, for another computer. Throws Error.
void exportProfile(const Profile& profile, const QString& path);

} // namespace dipwright
