// Finds the film on many places of a body.
#pragma once

#include "dip/LaidFilm.h"
#include "geometry/RefinedMesh.h"

#include <array>

namespace dipwright {

// Tells whether a picture of `pixels` pixels is drawn faster with a table of places. The table
// takes four searches per triangle. Without it, each pixel takes about one.
inline bool tablePays(const RefinedMesh& body, double pixels) {
    return pixels > 4 * double(body.mesh().triangles.size());
}

// A table of the film's places on a fine mesh of the body. A picture of a body needs millions of
// places, and LaidFilm::place() searches for each. The table holds the places of the corners of
// each fine triangle. It interpolates between them if the interpolated place of the triangle's
// middle is within 0.05 mm of the true one on the flat film. Elsewhere, such as at the end of the
// film, it searches, too. Any thread may read.
class FilmPlaces {
public:
    // Keeps references to both. `body` is a refined mesh of the film's body. Uses all cores.
    FilmPlaces(const RefinedMesh& body, const LaidFilm& laid);

    // Returns the place on the flat film that paints a place of the fine mesh; nothing if no film
    // does.
    std::optional<FilmPlace> at(const SurfacePoint& fine) const;

private:
    enum class Painted : std::uint8_t { No, Linearly, Unevenly };
    struct Triangle {
        Painted painted = Painted::Unevenly;
        std::array<Eigen::Vector2f, 3> corners; // on the flat film, mm, if `painted` is Linearly
    };
    Triangle triangleAt(std::uint32_t fine) const;

    const RefinedMesh& body_;
    const LaidFilm& laid_;
    std::vector<Triangle> triangles_; // per fine triangle
};

} // namespace dipwright
