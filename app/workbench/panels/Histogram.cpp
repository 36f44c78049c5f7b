#include "panels/Histogram.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

constexpr int barCount = 80;

// 1, 2 or 5 times a power of ten that divides `range` into about `wanted` parts.
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
    if (counts_.empty()) {
        return;
    }
    QPainter painter(this);
    const int line = fontMetrics().height();
    const QRectF key(12, height() - line - 16, width() - 24, 10);
    const double top = 4, barsHeight = key.top() - top;
    // The unstretched film would hide everything else: heights go by the square root.
    const double most = std::sqrt(double(*std::max_element(counts_.begin(), counts_.end())));
    const double barWidth = key.width() / barCount;
    for (int bar = 0; bar < barCount; ++bar) {
        const double value = std::lerp(scale_.low, scale_.high, (bar + 0.5) / barCount);
        const QColor colour = scale_.colour(value);
        const double share = std::sqrt(double(counts_[std::size_t(bar)])) / most;
        const double left = key.left() + bar * barWidth;
        painter.fillRect(QRectF(left, key.top() - share * barsHeight, barWidth, share * barsHeight),
                         colour);
        painter.fillRect(QRectF(left, key.top() + 1, barWidth + 0.5, key.height() - 1), colour);
    }
    painter.setPen(palette().color(QPalette::WindowText));
    const double labelWidth = fontMetrics().horizontalAdvance(QStringLiteral("0.000"));
    const double step = roundStep(scale_.high - scale_.low,
                                  std::max(2.0, std::floor(key.width() / (labelWidth * 2))));
    for (double tick = std::ceil(scale_.low / step - 1e-9) * step; tick <= scale_.high + 1e-9;
         tick += step) {
        const double x =
            key.left() + (tick - scale_.low) / (scale_.high - scale_.low) * key.width();
        painter.drawLine(QPointF(x, key.bottom()), QPointF(x, key.bottom() + 3));
        const QString label = locale().toString(tick, 'g', 4);
        const double half = fontMetrics().horizontalAdvance(label) / 2.0;
        const double left = std::clamp(x - half, 0.0, width() - 2 * half);
        painter.drawText(QPointF(left, height() - fontMetrics().descent()), label);
    }
    if (mark_) {
        const double share = (*mark_ - scale_.low) / (scale_.high - scale_.low);
        const double x = key.left() + std::clamp(share, 0.0, 1.0) * key.width();
        painter.setPen(QPen(palette().color(QPalette::WindowText), 2));
        painter.drawLine(QPointF(x, top), QPointF(x, key.bottom()));
    }
}

} // namespace dipwright
