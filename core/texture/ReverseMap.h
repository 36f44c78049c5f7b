// Which place on the body each place of the painted film comes to lie on, and so which place of the
// body's texture it has to show.
#pragma once

#include "dip/LaidFilm.h"
#include "model/TexturedMesh.h"

namespace dipwright {

// A place of the flat film by the weights of the corners of one film triangle.
struct FilmWeights {
    std::uint32_t triangle = 0;
    Eigen::Vector3f weights = Eigen::Vector3f::Zero();
};

// A place of the texture and the body triangle that says with which chart and material to read it.
struct TexturePlace {
    Eigen::Vector2f coordinate = Eigen::Vector2f::Zero(); // NaN: the material has no texture
    std::uint32_t bodyTriangle = 0;
};

// A piece of a film triangle: three of its places and where they lie on the body.
struct FilmPiece {
    std::uint32_t triangle = 0;
    std::array<Eigen::Vector3f, 3> corners; // weights of the film triangle's corners
    std::array<SurfacePoint, 3> surface;
    int depth = 0; // times it was halved

    // Of a place in the piece, by the weights of the piece's corners: which of the four pieces that
    // halving makes it is in (every place is in exactly one), and its weights there.
    static std::size_t child(const Eigen::Vector3f& weights);
    static Eigen::Vector3f childWeights(const Eigen::Vector3f& weights, std::size_t child);
};

// A piece whose texture coordinates are linear all over it, on one chart.
struct LinearPiece {
    std::array<Eigen::Vector2f, 3> coordinates;
    std::uint32_t bodyTriangle = 0; // one under the piece

    Eigen::Vector2f coordinate(const Eigen::Vector3f& weights) const {
        return weights[0] * coordinates[0] + weights[1] * coordinates[1] +
               weights[2] * coordinates[2];
    }
};

// A film place is carried linearly to the flat triangle between the points of contact and from
// there to the nearest place of the body. Pieces whose coordinates are linear within `tolerance` mm
// on the body are read directly; others are halved at the middles of their edges until they are,
// which resolves the seams between charts (the paper's Figure 5). Keeps references to the film and
// the appearance. Reading is const, any thread.
class ReverseMap {
public:
    static constexpr float tolerance = 0.03f; // mm on the body

    // `appearance`: of the triangles of the body that the film is laid on.
    ReverseMap(const LaidFilm& laid, const SurfaceAppearance& appearance);

    // Whether a border between charts runs through a painted triangle, by the body's topology.
    bool isSeam(std::uint32_t triangle) const { return seam_[triangle] != 0; }
    std::size_t seamCount() const;

    SurfacePoint surface(const FilmWeights& place) const;
    TexturePlace texture(const SurfacePoint& point) const;
    // The texture's place, as the sheet's pixels get it.
    TexturePlace texture(const FilmWeights& place) const;

    // Where the body would show a texture coordinate if its surface went on flat, and its texture
    // evenly, as in one of its triangles; none where all of that triangle shows one place or line.
    std::optional<Eigen::Vector3f> showing(const Eigen::Vector2f& coordinate,
                                           std::uint32_t bodyTriangle) const;

    // How a step on the body, in mm, moves the place on the texture; zero where it has none.
    // `steps` are the columns.
    Eigen::Matrix2f textureSteps(std::uint32_t bodyTriangle,
                                 const Eigen::Matrix<float, 3, 2>& steps) const;
    // The points of contact of a film triangle's corners, as columns.
    Eigen::Matrix3f contactPoints(std::uint32_t filmTriangle) const;

    FilmPiece whole(std::uint32_t triangle) const;
    // The four pieces between the corners and the middles of the edges: one at each corner, then
    // the one in the middle, which is upside down.
    std::array<FilmPiece, 4> halved(const FilmPiece& piece,
                                    const std::array<SurfacePoint, 3>& middles) const;
    // Where the middles of the edges lie: edge k runs from corner k to the next.
    std::array<SurfacePoint, 3> middles(const FilmPiece& piece) const;
    std::optional<LinearPiece> linear(const FilmPiece& piece,
                                      const std::array<SurfacePoint, 3>& middles) const;

private:
    float mismatch(const SurfacePoint& point, const Eigen::Vector2f& coordinate) const;
    void markSeams(const LaidFilm& laid);

    const FilmContact& contact_;
    const SurfaceAppearance& appearance_;
    const TriangleMesh& mesh_; // the body's
    const SurfaceQuery& query_;
    const std::vector<FilmTriangle>& triangles_;
    std::vector<std::uint8_t> seam_; // a film triangle each
};

} // namespace dipwright
