#include "texture/ReverseMap.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {

namespace {

// After this many halvings, a piece is at most 1/64 of a film cell wide, and its places are mapped
// one by one.
constexpr int deepest = 6;
// A triangle on a texture seam is halved at least this often before it may count as linear.
// Otherwise a narrow part of another chart could lie undetected between the tested places.
constexpr int seamDepth = 2;
constexpr double seamSamplesPerCell = 4;

Eigen::Matrix<float, 3, 2> edges(const TriangleMesh& mesh, std::uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    Eigen::Matrix<float, 3, 2> edges;
    edges << mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a];
    return edges;
}

bool isSeamEdge(const TriangleMesh& mesh, const SurfaceAppearance& appearance, std::uint32_t edge,
                std::uint32_t opposite) {
    const std::uint32_t here = edge / 3;
    const std::uint32_t there = opposite / 3;
    if (appearance.chart[here] != appearance.chart[there]) {
        return true;
    }
    // A seam can also lie within one chart, for example where a cylinder's side is closed.
    const auto matches = [&](std::uint32_t corner) {
        const std::uint32_t position = mesh.triangles[here][corner];
        const Eigen::Vector2f& coordinate = appearance.textureCoordinates[here][corner];
        for (std::size_t other = 0; other < 3; ++other) {
            if (mesh.triangles[there][other] == position) {
                return appearance.textureCoordinates[there][other] == coordinate ||
                       !coordinate.allFinite();
            }
        }
        return true;
    };
    return !matches(edge % 3) || !matches((edge + 1) % 3);
}

} // namespace

std::size_t FilmPiece::child(const Eigen::Vector3f& weights) {
    for (int corner = 0; corner < 3; ++corner) {
        if (weights[corner] >= 0.5f) {
            return std::size_t(corner);
        }
    }
    return 3;
}

Eigen::Vector3f FilmPiece::childWeights(const Eigen::Vector3f& weights, std::size_t child) {
    if (child == 3) {
        return Eigen::Vector3f::Ones() - 2 * weights;
    }
    return 2 * weights - Eigen::Vector3f::Unit(int(child));
}

ReverseMap::ReverseMap(const LaidFilm& laid, const SurfaceAppearance& appearance, float tolerance)
    : tolerance_(tolerance), contact_(laid.contact()), appearance_(appearance),
      mesh_(laid.body().mesh), query_(laid.body().query), triangles_(laid.triangles()),
      seam_(triangles_.size(), 0) {
    markSeams(laid);
}

void ReverseMap::markSeams(const LaidFilm& laid) {
    const std::vector<std::uint32_t> opposite = oppositeEdges(mesh_);
    std::vector<std::uint32_t> seamEdges;
    for (std::uint32_t edge = 0; edge < opposite.size(); ++edge) {
        if (opposite[edge] != noEdge && edge < opposite[edge] &&
            isSeamEdge(mesh_, appearance_, edge, opposite[edge])) {
            seamEdges.push_back(edge);
        }
    }
    if (seamEdges.empty()) {
        return;
    }
    const solver::FilmGrid& grid = laid.film().grid;
    const double step = grid.leastSpacing() / seamSamplesPerCell;
    for (const std::uint32_t edge : seamEdges) {
        const std::uint32_t triangle = edge / 3;
        const int from = int(edge % 3);
        const int to = (from + 1) % 3;
        const float length = (mesh_.positions[mesh_.triangles[triangle][std::size_t(to)]] -
                              mesh_.positions[mesh_.triangles[triangle][std::size_t(from)]])
                                 .norm();
        const int steps = 1 + int(double(length) / step);
        for (int place = 0; place <= steps; ++place) {
            const float share = float(place) / float(steps);
            SurfacePoint point{triangle, Eigen::Vector3f::Zero()};
            point.weights[from] = 1 - share;
            point.weights[to] = share;
            if (const std::optional<FilmPlace> covering = laid.place(point)) {
                seam_[covering->triangle] = 1;
            }
        }
    }
}

