#include "cli/HotFolder.h"

#include "base/Error.h"
#include "disk/AtomicFile.h"
#include "project/ProjectStore.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <algorithm>

namespace dipwright::cli {
namespace {

const QString printing = QStringLiteral("printing");
const QString released = QStringLiteral("release");
const QString projects = QStringLiteral("projects");
constexpr int callsUnchanged = 1;   // before a file counts as complete
constexpr int callsUnreadable = 10; // before an unreadable file counts as complete

QString nameOf(HotState state) {
    return state == HotState::Done     ? QStringLiteral("done")
           : state == HotState::Failed ? QStringLiteral("failed")
                                       : QStringLiteral("held");
}

bool canBeRead(const QString& path) {
    try {
        if (isTicket(path)) {
            QFile file(path);
            return file.open(QIODevice::ReadOnly) &&
                   !QJsonDocument::fromJson(file.read(mostTicketBytes)).isNull();
        }
        solverOfProject(path);
        return true;
    } catch (const Error&) {
        return false;
    }
}

// Moves a file into a folder, with a number in its name if the name is taken. Returns its new path.
QString moved(const QString& path, const QString& folder) {
    const QFileInfo file(path);
    for (int number = 1;; ++number) {
        const QString suffix = number > 1 ? QStringLiteral("-%1").arg(number) : QString();
        const QString target = QStringLiteral("%1/%2%3.%4")
                                   .arg(folder, file.completeBaseName(), suffix, file.suffix());
        if (QFileInfo::exists(target)) {
            continue;
        }
        QFile source(path);
        if (source.rename(target)) {
            return target;
        }
        if (!QFileInfo::exists(target)) {
            throw Error(QStringLiteral("The job cannot be moved to %1: %2")
                            .arg(folder, source.errorString()),
                        path);
        }
    }
}

} // namespace

bool isTicket(const QString& path) {
    return path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive);
}

HotFolder::HotFolder(const QString& path) : path_(QDir(path).absolutePath()) {
    QDir().mkpath(path_);
    const LockState lock = lock_.acquire(folder(QStringLiteral("watch")));
    if (!lock.acquired) {
        throw Error(QStringLiteral("The folder is already watched by %1; end that program or "
                                   "choose another folder")
                        .arg(holderText(lock)),
                    path_);
    }
    for (const QString& name : {printing, released, projects, nameOf(HotState::Done),
                                nameOf(HotState::Failed), nameOf(HotState::Held)}) {
        if (!QDir().mkpath(folder(name))) {
            throw Error(QStringLiteral("The folder cannot be created; choose a folder that can be "
                                       "written"),
                        folder(name));
        }
    }
    for (const QFileInfo& file : QDir(folder(printing)).entryInfoList(QDir::Files)) {
        end(file.filePath(), HotState::Held,
            QStringLiteral("The program ended while the sheets were sent to the printer. Check "
                           "which sheets came out. To print the job again, move it to the folder "
                           "“release”."));
    }
}

std::vector<HotJob> HotFolder::completeJobs() {
    std::map<QString, Seen> now;
    std::vector<QFileInfo> complete;
    for (const QString& place : {path_, folder(released)}) {
        for (const QFileInfo& file :
             QDir(place).entryInfoList({"*.dipw", "*.json"}, QDir::Files | QDir::NoSymLinks)) {
            Seen seen{file.size(), file.lastModified(), 0};
            const auto before = seen_.find(file.filePath());
            if (before != seen_.end() && before->second.size == seen.size &&
                before->second.changed == seen.changed) {
                seen.calls = before->second.calls + 1;
            }
            if (seen.calls >= callsUnreadable ||
                (seen.calls >= callsUnchanged && canBeRead(file.filePath()))) {
                complete.push_back(file);
            }
            now[file.filePath()] = seen;
        }
    }
    seen_ = std::move(now);
    std::ranges::sort(complete, [](const QFileInfo& a, const QFileInfo& b) {
        return std::pair(a.lastModified(), a.fileName()) <
               std::pair(b.lastModified(), b.fileName());
    });
    std::vector<HotJob> jobs;
    for (const QFileInfo& file : complete) {
        jobs.push_back({file.filePath(), file.path() == folder(released)});
    }
    return jobs;
}

QString HotFolder::startPrinting(const QString& job) const {
    return moved(job, folder(printing));
}

QString HotFolder::end(const QString& job, HotState state, const QString& reason) const {
    const QString file = moved(job, folder(nameOf(state)));
    const QString failure = replaceFile(file + QStringLiteral(".txt"), reason.toUtf8() + '\n');
    return failure.isEmpty()
               ? QString()
               : QStringLiteral(" The text file beside the job cannot be written: %1").arg(failure);
}

QString HotFolder::project(const QString& name) const {
    if (name.isEmpty() || QFileInfo(name).fileName() != name || name.startsWith(u'.')) {
        throw Error(
            QStringLiteral("“project” must be the name of a file in %1").arg(folder(projects)),
            name);
    }
    return folder(projects) + u'/' + name;
}

} // namespace dipwright::cli
