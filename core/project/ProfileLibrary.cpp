#include "project/ProfileLibrary.h"

#include "base/Error.h"
#include "base/JsonText.h"
#include "base/ProgramName.h"
#include "base/Sha256.h"
#include "disk/AtomicFile.h"
#include "disk/FileLock.h"
#include "disk/SmallFile.h"
#include "project/Profiles.h"
#include "project/Project.h"
#include "project/ProjectFile.h"

#include <QCoreApplication>
#include <QDir>
#include <QJsonDocument>
#include <QStandardPaths>
#include <algorithm>
#include <map>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Profiles)
};

constexpr const char* chosenFolder = "DIPWRIGHT_PROFILE_PATH";
const QString profilesName = QStringLiteral("/profiles");

bool isChosen() {
    return !qEnvironmentVariableIsEmpty(chosenFolder);
}

QString shippedFolder() {
    return QStringLiteral(":/dipwright/profiles");
}

// Makes a unique file name from any profile name, valid on every system.
QString fileName(const QString& name) {
    QString plain;
    for (const QChar letter : name.left(40)) {
        plain += letter.isLetterOrNumber() && letter.unicode() < 128 ? letter.toLower()
                                                                     : QLatin1Char('-');
    }
    return QStringLiteral("%1-%2.json").arg(plain, sha256Hex(name.toUtf8()).left(8));
}

// Adds the profiles of a folder; profiles found before keep their place.
void addFolder(std::map<QString, ProfileEntry>& found, ProfileKind kind, const QString& folder) {
    const QDir directory(folder + QLatin1Char('/') + profileKindName(kind));
    for (const QString& file :
         directory.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name)) {
        const QString path = directory.filePath(file);
        try {
            const Profile profile = importProfile(path);
            if (kindOf(profile) == kind) {
                ProfileEntry& first =
                    found.try_emplace(nameOf(profile), ProfileEntry{kind, nameOf(profile), path})
                        .first->second;
                if (first.path != path && QFileInfo(first.path).path() == directory.path()) {
                    first.others << path;
                }
            }
        } catch (const Error&) {
            continue; // one damaged file must not hide the others
        }
    }
}

void take(FileLock& lock, const QString& path) {
    const LockState state = lock.acquire(path);
    if (!state.acquired) {
        throw Error(Text::tr("Another program is writing the profile (%1); try again")
                        .arg(holderText(state)),
                    path);
    }
}

// Throws Error if the existing file is no readable profile. Otherwise a project, a profile of a
// newer version or a profile with a typing error would be lost.
void requireReadable(const QString& path) {
    const QFileInfo file(path);
    if (!file.exists() || (file.isFile() && file.size() == 0)) {
        return;
    }
    try {
        importProfile(path);
    } catch (const Error& error) {
        throw Error(Text::tr("A file of this name exists and is not a readable profile, so it is "
                             "not replaced; repair it, move it, or choose another name: %1")
                        .arg(error.message()),
                    error.where().startsWith(path)
                        ? error.where()
                        : QStringLiteral("%1: %2").arg(path, error.where()));
    }
}

// Throws Error if the profile could not be read again, for example because it has no name.
void requireReadableAgain(const Profile& profile) {
    profileFromJson(toJson(profile), {});
}

} // namespace

QString ProfileLibrary::standardFolder() {
    return isChosen()
               ? qEnvironmentVariable(chosenFolder)
               : QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + profilesName;
}

std::optional<Error> severalFiles(const ProfileEntry& entry) {
    if (entry.others.isEmpty()) {
        return std::nullopt;
    }
    const QStringList files = QStringList(entry.path) + entry.others;
    return Error(Text::tr("Several files hold a %1 profile of this name, and only the first is "
                          "read: %2; remove all but one, or change the name in the others")
                     .arg(profileKindName(entry.kind), files.join(QStringLiteral(", "))),
                 entry.name);
}

ProfileLibrary::ProfileLibrary(const QString& userFolder) : folder_(userFolder) {}

std::vector<ProfileEntry> ProfileLibrary::profiles(ProfileKind kind) const {
    std::map<QString, ProfileEntry> found;
    addFolder(found, kind, folder_);
    if (folder_ == standardFolder() && !isChosen()) {
        addFolder(found, kind, earlierDataFolder() + profilesName);
    }
    addFolder(found, kind, shippedFolder());
    std::vector<ProfileEntry> entries;
    entries.reserve(found.size());
    for (const auto& [name, entry] : found) {
        entries.push_back(entry);
    }
    return entries;
}

