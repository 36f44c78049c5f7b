// Files in memory.
#pragma once

#include <QByteArray>
#include <QFileDevice>
#include <functional>

namespace dipwright {

// The bytes that `write` puts into the device it is given.
QByteArray bytesOf(const std::function<void(QIODevice&)>& write);

// Writes all bytes and hands them to the system. Where that fails, the file's errorString() says
// why.
bool writeAll(QFileDevice& file, const QByteArray& bytes);

} // namespace dipwright
