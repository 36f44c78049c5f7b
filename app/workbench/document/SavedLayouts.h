// Stores named arrangements of a window's panels.
#pragma once

#include <QByteArray>
#include <QStringList>

namespace dipwright {

QStringList savedLayouts(); // sorted names
QByteArray savedLayout(const QString& name);
// Replaces a layout with the same name.
void saveLayout(const QString& name, const QByteArray& state);
void removeLayout(const QString& name);

} // namespace dipwright
