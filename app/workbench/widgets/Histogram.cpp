#include "workbench/widgets/Histogram.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

constexpr int barCount = 80;

// Returns a step that divides `range` into about `wanted` parts. The step is 1, 2 or 5 times a
// power of ten.
double roundStep(double range, double wanted) {
    const double raw = range / wanted;
    const double power = std::pow(10, std::floor(std::log10(raw)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= raw) {
            return factor * power;
        }
    }
    return 10 * power;
}

} // namespace

Histogram::Histogram(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Histogram"));
}

void Histogram::setValues(const std::vector<float>& values, const HeatScale& scale) {
    scale_ = scale;
    counts_.assign(values.empty() ? 0 : barCount, 0);
    for (const float value : values) {
        const double share = (double(value) - scale.low) / (scale.high - scale.low);
        ++counts_[std::size_t(std::clamp(int(share * barCount), 0, barCount - 1))];
    }
    update();
}

void Histogram::setMark(const std::optional<double>& value) {
    mark_ = value;
    update();
}

void Histogram::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paint(painter, rect(), palette().color(QPalette::WindowText));
}

void Histogram::paint(QPainter& painter, const QRectF& place, const QColor& ink) const {
    if (counts_.empty()) {
        return;
    }
    const QFontMetricsF metrics(painter.font());
    const double keyHeight = 0.7 * metrics.height();
    const QRectF key(place.left() + 12, place.bottom() - metrics.height() - 1.5 * keyHeight,
                     place.width() - 24, keyHeight);
    const double top = place.top() + 4, barsHeight = key.top() - top;
    const auto across = [&](double value) {
        const double share = (value - scale_.low) / (scale_.high - scale_.low);
        return key.left() + std::clamp(share, 0.0, 1.0) * key.width();
    };
    // Heights are square roots; otherwise the unstretched film would hide everything else.
    const double most = std::sqrt(double(*std::max_element(counts_.begin(), counts_.end())));
    const double barWidth = key.width() / barCount;
    QPolygonF outline; // makes bars in the background colour visible
    for (int bar = 0; bar < barCount; ++bar) {
        const double value = std::lerp(scale_.low, scale_.high, (bar + 0.5) / barCount);
        const QColor colour = scale_.colour(value);
        const double share = std::sqrt(double(counts_[std::size_t(bar)])) / most;
        const double left = key.left() + bar * barWidth;
        painter.fillRect(QRectF(left, key.top() - share * barsHeight, barWidth, share * barsHeight),
                         colour);
        outline << QPointF(left, key.top() - share * barsHeight)
                << QPointF(left + barWidth, key.top() - share * barsHeight);
        painter.fillRect(QRectF(left, key.top() + 1, barWidth + 0.5, key.height() - 1), colour);
    }
    QColor faint = ink;
    faint.setAlphaF(0.6f);
    painter.setPen(faint);
    painter.drawPolyline(outline);
    painter.setPen(ink);
    const double labelWidth = metrics.horizontalAdvance(QStringLiteral("0.000"));
    const double step = roundStep(scale_.high - scale_.low,
                                  std::max(2.0, std::floor(key.width() / (labelWidth * 2))));
    for (double tick = std::ceil(scale_.low / step - 1e-9) * step; tick <= scale_.high + 1e-9;
         tick += step) {
        const double x = across(tick);
        painter.drawLine(QPointF(x, key.bottom()), QPointF(x, key.bottom() + 3));
        const QString label = locale().toString(tick, 'g', 4);
        const double width = metrics.horizontalAdvance(label);
        const double left = std::clamp(x - width / 2, place.left(), place.right() - width);
        painter.drawText(QPointF(left, place.bottom() - metrics.descent()), label);
    }
    if (mark_) {
        painter.setPen(QPen(ink, 2));
        painter.drawLine(QPointF(across(*mark_), top), QPointF(across(*mark_), key.bottom()));
    }
}

} // namespace dipwright
