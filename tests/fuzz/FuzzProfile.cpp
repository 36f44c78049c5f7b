// Fuzzes the reader of profiles of all kinds. An accepted profile must survive writing and reading
// again.
#include "base/Error.h"
#include "project/Profiles.h"

#include <QJsonDocument>

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const QByteArray bytes(reinterpret_cast<const char*>(data), qsizetype(size));
    const QJsonObject json = QJsonDocument::fromJson(bytes).object();
    QJsonObject written;
    try {
        written = dipwright::toJson(dipwright::profileFromJson(json, QStringLiteral("x")));
    } catch (const dipwright::Error&) {
        return 0;
    }
    if (dipwright::toJson(dipwright::profileFromJson(written, QStringLiteral("x"))) != written) {
        std::abort();
    }
    return 0;
}
