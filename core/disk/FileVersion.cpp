#include "disk/FileVersion.h"

#include <QCryptographicHash>
#include <QFile>

namespace dipwright {

FileVersion FileVersion::of(const QString& path) {
    FileVersion version;
    QFile file(path);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (file.open(QIODevice::ReadOnly) && hash.addData(&file)) {
        version.hash_ = hash.result();
    }
    return version;
}

FileVersion FileVersion::ofBytes(const QByteArray& bytes) {
    FileVersion version;
    version.hash_ = QCryptographicHash::hash(bytes, QCryptographicHash::Sha256);
    return version;
}

} // namespace dipwright
