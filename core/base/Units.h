// Quantities that carry their unit in their type. Files, command lines and dialogs pass values in
// these types. Bulk data (meshes, grids, films) is plain float or double in millimetres.
#pragma once

#include <compare>

namespace dipwright {

// A number with a unit. Converts to and from plain numbers only explicitly: Millimetres(3),
// x.value().
template <typename Unit>
class Quantity {
public:
    constexpr Quantity() = default;
    constexpr explicit Quantity(double value) : value_(value) {}
    constexpr double value() const { return value_; }

    constexpr auto operator<=>(const Quantity&) const = default;
    constexpr Quantity operator-() const { return Quantity(-value_); }
    constexpr Quantity operator+(Quantity other) const { return Quantity(value_ + other.value_); }
    constexpr Quantity operator-(Quantity other) const { return Quantity(value_ - other.value_); }
    constexpr Quantity operator*(double factor) const { return Quantity(value_ * factor); }
    constexpr Quantity operator/(double divisor) const { return Quantity(value_ / divisor); }
    constexpr double operator/(Quantity other) const { return value_ / other.value_; }

private:
    double value_ = 0;
};

using Millimetres = Quantity<struct MillimetresUnit>;
using Seconds = Quantity<struct SecondsUnit>;
using MillimetresPerSecond = Quantity<struct MillimetresPerSecondUnit>;
using MillimetresPerSecondSquared = Quantity<struct MillimetresPerSecondSquaredUnit>;
using Degrees = Quantity<struct DegreesUnit>;
using DegreesPerSecond = Quantity<struct DegreesPerSecondUnit>;
using DotsPerInch = Quantity<struct DotsPerInchUnit>;

inline constexpr double millimetresPerInch = 25.4;
// The unit in which lengths are shown to the user. Lengths are stored in millimetres.
enum class LengthUnit { Millimetre, Inch };
constexpr double millimetresIn(LengthUnit unit) {
    return unit == LengthUnit::Inch ? millimetresPerInch : 1;
}
// The unit in which a field is shown to the user.
enum class Unit {
    None,
    Length,
    Speed,
    Acceleration,
    Time,
    Angle,
    AngularSpeed,
    Resolution,
    Ratio,
    Cells,
    Density,
    Share,
    ShareRate,
    Million
};
inline constexpr double pi = 3.14159265358979323846;
constexpr double radians(Degrees angle) {
    return angle.value() * pi / 180;
}
constexpr double pixelsPerMillimetre(DotsPerInch dpi) {
    return dpi.value() / millimetresPerInch;
}

} // namespace dipwright
