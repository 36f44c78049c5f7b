// Combines the ink of several films on one body.
#pragma once

#include "results/Results.h"
#include "settings/InkSettings.h"
#include "texture/LinearLight.h"

#include <memory>

namespace dipwright {

class PaintedFilm;

// Keeps the films. Any thread may read it.
class PaintedBody {
public:
    // `ink`: how the images were compensated, if at all.
    PaintedBody(const std::vector<FilmAppearance>& films, const InkSettings& ink,
                const Ground& ground = {});
    ~PaintedBody();

    // Returns the bare body's colour, or the films' ink on white or on the body's own colour.
    // Densities add up, because light passes through all films.
    LinearColour colour(const SurfacePoint& point) const;
    // Returns the solver::PointMark bits of the last dipped film that paints a place; nothing if
    // none does.
    std::optional<std::uint8_t> marks(const SurfacePoint& point) const;

private:
    LinearColour onBase(const SurfacePoint& point) const;

    std::vector<std::unique_ptr<const PaintedFilm>> films_;
    std::optional<LinearColour> base_;
    bool whiteOutside_;
};

} // namespace dipwright
