#include "disk/FileVersion.h"

#include "base/Sha256.h"
#include "disk/PlainFile.h"

#include <QFile>

namespace dipwright {
namespace {

constexpr qint64 pieceBytes = 1 << 20;

} // namespace

FileVersion FileVersion::of(const QString& path) {
    FileVersion version;
    QFile file(path);
    if (openToRead(file).isEmpty()) {
        Sha256 hash;
        for (QByteArray bytes = file.read(pieceBytes); !bytes.isEmpty();
             bytes = file.read(pieceBytes)) {
            hash.add(bytes);
        }
        if (file.atEnd()) {
            version.hash_ = hash.result();
        }
    }
    return version;
}

FileVersion FileVersion::fromText(const QString& text) {
    FileVersion version;
    version.hash_ = QByteArray::fromHex(text.toLatin1());
    return version;
}

FileVersion FileVersion::ofBytes(const QByteArray& bytes) {
    FileVersion version;
    version.hash_ = sha256(bytes);
    return version;
}

} // namespace dipwright
