// Files in memory, and from there on the disk.
#pragma once

#include <QByteArray>
#include <QFileDevice>
#include <QString>
#include <functional>

namespace dipwright {

// The bytes that `write` puts into the device it is given.
QByteArray bytesOf(const std::function<void(QIODevice&)>& write);

// Writes all bytes through to the disk. Where that fails, the file's errorString() says why.
bool writeAll(QFileDevice& file, const QByteArray& bytes);
// Replaces a file whole or not at all. Empty when done, else why not in the system's words.
QString replaceFile(const QString& path, const QByteArray& bytes);
// The same with what `write` puts into the device it is given. Throws Error.
void writeWhole(const QString& path, const std::function<void(QIODevice&)>& write);

} // namespace dipwright
