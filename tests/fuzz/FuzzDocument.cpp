// Fuzzes the reader of project.json. An accepted project must survive writing and reading again.
#include "base/Error.h"
#include "project/Project.h"

#include <QJsonDocument>

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    const QByteArray bytes(reinterpret_cast<const char*>(data), qsizetype(size));
    const QJsonObject json = QJsonDocument::fromJson(bytes).object();
    QJsonObject written;
    try {
        written = dipwright::toJson(dipwright::fromJson(json, QStringLiteral("x")));
    } catch (const dipwright::Error&) {
        return 0;
    }
    if (dipwright::toJson(dipwright::fromJson(written, QStringLiteral("x"))) != written) {
        std::abort();
    }
    return 0;
}
