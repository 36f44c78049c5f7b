#include "workbench/inspection/PhotoView.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

constexpr double markRadius = 6; // pixels of the window
constexpr double grip = 9;       // pixels; a press this near takes hold of a mark
constexpr double stillness = 4;  // pixels; a click moves less than this
const QColor markColour(0x12, 0x8c, 0xe8);
const QColor chosenColour(0xff, 0xb0, 0x20);
const QColor residualColour(0xe0, 0x30, 0x50);

void drawOutlined(QPainter& painter, const QColor& colour, double width, const auto& draw) {
    for (const auto& [pen, thick] :
         {std::pair(QColor(255, 255, 255, 220), width + 2), std::pair(colour, width)}) {
        painter.setPen(QPen(pen, thick, Qt::SolidLine, Qt::RoundCap));
        draw();
    }
}

} // namespace

void PhotoView::setMarks(const QList<QPointF>& marks) {
    marks_ = marks;
    chosen_ = chosen_ < marks.size() ? chosen_ : -1;
    dragged_ = dragged_ < marks.size() ? dragged_ : -1;
    update();
}

void PhotoView::setChosen(int mark) {
    chosen_ = mark;
    update();
}

void PhotoView::setPending(const std::optional<QPointF>& place) {
    pending_ = place;
    update();
}

void PhotoView::setResiduals(const QList<QLineF>& residuals) {
    residuals_ = residuals;
    update();
}

double PhotoView::enlargement() const {
    double longest = 1e-3;
    for (const QLineF& line : residuals_) {
        longest = std::max(longest, line.length());
    }
    const double room = std::max(picture().width(), picture().height()) / 20.0;
    return std::max(1.0, std::pow(10, std::floor(std::log10(room / longest))));
}

void PhotoView::paintOver(QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const double times = enlargement();
    for (const QLineF& line : residuals_) {
        const QPointF from = widgetAt(line.p1());
        const QPointF end = widgetAt(line.p1() + times * (line.p2() - line.p1()));
        drawOutlined(painter, residualColour, 1.4, [&] {
            painter.drawEllipse(from, 3.0, 3.0);
            painter.drawLine(from, end);
        });
    }
    for (int i = 0; i < marks_.size(); ++i) {
        const QPointF at = widgetAt(marks_[i]);
        drawOutlined(painter, i == chosen_ ? chosenColour : markColour, 1.6, [&] {
            painter.drawEllipse(at, markRadius, markRadius);
            painter.drawPoint(at);
        });
        painter.drawText(at + QPointF(markRadius + 3, -3), QString::number(i + 1));
    }
    if (pending_) {
        const QPointF at = widgetAt(*pending_);
        drawOutlined(painter, chosenColour, 1.6, [&] {
            painter.drawLine(at - QPointF(9, 0), at + QPointF(9, 0));
            painter.drawLine(at - QPointF(0, 9), at + QPointF(0, 9));
        });
    }
    if (!residuals_.isEmpty()) {
        const QString words = tr("Lines: residuals, scale %1:1").arg(QLocale().toString(times));
        QRectF band(0, height() - 22, width(), 22);
        painter.fillRect(band, QColor(255, 255, 255, 210));
        painter.setPen(Qt::black);
        painter.drawText(band.adjusted(6, 0, -6, 0), Qt::AlignVCenter, words);
    }
}

int PhotoView::markNear(QPointF inWidget) const {
    int nearest = -1;
    double within = grip;
    for (int i = 0; i < marks_.size(); ++i) {
        const double away = QLineF(widgetAt(marks_[i]), inWidget).length();
        if (away < within) {
            within = away;
            nearest = i;
        }
    }
    return nearest;
}

void PhotoView::mousePressEvent(QMouseEvent* event) {
    pressed_ = event->position();
    dragged_ = event->button() == Qt::LeftButton ? markNear(event->position()) : -1;
    if (dragged_ >= 0) {
        setChosen(dragged_);
        emit markChosen(dragged_);
        return;
    }
    PictureView::mousePressEvent(event);
}

void PhotoView::mouseMoveEvent(QMouseEvent* event) {
    if (dragged_ < 0) {
        PictureView::mouseMoveEvent(event);
        return;
    }
    const QPointF place = pictureAt(event->position());
    if (contains(place) && QLineF(pressed_, event->position()).length() >= stillness) {
        pressed_ = QPointF(-1e6, -1e6); // every further move is a drag
        emit markDragged(dragged_, place);
    }
}

void PhotoView::mouseReleaseEvent(QMouseEvent* event) {
    if (dragged_ >= 0) {
        dragged_ = -1;
        emit markDropped();
        return;
    }
    const QPointF place = pictureAt(event->position());
    const bool isStill = QLineF(pressed_, event->position()).length() < stillness;
    if (event->button() == Qt::LeftButton && isStill && contains(place)) {
        emit clicked(place);
    }
}

void PhotoView::keyPressEvent(QKeyEvent* event) {
    if ((event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace) && chosen_ >= 0) {
        emit removeAsked(chosen_);
        return;
    }
    PictureView::keyPressEvent(event);
}

} // namespace dipwright
