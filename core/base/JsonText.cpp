#include "base/JsonText.h"

#include "base/Budgets.h"

#include <QSet>
#include <algorithm>
#include <vector>

namespace dipwright {
namespace {

struct Extent {
    qint64 values = 0;
    qint64 depth = 0;
};

// Returns the index of the quote that ends the string which begins at `at`, or the end of the text.
qsizetype endOfText(const QByteArray& json, qsizetype at) {
    for (++at; at < json.size() && json[at] != '"'; ++at) {
        at += json[at] == '\\' ? 1 : 0;
    }
    return at;
}

Extent extentOf(const QByteArray& json) {
    Extent extent;
    qint64 depth = 0;
    for (qsizetype at = 0; at < json.size(); ++at) {
        switch (json[at]) {
        case '"':
            at = endOfText(json, at);
            break;
        case '[':
        case '{':
            extent.depth = std::max(extent.depth, ++depth);
            ++extent.values;
            break;
        case ']':
        case '}':
            --depth;
            break;
        case ',':
            ++extent.values;
            break;
        default:
            break;
        }
    }
    return extent;
}

// An object or a list that is being read.
struct Level {
    bool isObject = false;
    QSet<QByteArray> keys = {};
    QByteArray key = {}; // of the value that is being read
    int index = 0;       // likewise
};

QString pathOf(const std::vector<Level>& levels) {
    QString path;
    for (const Level& level : levels) {
        path += level.isObject ? u'.' + QString::fromUtf8(level.key)
                               : QStringLiteral("[%1]").arg(level.index);
    }
    return path.mid(1);
}

} // namespace

QString repeatedKey(const QByteArray& text) {
    std::vector<Level> levels;
    bool isKeyNext = false;
    for (qsizetype at = 0; at < text.size(); ++at) {
        const char sign = text[at];
        if (sign == '{' || sign == '[') {
            levels.push_back({sign == '{'});
            isKeyNext = levels.back().isObject;
        } else if (sign == '}' || sign == ']') {
            levels.pop_back();
            isKeyNext = false;
        } else if (sign == ',') {
            ++levels.back().index;
            isKeyNext = levels.back().isObject;
        } else if (sign == '"') {
            const qsizetype begin = at + 1;
            at = endOfText(text, at);
            if (isKeyNext) {
                Level& level = levels.back();
                level.key = text.mid(begin, at - begin);
                if (level.keys.contains(level.key)) {
                    return pathOf(levels);
                }
                level.keys.insert(level.key);
                isKeyNext = false;
            }
        }
    }
    return {};
}

void requireJsonWithinLimits(const QByteArray& text, const QString& where) {
    const Extent extent = extentOf(text);
    requireWithin(Budget::DocumentDepth, extent.depth, where);
    requireWithin(Budget::DocumentValues, extent.values, where);
}

} // namespace dipwright
