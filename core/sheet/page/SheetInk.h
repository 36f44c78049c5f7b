// How marks, rulers and lettering are drawn. Painters' units are millimetres.
#pragma once

#include "sheet/page/SheetLayout.h"

#include <QPainterPath>

namespace dipwright {

inline constexpr double hairline = 0.1; // mm

// Draws lines, and text as text, with a white rim round them where they stand on paint.
class SheetInk {
public:
    SheetInk(QPainter& painter, bool rimmed, const QColor& colour = Qt::black)
        : painter_(painter), rimmed_(rimmed), colour_(colour) {}

    void stroke(const QPainterPath& path) const;
    // `baseline`: the left end of the text's baseline; `height` of the type, mm.
    void text(QPointF baseline, double height, const QString& text) const;

private:
    QPainter& painter_;
    bool rimmed_;
    QColor colour_;
};

// A circle and a cross. The upper left one, the `first`, is filled in two quarters: a sheet that
// was turned or turned over shows it.
void paintMark(QPainter& painter, const SheetMark& mark, bool first);
// A ruler with its scale in mm along a strip.
void paintRuler(QPainter& painter, const SheetStrip& strip);
// All that is printed round the film image.
void paintMarks(QPainter& painter, const SheetLayout& layout);

} // namespace dipwright
