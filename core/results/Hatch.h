// Hatches marked film in pictures.
#pragma once

#include "dip/FilmMarks.h"

#include <QRgb>

class QPainter;
class QRectF;

namespace dipwright {

// Slanting lines in the mark's colour, each beside a white line so that it shows on any colour. The
// picture between them stays visible.
class Hatch {
public:
    // `longEdge`: of the picture, in pixels.
    explicit Hatch(int longEdge);

    // Whether a line covers a pixel, and its colour there.
    bool isOn(int x, int y) const { return 2 * along(x, y) < period_; }
    QRgb colour(int x, int y, solver::PointMark mark) const;

private:
    int along(int x, int y) const { return (x + y) % period_; }

    int period_; // pixels along a row
};

// Draws a hatched box for a legend. `box` and the lines are in the painter's units.
void paintHatched(QPainter& painter, const QRectF& box, solver::PointMark mark);

} // namespace dipwright
