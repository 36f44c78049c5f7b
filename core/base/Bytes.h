// Writes bytes to files, and collects written bytes in memory.
#pragma once

#include <QByteArray>
#include <QByteArrayView>
#include <QFileDevice>
#include <functional>
#include <vector>

namespace dipwright {

// Returns the bytes that `write` writes to its device.
QByteArray bytesOf(const std::function<void(QIODevice&)>& write);
// Returns the bytes of the values as they lie in memory.
template <typename Value>
QByteArrayView bytesOf(const std::vector<Value>& values) {
    return {reinterpret_cast<const char*>(values.data()), qsizetype(values.size() * sizeof(Value))};
}

// Writes all bytes to a device. If it takes fewer, throws Error about `where`; %1 in `message`
// becomes the device's reason.
void writeTo(QIODevice& device, const QByteArray& bytes, const QString& message,
             const QString& where);

// Writes all bytes and flushes them to the operating system. If it returns false, the file's
// errorString() says why.
bool writeAll(QFileDevice& file, const QByteArray& bytes);

} // namespace dipwright
