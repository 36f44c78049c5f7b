#include "disk/Unfinished.h"

#include "base/Bytes.h"
#include "disk/ResultFolder.h"
#include "disk/WholeFile.h"

#include <QDir>
#include <QStandardPaths>
#include <QUuid>
#include <algorithm>

namespace dipwright {
namespace {

QDir noteFolder() {
    return {QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) +
            QStringLiteral("/unfinished")};
}

// Lines: the work, and the folders made for it.
void putRight(const QStringList& lines) {
    const QString work = lines.value(0);
    if (QFileInfo(work).fileName() == ResultFolder::workName()) {
        ResultFolder::putRight(QFileInfo(work).path());
    } else if (!work.isEmpty()) {
        removeAbandoned(work);
    }
    QStringList made = lines.mid(1);
    std::reverse(made.begin(), made.end());
    for (const QString& folder : made) {
        QDir().rmdir(folder); // where nothing is in it
    }
}

} // namespace

UnfinishedNote::UnfinishedNote(const QString& work, const QStringList& made) {
    const QDir folder = noteFolder();
    folder.mkpath(QStringLiteral("."));
    const QString name = QUuid::createUuid().toString(QUuid::WithoutBraces);
    if (note_.open(folder.filePath(name)) == LockedFile::Outcome::Opened) {
        writeAll(note_.device(), (QStringList{work} + made).join(QLatin1Char('\n')).toUtf8());
    }
}

UnfinishedNote::~UnfinishedNote() {
    note_.remove();
}

void UnfinishedNote::leave() {
    note_.device().close();
}

void tidyUnfinished() {
    const QDir folder = noteFolder();
    for (const QString& name : folder.entryList(QDir::Files)) {
        LockedFile note;
        if (note.open(folder.filePath(name)) == LockedFile::Outcome::Opened) {
            putRight(QString::fromUtf8(note.device().readAll()).split(QLatin1Char('\n')));
            note.remove();
        }
    }
}

} // namespace dipwright
