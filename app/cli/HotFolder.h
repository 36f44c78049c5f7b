// Watches a folder into which jobs are dropped.
//
// Jobs are project files (.dipw) and print tickets (.json). Subfolders hold the jobs by their
// state, so that a crash loses no state: `printing` while sheets are sent, then `done`, `failed` or
// `held`, with a text file that gives the reason. Jobs in `release` are to be printed whatever
// their verdict is. `projects` holds the projects that print tickets name.
#pragma once

#include "serving/StateFolders.h"

#include <QDateTime>
#include <QString>
#include <map>
#include <vector>

namespace dipwright::cli {

struct HotJob {
    QString path;
    bool isReleased = false; // to be printed whatever the verdict is
};

inline constexpr qint64 mostTicketBytes = 1 << 20; // longest print ticket
bool isTicket(const QString& path);                // else the job is a project

enum class HotState { Done, Failed, Held };

class HotFolder {
public:
    // Creates the subfolders and locks the folder. Moves jobs that an earlier program was printing
    // when it ended to `held`, because they may be printed already. Throws Error if the folder
    // cannot be written or another program watches it.
    explicit HotFolder(const QString& path);
    // Returns the names of the jobs that the constructor moved to `held`.
    const QStringList& interrupted() const { return interrupted_; }

    // Returns the jobs that have not changed since the previous call, the oldest first. A file that
    // is still being copied changes or cannot be read, so unreadable files are returned only after
    // ten calls without a change. Call about once a second.
    std::vector<HotJob> completeJobs();
    // Whether the folder contains jobs, complete or not.
    bool hasJobs() const { return !seen_.empty(); }

    // Moves the job to `printing`. Returns its new path. Throws Error.
    QString startPrinting(const QString& job) const;
    // Moves the job to the folder of its state, and writes `reason` beside it, into a text file.
    // Throws Error if the job cannot be moved. Returns a sentence if the text cannot be written;
    // else an empty string.
    QString end(const QString& job, HotState state, const QString& reason) const;
    // Returns the path of a project in `projects`. Throws Error if `name` is not a plain file name.
    QString project(const QString& name) const;

private:
    struct Seen {
        qint64 size = 0;
        QDateTime changed;
        int calls = 0; // calls without a change
    };
    QString folder(const QString& name) const { return folders_.folder(name); }

    StateFolders folders_;
    QStringList interrupted_;
    std::map<QString, Seen> seen_;
};

} // namespace dipwright::cli
