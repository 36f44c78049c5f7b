// A picture of any format that is read.
#include "base/Error.h"
#include "foreign/PictureReader.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    try {
        dipwright::PictureReader().read(
            QByteArray(reinterpret_cast<const char*>(data), qsizetype(size)), QStringLiteral("x"));
    } catch (const dipwright::Error&) {
    }
    return 0;
}
