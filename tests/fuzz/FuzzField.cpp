// Fuzzes the reader of a cached distance field of 2 × 2 × 2 samples. An accepted field must be
// written back as the same bytes.
#include "geometry/FieldFile.h"

#include <QBuffer>

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    QByteArray bytes(reinterpret_cast<const char*>(data), qsizetype(size));
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::ReadOnly);
    const auto field = dipwright::readField(buffer);
    QByteArray written;
    QBuffer device(&written);
    device.open(QIODevice::WriteOnly);
    if (field && (!dipwright::writeField(*field, device) || written != bytes)) {
        std::abort();
    }
    return 0;
}
