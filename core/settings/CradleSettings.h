// What the user says of cradles.
#pragma once

#include "base/Units.h"

namespace dipwright {

// The defaults suit a printer of melted plastic with a nozzle of 0.4 mm and a bed of 220 mm.
struct CradleSettings {
    Millimetres clearance{0.3};   // between cradle and body
    Millimetres wall{3};          // of what holds the body, at its thinnest
    Millimetres reach{15};        // from the body's top down; farther where it would tip
    Millimetres paintDistance{4}; // from all that film reaches, and from earlier paint
    bool onPaint = false;         // earlier paint may be touched, through padding
    Millimetres padding{1.5};     // room left for it there
    Millimetres plateThickness{5};
    Millimetres pinSpan{180};        // between two pins along an edge, at most
    Millimetres standoff{10};        // of the plate from the water at the end of the dip
    Millimetres pinDiameter{6};      // of the datum pins
    Millimetres pinClearance{0.1};   // between pin and hole, all round
    Millimetres bore{8};             // through plate and seat, to fix the body by; 0: none
    Millimetres engravingDepth{0.8}; // 0: nothing is engraved
    Millimetres cell{0.5};           // how fine the form is
    bool operator==(const CradleSettings&) const = default;
};

} // namespace dipwright