std::size_t ReverseMap::seamCount() const {
    return std::size_t(std::count(seam_.begin(), seam_.end(), 1));
}

SurfacePoint ReverseMap::surface(const FilmWeights& place) const {
    const FilmTriangle& corners = triangles_[place.triangle];
    const Eigen::Vector3f& a = contact_.places[corners[0]];
    const Eigen::Vector3f& b = contact_.places[corners[1]];
    const Eigen::Vector3f& c = contact_.places[corners[2]];
    const Eigen::Vector3f flat = place.weights[0] * a + place.weights[1] * b + place.weights[2] * c;
    const float reach = (b - a).norm() + (c - a).norm(); // the corners are on the body
    // If film is compressed to a point, `reach` is 0, and because of rounding no body lies within
    // it.
    const ClosestPoint closest = query_.closestNear(flat, reach);
    // Where the body is thin, its other side may be nearer. The right side is the one that faces
    // the film.
    const Eigen::Vector3f intoBody = (b - a).cross(c - a);
    if (triangleNormal(mesh_, closest.point.triangle).dot(intoBody) < 0) {
        return closest.point;
    }
    const RayHit facing = query_.hit(flat, -intoBody.normalized(), reach);
    return facing.point.isValid() ? facing.point : closest.point;
}

TexturePlace ReverseMap::texture(const SurfacePoint& point) const {
    return {appearance_.textureCoordinate(point), point.triangle};
}

TexturePlace ReverseMap::texture(const FilmWeights& place) const {
    FilmPiece piece = whole(place.triangle);
    Eigen::Vector3f weights = place.weights;
    while (piece.depth < deepest) {
        const std::array<SurfacePoint, 3> between = middles(piece);
        if (const auto patch = linear(piece, between)) {
            return {patch->coordinate(weights), patch->bodyTriangle};
        }
        const std::size_t child = FilmPiece::child(weights);
        weights = FilmPiece::childWeights(weights, child);
        piece = halved(piece, between)[child];
    }
    return texture(surface(place));
}

Eigen::Matrix2f ReverseMap::textureSteps(std::uint32_t bodyTriangle,
                                         const Eigen::Matrix<float, 3, 2>& steps) const {
    const auto& corners = appearance_.textureCoordinates[bodyTriangle];
    Eigen::Matrix2f onTexture;
    onTexture << corners[1] - corners[0], corners[2] - corners[0];
    const Eigen::Matrix<float, 3, 2> onBody = edges(mesh_, bodyTriangle);
    const Eigen::Matrix2f normal = onBody.transpose() * onBody;
    const Eigen::Matrix2f moved = onTexture * normal.inverse() * onBody.transpose() * steps;
    return moved.allFinite() ? moved : Eigen::Matrix2f(Eigen::Matrix2f::Zero());
}

Eigen::Matrix3f ReverseMap::contactPoints(std::uint32_t filmTriangle) const {
    const FilmTriangle& corners = triangles_[filmTriangle];
    Eigen::Matrix3f points;
    points << contact_.places[corners[0]], contact_.places[corners[1]], contact_.places[corners[2]];
    return points;
}

FilmPiece ReverseMap::whole(std::uint32_t triangle) const {
    FilmPiece piece;
    piece.triangle = triangle;
    for (int corner = 0; corner < 3; ++corner) {
        piece.corners[std::size_t(corner)] = Eigen::Vector3f::Unit(corner);
        const SurfacePoint& touched = contact_.surface[triangles_[triangle][std::size_t(corner)]];
        piece.surface[std::size_t(corner)] =
            touched.isValid() ? touched : surface({triangle, Eigen::Vector3f::Unit(corner)});
    }
    return piece;
}

