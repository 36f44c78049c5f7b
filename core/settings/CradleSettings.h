// The user's settings for cradles.
#pragma once

#include "base/Units.h"

namespace dipwright {

// The defaults suit a 3D printer (melted plastic) with a 0.4 mm nozzle and a 220 mm bed.
struct CradleSettings {
    Millimetres clearance{0.3}; // gap between cradle and body
    Millimetres wall{3};        // thinnest wall that holds the body
    Millimetres reach{15}; // height of the cradle below the body's top; more if the body would tip
    Millimetres paintDistance{4}; // distance kept from this dip's film and from earlier paint
    bool onPaint = false;         // whether the cradle may touch earlier paint, through padding
    Millimetres padding{1.5};     // room left for the padding
    Millimetres plateThickness{5};
    Millimetres pinSpan{180};        // largest distance between two pins along an edge
    Millimetres standoff{10};        // distance from the plate to the water at the end of the dip
    Millimetres pinDiameter{6};      // diameter of the datum pins
    Millimetres pinClearance{0.1};   // gap between pin and hole, all round
    Millimetres bore{8};             // hole through plate and seat to fix the body; 0: none
    Millimetres engravingDepth{0.8}; // 0: no engraving
    Millimetres cell{0.5};           // cell size of the grid that the shape is computed on
    bool operator==(const CradleSettings&) const = default;
};

} // namespace dipwright
