// Fuzzes the readers of pictures, of all supported formats.
#include "base/Error.h"
#include "import/sandboxed/PhotoFacts.h"
#include "import/sandboxed/PictureReader.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const QByteArray bytes(reinterpret_cast<const char*>(data), qsizetype(size));
    dipwright::photoFacts(bytes);
    try {
        dipwright::PictureReader().read(bytes, QStringLiteral("x"));
    } catch (const dipwright::Error&) {
    }
    return 0;
}
