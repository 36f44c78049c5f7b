#include "marks/StrokePatch.h"

namespace dipwright {

StrokePatch::StrokePatch(const TriangleMesh& mesh, const SurfaceQuery& query, Millimetres radius)
    : mesh_(mesh), query_(query), stroke_({}, radius), isWhole_(mesh.triangles.size()) {}

void StrokePatch::add(const BrushPoint& point) {
    const Eigen::Vector3f to = modelPlace(point.place),
                          from = path_.empty() ? to : modelPlace(path_.back().place);
    path_.push_back(point);
    stroke_.add(point);
    const float radius = stroke_.radius();
    for (const std::uint32_t triangle :
         query_.trianglesNear((from + to) / 2, radius + (to - from).norm() / 2)) {
        if (isWhole_[triangle] != 0) {
            continue;
        }
        const MarkedPiece whole{triangle, cornersOf(mesh_, triangle)};
        const Eigen::Vector3f normal = triangleNormal(mesh_, triangle);
        std::vector<MarkedPiece> pieces;
        addPieces(
            whole,
            [&](const Eigen::Vector3f& place) { return radius - stroke_.distance(place, normal); },
            sidePerRadius * radius, pieces);
        if (pieces.size() == 1 && pieces.front().corners == whole.corners) {
            isWhole_[triangle] = 1;
            whole_.push_back(whole);
            parts_.erase(triangle);
        } else if (!pieces.empty()) {
            parts_[triangle] = std::move(pieces);
        }
    }
}

std::vector<MarkedPiece> StrokePatch::pieces() const {
    std::vector<MarkedPiece> all = whole_;
    for (const auto& [triangle, pieces] : parts_) {
        all.insert(all.end(), pieces.begin(), pieces.end());
    }
    return all;
}

} // namespace dipwright
