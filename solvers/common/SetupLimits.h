// Which dips a film can be begun with.
#pragma once

#include <dipwright/FilmSolver.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace dipwright::numerics {

namespace detail {

inline void require(bool holds, const char* sentence) {
    if (!holds) {
        throw std::invalid_argument(sentence);
    }
}

inline bool isPositive(double value) {
    return std::isfinite(value) && value > 0 && value < 1e6;
}

} // namespace detail

// Throws std::invalid_argument with a sentence unless the numbers of `setup` make a dip.
inline void requireValid(const solver::DipSetup& setup) {
    using detail::isPositive;
    using detail::require;
    const solver::FilmGrid& film = setup.film;
    const solver::FieldView& field = setup.field;
    const solver::Settings& settings = setup.settings;
    require(film.columns >= 2 && film.rows >= 2 && film.columns <= 20000 && film.rows <= 20000,
            "the film needs 2 to 20,000 points along each edge");
    require(isPositive(film.width) && isPositive(film.depth), "the film's size has to be positive");
    require(field.distance && std::min({field.size[0], field.size[1], field.size[2]}) >= 2 &&
                isPositive(field.spacing),
            "the body's distance field is empty");
    require(isPositive(setup.motion.speed) && std::isfinite(setup.motion.travel) &&
                setup.motion.travel >= 0,
            "the body's speed and travel have to be positive");
    require(isPositive(settings.timeStep) && settings.iterations >= 1 &&
                settings.iterations <= 1000,
            "the time step has to be positive, with 1 to 1,000 iterations");
    require(isPositive(settings.contactTravel),
            "the contact line's travel in one step has to be positive");
    require(std::isfinite(settings.contactDistance) && settings.contactDistance >= 0,
            "the contact distance cannot be negative");
    require(settings.threads >= 0, "the number of threads cannot be negative");
    require(setup.pinned.empty() || setup.pinned.size() == film.pointCount(),
            "the film's pinned points do not match its points");
}

} // namespace dipwright::numerics
