#include "project/FieldJson.h"

#include "base/Error.h"

#include <QCoreApplication>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Project)
};

} // namespace

QJsonValue valueAt(const QJsonObject& json, const QString& path, const QString& file) {
    const auto dot = path.indexOf(QLatin1Char('.'));
    if (dot < 0) {
        return json.value(path);
    }
    const QString head = path.left(dot);
    const QJsonValue inner = json.value(head);
    if (inner.isUndefined()) {
        return inner;
    }
    if (!inner.isObject()) {
        throw Error(Text::tr("“%1” must be an object").arg(head), file);
    }
    return valueAt(inner.toObject(), path.mid(dot + 1), file);
}

void insertAt(QJsonObject& json, const QString& path, const QJsonValue& value) {
    const auto dot = path.indexOf(QLatin1Char('.'));
    if (dot < 0) {
        json.insert(path, value);
        return;
    }
    QJsonObject inner = json.value(path.left(dot)).toObject();
    insertAt(inner, path.mid(dot + 1), value);
    json.insert(path.left(dot), inner);
}

void removeAt(QJsonObject& json, const QString& path) {
    const auto dot = path.indexOf(QLatin1Char('.'));
    if (dot < 0) {
        json.remove(path);
        return;
    }
    const QString head = path.left(dot);
    if (!json.value(head).isObject()) {
        return;
    }
    QJsonObject inner = json.value(head).toObject();
    removeAt(inner, path.mid(dot + 1));
    if (inner.isEmpty()) {
        json.remove(head);
    } else {
        json.insert(head, inner);
    }
}

} // namespace dipwright
