// Writes, reads and lists files for tests.
#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <QStringList>

namespace dipwright::test {

// Writes the file. Throws std::runtime_error if that fails.
void writeFile(const QString& path, const QByteArray& bytes);
// Returns the file's bytes; empty if there is no such file.
QByteArray bytesOf(const QString& path);
// Lists all files below the folder, relative to it, hidden ones too, sorted.
QStringList filesBelow(const QString& folder);

// Whether all `keys` of `object` hold finite numbers.
bool hasNumbers(const QJsonObject& object, const QStringList& keys);

} // namespace dipwright::test
