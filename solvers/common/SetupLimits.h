// Checks that a dip's setup is valid for a solver.
#pragma once

#include <dipwright/FilmSolver.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

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

// Returns whether `places` are valid columns or rows of a film with this length.
inline bool areLines(const std::vector<double>& places, int count, double length) {
    if (places.empty()) {
        return true;
    }
    bool isAscending = places.size() == std::size_t(count);
    for (std::size_t line = 1; isAscending && line < places.size(); ++line) {
        isAscending = places[line] > places[line - 1];
    }
    return isAscending && places.front() == -length / 2 && places.back() == length / 2;
}

// Returns whether the poses of a path are valid, are in ascending order, and end where the travel
// ends.
inline bool isPath(const solver::BodyPath& path, double travel) {
    constexpr std::size_t mostPoses = 10'000;
    const std::vector<solver::PathPose>& poses = path.poses;
    bool isValid = poses.size() >= 2 && poses.size() <= mostPoses && poses[0].travelled == 0 &&
                   poses[0].seconds == 0 && poses.back().travelled == travel;
    for (std::size_t i = 0; isValid && i < poses.size(); ++i) {
        const auto& [w, x, y, z] = poses[i].rotation;
        isValid = std::abs(w * w + x * x + y * y + z * z - 1) < 1e-6;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            isValid =
                isValid && std::abs(poses[i].pivot[axis]) < 1e6 && std::abs(path.pivot[axis]) < 1e6;
        }
        isValid = isValid && (i == 0 || (poses[i].travelled > poses[i - 1].travelled &&
                                         poses[i].seconds > poses[i - 1].seconds));
    }
    return isValid && std::isfinite(poses.back().seconds);
}

} // namespace detail

// Throws std::invalid_argument if the body does not move straight down.
inline void requireStraightDown(const solver::DipSetup& setup) {
    detail::require(setup.path.isStraightDown(),
                    "with this film the body can only move straight down: choose a straight dip");
}

// Throws std::invalid_argument if the points are not evenly spaced.
inline void requireEven(const solver::FilmGrid& film) {
    detail::require(film.isEven(), "this film needs evenly spaced points: set the number of points "
                                   "instead of the size of the cells");
}

// Throws std::invalid_argument if the film grows.
inline void requireNoGrowth(const solver::Settings& settings) {
    detail::require(settings.growthRate == 0 || settings.growthLimit == 0,
                    "this film cannot grow while it floats: set its growth to 0");
}

// Throws std::invalid_argument with a sentence for the user if `setup` is not a valid dip.
inline void requireValid(const solver::DipSetup& setup) {
    using detail::isPositive;
    using detail::require;
    const solver::FilmGrid& film = setup.film;
    const solver::FieldView& field = setup.field;
    const solver::Settings& settings = setup.settings;
    require(film.columns >= 2 && film.rows >= 2 && film.columns <= 20000 && film.rows <= 20000,
            "the film needs 2 to 20,000 points along each edge");
    require(isPositive(film.width) && isPositive(film.depth), "the film's size must be positive");
    require(detail::areLines(film.columnPlaces, film.columns, film.width) &&
                detail::areLines(film.rowPlaces, film.rows, film.depth),
            "the film's columns and rows must be in ascending order, from one edge to the other");
    require(field.distance && std::min({field.size[0], field.size[1], field.size[2]}) >= 2 &&
                isPositive(field.spacing),
            "the body's signed distance field is empty");
    require(isPositive(setup.motion.speed) && std::isfinite(setup.motion.travel) &&
                setup.motion.travel >= 0,
            "the body's speed must be positive, and its travel must not be negative");
    require(setup.path.isStraightDown() || detail::isPath(setup.path, setup.motion.travel),
            "the poses of the body's path must be in ascending order of time and of travel");
    require(isPositive(settings.timeStep) && settings.iterations >= 1 &&
                settings.iterations <= 1000,
            "the time step must be positive, with 1 to 1,000 iterations");
    require(isPositive(settings.contactTravel),
            "the contact line's travel in one step must be positive");
    require(std::isfinite(settings.contactDistance) && settings.contactDistance >= 0,
            "the contact distance must not be negative");
    require(isPositive(settings.gripFade) && settings.gripFade <= 1,
            "the grip must fade over more than 0 and at most 1 radian");
    require(settings.gatheringStretch > 0.6 && settings.gatheringStretch <= 1,
            "the mean stretch below which film gathers must be between 0.6 and 1");
    require(std::isfinite(settings.growthRate) && settings.growthRate >= 0 &&
                std::isfinite(settings.growthLimit) && settings.growthLimit >= 0,
            "the film's growth must not be negative");
    require(settings.threads >= 0, "the number of threads must not be negative");
    require(setup.pinned.empty() || setup.pinned.size() == film.pointCount(),
            "the number of pinned flags must match the film's points");
}

} // namespace dipwright::numerics
