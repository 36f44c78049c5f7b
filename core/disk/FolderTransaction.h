// Replaces several files in a user's folder together, completely or not at all, even if the program
// or the computer crashes.
//
// The new files are written into a hidden folder inside the user's folder, which is locked. When
// all are on disk, a journal is renamed into place there. From that moment the new files count.
// Before it nothing outside has changed; after it the next program that comes by completes the
// renaming (docs/files-and-commands.md, "Atomic writes").
#pragma once

#include "disk/FileLock.h"
#include "disk/UnfinishedWrites.h"

#include <QSet>
#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <mutex>

namespace dipwright {

// write() stores files in a hidden folder; commit() moves them into the target. Without a commit
// the destructor removes everything and the target is unchanged.
class FolderTransaction {
public:
    // `names` are the files, relative to the target, that are replaced together. Creates the
    // target, and completes a transaction of these files that a crashed process left there. Throws
    // Error if the target cannot be written, if another program is writing it, or if something else
    // is in the way of a result. Also throws Error, with nothing touched, if a journal there cannot
    // be read or names other files.
    FolderTransaction(const QString& target, const QStringList& names);
    ~FolderTransaction();
    FolderTransaction(const FolderTransaction&) = delete;
    FolderTransaction& operator=(const FolderTransaction&) = delete;

    // Writes one of the files. Thread-safe. Throws Error, for example when the disk is full.
    void write(const QString& name, const QByteArray& contents) const;
    // Returns what was written to one of the files; empty if nothing was. Throws Error if it cannot
    // be read.
    QByteArray written(const QString& name) const;
    // Replaces the target's files by the written ones, and removes the files of `names` that were
    // not written. Leaves other files alone. Throws Error, with the target unchanged. Call once.
    void commit();

    // Completes what a crashed process left in the folder `target`: moves all new files into place
    // if they were complete, else removes them. Does nothing while somebody writes there. Returns
    // false if something is left to do. Call it only for folders that this user's own programs have
    // noted as theirs, because it trusts a journal there whatever results it names. `mayGoOn` is
    // asked between two operations; when it returns false, the next call continues.
    static bool putRight(const QString& target, const std::function<bool()>& mayGoOn = {});
    // The name of the hidden folder.
    static QString workName();

private:
    void lockTarget();
    void refuseOthers() const;

    QString target_;
    QStringList names_;
    std::unique_ptr<UnfinishedWrite> note_;
    QStringList made_; // created folders, the innermost last
    FileLock lock_;
    mutable std::mutex writing_;
    mutable QSet<QString> written_; // a subset of names_
};

} // namespace dipwright
