#include "base/Bytes.h"

#include "base/Error.h"

#include <QBuffer>

namespace dipwright {

QByteArray bytesOf(const std::function<void(QIODevice&)>& write) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    write(buffer);
    return bytes;
}

void writeTo(QIODevice& device, const QByteArray& bytes, const QString& message,
             const QString& where) {
    if (device.write(bytes) != bytes.size()) {
        throw Error(message.arg(device.errorString()), where);
    }
}

bool writeAll(QFileDevice& file, const QByteArray& bytes) {
    // On a full disk the first write is short, and only the next write reports the reason.
    for (qint64 written = 0; written < bytes.size();) {
        const qint64 more = file.write(bytes.constData() + written, bytes.size() - written);
        if (more <= 0) {
            return false;
        }
        written += more;
    }
    return file.flush() || file.flush(); // the second flush reports the reason
}

} // namespace dipwright
