// Maps each place of the painted film to its place on the body and to the place of the texture that
// the film must show there.
#pragma once

#include "dip/LaidFilm.h"
#include "model/TexturedMesh.h"

namespace dipwright {

// A place on the flat film: a film triangle and the weights of its three corners.
struct FilmWeights {
    std::uint32_t triangle = 0;
    Eigen::Vector3f weights = Eigen::Vector3f::Zero();
};

// A place on the texture, and the body triangle that determines its chart and material.
struct TexturePlace {
    Eigen::Vector2f coordinate = Eigen::Vector2f::Zero(); // NaN: the material has no texture
    std::uint32_t bodyTriangle = 0;
};

// A piece of a film triangle: three places on the film and their places on the body.
struct FilmPiece {
    std::uint32_t triangle = 0;
    std::array<Eigen::Vector3f, 3> corners; // weights of the film triangle's corners
    std::array<SurfacePoint, 3> surface;
    int depth = 0; // number of halvings

    // Halving all edges divides a piece into four. A place is given by weights of the piece's
    // corners; it lies in exactly one of the four. child() returns that piece's number,
    // childWeights() the place's weights in it.
    static std::size_t child(const Eigen::Vector3f& weights);
    static Eigen::Vector3f childWeights(const Eigen::Vector3f& weights, std::size_t child);
};

// A piece on one chart whose texture coordinates are linear.
struct LinearPiece {
    std::array<Eigen::Vector2f, 3> coordinates;
    std::uint32_t bodyTriangle = 0; // a body triangle under the piece

    Eigen::Vector2f coordinate(const Eigen::Vector3f& weights) const {
        return weights[0] * coordinates[0] + weights[1] * coordinates[1] +
               weights[2] * coordinates[2];
    }
};

// Projects a film place linearly to the flat triangle between the points of contact, and from there
// to the nearest place on the body. Texture coordinates are interpolated directly in a piece where
// they are linear within a tolerance. Other pieces are halved at the middles of
// their edges, which resolves the texture seams between charts (the paper's Figure 5). Keeps
// references to the film and the appearance. Const members may be used from several threads.
class ReverseMap {
public:
    // `appearance` describes the triangles of the body on which the film is laid. `tolerance` is in
    // mm on the body.
    ReverseMap(const LaidFilm& laid, const SurfaceAppearance& appearance, float tolerance = 0.03f);

    // Returns whether a texture seam (edges of the body's mesh) crosses a painted film triangle.
    bool isSeam(std::uint32_t triangle) const { return seam_[triangle] != 0; }
    std::size_t seamCount() const;

    SurfacePoint surface(const FilmWeights& place) const;
    TexturePlace texture(const SurfacePoint& point) const;
    // Returns the place of the texture that the sheet shows at a place of the film.
    TexturePlace texture(const FilmWeights& place) const;

    // Returns the point in the plane of a body triangle that has this texture coordinate. The
    // triangle's texture map is continued beyond its edges. None if the whole triangle shows a
    // single point or line of the texture.
    std::optional<Eigen::Vector3f> showing(const Eigen::Vector2f& coordinate,
                                           std::uint32_t bodyTriangle) const;

    // Converts displacements on the body (mm, one per column) to differences of texture
    // coordinates. Zero if the triangle has no texture coordinates.
    Eigen::Matrix2f textureSteps(std::uint32_t bodyTriangle,
                                 const Eigen::Matrix<float, 3, 2>& steps) const;
    // Returns the points of contact of a film triangle's corners, as columns.
    Eigen::Matrix3f contactPoints(std::uint32_t filmTriangle) const;

    // Returns a whole film triangle as a piece.
    FilmPiece whole(std::uint32_t triangle) const;
    // Returns the four pieces between the corners and the middles of the edges: one at each corner,
    // then the middle one, which is upside down.
    std::array<FilmPiece, 4> halved(const FilmPiece& piece,
                                    const std::array<SurfacePoint, 3>& middles) const;
    // Returns the middles of the edges on the body; edge k runs from corner k to the next.
    std::array<SurfacePoint, 3> middles(const FilmPiece& piece) const;
    // Returns the piece's texture coordinates if they are linear; none if the piece must be halved.
    std::optional<LinearPiece> linear(const FilmPiece& piece,
                                      const std::array<SurfacePoint, 3>& middles) const;

private:
    float mismatch(const SurfacePoint& point, const Eigen::Vector2f& coordinate) const;
    void markSeams(const LaidFilm& laid);

    float tolerance_;
    const FilmContact& contact_;
    const SurfaceAppearance& appearance_;
    const TriangleMesh& mesh_; // the body's
    const SurfaceQuery& query_;
    const std::vector<FilmTriangle>& triangles_;
    std::vector<std::uint8_t> seam_; // one per film triangle
};

} // namespace dipwright
