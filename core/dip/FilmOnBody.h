// Maps a place on the body back to the flat film. Private to this folder; others use
// LaidFilm::place().
#pragma once

#include "dip/LaidFilm.h"

#include <atomic>

namespace dipwright {

// A search hierarchy over the deformed film that paints. Keeps references to its arguments. Any
// thread may read.
class FilmOnBody {
public:
    // `triangles` are filmTriangles() of the grid. `body` is in the same pose frame as the contact.
    FilmOnBody(const solver::FilmGrid& grid, const std::vector<FilmTriangle>& triangles,
               const FilmContact& contact, const TriangleMesh& body);

    // Returns the place of the film that paints `point` of the body; nothing if no film does.
    std::optional<FilmPlace> place(const SurfacePoint& point) const;

private:
    enum class Near : std::uint8_t { Unknown, Yes, No };

    bool isNear(std::uint32_t triangle) const;
    float cell(const SurfacePoint& onFilm) const; // cell size of the film there, mm
    bool fits(const SurfacePoint& onFilm, float distance, const Eigen::Vector3f& outward) const;
    bool isOnBorder(const SurfacePoint& onFilm) const;
    bool isBeyondBorder(const SurfacePoint& onFilm, const Eigen::Vector3f& offset,
                        const Eigen::Vector3f& outward) const;
    ClosestPoint filmOver(const Eigen::Vector3f& place, const Eigen::Vector3f& outward) const;

    const solver::FilmGrid& grid_;
    const FilmContact& contact_;
    const TriangleMesh& body_;
    std::vector<std::uint32_t> filmTriangle_; // per triangle of painted_: the film triangle
    TriangleMesh painted_;
    // Per triangle of body_ and of painted_.
    std::vector<Eigen::Vector3f> bodyNormals_, paintedNormals_;
    // Per edge of painted_: the opposite edge; noEdge at the border.
    std::vector<std::uint32_t> opposite_;
    std::vector<std::uint8_t> isBorderPoint_; // per film point
    SurfaceQuery query_;                      // of painted_
    float reach_;                             // size of the largest film cell that paints, mm
    // Per body triangle: whether film is within reach_; found when it is first needed.
    mutable std::vector<std::atomic<Near>> near_;
};

} // namespace dipwright
