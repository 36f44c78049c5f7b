// Colours of values outside the scale of a colour map.
#pragma once

#include <QColor>
#include <QString>

namespace dipwright {

// Returns the colour of values above the scale of a map (colourMaps() in Results.h). It differs
// from all colours of the map with any colour vision. Throws Error for an unknown map.
QColor colourAbove(const QString& map);

} // namespace dipwright
