#include "marks/MarkedPieces.h"

namespace dipwright {

void addNotNegative(const MarkedPiece& piece, const std::array<float, 3>& values,
                    std::vector<MarkedPiece>& pieces) {
    std::vector<Eigen::Vector3f> outline;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (values[k] >= 0) {
            outline.push_back(piece.corners[k]);
        }
        if ((values[k] >= 0) != (values[next] >= 0)) {
            // A value of infinity is at the border of what faces the brush.
            const float share = std::isfinite(values[k]) && std::isfinite(values[next])
                                    ? values[k] / (values[k] - values[next])
                                    : 0.5f;
            outline.push_back(piece.corners[k] + share * (piece.corners[next] - piece.corners[k]));
        }
    }
    for (std::size_t k = 2; k < outline.size(); ++k) {
        pieces.push_back({piece.triangle, {outline[0], outline[k - 1], outline[k]}});
    }
}

} // namespace dipwright
