// Fuzzes the reader of the project's own model format. The sandboxed reader also returns its result
// in this format.
#include "base/Error.h"
#include "model/StoredModel.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const QByteArray bytes(reinterpret_cast<const char*>(data), qsizetype(size));
    for (const auto read : {dipwright::readModel, dipwright::readUncheckedModel}) {
        try {
            read(bytes, QStringLiteral("x"));
        } catch (const dipwright::Error&) {
        }
    }
    return 0;
}
