#include "production/reference/PlaneEquilibrium.h"

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

namespace dipwright::reference {

using numerics::Matrix2;

namespace {

constexpr int maximumNewtonSteps = 40;

} // namespace

PlaneEquilibrium::PlaneEquilibrium(const solver::FilmGrid& grid) : grid_(grid) {
    const Matrix2<double> rest{1 / grid.spacingX(), 0, 0, 1 / grid.spacingZ()};
    for (int row = 0; row + 1 < grid.rows; ++row) {
        for (int column = 0; column + 1 < grid.columns; ++column) {
            const std::size_t lowerLeft =
                std::size_t(row) * std::size_t(grid.columns) + std::size_t(column);
            const std::size_t upperLeft = lowerLeft + std::size_t(grid.columns);
            const std::size_t side = (row + column) % 2 == 0 ? 1 : 0; // first triangle: right edge
            triangles_.push_back(
                {lowerLeft, lowerLeft + 1, lowerLeft + side, upperLeft + side, rest});
            triangles_.push_back(
                {upperLeft, upperLeft + 1, lowerLeft + 1 - side, upperLeft + 1 - side, rest});
        }
    }
    setFree(std::vector<float>(grid.pointCount(), 1.f));
}

void PlaneEquilibrium::setFree(const std::vector<float>& free) {
    unknown_.assign(free.size(), -1);
    unknowns_ = 0;
    for (std::size_t point = 0; point < free.size(); ++point) {
        if (free[point] > 0) {
            unknown_[point] = unknowns_++;
        }
    }
}

PlaneEquilibrium::Triangle& PlaneEquilibrium::triangleOf(const Crossing& crossing) {
    return triangles_[2 * std::size_t(crossing.cell) + crossing.second];
}

const PlaneEquilibrium::Triangle& PlaneEquilibrium::triangleOf(const Crossing& crossing) const {
    return triangles_[2 * std::size_t(crossing.cell) + crossing.second];
}

numerics::EdgePair<double> PlaneEquilibrium::edges(const Triangle& triangle,
                                                   const PlaneVector& displacement) const {
    const numerics::EdgePair<double> plane{
        grid_.spacingX() + displacement.x[triangle.right] - displacement.x[triangle.left],
        displacement.z[triangle.right] - displacement.z[triangle.left],
        displacement.x[triangle.upper] - displacement.x[triangle.lower],
        grid_.spacingZ() + displacement.z[triangle.upper] - displacement.z[triangle.lower]};
    return triangle.crossing < 0
               ? plane
               : numerics::unfoldedEdges(plane, crossing_[std::size_t(triangle.crossing)]);
}

Matrix2<double> PlaneEquilibrium::wholeGradient(const Triangle& triangle,
                                                const PlaneVector& displacement) const {
    return gradientOf(edges(triangle, displacement), triangle.inverseShape);
}

void PlaneEquilibrium::setCrossing(std::vector<Crossing> triangles,
                                   const PlaneVector& displacement) {
    for (const Crossing& crossing : crossing_) {
        triangleOf(crossing).crossing = -1;
    }
    crossing_ = std::move(triangles);
    anchors_.clear();
    for (std::size_t k = 0; k < crossing_.size(); ++k) {
        Triangle& triangle = triangleOf(crossing_[k]);
        triangle.crossing = int(k);
        anchors_.push_back(
            numerics::crossingAnchor(crossing_[k], wholeGradient(triangle, displacement)));
    }
}

void PlaneEquilibrium::moveCrossing(std::vector<Crossing> triangles) {
    crossing_ = std::move(triangles);
    for (std::size_t k = 0; k < crossing_.size(); ++k) {
        anchors_[k] = numerics::anchorOverStep(anchors_[k], crossing_[k]);
    }
}

bool PlaneEquilibrium::moves(const Triangle& triangle) const {
    return unknown_[triangle.left] >= 0 || unknown_[triangle.right] >= 0 ||
           unknown_[triangle.lower] >= 0 || unknown_[triangle.upper] >= 0;
}

// The gradient of the energy at the moving points, and its derivative when asked for. Returns the
// root of the sum of squares of all edge forces of triangles that can move.
double PlaneEquilibrium::assemble(const PlaneVector& displacement, const Drag& drag,
                                  Eigen::VectorXd& force,
                                  Eigen::SparseMatrix<double>* jacobian) const {
    force = Eigen::VectorXd::Zero(2 * unknowns_);
    std::vector<Eigen::Triplet<double>> entries;
    const double area = grid_.spacingX() * grid_.spacingZ() / 2;
    double squares = 0;
    for (const Triangle& triangle : triangles_) {
        if (!moves(triangle)) {
            continue;
        }
        const bool crosses = triangle.crossing >= 0;
        const auto edgeForces = [&](const Matrix2<double>& P) -> std::array<double, 4> {
            const numerics::EdgePair<double> f =
                crosses ? numerics::crossingForces(crossing_[std::size_t(triangle.crossing)], P,
                                                   triangle.inverseShape, area)
                        : numerics::edgeForces(P, triangle.inverseShape, area);
            return {f.hx, f.hz, f.vx, f.vz};
        };
        Matrix2<double> F = wholeGradient(triangle, displacement);
        if (crosses) {
            F = floatingGradient(anchors_[std::size_t(triangle.crossing)], F);
        }
        numerics::StressState<double> state;
        const std::array<double, 4> f = edgeForces(stress(F, state));
        squares += f[0] * f[0] + f[1] * f[1];
        // Each entry: a point, the sign with which the edges' forces reach it, and which edge.
        const std::array<std::size_t, 4> points{triangle.right, triangle.left, triangle.upper,
                                                triangle.lower};
        const auto sign = [](std::size_t end) { return end % 2 == 0 ? 1.0 : -1.0; };
        for (std::size_t end = 0; end < 4; ++end) {
            const int row = unknown_[points[end]];
            if (row >= 0) {
                force[2 * row] += sign(end) * f[2 * (end / 2)];
                force[2 * row + 1] += sign(end) * f[2 * (end / 2) + 1];
            }
        }
        if (!jacobian) {
            continue;
        }
        for (std::size_t moved = 0; moved < 4; ++moved) {
            const int column = unknown_[points[moved]];
            for (int component = 0; column >= 0 && component < 2; ++component) {
                const double change = sign(moved);
                const bool horizontal = moved < 2, isX = component == 0;
                const Matrix2<double> edges{
                    horizontal && isX ? change : 0, !horizontal && isX ? change : 0,
                    horizontal && !isX ? change : 0, !horizontal && !isX ? change : 0};
                Matrix2<double> dF = edges * triangle.inverseShape;
                if (crosses) {
                    dF = floatingChange(anchors_[std::size_t(triangle.crossing)], dF);
                }
                const std::array<double, 4> df = edgeForces(stressDerivative(dF, state));
                for (std::size_t end = 0; end < 4; ++end) {
                    const int row = unknown_[points[end]];
                    if (row >= 0) {
                        for (int k = 0; k < 2; ++k) {
                            entries.emplace_back(2 * row + k, 2 * column + component,
                                                 sign(end) * df[2 * (end / 2) + std::size_t(k)]);
                        }
                    }
                }
            }
        }
    }
    for (std::size_t point = 0; point < unknown_.size(); ++point) {
        const int row = unknown_[point];
        if (row >= 0) {
            force[2 * row] += drag.perPoint * (displacement.x[point] - drag.before.x[point]);
            force[2 * row + 1] += drag.perPoint * (displacement.z[point] - drag.before.z[point]);
        }
    }
    if (jacobian) {
        for (int i = 0; i < 2 * unknowns_; ++i) {
            entries.emplace_back(i, i, drag.perPoint);
        }
        jacobian->resize(2 * unknowns_, 2 * unknowns_);
        jacobian->setFromTriplets(entries.begin(), entries.end());
    }
    return std::sqrt(squares);
}

double PlaneEquilibrium::solve(PlaneVector& displacement, const Drag& drag, double residual) {
    Eigen::VectorXd force;
    Eigen::SparseMatrix<double> jacobian;
    double ratio = 0;
    for (int iteration = 0; iteration < maximumNewtonSteps && unknowns_ > 0; ++iteration) {
        const double elastic = assemble(displacement, drag, force, &jacobian);
        ratio = elastic > 1e-9 ? force.norm() / elastic : 0;
        if (ratio <= residual) {
            break;
        }
        Eigen::SparseLU<Eigen::SparseMatrix<double>> factors;
        factors.compute(jacobian);
        const Eigen::VectorXd step = factors.solve(force);
        const double longest = step.cwiseAbs().maxCoeff();
        const double cell = std::max(grid_.spacingX(), grid_.spacingZ());
        double length = std::min(1.0, 2 * cell / std::max(longest, 1e-30));
        const PlaneVector start = displacement;
        const double before = force.norm();
        const double whole = length;
        const auto take = [&](double share) {
            for (std::size_t point = 0; point < unknown_.size(); ++point) {
                if (unknown_[point] >= 0) {
                    displacement.x[point] = start.x[point] - share * step[2 * unknown_[point]];
                    displacement.z[point] = start.z[point] - share * step[2 * unknown_[point] + 1];
                }
            }
            assemble(displacement, drag, force, nullptr);
            return force.norm();
        };
        bool better = false;
        for (int attempt = 0; attempt < 8 && !better; ++attempt, length /= 2) {
            better = take(length) < before;
        }
        if (!better) { // the forces may have to grow on the way past a crease
            take(whole);
        }
    }
    return ratio;
}

std::vector<numerics::TriangleCorners>
PlaneEquilibrium::tornTriangles(const PlaneVector& displacement, double limit) const {
    std::vector<numerics::TriangleCorners> torn;
    for (std::size_t index = 0; index < triangles_.size(); ++index) {
        const Triangle& triangle = triangles_[index];
        if (moves(triangle) &&
            isTorn(edges(triangle, displacement), grid_.spacingX(), grid_.spacingZ(), limit)) {
            torn.push_back(numerics::triangleCorners(grid_.columns, index));
        }
    }
    return torn;
}

void PlaneEquilibrium::reshape(std::size_t cell, bool second, const Matrix2<double>& change) {
    Matrix2<double>& shape = triangles_[2 * cell + second].inverseShape;
    shape = change * shape;
}

void PlaneEquilibrium::relax(const PlaneVector& displacement, double keep) {
    for (Triangle& triangle : triangles_) {
        const Matrix2<double> whole = wholeGradient(triangle, displacement);
        if (triangle.crossing < 0) {
            if (keep < 1) {
                triangle.inverseShape =
                    numerics::relaxedInverseShape(triangle.inverseShape, whole, keep);
            }
            continue;
        }
        triangle.inverseShape = numerics::relaxedCrossingShape(
            anchors_[std::size_t(triangle.crossing)], whole, triangle.inverseShape, keep);
    }
}

} // namespace dipwright::reference
