#include "validation/ClosedForm.h"

#include "base/Units.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace dipwright {

Meridian sphereMeridian(double radius, double polarAngle) {
    return {[radius](double arc) { return radius * std::sin(arc / radius); },
            [radius](double distance, double height) {
                return radius * std::atan2(distance, radius - height);
            },
            radius * polarAngle, radius * (1 - std::cos(polarAngle))};
}

Meridian spheroidMeridian(double across, double along, double parameter) {
    // Arc length by the parameter t of (across·sin t, along·(1 − cos t)), Simpson's rule.
    constexpr int samples = 20000;
    const double last = pi / 2, width = last / samples;
    const auto speed = [across, along](double t) {
        return std::hypot(across * std::cos(t), along * std::sin(t));
    };
    auto arcs = std::make_shared<std::vector<double>>(std::size_t(samples) + 1, 0.0);
    for (int i = 0; i < samples; ++i) {
        const double t = i * width;
        (*arcs)[std::size_t(i) + 1] =
            (*arcs)[std::size_t(i)] +
            width / 6 * (speed(t) + 4 * speed(t + width / 2) + speed(t + width));
    }
    const auto arcOf = [arcs](double t) {
        const double place = std::clamp(t / (pi / 2) * samples, 0.0, double(samples));
        const std::size_t index = std::min(std::size_t(place), std::size_t(samples) - 1);
        const double share = place - double(index);
        return (*arcs)[index] + share * ((*arcs)[index + 1] - (*arcs)[index]);
    };
    const auto parameterOf = [arcs, width](double arc) {
        const auto upper = std::upper_bound(arcs->begin() + 1, arcs->end() - 1, arc);
        const std::size_t index = std::size_t(upper - arcs->begin()) - 1;
        const double share = (arc - (*arcs)[index]) / ((*arcs)[index + 1] - (*arcs)[index]);
        return width * (double(index) + share);
    };
    return {[across, parameterOf](double arc) { return across * std::sin(parameterOf(arc)); },
            [across, along, arcOf](double distance, double height) {
                return arcOf(std::atan2(distance / across, 1 - height / along));
            },
            arcOf(parameter), along * (1 - std::cos(parameter))};
}

Meridian coneMeridian(double halfAngle, double contactRadius) {
    const double sine = std::sin(halfAngle);
    return {[sine](double arc) { return arc * sine; },
            [](double distance, double height) { return std::hypot(distance, height); },
            contactRadius / sine, contactRadius / std::tan(halfAngle)};
}

ClosedForm::ClosedForm(const Meridian& profile, FilmLaw law, double ringRadius) {
    const std::size_t samples = std::size_t(std::ceil(profile.fullArc / 0.001)) + 1;
    step_ = profile.fullArc / double(samples - 1);
    const double ring = ringRadius * ringRadius;
    const auto slope = [&](double arc, double R) {
        const double a = profile.radius(arc);
        if (law == FilmLaw::Viscous) {
            return a * (ring - R * R) / (R * (ring - a * a));
        }
        const double A = (a - R) / (R - ring / R);
        return 1 / (1 + A + A * ring / (R * R));
    };
    // Near the pole the body is a cone of the slope da/ds (a plane for smooth bodies): the forms of
    // a large film.
    const double sine = profile.radius(step_) / step_;
    radii_.assign(samples, 0.0);
    radii_[1] = law == FilmLaw::Viscous ? step_ * std::sqrt(sine) : step_ * (sine + 1) / 2;
    for (std::size_t i = 1; i + 1 < samples; ++i) {
        const double s = double(i) * step_, R = radii_[i], h = step_;
        const double k1 = slope(s, R), k2 = slope(s + h / 2, R + h / 2 * k1);
        const double k3 = slope(s + h / 2, R + h / 2 * k2), k4 = slope(s + h, R + h * k3);
        radii_[i + 1] = R + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
}

double ClosedForm::filmRadius(double arc) const {
    const double place = std::clamp(arc / step_, 0.0, double(radii_.size() - 1));
    const std::size_t index = std::min(std::size_t(place), radii_.size() - 2);
    return radii_[index] + (place - double(index)) * (radii_[index + 1] - radii_[index]);
}

double insideTorusFilmRadius(double circleRadius, double tubeRadius, double angle) {
    const double c = circleRadius, rho = tubeRadius, root = std::sqrt(c * c - rho * rho);
    // ∫dθ/(c − ρ·sin θ) = 2/√(c² − ρ²)·atan((c·tan(θ/2) − ρ)/√(c² − ρ²))
    const double integral =
        2 / root * (std::atan((c * std::tan(angle / 2) - rho) / root) + std::atan(rho / root));
    return c * std::exp(-rho * integral);
}

} // namespace dipwright
