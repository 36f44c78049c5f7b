// Files as tests write them and find them.
#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <QStringList>

namespace dipwright::test {

// Throws std::runtime_error where the file cannot be written.
void writeFile(const QString& path, const QByteArray& bytes);
// Nothing where there is no such file.
QByteArray bytesOf(const QString& path);
// Relative to the folder, hidden ones too, sorted.
QStringList filesBelow(const QString& folder);

bool hasNumbers(const QJsonObject& object, const QStringList& keys); // finite ones

} // namespace dipwright::test
