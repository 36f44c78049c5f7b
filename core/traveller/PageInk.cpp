#include "traveller/PageInk.h"

#include "sheet/page/PrintableText.h"
#include "sheet/page/SheetLayout.h"

#include <QPen>

#include <algorithm>
#include <cmath>

namespace dipwright {

double PageInk::text(const QRectF& place, double height, const QString& text,
                     Qt::Alignment alignment) const {
    painter_.save();
    painter_.translate(place.topLeft());
    painter_.scale(typeUnit, typeUnit);
    const QFont font = sheetFont(height);
    painter_.setFont(font);
    painter_.setPen(Qt::black);
    const QRectF room(0, 0, place.width() / typeUnit, 1e6);
    QRectF taken;
    painter_.drawText(room, int(alignment) | Qt::AlignTop | Qt::TextWordWrap,
                      printableText(text, font), &taken);
    painter_.restore();
    return place.y() + taken.height() * typeUnit;
}

QRectF PageInk::picture(const QRectF& place, const QImage& image) const {
    if (image.isNull()) {
        return place;
    }
    const double scale = std::min(place.width() / image.width(), place.height() / image.height());
    QRectF target(0, 0, image.width() * scale, image.height() * scale);
    target.moveCenter(place.center());
    painter_.drawImage(target, image);
    return target;
}

void PageInk::line(QPointF from, QPointF to, double width, const QColor& colour,
                   Qt::PenStyle style) const {
    painter_.setPen(QPen(colour, width, style, Qt::FlatCap));
    painter_.drawLine(from, to);
}

void PageInk::box(const QRectF& place, double width, const QColor& colour,
                  Qt::PenStyle style) const {
    painter_.setPen(QPen(colour, width, style, Qt::FlatCap, Qt::MiterJoin));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawRect(place);
}

void PageInk::arrow(QPointF from, QPointF to, const QColor& colour) const {
    constexpr double head = 2.4, half = 1.1;
    const QPointF way = to - from;
    const QPointF along = way / std::hypot(way.x(), way.y());
    const QPointF across(-along.y(), along.x());
    line(from, to - head * along, 0.5, colour);
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(colour);
    painter_.drawPolygon(
        QPolygonF({to, to - head * along + half * across, to - head * along - half * across}));
}

double PageInk::tick(QPointF corner, double width, double height, const QString& words) const {
    const double side = 1.1 * height;
    box(QRectF(corner, QSizeF(side, side)), 0.25);
    const double left = side + 2;
    return text({corner.x() + left, corner.y() - 0.15 * height, width - left, 0}, height, words);
}

} // namespace dipwright
