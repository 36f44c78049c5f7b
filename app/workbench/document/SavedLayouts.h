// Arrangements of a window's panels that the user has given names.
#pragma once

#include <QByteArray>
#include <QStringList>

namespace dipwright {

QStringList savedLayouts(); // by name
QByteArray savedLayout(const QString& name);
void saveLayout(const QString& name, const QByteArray& state); // over one of the same name
void removeLayout(const QString& name);

} // namespace dipwright
