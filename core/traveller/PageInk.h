// Draws text, boxes and pictures on a page of the traveller. The painter's unit is the millimetre.
#pragma once

#include <QImage>
#include <QPainter>
#include <QRectF>
#include <QString>

namespace dipwright {

class PageInk {
public:
    explicit PageInk(QPainter& painter) : painter_(painter) {}

    // Wraps the text to the width of `place` and returns the y below its last line. `height` is the
    // height of the font in mm. The font is never bold, because Qt writes two fonts into a PDF in
    // an order that differs from run to run.
    double text(const QRectF& place, double height, const QString& text,
                Qt::Alignment alignment = Qt::AlignLeft) const;
    // Draws the image in the middle of `place`, as large as possible without distortion. Returns
    // the rectangle that the image fills.
    QRectF picture(const QRectF& place, const QImage& image) const;
    void line(QPointF from, QPointF to, double width, const QColor& colour = Qt::black,
              Qt::PenStyle style = Qt::SolidLine) const;
    void box(const QRectF& place, double width, const QColor& colour = Qt::black,
             Qt::PenStyle style = Qt::SolidLine) const;
    // Draws an arrow whose head is at `to`.
    void arrow(QPointF from, QPointF to, const QColor& colour) const;
    // Draws a checkbox with text beside it. Returns the y below the text.
    double tick(QPointF corner, double width, double height, const QString& words) const;

private:
    QPainter& painter_;
};

} // namespace dipwright
