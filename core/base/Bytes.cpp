#include "base/Bytes.h"

#include <QBuffer>

namespace dipwright {

QByteArray bytesOf(const std::function<void(QIODevice&)>& write) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    write(buffer);
    return bytes;
}

} // namespace dipwright
