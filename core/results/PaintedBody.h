// Combines the ink of several films on one body.
#pragma once

#include "results/Results.h"
#include "settings/InkSettings.h"
#include "texture/LinearLight.h"

#include <limits>
#include <memory>

namespace dipwright {

class PaintedFilm;

// A body with the ink of its films. Keeps the films, and a reference to the refined mesh. Any
// thread may read it.
class PaintedBody {
public:
    // `ink` holds the settings by which the images were compensated. If `fine` is given, places
    // refer to this refined mesh of the body, and each film gets a table of its places
    // (FilmPlaces.h) if that is faster for `count` places. Uses all cores.
    PaintedBody(const std::vector<FilmAppearance>& films, const InkSettings& ink,
                const Ground& ground = {}, const RefinedMesh* fine = nullptr,
                double count = std::numeric_limits<double>::infinity());

    // Returns the colour of a place: the bare body's colour, or the ink of all films on white or on
    // the body's own colour. The densities of films add up, because light passes through all of
    // them.
    LinearColour colour(const SurfacePoint& point) const;
    // Returns the solver::PointMark bits of the last dipped film that paints a place; none if no
    // film paints the place.
    std::optional<std::uint8_t> marks(const SurfacePoint& point) const;

private:
    LinearColour onBase(const SurfacePoint& point) const;

    std::vector<std::shared_ptr<const PaintedFilm>> films_;
    std::optional<LinearColour> base_;
    bool whiteOutside_;
};

} // namespace dipwright
