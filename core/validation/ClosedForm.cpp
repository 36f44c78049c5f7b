#include "validation/ClosedForm.h"

#include "base/Units.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace dipwright {

Meridian sphereMeridian(double radius, double polarAngle) {
    return {[radius](double arc) { return radius * std::sin(arc / radius); },
            [radius](double arc) { return radius * (1 - std::cos(arc / radius)); },
            [radius](double distance, double height) {
                return radius * std::atan2(distance, radius - height);
            },
            radius * polarAngle, radius * (1 - std::cos(polarAngle))};
}

Meridian spheroidMeridian(double across, double along, double parameter) {
    // Computes the arc length over the parameter t of the curve (across·sin t, along·(1 − cos t)),
    // by Simpson's rule.
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
            [along, parameterOf](double arc) { return along * (1 - std::cos(parameterOf(arc))); },
            [across, along, arcOf](double distance, double height) {
                return arcOf(std::atan2(distance / across, 1 - height / along));
            },
            arcOf(parameter), along * (1 - std::cos(parameter))};
}

Meridian coneMeridian(double halfAngle, double contactRadius) {
    const double sine = std::sin(halfAngle), cosine = std::cos(halfAngle);
    return {[sine](double arc) { return arc * sine; },
            [cosine](double arc) { return arc * cosine; },
            [](double distance, double height) { return std::hypot(distance, height); },
            contactRadius / sine, contactRadius / std::tan(halfAngle)};
}

namespace {

// The state of the film on the contact line.
struct LaidFilm {
    double radius = 0;  // R, mm
    double logArea = 0; // ln J, for a viscous film with a free edge
};

LaidFilm slope(const Meridian& profile, const FloatingFilm& film, double arc, double width,
               const LaidFilm& laid) {
    const double a = profile.radius(arc), R = laid.radius;
    const double edge = film.edgeRadius * film.edgeRadius;
    const bool isHeld = film.edge == FilmEdge::Held;
    const auto grown = [&](double s) { return film.grown(profile.height(s)); };
    if (film.law == FilmLaw::Elastic) {
        const double mean = isHeld ? (edge - a * R) / (edge - R * R)
                                   : (a * R + 2 * grown(arc) * edge) / (R * R + 2 * edge);
        return {1 / (2 * mean - a / R), 0};
    }
    if (isHeld) {
        return {a * (edge - R * R) / (R * (edge - a * a)), 0};
    }
    const double J = std::exp(laid.logArea), edgeNow = a * a + J * (edge - R * R);
    const auto perArc = [&](double begin, double end) { return (end - begin) / width; };
    const double before = arc - width / 2, after = arc + width / 2;
    const double widening = perArc(profile.radius(before), profile.radius(after)); // a′
    const double growth = perArc(std::log(grown(before)), std::log(grown(after))); // g′/g
    return {a / (J * R), 2 * ((widening - 1) * a + 2 * edgeNow * growth) / (a * a + 2 * edgeNow)};
}

} // namespace

ClosedForm::ClosedForm(const Meridian& profile, const FloatingFilm& film) {
    const std::size_t samples = std::size_t(std::ceil(profile.fullArc / 0.001)) + 1;
    step_ = profile.fullArc / double(samples - 1);
    const double h = step_;
    // Near the pole the body is a cone of slope da/ds (a plane for smooth bodies), and the forms of
    // an infinite film apply.
    const double sine = profile.radius(h) / h;
    const double first = film.edge == FilmEdge::Held ? 1 : film.grown(0);
    const double R = film.law == FilmLaw::Viscous ? h * std::sqrt(sine) : h * (sine + 1) / 2;
    LaidFilm laid{R / first, 2 * std::log(first)};
    radii_ = {0, laid.radius};
    for (std::size_t i = 1; i + 1 < samples; ++i) {
        const double s = double(i) * h;
        const auto slopeAfter = [&](double way, const LaidFilm& k) {
            return slope(profile, film, s + way, h,
                         {laid.radius + way * k.radius, laid.logArea + way * k.logArea});
        };
        const LaidFilm k1 = slopeAfter(0, {}), k2 = slopeAfter(h / 2, k1);
        const LaidFilm k3 = slopeAfter(h / 2, k2), k4 = slopeAfter(h, k3);
        laid.radius += h / 6 * (k1.radius + 2 * k2.radius + 2 * k3.radius + k4.radius);
        laid.logArea += h / 6 * (k1.logArea + 2 * k2.logArea + 2 * k3.logArea + k4.logArea);
        radii_.push_back(laid.radius);
    }
}

double ClosedForm::filmRadius(double arc) const {
    const double place = std::clamp(arc / step_, 0.0, double(radii_.size() - 1));
    const std::size_t index = std::min(std::size_t(place), radii_.size() - 2);
    return radii_[index] + (place - double(index)) * (radii_[index + 1] - radii_[index]);
}

double filmOnCylinder(double cylinderRadius, double arc, const FloatingFilm& film) {
    const double first = film.grown(0);
    const auto slope = [&](double s) {
        const double g = film.grown(cylinderRadius * (1 - std::cos(s / cylinderRadius)));
        return film.law == FilmLaw::Viscous ? 1 / (first * std::pow(g / first, 4. / 3))
                                            : 3 / (4 * g - first);
    };
    constexpr int parts = 100; // Simpson's rule
    const double width = arc / parts;
    double sum = 0;
    for (int i = 0; i < parts; ++i) {
        const double s = i * width;
        sum += slope(s) + 4 * slope(s + width / 2) + slope(s + width);
    }
    return width / 6 * sum;
}

double insideTorusFilmRadius(double circleRadius, double tubeRadius, double angle) {
    const double c = circleRadius, rho = tubeRadius, root = std::sqrt(c * c - rho * rho);
    // ∫dθ/(c − ρ·sin θ) = 2/√(c² − ρ²)·atan((c·tan(θ/2) − ρ)/√(c² − ρ²))
    const double integral =
        2 / root * (std::atan((c * std::tan(angle / 2) - rho) / root) + std::atan(rho / root));
    return c * std::exp(-rho * integral);
}

} // namespace dipwright
