// The colour of masks in the 3D view and on the traveller.
#pragma once

#include <QColor>

namespace dipwright {

// Distinguishable from zones and maps with any colour vision (Okabe & Ito).
inline const QColor maskColour(0xcc, 0x79, 0xa7);

} // namespace dipwright
