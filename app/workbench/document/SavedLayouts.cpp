#include "workbench/document/SavedLayouts.h"

#include <QSettings>

namespace dipwright {

namespace {

const char* const key = "window/layouts"; // a map: keys allow fewer characters than names

} // namespace

QStringList savedLayouts() {
    return QSettings().value(QLatin1String(key)).toMap().keys();
}

QByteArray savedLayout(const QString& name) {
    return QSettings().value(QLatin1String(key)).toMap().value(name).toByteArray();
}

void saveLayout(const QString& name, const QByteArray& state) {
    QSettings settings;
    QVariantMap layouts = settings.value(QLatin1String(key)).toMap();
    layouts[name] = state;
    settings.setValue(QLatin1String(key), layouts);
}

void removeLayout(const QString& name) {
    QSettings settings;
    QVariantMap layouts = settings.value(QLatin1String(key)).toMap();
    layouts.remove(name);
    settings.setValue(QLatin1String(key), layouts);
}

} // namespace dipwright
