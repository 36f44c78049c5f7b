#include "base/Bytes.h"

#include "base/Error.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QSaveFile>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Bytes)
};

} // namespace

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
    return file.flush() || file.flush(); // the same of what was buffered
}

QString replaceFile(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path); // temporary beside the target, flushed to the disk, renamed over it
    // Committing after a failure would forget the reason.
    const bool good = file.open(QIODevice::WriteOnly) && writeAll(file, bytes) && file.commit();
    return good ? QString() : file.errorString();
}

void writeWhole(const QString& path, const std::function<void(QIODevice&)>& write) {
    const QString failure = replaceFile(path, bytesOf(write));
    if (!failure.isEmpty()) {
        throw Error(Text::tr("The file cannot be written: %1").arg(failure), path);
    }
}

} // namespace dipwright
