// Computes the contrast of two colours as WCAG 2 defines it.
#pragma once

#include <QColor>
#include <algorithm>
#include <cmath>

namespace dipwright {

inline double relativeLuminance(const QColor& colour) {
    const auto linear = [](double value) {
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

// Returns the contrast ratio, 1 to 21. Text needs at least 4.5.
inline double contrast(const QColor& a, const QColor& b) {
    const auto [darker, lighter] = std::minmax({relativeLuminance(a), relativeLuminance(b)});
    return (lighter + 0.05) / (darker + 0.05);
}

} // namespace dipwright
