#include "results/Hatch.h"

#include "results/Results.h"

#include <QPainter>

#include <algorithm>

namespace dipwright {

QColor markColour(solver::PointMark mark) {
    switch (mark) {
    case solver::PointMark::Torn:
        return {176, 20, 40};
    case solver::PointMark::Unbalanced:
        return {112, 44, 160};
    case solver::PointMark::LetGo:
        return {222, 110, 0};
    }
    return {};
}

Hatch::Hatch(int longEdge) : period_(std::max(8, longEdge / 80)) {}

QRgb Hatch::colour(int x, int y, solver::PointMark mark) const {
    return 4 * along(x, y) < period_ ? markColour(mark).rgb() : qRgb(255, 255, 255);
}

void paintHatched(QPainter& painter, const QRectF& box, solver::PointMark mark) {
    painter.save();
    painter.setClipRect(box, Qt::IntersectClip);
    painter.fillRect(box, QColor(196, 200, 204));
    const double width = box.height() / 6;
    const auto slanted = [&](double left, const QColor& colour) {
        painter.setPen(QPen(colour, width));
        painter.drawLine(QPointF(left, box.bottom()), QPointF(left + box.height(), box.top()));
    };
    for (double left = box.left() - box.height(); left < box.right(); left += 4 * 1.4 * width) {
        slanted(left, markColour(mark));
        slanted(left + 1.4 * width, Qt::white);
    }
    painter.restore();
}

} // namespace dipwright
