// Fuzzes the template for motion files.
#include "base/Error.h"
#include "traveller/Motion.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const QByteArray bytes(reinterpret_cast<const char*>(data), qsizetype(size));
    try {
        dipwright::filledTemplate({QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")},
                                  QString::fromUtf8(bytes), QStringLiteral("x"));
    } catch (const dipwright::Error&) {
    }
    return 0;
}
