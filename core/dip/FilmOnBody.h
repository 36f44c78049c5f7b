// Where film lands on the body: from a place on the body back to the flat film. Private to this
// folder: LaidFilm::place() is how everyone else asks.
#pragma once

#include "dip/LaidFilm.h"

namespace dipwright {

// A hierarchy over the painted, deformed film. Keeps references to its arguments. Reading is const,
// any thread.
class FilmOnBody {
public:
    // `triangles`: filmTriangles() of the grid; `body` in the pose frame of the contact.
    FilmOnBody(const solver::FilmGrid& grid, const std::vector<FilmTriangle>& triangles,
               const FilmContact& contact, const TriangleMesh& body);

    // The place of the film that covers `point` of the body; nothing where none does.
    std::optional<FilmPlace> place(const SurfacePoint& point) const;

private:
    float cell(const SurfacePoint& onFilm) const; // the film's, mm
    bool fits(const SurfacePoint& onFilm, float distance, const Eigen::Vector3f& outward) const;
    bool isOnBorder(const SurfacePoint& onFilm) const;
    bool isBeyondBorder(const SurfacePoint& onFilm, const Eigen::Vector3f& offset,
                        const Eigen::Vector3f& outward) const;
    ClosestPoint filmOver(const Eigen::Vector3f& place, const Eigen::Vector3f& outward) const;

    const solver::FilmGrid& grid_;
    const FilmContact& contact_;
    const TriangleMesh& body_;
    std::vector<std::uint32_t> filmTriangle_; // of each painted triangle
    TriangleMesh painted_;
    std::vector<Eigen::Vector3f> bodyNormals_, paintedNormals_; // a triangle each
    std::vector<std::uint32_t> opposite_;     // by painted edge: noEdge at the border
    std::vector<std::uint8_t> isBorderPoint_; // a film point each
    SurfaceQuery query_;                      // of painted_
    float reach_;                             // the largest film cell that is painted, mm
    std::vector<std::uint8_t> isNear_;        // a body triangle each: film is within its reach
};

} // namespace dipwright
