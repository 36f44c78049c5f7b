// Computes how far colours land from their places when a dip deviates from the nominal dip that the
// sheet was printed for (docs/film-model.md, "Tolerances").
#pragma once

#include "dip/LaidFilm.h"

#include <functional>

namespace dipwright {

// The nominal film at given places of the body, prepared for comparisons with many other dips.
// Keeps a reference to the film. Any thread may read it.
class ColourPlaces {
public:
    // Invalid places count as unpainted. `isPainted` returns false for places that belong to
    // another dip; they also count as unpainted. `isPainted` may be empty.
    ColourPlaces(const LaidFilm& nominal, const std::vector<SurfacePoint>& places,
                 const std::function<bool(const SurfacePoint&)>& isPainted);

    std::size_t count() const { return places_.size(); }
    bool isPainted(std::size_t place) const { return films_[place].has_value(); }
    // Tells whether this film should paint the place but does not.
    bool isBare(std::size_t place) const { return isOurs_[place] != 0 && !isPainted(place); }

    // Returns which point of the film touches each place in another dip of the same body; NaN where
    // no film touches it. Points are in mm of the nominal floating film; the other film is `swell`
    // times as large. Uses all cores.
    std::vector<Eigen::Vector2f> touched(const LaidFilm& other, double swell) const;

    // The colour of the film point `film` lands at `place`. Returns the vector to `place` from
    // the point where this colour should land, in model coordinates, mm. Computed to first order
    // from the film's stretch at `place`. The vector lies in the surface and exists even if the
    // sheet has no colour at `film`.
    Eigen::Vector3f linearShift(std::size_t place, const Eigen::Vector2f& film) const;
    // Returns the same vector, measured exactly on the laid film. None where the sheet has no
    // colour for the body.
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
    std::vector<std::optional<OnFilm>> films_; // none where unpainted
};

} // namespace dipwright
