// Replaces several files in a user's folder together, completely or not at all, even if the program
// or the computer crashes.
//
// The new files are written into a hidden folder inside the user's folder, which is locked. When
// all are on disk, a journal is renamed into place there. From that moment the transaction is
// committed. Before it, nothing outside the hidden folder has changed. After a later crash, the
// next program that uses the folder completes the renaming (docs/files-and-commands.md, "Atomic
// writes").
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
    // Error if the target cannot be written or another program is writing to it. Throws Error if a
    // file or folder is in the way of a result. Also throws Error, and changes nothing, if a
    // journal in the target cannot be read or names other files.
    FolderTransaction(const QString& target, const QStringList& names);
    ~FolderTransaction();
    FolderTransaction(const FolderTransaction&) = delete;
    FolderTransaction& operator=(const FolderTransaction&) = delete;

    // Writes one of the files. Thread-safe. Throws Error, for example when the disk is full.
    void write(const QString& name, const QByteArray& contents) const;
    // Returns the new contents of one of the files; empty if the file was not written. Throws Error
    // if they cannot be read.
    QByteArray written(const QString& name) const;
    // Replaces the target's files by the written ones, and removes the files of `names` that were
    // not written. Leaves other files alone. If it throws Error, the target is unchanged, or the
    // error says that only some files were moved. Call once.
    void commit();

    // Completes the transaction that a crashed process left in the folder `target`: moves all new
    // files into place if they were complete, else removes them. Does nothing while another process
    // writes there. Returns false if work remains. Call it only for folders in this user's notes
    // (UnfinishedWrites.h), because it trusts the folder's journal, whatever files the journal
    // names. `shouldContinue` is called between two operations. If it returns false, the work
    // stops, and the next call continues it.
    static bool completeTransaction(const QString& target,
                                    const std::function<bool()>& shouldContinue = {});
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
