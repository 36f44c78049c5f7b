#include "import/sandboxed/StlBytes.h"

#include <QCoreApplication>
#include <QtEndian>

#include <algorithm>
#include <optional>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

constexpr qsizetype countPlace = 80, headerBytes = 84, triangleBytes = 50;

// Of header and triangles of a binary file; nothing where it is none, however it begins: many begin
// with "solid". In ASCII, four letters stand for a count that no file is long enough for.
std::optional<qsizetype> binarySize(const QByteArray& bytes) {
    if (bytes.size() < headerBytes) {
        return std::nullopt;
    }
    const auto count = qFromLittleEndian<quint32>(bytes.constData() + countPlace);
    const qsizetype size = headerBytes + triangleBytes * qsizetype(count);
    return size <= bytes.size() ? std::optional(size) : std::nullopt;
}

bool isAsciiInCapitals(const QByteArray& bytes) {
    const QByteArrayView solid = "solid";
    const QByteArrayView text = QByteArrayView(bytes).trimmed();
    const QByteArrayView begin = text.first(std::min(text.size(), solid.size()));
    return begin.compare(solid, Qt::CaseInsensitive) == 0 &&
           (begin != solid || text.contains("FACET"));
}

} // namespace

QByteArray stlForAssimp(const ModelSource& source) {
    const QByteArray& bytes = source.bytes;
    if (const auto size = binarySize(bytes)) {
        if (areFurtherRows(QByteArrayView(bytes).sliced(*size), triangleBytes)) {
            source.throwDamaged(Text::tr("it holds more than its header counts"));
        }
        return QByteArray::fromRawData(bytes.constData(), *size);
    }
    return isAsciiInCapitals(bytes) ? bytes.toLower() : bytes;
}

} // namespace dipwright
