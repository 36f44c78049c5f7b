// The program's own icons, drawn in the colours of the palette.
#pragma once

#include <QIcon>
#include <QString>

namespace dipwright {

// `name` as the file in resources/icons, without .svg. Follows light and dark, any size and scale.
QIcon icon(const QString& name);

} // namespace dipwright