std::array<SurfacePoint, 3> ReverseMap::middles(const FilmPiece& piece) const {
    std::array<SurfacePoint, 3> middles;
    for (std::size_t edge = 0; edge < 3; ++edge) {
        middles[edge] =
            surface({piece.triangle, (piece.corners[edge] + piece.corners[(edge + 1) % 3]) / 2});
    }
    return middles;
}

std::array<FilmPiece, 4> ReverseMap::halved(const FilmPiece& piece,
                                            const std::array<SurfacePoint, 3>& middles) const {
    std::array<FilmPiece, 4> children{piece, piece, piece, piece};
    for (FilmPiece& child : children) {
        ++child.depth;
    }
    const auto setMiddle = [&](FilmPiece& child, std::size_t corner, std::size_t edge) {
        child.corners[corner] = (piece.corners[edge] + piece.corners[(edge + 1) % 3]) / 2;
        child.surface[corner] = middles[edge];
    };
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::size_t next = (corner + 1) % 3;
        const std::size_t previous = (corner + 2) % 3;
        setMiddle(children[corner], next, corner);
        setMiddle(children[corner], previous, previous);
        setMiddle(children[3], corner, next);
    }
    return children;
}

std::optional<Eigen::Vector3f> ReverseMap::showing(const Eigen::Vector2f& coordinate,
                                                   std::uint32_t bodyTriangle) const {
    const auto& corners = appearance_.textureCoordinates[bodyTriangle];
    Eigen::Matrix2f onTexture;
    onTexture << corners[1] - corners[0], corners[2] - corners[0];
    const Eigen::Vector2f steps = onTexture.inverse() * (coordinate - corners[0]);
    if (!steps.allFinite()) {
        return std::nullopt;
    }
    const std::uint32_t first = mesh_.triangles[bodyTriangle][0];
    return mesh_.positions[first] + edges(mesh_, bodyTriangle) * steps;
}

float ReverseMap::mismatch(const SurfacePoint& point, const Eigen::Vector2f& coordinate) const {
    if (const auto shown = showing(coordinate, point.triangle)) {
        return (*shown - position(mesh_, point)).norm();
    }
    return coordinate == appearance_.textureCoordinate(point)
               ? 0
               : std::numeric_limits<float>::infinity();
}

std::optional<LinearPiece> ReverseMap::linear(const FilmPiece& piece,
                                              const std::array<SurfacePoint, 3>& middles) const {
    if (isSeam(piece.triangle) && piece.depth < seamDepth) {
        return std::nullopt;
    }
    const std::uint32_t chart = appearance_.chart[middles[0].triangle];
    const auto onChart = [&](const SurfacePoint& point) {
        return appearance_.chart[point.triangle] == chart;
    };
    if (!std::all_of(middles.begin(), middles.end(), onChart) ||
        !std::all_of(piece.surface.begin(), piece.surface.end(), onChart)) {
        return std::nullopt;
    }
    LinearPiece linear;
    linear.bodyTriangle = middles[0].triangle;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        linear.coordinates[corner] = appearance_.textureCoordinate(piece.surface[corner]);
    }
    const bool isTextured = appearance_.hasTextureCoordinates(linear.bodyTriangle);
    const auto& [a, b, c] = linear.coordinates;
    const auto fits = [&](const SurfacePoint& point, const Eigen::Vector2f& coordinate) {
        return !isTextured || mismatch(point, coordinate) <= tolerance_;
    };
    if (!fits(middles[0], (a + b) / 2) || !fits(middles[1], (b + c) / 2) ||
        !fits(middles[2], (c + a) / 2)) {
        return std::nullopt; // before the search for the centre, which takes most of the time
    }
    const Eigen::Vector3f centre = (piece.corners[0] + piece.corners[1] + piece.corners[2]) / 3;
    const SurfacePoint middle = surface({piece.triangle, centre});
    return onChart(middle) && fits(middle, (a + b + c) / 3) ? std::optional(linear) : std::nullopt;
}

} // namespace dipwright
