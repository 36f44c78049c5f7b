// The files that a cradle is written to, lying on the bed of a printer (Cradle::poseToPrinter), mm.
// The same bytes for the same cradle. Reentrant.
#pragma once

#include "cradle/Cradle.h"

#include <QByteArray>

namespace dipwright {

// Binary STL.
QByteArray cradleStl(const Cradle& cradle);
// 3MF core specification 1.3: one object of one mesh, in millimetres, called `title`.
QByteArray cradle3mf(const Cradle& cradle, const QString& title);

} // namespace dipwright
