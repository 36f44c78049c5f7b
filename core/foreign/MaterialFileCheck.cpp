#include "foreign/MaterialFileCheck.h"

#include <QCoreApplication>

#include <algorithm>
#include <initializer_list>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

bool startsWithAny(QByteArrayView line, std::initializer_list<const char*> words,
                   Qt::CaseSensitivity sensitivity) {
    return std::any_of(words.begin(), words.end(), [&](const char* word) {
        const auto size = qsizetype(qstrlen(word));
        return line.size() >= size && line.first(size).compare(word, sensitivity) == 0;
    });
}

// Pictures, and what physically based materials have beside their colours: all else assimp passes
// over where there is no material, a heading such as "Alias OBJ Material File" too.
bool needsMaterial(QByteArrayView line) {
    return startsWithAny(line, {"map_", "bump", "disp", "decal", "refl", "norm"},
                         Qt::CaseInsensitive) ||
           startsWithAny(line, {"a", "Pr", "Pm", "Ps", "Pc"}, Qt::CaseSensitive);
}

} // namespace

QString faultOfMaterials(const QByteArray& bytes, const QString& name) {
    QByteArrayView rest(bytes);
    while (!rest.isEmpty()) {
        const auto end = std::find_if(rest.begin(), rest.end(), [](char byte) {
            return byte == '\n' || byte == '\r' || byte == '\f' || byte == '\0';
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
