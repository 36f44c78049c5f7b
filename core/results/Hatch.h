// Draws hatching over marked film in pictures.
#pragma once

#include "dip/FilmMarks.h"

#include <QRgb>

class QPainter;
class QRectF;

namespace dipwright {

// A pattern of slanting lines in the mark's colour. Each line has a white line beside it, so that
// it is visible on any colour. The picture between the lines stays visible.
class Hatch {
public:
    // `longEdge` is the picture's longer side in pixels.
    explicit Hatch(int longEdge);

    // Tells whether a line covers a pixel.
    bool isOn(int x, int y) const { return 2 * along(x, y) < period_; }
    // Returns the colour of a pixel that a line covers.
    QRgb colour(int x, int y, solver::PointMark mark) const;

private:
    int along(int x, int y) const { return (x + y) % period_; }

    int period_; // pixels along a row
};

// Draws a hatched box for a legend. `box` and the lines are in the painter's units.
void paintHatched(QPainter& painter, const QRectF& box, solver::PointMark mark);

} // namespace dipwright
