// Computes how far colours land from their places when a dip deviates from the nominal dip that the
// sheet was printed for (docs/film-model.md, "Tolerances").
#pragma once

#include "dip/LaidFilm.h"

#include <functional>

namespace dipwright {

// The nominal film at given places of the body. Prepares what all comparisons with other dips
// share. Keeps a reference to the film. Any thread may read it.
class ColourPlaces {
public:
    // Invalid places count as unpainted. So do places for which `isPainted` returns false, because
    // they belong to another dip; `isPainted` may be empty.
    ColourPlaces(const LaidFilm& nominal, const std::vector<SurfacePoint>& places,
                 const std::function<bool(const SurfacePoint&)>& isPainted);

    std::size_t count() const { return places_.size(); }
    bool isPainted(std::size_t place) const { return films_[place].has_value(); }
    // Whether this film should paint the place but does not.
    bool isBare(std::size_t place) const { return isOurs_[place] != 0 && !isPainted(place); }

    // Returns the film that touches each place in another dip of the same body; NaN where none
    // does. In mm of the nominal floating film; the other film is `swell` times as large. All
    // cores.
    std::vector<Eigen::Vector2f> touched(const LaidFilm& other, double swell) const;

    // Returns the vector from where the colour of `film` belongs to the painted place where it
    // landed. Model coordinates, mm. First order, by the film's stretch at the place: it lies in
    // the surface and also exists for film that was not printed for the body.
    Eigen::Vector3f shiftNear(std::size_t place, const Eigen::Vector2f& film) const;
    // Returns the same vector, measured on the laid film at any distance. Nothing where the sheet
    // has no colour for the body.
    std::optional<Eigen::Vector3f> shift(std::size_t place, const Eigen::Vector2f& film) const;

private:
    struct OnFilm {
        Eigen::Vector2f rest;                // on the flat film, mm
        Eigen::Vector3f place;               // on the laid film, in model coordinates, mm
        Eigen::Matrix<float, 3, 2> fromFilm; // maps mm of flat film to mm on the body
    };
    OnFilm onFilm(const FilmPlace& place) const;

    const LaidFilm& nominal_;
    Eigen::Isometry3f toModel_;
    std::vector<SurfacePoint> places_;
    std::vector<std::uint8_t> isOurs_;
    std::vector<std::optional<OnFilm>> films_; // nothing where unpainted
};

} // namespace dipwright