bool ProfileLibrary::contains(ProfileKind kind, const QString& name) const {
    const std::vector<ProfileEntry> all = profiles(kind);
    return std::any_of(all.begin(), all.end(),
                       [&](const ProfileEntry& entry) { return entry.name == name; });
}

Profile ProfileLibrary::profile(ProfileKind kind, const QString& name) const {
    QStringList names;
    for (const ProfileEntry& entry : profiles(kind)) {
        if (entry.name == name) {
            return importProfile(entry.path);
        }
        names << entry.name;
    }
    throw Error(Text::tr("There is no %1 profile of this name; choose one of: %2")
                    .arg(profileKindName(kind), names.join(QStringLiteral(", "))),
                name);
}

std::optional<Profile> ProfileLibrary::found(ProfileKind kind, const QString& name) const {
    for (const ProfileEntry& entry : profiles(kind)) {
        if (entry.name == name) {
            return importProfile(entry.path);
        }
    }
    return std::nullopt;
}

void ProfileLibrary::requireOneFile(ProfileKind kind, const QString& name) const {
    for (const ProfileEntry& entry : profiles(kind)) {
        if (const auto several = severalFiles(entry); several && entry.name == name) {
            throw *several;
        }
    }
}

void ProfileLibrary::save(const Profile& profile, const std::optional<Profile>& known) const {
    requireReadableAgain(profile);
    const QString path = pathFor(profile);
    FileLock lock;
    take(lock, path);
    requireReadable(path);
    if (found(kindOf(profile), nameOf(profile)) != known) {
        throw ChangedFile(Text::tr("Another program has changed the profile since it was read, so "
                                   "it is not saved; read it again and repeat your change"),
                          nameOf(profile));
    }
    exportProfile(profile, path);
}

void ProfileLibrary::replace(const Profile& profile) const {
    requireReadableAgain(profile);
    const QString path = pathFor(profile);
    FileLock lock;
    take(lock, path);
    exportProfile(profile, path);
}

// Creates the folder if it is missing.
QString ProfileLibrary::pathFor(const Profile& profile) const {
    requireOneFile(kindOf(profile), nameOf(profile));
    const QString folder = folder_ + QLatin1Char('/') + profileKindName(kindOf(profile));
    if (!QDir().mkpath(folder)) {
        throw Error(Text::tr("The folder for profiles cannot be created; choose another with "
                             "DIPWRIGHT_PROFILE_PATH"),
                    folder);
    }
    // The user may have stored a profile of this name in a file of another name.
    QString path = folder + QLatin1Char('/') + fileName(nameOf(profile));
    for (const ProfileEntry& entry : profiles(kindOf(profile))) {
        if (entry.name == nameOf(profile) && entry.isUsers()) {
            path = entry.path;
        }
    }
    return path;
}

void ProfileLibrary::remove(ProfileKind kind, const QString& name) const {
    requireOneFile(kind, name);
    for (const ProfileEntry& entry : profiles(kind)) {
        if (entry.name == name && entry.isUsers()) {
            FileLock lock;
            take(lock, entry.path);
            if (!QFile::remove(entry.path)) {
                throw Error(Text::tr("The profile cannot be removed"), entry.path);
            }
            return;
        }
    }
    throw Error(Text::tr("You have no %1 profile of this name; profiles that come with the program "
                         "cannot be removed")
                    .arg(profileKindName(kind)),
                name);
}

Profile importProfile(const QString& path) {
    const QByteArray bytes = readSmallFile(path, mostProfileBytes);
    requireJsonWithinLimits(bytes, path);
    QJsonParseError failure;
    const QJsonDocument document = QJsonDocument::fromJson(bytes, &failure);
    if (!document.isObject()) {
        throw Error(Text::tr("This is not a Dipwright profile: %1").arg(failure.errorString()),
                    path);
    }
    return profileFromJson(document.object(), path);
}

void exportProfile(const Profile& profile, const QString& path) {
    requireReadable(path);
    const QString failure = replaceFile(path, QJsonDocument(toJson(profile)).toJson());
    if (!failure.isEmpty()) {
        throw Error(Text::tr("The profile cannot be written: %1").arg(failure), path);
    }
}

} // namespace dipwright
