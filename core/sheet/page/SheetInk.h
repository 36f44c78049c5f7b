// Draws marks, rulers and lettering. The painters' unit is the millimetre.
#pragma once

#include "sheet/page/SheetLayout.h"

#include <QPainterPath>

namespace dipwright {

inline constexpr double hairline = 0.1; // mm

// Draws lines and text, with a white rim if they stand on ink. Text stays searchable in a PDF.
class SheetInk {
public:
    SheetInk(QPainter& painter, bool rimmed, const QColor& colour = Qt::black)
        : painter_(painter), rimmed_(rimmed), colour_(colour) {}

    void stroke(const QPainterPath& path) const;
    // `baseline` is the left end of the text's baseline, `height` the height of the font in mm.
    void text(QPointF baseline, double height, const QString& text) const;

private:
    QPainter& painter_;
    bool rimmed_;
    QColor colour_;
};

// Draws a circle with a cross. `first` is the mark in the upper left; two of its quarters are
// filled, to show whether a sheet is turned or flipped.
void paintMark(QPainter& painter, const SheetMark& mark, bool first);
// Draws a ruler with a scale in mm along a strip.
void paintRuler(QPainter& painter, const SheetStrip& strip);
// Draws everything that is printed around the film image.
void paintMarks(QPainter& painter, const SheetLayout& layout);

} // namespace dipwright
