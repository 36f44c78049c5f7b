// Writes a cradle as STL or 3MF, in mm, placed on the printer bed by Cradle::poseToPrinter. Equal
// cradles give equal bytes. Reentrant.
#pragma once

#include "cradle/Cradle.h"

#include <QByteArray>

namespace dipwright {

// Returns a binary STL file.
QByteArray cradleStl(const Cradle& cradle);
// Returns a 3MF package (core specification 1.3) with one object of one mesh, named `title`.
QByteArray cradle3mf(const Cradle& cradle, const QString& title);

} // namespace dipwright
