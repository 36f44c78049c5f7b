// The program's own icons, drawn in the colours of the palette.
#pragma once

#include <QIcon>
#include <QString>

namespace dipwright {

// `name`: a file in resources/icons, without .svg. The icon follows the theme and scales to any
// size.
QIcon icon(const QString& name);

} // namespace dipwright
