// Makes the line along which the printed film is cut.
#pragma once

#include "sheet/page/SheetLayout.h"

#include <QPainterPath>

namespace dipwright {

// Returns closed paths on the page, in mm. The settings choose between the film's edge (with
// several jobs, the edge of each piece) and a line round the ink. The line round the ink keeps the
// settings' distance from all plates, white and spot inks included. It stays within the film and
// does not cut out holes. The result is empty if the settings ask for no line or nothing is
// printed.
QPainterPath cutContour(const Sheet& sheet, const SheetLayout& layout);

// The bare places of a film that the ink encloses, such as a mask in the middle of the paint. Bleed
// past the cut contour does not reach them.
class EnclosedPlaces {
public:
    // `film`: the size of the film image, in mm.
    EnclosedPlaces(const Sheet& sheet, QSizeF film);
    // `place`: from the upper left corner of the film, in mm.
    bool contains(QPointF place) const;

private:
    double size_; // side of a cell, mm
    QSize grid_;  // one cell more than the film on each side
    std::vector<unsigned char> isEnclosed_;
};

// Returns how far, in mm, the line round the ink and the bleed past it reach from the ink. 0 if the
// settings ask for no line round the ink.
double cutReach(const SheetSettings& settings);

} // namespace dipwright
