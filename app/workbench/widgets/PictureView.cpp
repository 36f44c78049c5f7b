#include "workbench/widgets/PictureView.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScreen>
#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

constexpr double margin = 8; // pixels around a fitted picture

void paintTransparency(QPainter& painter, const QRectF& rect, const QPalette& palette) {
    QPixmap tile(16, 16);
    const bool dark = palette.color(QPalette::Window).lightness() < 128;
    tile.fill(dark ? QColor(0x3a, 0x3e, 0x45) : QColor(0xff, 0xff, 0xff));
    QPainter squares(&tile);
    const QColor other = dark ? QColor(0x33, 0x37, 0x3d) : QColor(0xec, 0xee, 0xf1);
    squares.fillRect(0, 0, 8, 8, other);
    squares.fillRect(8, 8, 8, 8, other);
    squares.end();
    painter.drawTiledPixmap(rect.toAlignedRect(), tile);
}

} // namespace

PictureView::PictureView(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PictureView::setPicture(const QImage& picture, QSizeF millimetres) {
    const bool sameSize = millimetres == size_ && !picture_.isNull();
    picture_ = picture;
    shrunk_ = {};
    size_ = millimetres;
    if (!sameSize) {
        zoomToFit();
    }
    update();
}

void PictureView::clear(const QString& hint) {
    picture_ = {};
    shrunk_ = {};
    hint_ = hint;
    lines_.clear();
    cursor_.reset();
    update();
}

void PictureView::setLines(const QList<QLineF>& lines) {
    lines_ = lines;
    update();
}

void PictureView::setCursorAt(const std::optional<QPointF>& place) {
    if (place != cursor_) {
        cursor_ = place;
        update();
    }
}

void PictureView::fitNow() {
    if (size_.isEmpty()) {
        return;
    }
    const double across = std::max(16.0, width() - 2 * margin) / size_.width();
    const double down = std::max(16.0, height() - 2 * margin) / size_.height();
    pixelsPerMillimetre_ = std::min(across, down);
    middle_ = {size_.width() / 2, size_.height() / 2};
}

void PictureView::zoomToFit() {
    fits_ = true;
    fitNow();
    update();
    emit zoomChanged();
}

void PictureView::zoomToTrueSize() {
    const double perInch = screen()->physicalDotsPerInch() / 25.4;
    zoomBy(perInch / pixelsPerMillimetre_);
}

void PictureView::zoomBy(double factor, const std::optional<QPointF>& fixed) {
    const QPointF anchor = fixed.value_or(QPointF(width() / 2.0, height() / 2.0));
    const QPointF fromMiddle = anchor - QPointF(width() / 2.0, height() / 2.0);
    const QPointF held = middle_ + fromMiddle / pixelsPerMillimetre_;
    pixelsPerMillimetre_ = std::clamp(pixelsPerMillimetre_ * factor, 0.05, 400.0);
    middle_ = held - fromMiddle / pixelsPerMillimetre_;
    fits_ = false;
    update();
    emit zoomChanged();
}

QRectF PictureView::shownRect() const {
    const QPointF corner = QPointF(width() / 2.0, height() / 2.0) - middle_ * pixelsPerMillimetre_;
    return {corner, size_ * pixelsPerMillimetre_};
}

QPointF PictureView::pictureAt(QPointF inWidget) const {
    return (inWidget - shownRect().topLeft()) / pixelsPerMillimetre_;
}

QPointF PictureView::widgetAt(QPointF millimetres) const {
    return shownRect().topLeft() + millimetres * pixelsPerMillimetre_;
}

bool PictureView::contains(QPointF millimetres) const {
    return !picture_.isNull() && QRectF(QPointF(), size_).contains(millimetres);
}

const QImage& PictureView::shrunk(QSize pixels) {
    if (shrunk_.size() != pixels) {
        shrunk_ = picture_.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    }
    return shrunk_;
}

void PictureView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Window).darker(104));
    if (picture_.isNull()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                         hint_);
        return;
    }
    const QRectF shown = shownRect();
    if (picture_.hasAlphaChannel()) {
        paintTransparency(painter, shown.intersected(QRectF(rect())), palette());
    }
    // A picture drawn smaller than its size is averaged; one drawn larger shows its pixels.
    const double scale = shown.width() * devicePixelRatioF() / picture_.width();
    painter.setRenderHint(QPainter::SmoothPixmapTransform, scale < 3);
    painter.drawImage(shown,
                      scale < 1 ? shrunk((shown.size() * devicePixelRatioF()).toSize()) : picture_);
    painter.setPen(QPen(palette().color(QPalette::Mid), 1));
    painter.drawRect(shown);
    painter.translate(shown.topLeft());
    painter.scale(pixelsPerMillimetre_, pixelsPerMillimetre_);
    QPen linePen(QColor(0, 0, 0, 170), 1.2);
    linePen.setCosmetic(true);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(linePen);
    painter.drawLines(lines_);
    painter.resetTransform();
    if (cursor_) {
        const QPointF place = shown.topLeft() + *cursor_ * pixelsPerMillimetre_;
        for (const auto& [colour, thickness] :
             {std::pair(QColor(255, 255, 255, 200), 3.0), std::pair(QColor(20, 20, 20), 1.2)}) {
            painter.setPen(QPen(colour, thickness));
            painter.drawLine(place - QPointF(10, 0), place - QPointF(3, 0));
            painter.drawLine(place + QPointF(3, 0), place + QPointF(10, 0));
            painter.drawLine(place - QPointF(0, 10), place - QPointF(0, 3));
            painter.drawLine(place + QPointF(0, 3), place + QPointF(0, 10));
        }
    }
    paintOver(painter);
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void PictureView::resizeEvent(QResizeEvent*) {
    if (fits_) {
        fitNow();
        emit zoomChanged();
    }
}

void PictureView::wheelEvent(QWheelEvent* event) {
    zoomBy(std::pow(1.0015, event->angleDelta().y()), event->position());
    event->accept();
}

void PictureView::mousePressEvent(QMouseEvent* event) {
    dragged_ = event->position();
}

void PictureView::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton) {
        middle_ -= (event->position() - dragged_) / pixelsPerMillimetre_;
        dragged_ = event->position();
        fits_ = false;
        update();
        return;
    }
    const QPointF place = pictureAt(event->position());
    if (contains(place)) {
        emit hovered(place);
    } else {
        emit hoverLeft();
    }
}

void PictureView::mouseDoubleClickEvent(QMouseEvent*) {
    zoomToFit();
}

void PictureView::leaveEvent(QEvent*) {
    emit hoverLeft();
}

void PictureView::keyPressEvent(QKeyEvent* event) {
    const double step = 40 / pixelsPerMillimetre_;
    switch (event->key()) {
    case Qt::Key_Plus:
        zoomBy(1.25);
        return;
    case Qt::Key_Minus:
        zoomBy(0.8);
        return;
    case Qt::Key_0:
        zoomToFit();
        return;
    case Qt::Key_1:
        zoomToTrueSize();
        return;
    case Qt::Key_Left:
        middle_.rx() -= step;
        break;
    case Qt::Key_Right:
        middle_.rx() += step;
        break;
    case Qt::Key_Up:
        middle_.ry() -= step;
        break;
    case Qt::Key_Down:
        middle_.ry() += step;
        break;
    default:
        QWidget::keyPressEvent(event);
        return;
    }
    fits_ = false;
    update();
}

} // namespace dipwright
