#include "share/SmoothSeam.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

constexpr double solved = 1e-6; // relative residual of the solver; moves the line by less than 1 µm
constexpr int mostIterations = 500;

// Cotangent of the angle between two sides of a triangle.
double cotangent(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
    const double area = double(a.cross(b).norm());
    return area > 0 ? double(a.dot(b)) / area : 0;
}

} // namespace

float steepness(const std::array<Eigen::Vector3f, 3>& corners, const std::array<float, 3>& values) {
    const Eigen::Vector3f u = corners[1] - corners[0];
    const Eigen::Vector3f v = corners[2] - corners[0];
    const float alongU = values[1] - values[0];
    const float alongV = values[2] - values[0];
    const float area = u.cross(v).norm();
    return area > 0 ? (alongU * v - alongV * u).norm() / area : 0;
}

float steepness(const TriangleMesh& mesh, std::size_t triangle, const std::vector<float>& field) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return steepness(cornersOf(mesh, triangle), {field[a], field[b], field[c]});
}

std::vector<float> smoothBorder(const TriangleMesh& mesh, const std::vector<std::uint8_t>& labels,
                                double width) {
    const auto size = Eigen::Index(mesh.positions.size());
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(size);
    Eigen::VectorXd labelled = Eigen::VectorXd::Zero(size);
    std::vector<Eigen::Triplet<double>> entries;
    // Implicit heat flow for the time t = width²/4: (M + t·L) u = M·label. M are the lumped areas,
    // L the cotangent weights. Weights of obtuse angles are set to 0 so that nothing overshoots.
    const double time = width * width / 4;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const auto& corners = mesh.triangles[triangle];
        const double area = triangleArea(mesh, triangle) / 3;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto i = Eigen::Index(corners[(k + 1) % 3]);
            const auto j = Eigen::Index(corners[(k + 2) % 3]);
            const Eigen::Vector3f& tip = mesh.positions[corners[k]];
            const double weight = std::max(0.0, cotangent(mesh.positions[std::size_t(i)] - tip,
                                                          mesh.positions[std::size_t(j)] - tip)) /
                                  2 * time;
            entries.emplace_back(i, j, -weight);
            entries.emplace_back(j, i, -weight);
            entries.emplace_back(i, i, weight);
            entries.emplace_back(j, j, weight);
            areas[corners[k]] += area;
            labelled[corners[k]] += labels[triangle] == 0 ? area : -area;
        }
    }
    for (Eigen::Index position = 0; position < size; ++position) {
        // A position without triangles has no area; any value will do.
        entries.emplace_back(position, position, std::max(areas[position], 1e-12));
    }
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver;
    solver.setTolerance(solved);
    solver.setMaxIterations(mostIterations);
    solver.compute(matrix);
    const Eigen::VectorXd smooth = solver.solve(labelled);
    return {smooth.data(), smooth.data() + smooth.size()};
}

std::vector<float> signedDistance(const TriangleMesh& mesh, const std::vector<float>& field,
                                  float limit, const UnfoldedTriangles& measured) {
    std::vector<float> begin(field.size(), std::numeric_limits<float>::infinity());
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const auto& corners = mesh.triangles[triangle];
        const auto isAbove = [&](std::uint32_t corner) { return field[corner] >= 0; };
        if (isAbove(corners[0]) == isAbove(corners[1]) &&
            isAbove(corners[1]) == isAbove(corners[2])) {
            continue;
        }
        const float steep =
            steepness(measured.empty() ? cornersOf(mesh, triangle) : measured[triangle],
                      {field[corners[0]], field[corners[1]], field[corners[2]]});
        for (const std::uint32_t corner : corners) {
            const float away = steep > 0 ? std::abs(field[corner]) / steep : 0;
            begin[corner] = std::min(begin[corner], away);
        }
    }
    std::vector<float> distance = surfaceDistance(mesh, std::move(begin), limit, measured);
    for (std::size_t position = 0; position < distance.size(); ++position) {
        distance[position] =
            std::copysign(std::min(distance[position], limit), field[position] >= 0 ? 1.0f : -1.0f);
    }
    return distance;
}

} // namespace dipwright
