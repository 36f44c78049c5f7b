#include "results/ProofScene.h"

#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dipwright {
namespace {

// Returns directions in the half sphere round +Z, denser towards the pole, where light counts more
// (cosine-weighted Fibonacci spiral).
std::vector<Eigen::Vector3f> hemisphere(int count) {
    std::vector<Eigen::Vector3f> directions;
    const float turn = std::numbers::pi_v<float> * (3 - std::sqrt(5.0f));
    for (int i = 0; i < count; ++i) {
        const float squared = (float(i) + 0.5f) / float(count);
        const float radius = std::sqrt(squared);
        const float angle = turn * float(i);
        directions.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                std::sqrt(1 - squared));
    }
    return directions;
}

float openShare(const SurfaceQuery& query, const Eigen::Vector3f& place,
                const Eigen::Vector3f& normal, const std::vector<Eigen::Vector3f>& directions,
                float reach) {
    const Eigen::Quaternionf turn =
        Eigen::Quaternionf::FromTwoVectors(Eigen::Vector3f::UnitZ(), normal);
    const Eigen::Vector3f start = place + normal * (reach * 2e-3f);
    float open = 0;
    for (const Eigen::Vector3f& direction : directions) {
        const RayHit hit = query.hit(start, turn * direction, reach);
        open += hit.point.isValid() ? std::min(1.0f, hit.distance / reach) : 1.0f;
    }
    return open / float(directions.size());
}

} // namespace

SkyLight::SkyLight(const TriangleMesh& mesh, const SurfaceQuery& query)
    : mesh_(mesh), body_(mesh.positions.size()),
      table_(std::size_t(tableCells + 1) * std::size_t(tableCells + 1)) {
    const BoundingBox box = boundingBox(mesh);
    const float size = box.diagonal().norm();
    const std::vector<Eigen::Vector3f> normals = vertexNormals(mesh);
    // Fine meshes need fewer rays, because interpolation between many positions averages the noise.
    const auto rays = int(std::clamp<std::size_t>(4'000'000 / mesh.positions.size(), 12, 96));
    const std::vector<Eigen::Vector3f> overBody = hemisphere(rays);
    parallelFor(std::size_t(0), body_.size(), [&](std::size_t i) {
        body_[i] = openShare(query, mesh.positions[i], normals[i], overBody, 0.4f * size);
    });

    tableHeight_ = box.min().y() - 0.01f * size;
    const Eigen::Vector2f centre(box.center().x(), box.center().z());
    tableOrigin_ = centre - Eigen::Vector2f::Constant(1.2f * size);
    tableSpacing_ = 2.4f * size / tableCells;
    const std::vector<Eigen::Vector3f> overTable = hemisphere(192);
    parallelFor(std::size_t(0), table_.size(), [&](std::size_t i) {
        const auto row = float(i / (tableCells + 1));
        const auto column = float(i % (tableCells + 1));
        const Eigen::Vector3f place(tableOrigin_.x() + column * tableSpacing_, tableHeight_,
                                    tableOrigin_.y() + row * tableSpacing_);
        table_[i] = openShare(query, place, Eigen::Vector3f::UnitY(), overTable, size);
    });
}

float SkyLight::onBody(const SurfacePoint& point) const {
    const auto& corners = mesh_.triangles[point.triangle];
    return point.weights[0] * body_[corners[0]] + point.weights[1] * body_[corners[1]] +
           point.weights[2] * body_[corners[2]];
}

float SkyLight::onTable(float x, float z) const {
    const float column = (x - tableOrigin_.x()) / tableSpacing_;
    const float row = (z - tableOrigin_.y()) / tableSpacing_;
    if (!(column >= 0 && row >= 0 && column < tableCells && row < tableCells)) {
        return 1;
    }
    const int i = int(column);
    const int j = int(row);
    const float u = column - float(i);
    const float v = row - float(j);
    const float* upper = table_.data() + j * (tableCells + 1) + i;
    const float* lower = upper + tableCells + 1;
    return (1 - v) * ((1 - u) * upper[0] + u * upper[1]) + v * ((1 - u) * lower[0] + u * lower[1]);
}

} // namespace dipwright
