#include "TestFiles.h"

#include <QDirIterator>
#include <QFile>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace dipwright::test {

void writeFile(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
        throw std::runtime_error("cannot write " + path.toStdString());
    }
}

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QStringList filesBelow(const QString& folder) {
    QStringList files;
    QDirIterator all(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (all.hasNext()) {
        files.append(QDir(folder).relativeFilePath(all.next()));
    }
    files.sort();
    return files;
}

bool hasNumbers(const QJsonObject& object, const QStringList& keys) {
    return std::all_of(keys.begin(), keys.end(), [&](const QString& key) {
        return object[key].isDouble() && std::isfinite(object[key].toDouble());
    });
}

} // namespace dipwright::test
