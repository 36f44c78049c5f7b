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

// Returns the size of header and triangles of a binary file; nothing if the file is not binary. The
// first word does not decide, as many binary files begin with "solid". Instead, the count of
// triangles decides: in an ASCII file, its four bytes are letters that give a number far too large
// for the file.
std::optional<qsizetype> binarySize(const QByteArray& bytes) {
    if (bytes.size() < headerBytes) {
        return std::nullopt;
    }
    const auto count = qFromLittleEndian<quint32>(bytes.constData() + countPlace);
    const qsizetype size = headerBytes + triangleBytes * qsizetype(count);
    return size <= bytes.size() ? std::optional(size) : std::nullopt;
}

const QByteArrayView solid = "solid"; // first word of an ASCII file

bool isAscii(QByteArrayView text) {
    return text.first(std::min(text.size(), solid.size())).compare(solid, Qt::CaseInsensitive) == 0;
}

// Whether an ASCII file closes its last solid. Some programs write comments or zeros after it.
bool isClosed(QByteArrayView text) {
    constexpr qsizetype farthest = 1 << 16; // bytes from the end
    const QByteArray end = text.last(std::min(text.size(), farthest)).toByteArray().toLower();
    return std::max(end.lastIndexOf("endsolid"), end.lastIndexOf("end solid")) >
           end.lastIndexOf("endfacet");
}

bool isInCapitals(QByteArrayView text) {
    return !text.startsWith(solid) || text.contains("FACET");
}

} // namespace

QByteArray stlForAssimp(const ModelSource& source) {
    const QByteArray& bytes = source.bytes;
    if (const auto size = binarySize(bytes)) {
        if (mayBeFurtherRows(QByteArrayView(bytes).sliced(*size), triangleBytes)) {
            source.throwDamaged(Text::tr("it holds more data than its header declares"));
        }
        return QByteArray::fromRawData(bytes.constData(), *size);
    }
    const QByteArrayView text = QByteArrayView(bytes).trimmed();
    if (!isAscii(text)) {
        return bytes;
    }
    if (!isClosed(text)) {
        source.throwDamaged(Text::tr("it ends too early"));
    }
    return isInCapitals(text) ? text.toByteArray().toLower() : text.toByteArray();
}

} // namespace dipwright
