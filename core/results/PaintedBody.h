// The ink of several films on one body.
#pragma once

#include "results/Results.h"
#include "settings/InkSettings.h"
#include "texture/LinearLight.h"

#include <memory>

namespace dipwright {

class PaintedFilm;

// Keeps the films. Any thread may read.
class PaintedBody {
public:
    // `ink`: by which the images were compensated, if they were.
    PaintedBody(const std::vector<FilmAppearance>& films, const InkSettings& ink,
                const Ground& ground = {});
    ~PaintedBody();

    // The bare body, or the films' ink on white or on the body's own colour. Densities add up:
    // light goes through them all.
    LinearColour colour(const SurfacePoint& point) const;
    // solver::PointMark bits of the film that was dipped last of those that paint a place; nothing
    // where none does.
    std::optional<std::uint8_t> marks(const SurfacePoint& point) const;

private:
    LinearColour onBase(const SurfacePoint& point) const;

    std::vector<std::unique_ptr<const PaintedFilm>> films_;
    std::optional<LinearColour> base_;
    bool whiteOutside_;
};

} // namespace dipwright
