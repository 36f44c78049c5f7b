// Words, boxes and pictures on a traveller's page. The painter's unit is the millimetre.
#pragma once

#include <QImage>
#include <QPainter>
#include <QRectF>
#include <QString>

namespace dipwright {

class PageInk {
public:
    explicit PageInk(QPainter& painter) : painter_(painter) {}

    // In as many lines as it takes; returns the y under the last one. `height` of the type, mm.
    // Never bold: Qt writes two fonts into a PDF in an order that differs from run to run.
    double text(const QRectF& place, double height, const QString& text,
                Qt::Alignment alignment = Qt::AlignLeft) const;
    // As large as `place` takes it, its proportions kept, in the middle; returns where it is.
    QRectF picture(const QRectF& place, const QImage& image) const;
    void line(QPointF from, QPointF to, double width, const QColor& colour = Qt::black,
              Qt::PenStyle style = Qt::SolidLine) const;
    void box(const QRectF& place, double width, const QColor& colour = Qt::black,
             Qt::PenStyle style = Qt::SolidLine) const;
    // From `from` to its head at `to`.
    void arrow(QPointF from, QPointF to, const QColor& colour) const;
    // To be ticked, with its words beside it; returns the y under them.
    double tick(QPointF corner, double width, double height, const QString& words) const;

private:
    QPainter& painter_;
};

} // namespace dipwright
