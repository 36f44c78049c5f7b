#include "disk/UnfinishedNote.h"

#include "disk/AtomicFile.h"
#include "disk/FolderTransaction.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>

namespace dipwright {
namespace {

constexpr qsizetype longestPath = 4096; // characters
constexpr qsizetype mostFolders = 64;

bool isWork(const QString& path) {
    return path.size() <= longestPath && QDir::isAbsolutePath(path) && !path.contains(QChar(0)) &&
           (isHiddenFile(path) || QFileInfo(path).fileName() == FolderTransaction::workName());
}

} // namespace

// Encoded as JSON, not as lines: a folder's name may contain line breaks.
QByteArray bytesOf(const UnfinishedNote& note) {
    return QJsonDocument(QJsonArray::fromStringList(QStringList{note.work} + note.made))
        .toJson(QJsonDocument::Compact);
}

std::optional<UnfinishedNote> noteOf(const QByteArray& bytes) {
    const QJsonArray array = QJsonDocument::fromJson(bytes).array();
    UnfinishedNote note{array.first().toString(), {}};
    if (array.size() > 1 + mostFolders || !isWork(note.work)) {
        return std::nullopt;
    }
    for (qsizetype i = 1; i < array.size(); ++i) {
        note.made << array[i].toString();
    }
    const bool isAround =
        std::all_of(note.made.begin(), note.made.end(), [&note](const QString& folder) {
            return QDir::isAbsolutePath(folder) && note.work.startsWith(folder + QLatin1Char('/'));
        });
    return isAround ? std::optional(note) : std::nullopt;
}

} // namespace dipwright
