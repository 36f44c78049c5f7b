// How far colours land from where they belong when a dip is off: the sheet was printed for another
// (docs/film-model.md, "Tolerances").
#pragma once

#include "dip/LaidFilm.h"

#include <functional>

namespace dipwright {

// Where a nominal film lies on the body at these places of it; what does not depend on how another
// dip is off. Keeps a reference to the film. Reading is const, any thread.
class ColourPlaces {
public:
    // Invalid places are taken for unpainted, as are those that `isPainted` (may be empty) says are
    // another film's.
    ColourPlaces(const LaidFilm& nominal, const std::vector<SurfacePoint>& places,
                 const std::function<bool(const SurfacePoint&)>& isPainted);

    std::size_t count() const { return places_.size(); }
    bool isPainted(std::size_t place) const { return films_[place].has_value(); }
    // Would be this film's to paint, and is not.
    bool isBare(std::size_t place) const { return isOurs_[place] != 0 && !isPainted(place); }

    // The film that touches each of the places in another dip of the same body, in mm of the
    // nominal floating film, of which that dip's is `swell` times as large; NaN where none does.
    // All cores.
    std::vector<Eigen::Vector2f> touched(const LaidFilm& other, double swell) const;

    // From where the colour of film belongs to the painted place where it has landed, in model
    // coordinates, mm. To first order, through the film's stretch at the place: in the surface, and
    // also of film that was not printed for the body.
    Eigen::Vector3f shiftNear(std::size_t place, const Eigen::Vector2f& film) const;
    // Along the film as it lies, however far; nothing where the sheet has no colour for the body.
    std::optional<Eigen::Vector3f> shift(std::size_t place, const Eigen::Vector2f& film) const;

private:
    struct OnFilm {
        Eigen::Vector2f rest;
        Eigen::Vector3f place;               // on the film as it lies, model coordinates
        Eigen::Matrix<float, 3, 2> fromFilm; // a mm of flat film, on the body
    };
    OnFilm onFilm(const FilmPlace& place) const;

    const LaidFilm& nominal_;
    Eigen::Isometry3f toModel_;
    std::vector<SurfacePoint> places_;
    std::vector<std::uint8_t> isOurs_;
    std::vector<std::optional<OnFilm>> films_; // nothing where unpainted
};

} // namespace dipwright
