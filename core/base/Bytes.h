// Writes bytes to files, and collects written bytes in memory.
#pragma once

#include <QByteArray>
#include <QFileDevice>
#include <functional>

namespace dipwright {

// Returns the bytes that `write` writes to its device.
QByteArray bytesOf(const std::function<void(QIODevice&)>& write);

// Writes all bytes and flushes them to the operating system. If it returns false, the file's
// errorString() says why.
bool writeAll(QFileDevice& file, const QByteArray& bytes);

} // namespace dipwright
