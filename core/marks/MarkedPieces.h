// Cuts triangles along the border of a marked area.
#pragma once

#include "geometry/TriangleMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dipwright {

// A flat piece of a marked surface.
struct MarkedPiece {
    std::uint32_t triangle = 0; // of the body, on which it lies
    std::array<Eigen::Vector3f, 3> corners;
};

// Side of a piece at the border, relative to the radius of the brush. The outline of the pieces
// then deviates from the exact one by less than 1 % of the radius.
inline constexpr float sidePerRadius = 0.15f;

// Adds the part of a piece where a value that is linear on it is not negative.
void addNotNegative(const MarkedPiece& piece, const std::array<float, 3>& values,
                    std::vector<MarkedPiece>& pieces);

// Adds the marked part of a piece. `inside` returns the distance of a place from the border of the
// marked area, mm, negative outside. It may be less than the true distance. At the border, the
// piece is divided until its sides are at most `finest` mm long.
template <typename Inside>
void addPieces(const MarkedPiece& piece, const Inside& inside, float finest,
               std::vector<MarkedPiece>& pieces) {
    const auto& [a, b, c] = piece.corners;
    const Eigen::Vector3f middle = (a + b + c) / 3;
    const float here = inside(middle);
    const float reach = std::max({(a - middle).norm(), (b - middle).norm(), (c - middle).norm()});
    if (std::abs(here) > reach) { // the border does not cross the piece
        if (here > 0) {
            pieces.push_back(piece);
        }
    } else if (std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()}) > finest) {
        const Eigen::Vector3f ab = (a + b) / 2, bc = (b + c) / 2, ca = (c + a) / 2;
        for (const std::array<Eigen::Vector3f, 3>& quarter :
             {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c},
              std::array{ab, bc, ca}}) {
            addPieces({piece.triangle, quarter}, inside, finest, pieces);
        }
    } else {
        addNotNegative(piece, {inside(a), inside(b), inside(c)}, pieces);
    }
}

} // namespace dipwright
