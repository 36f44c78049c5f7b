#include "foreign/MaterialFileCheck.h"

#include <QCoreApplication>

#include <algorithm>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

// Pictures, and what physically based materials have beside their colours: all else assimp passes
// over where there is no material.
bool needsMaterial(QByteArrayView line) {
    for (const char* word : {"map_", "bump", "disp", "decal", "refl", "norm", "a", "P"}) {
        if (line.size() >= qsizetype(qstrlen(word)) &&
            line.first(qsizetype(qstrlen(word))).compare(word, Qt::CaseInsensitive) == 0) {
            return true;
        }
    }
    return false;
}

} // namespace

QString faultOfMaterials(const QByteArray& bytes, const QString& name) {
    QByteArrayView rest(bytes);
    while (!rest.isEmpty()) {
        const auto end = std::find_if(rest.begin(), rest.end(), [](char byte) {
            return byte == '\n' || byte == '\r' || byte == '\0';
        });
        const QByteArrayView line = QByteArrayView(rest.begin(), end).trimmed();
        rest = rest.sliced(std::min(qsizetype(end - rest.begin()) + 1, rest.size()));
        if (line.startsWith("newmtl")) {
            return QString();
        }
        if (needsMaterial(line)) {
            return Text::tr("%1 describes a material before it names any").arg(name);
        }
    }
    return QString();
}

} // namespace dipwright
