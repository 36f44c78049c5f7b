// Several files in a user's folder that are replaced together, whatever dies meanwhile.
//
// They are made in a hidden folder inside the user's, which is locked. A journal in it, renamed in
// place when all of them are on the disk, is the moment from which the new ones count: until then
// nothing outside has changed, and afterwards whoever comes next carries the renamings to their end
// (docs/files-and-commands.md, "Written whole or not at all").
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

// Files are written below a hidden folder; commit() moves them into the target. Destroyed without a
// commit, nothing stays behind and the target is as it was.
class FolderTransaction {
public:
    // `names`: the files, relative to the target, that are replaced together. Makes the target, and
    // brings to an end what a dead process has left there of them. Throws Error where the target
    // cannot be written, another program is writing it, something that is no result lies in the
    // way, or a journal there cannot be read or names other files, of which none is touched.
    FolderTransaction(const QString& target, const QStringList& names);
    ~FolderTransaction();
    FolderTransaction(const FolderTransaction&) = delete;
    FolderTransaction& operator=(const FolderTransaction&) = delete;

    // Writes one of the files. Any thread. Throws Error: disk full …
    void write(const QString& name, const QByteArray& contents) const;
    // What was written to one of the files; empty: nothing. Throws Error where it cannot be read.
    QByteArray written(const QString& name) const;
    // Replaces the target's files by those written; of `names`, those that were not written are
    // removed there. Other files of the target are left alone. Throws Error, with the target as it
    // was. Once.
    void commit();

    // Brings to an end what a dead process has left in the folder `target`: all of its new files
    // are moved in place if they were complete, else they go. Nothing happens while somebody writes
    // there. False where something is left to do. Only of a folder that this user's own programs
    // have noted as theirs: a journal there is believed, whatever results it names. `mayGoOn` is
    // asked between two operations; what it stops is gone on with by the next call.
    static bool putRight(const QString& target, const std::function<bool()>& mayGoOn = {});
    // Of the hidden folder.
    static QString workName();

private:
    void lockTarget();
    void refuseOthers() const;

    QString target_;
    QStringList names_;
    std::unique_ptr<UnfinishedWrite> note_;
    QStringList made_; // folders, the innermost last
    FileLock lock_;
    mutable std::mutex writing_;
    mutable QSet<QString> written_; // of names_
};

} // namespace dipwright
