#include "base/JsonText.h"

#include "base/Budgets.h"

#include <algorithm>

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

} // namespace

void requireJsonWithinLimits(const QByteArray& text, const QString& where) {
    const Extent extent = extentOf(text);
    requireWithin(Budget::DocumentDepth, extent.depth, where);
    requireWithin(Budget::DocumentValues, extent.values, where);
}

} // namespace dipwright
