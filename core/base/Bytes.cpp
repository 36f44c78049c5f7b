#include "base/Bytes.h"

#include <QBuffer>
#include <QSaveFile>

namespace dipwright {

QByteArray bytesOf(const std::function<void(QIODevice&)>& write) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    write(buffer);
    return bytes;
}

bool writeAll(QFileDevice& file, const QByteArray& bytes) {
    // On a full disk the first write is a short one, and only the next tells the reason.
    for (qint64 written = 0; written < bytes.size();) {
        const qint64 more = file.write(bytes.constData() + written, bytes.size() - written);
        if (more <= 0) {
            return false;
        }
        written += more;
    }
    return file.flush();
}

QString replaceFile(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path); // temporary beside the target, flushed to the disk, renamed over it
    // Committing after a failure would forget the reason.
    const bool good = file.open(QIODevice::WriteOnly) && writeAll(file, bytes) && file.commit();
    return good ? QString() : file.errorString();
}

} // namespace dipwright
