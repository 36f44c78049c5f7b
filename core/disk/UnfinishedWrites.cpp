#include "disk/UnfinishedWrites.h"

#include "base/Bytes.h"
#include "disk/AtomicFile.h"
#include "disk/FolderTransaction.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>

namespace dipwright {
namespace {

constexpr qint64 longestNote = 1 << 20; // bytes

QDir noteFolder() {
    return {QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
            QStringLiteral("/unfinished")};
}

// The work, and the folders made for it. Not as lines: a folder's name may have several.
QByteArray bytesOf(const QStringList& paths) {
    return QJsonDocument(QJsonArray::fromStringList(paths)).toJson(QJsonDocument::Compact);
}

QStringList pathsOf(const QByteArray& note) {
    QStringList paths;
    for (const QJsonValue& path : QJsonDocument::fromJson(note).array()) {
        paths << path.toString();
    }
    return paths;
}

// False where something is left to do.
bool putRight(const QStringList& paths) {
    const QString work = paths.value(0);
    bool done = true;
    if (QFileInfo(work).fileName() == FolderTransaction::workName()) {
        done = FolderTransaction::putRight(QFileInfo(work).path());
    } else if (isHiddenBeside(work)) {
        removeAbandoned(work);
        done = !QFileInfo::exists(work);
    }
    QStringList made = paths.mid(1);
    std::reverse(made.begin(), made.end());
    for (const QString& folder : made) {
        QDir().rmdir(folder); // where nothing is in it
    }
    return done;
}

} // namespace

UnfinishedWrite::UnfinishedWrite(const QString& work, const QStringList& made) {
    const QDir folder = noteFolder();
    folder.mkpath(QStringLiteral("."));
    const QString name = QUuid::createUuid().toString(QUuid::WithoutBraces);
    if (note_.open(folder.filePath(name)) == LockedFile::Outcome::Opened) {
        writeAll(note_.device(), bytesOf(QStringList{work} + made));
    }
}

UnfinishedWrite::~UnfinishedWrite() {
    note_.remove();
}

void UnfinishedWrite::leave() {
    note_.device().close();
}

void recoverUnfinishedWrites() {
    const QDir folder = noteFolder();
    for (const QString& name : folder.entryList(QDir::Files)) {
        LockedFile note;
        if (note.open(folder.filePath(name)) == LockedFile::Outcome::Opened && note.isLocked() &&
            putRight(pathsOf(note.device().read(longestNote)))) {
            note.remove();
        }
    }
}

} // namespace dipwright
