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

const QByteArrayView solid = "solid"; // begins an ASCII file

bool isAscii(QByteArrayView text) {
    return text.first(std::min(text.size(), solid.size())).compare(solid, Qt::CaseInsensitive) == 0;
}

bool isInCapitals(QByteArrayView text) {
    return !text.startsWith(solid) || text.contains("FACET");
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
    const QByteArrayView text = QByteArrayView(bytes).trimmed();
    if (!isAscii(text)) {
        return bytes;
    }
    return isInCapitals(text) ? text.toByteArray().toLower() : text.toByteArray();
}

} // namespace dipwright
