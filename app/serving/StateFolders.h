// Holds jobs as files in subfolders by their state, so that a crash loses no job and no state.
#pragma once

#include "disk/FileLock.h"

#include <QString>
#include <QStringList>

namespace dipwright {

class StateFolders {
public:
    // Creates the folder with these subfolders and locks it under the name `lock`. Throws Error if
    // it cannot be written or another program holds the lock.
    StateFolders(const QString& path, const QStringList& states, const QString& lock);

    const QString& path() const { return path_; }
    QString folder(const QString& state) const { return path_ + u'/' + state; }
    // Moves a job to the folder of a state; with a number in its name if the name is taken. Returns
    // its new path. Throws Error.
    QString move(const QString& job, const QString& state) const;
    // Moves a job and writes `reason` beside it, into a text file. Throws Error if the job cannot
    // be moved. Returns a sentence if the text cannot be written; else an empty string.
    QString end(const QString& job, const QString& state, const QString& reason) const;

private:
    QString path_; // absolute
    FileLock lock_;
};

} // namespace dipwright
