#include "cli/HotFolder.h"

#include "base/Error.h"
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

} // namespace

bool isTicket(const QString& path) {
    return path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive);
}

HotFolder::HotFolder(const QString& path)
    : folders_(path,
               {printing, released, projects, nameOf(HotState::Done), nameOf(HotState::Failed),
                nameOf(HotState::Held)},
               QStringLiteral("watch")) {
    for (const QFileInfo& file : QDir(folder(printing)).entryInfoList(QDir::Files)) {
        end(file.filePath(), HotState::Held,
            QStringLiteral("The program ended while the sheets were sent to the printer. Check "
                           "which sheets came out. To print the job again, move it to the folder "
                           "“release”."));
        interrupted_ << file.fileName();
    }
}

std::vector<HotJob> HotFolder::completeJobs() {
    std::map<QString, Seen> now;
    std::vector<QFileInfo> complete;
    for (const QString& place : {folders_.path(), folder(released)}) {
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
    return folders_.move(job, printing);
}

QString HotFolder::end(const QString& job, HotState state, const QString& reason) const {
    return folders_.end(job, nameOf(state), reason);
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
