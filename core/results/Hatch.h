// Lines across a picture over what is marked.
#pragma once

#include "dip/FilmMarks.h"

#include <QRgb>

class QPainter;
class QRectF;

namespace dipwright {

// Slanting lines, one in the mark's colour beside a white one so that they show on any colour, and
// what lies between them left as it is.
class Hatch {
public:
    // `longEdge` of the picture, pixels.
    explicit Hatch(int longEdge);

    // Whether a line goes over a pixel, and its colour there.
    bool isOn(int x, int y) const { return 2 * along(x, y) < period_; }
    QRgb colour(int x, int y, solver::PointMark mark) const;

private:
    int along(int x, int y) const { return (x + y) % period_; }

    int period_; // pixels along a row
};

// A small piece of hatched ground, for a legend; `box` and the lines in the painter's units.
void paintHatched(QPainter& painter, const QRectF& box, solver::PointMark mark);

} // namespace dipwright
