#include "accuracy/tolerance/ColourShift.h"

#include "parallel/ParallelFor.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {
ColourPlaces::ColourPlaces(const LaidFilm& nominal, const std::vector<SurfacePoint>& places,
                           const std::function<bool(const SurfacePoint&)>& isPainted)
    : nominal_(nominal), toModel_(nominal.body().modelToPose.inverse().cast<float>()),
      places_(places), isOurs_(places.size(), 0), films_(places.size()) {
    parallelFor(std::size_t(0), places_.size(), [&](std::size_t place) {
        const SurfacePoint& point = places_[place];
        if (!point.isValid() || (isPainted && !isPainted(point))) {
            return;
        }
        isOurs_[place] = 1;
        if (const std::optional<FilmPlace> film = nominal_.place(point)) {
            films_[place] = onFilm(*film);
        }
    });
}

ColourPlaces::OnFilm ColourPlaces::onFilm(const FilmPlace& place) const {
    const FilmTriangle& corners = nominal_.triangles()[place.triangle];
    const std::vector<Eigen::Vector3f>& lies = nominal_.contact().places;
    const solver::FilmGrid& grid = nominal_.film().grid;
    const Eigen::Vector2f rest = restPosition(grid, corners[0]);
    Eigen::Matrix2f flat;
    flat << restPosition(grid, corners[1]) - rest, restPosition(grid, corners[2]) - rest;
    Eigen::Matrix<float, 3, 2> laid;
    laid << lies[corners[1]] - lies[corners[0]], lies[corners[2]] - lies[corners[0]];
    OnFilm found;
    found.rest = place.rest;
    found.fromFilm = toModel_.linear() * laid * flat.inverse();
    found.place = toModel_ * lies[corners[0]] + found.fromFilm * (place.rest - rest);
    return found;
}

std::vector<Eigen::Vector2f> ColourPlaces::touched(const LaidFilm& other, double swell) const {
    const Eigen::Vector2f none = Eigen::Vector2f::Constant(std::numeric_limits<float>::quiet_NaN());
    std::vector<Eigen::Vector2f> films(places_.size(), none);
    parallelFor(std::size_t(0), places_.size(), [&](std::size_t place) {
        if (!places_[place].isValid()) {
            return;
        }
        if (const std::optional<FilmPlace> film = other.place(places_[place])) {
            films[place] = film->rest / float(swell);
        }
    });
    return films;
}

Eigen::Vector3f ColourPlaces::linearShift(std::size_t place, const Eigen::Vector2f& film) const {
    return films_[place]->fromFilm * (films_[place]->rest - film);
}

std::optional<Eigen::Vector3f> ColourPlaces::shift(std::size_t place,
                                                   const Eigen::Vector2f& film) const {
    const std::optional<FilmPlace> belongs = nominal_.flat(film);
    if (!belongs || !nominal_.contact().reaches(belongs->triangle, nominal_.weights(*belongs))) {
        return std::nullopt;
    }
    return films_[place]->place - onFilm(*belongs).place;
}

} // namespace dipwright
