// A folder that appears whole or not at all.
#pragma once

#include <QString>
#include <QStringList>
#include <memory>

class QTemporaryDir;

namespace dipwright {

// Files are written below path(); commit() moves them into the target folder. Destroyed without a
// commit, nothing stays behind and the target is as it was.
class ResultFolder {
public:
    // Makes the temporary folder inside the target, or beside the place where it will be. Throws
    // Error where that cannot be written.
    explicit ResultFolder(const QString& target);
    ~ResultFolder();

    QString path() const;
    // Writes one file, at a path relative to path(). Throws Error: disk full …
    void write(const QString& name, const QByteArray& contents) const;
    // Replaces the target's files `names`, relative to it, by those written here; ones that were
    // not written are removed there. Other files of the target are left alone. Throws Error, with
    // the target as it was.
    void commit(const QStringList& names);

private:
    void refuseOthers(const QString& name) const;

    QString target_;
    std::unique_ptr<QTemporaryDir> temporary_;
};

} // namespace dipwright
