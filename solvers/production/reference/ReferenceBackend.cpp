#include "production/reference/ReferenceBackend.h"

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

namespace dipwright::reference {

using numerics::Matrix2;

static_assert(numerics::FilmBackend<ReferenceBackend>);

namespace {

// Returns the sign of the four ends of a triangle's edges: right, left, upper, lower. A gradient on
// an edge acts with + on the edge's higher end and with − on its lower end.
double sign(std::size_t end) {
    return end % 2 == 0 ? 1.0 : -1.0;
}
template <typename Triangle>
std::array<std::size_t, 4> endsOf(const Triangle& triangle) {
    return {triangle.right, triangle.left, triangle.upper, triangle.lower};
}

} // namespace

ReferenceBackend::ReferenceBackend(const solver::DipSetup& setup) : HostFilm(setup) {
    const solver::FilmGrid& grid = setup.film;
    for (int row = 0; row + 1 < grid.rows; ++row) {
        for (int column = 0; column + 1 < grid.columns; ++column) {
            const std::size_t lowerLeft =
                std::size_t(row) * std::size_t(grid.columns) + std::size_t(column);
            const std::size_t upperLeft = lowerLeft + std::size_t(grid.columns);
            const Matrix2<double> rest{1 / grid.spacingX(column), 0, 0, 1 / grid.spacingZ(row)};
            const double area = grid.spacingX(column) * grid.spacingZ(row) / 2;
            // Index of the edge: the first triangle has the right edge.
            const std::size_t side = (row + column) % 2 == 0 ? 1 : 0;
            triangles_.push_back(
                {lowerLeft, lowerLeft + 1, lowerLeft + side, upperLeft + side, area, rest});
            triangles_.push_back(
                {upperLeft, upperLeft + 1, lowerLeft + 1 - side, upperLeft + 1 - side, area, rest});
        }
    }
    states_.resize(triangles_.size());
    setFree();
}

void ReferenceBackend::setFree() {
    unknown_.assign(free_.size(), -1);
    unknowns_ = 0;
    for (std::size_t point = 0; point < free_.size(); ++point) {
        if (free_[point] > 0) {
            unknown_[point] = unknowns_++;
        }
    }
}

numerics::EdgePair<double> ReferenceBackend::edges(int number) const {
    const Triangle& triangle = at(number);
    const numerics::TriangleSize<double> size = triangleSize(model(), number);
    return {size.x + displacement_.x[triangle.right] - displacement_.x[triangle.left],
            displacement_.z[triangle.right] - displacement_.z[triangle.left],
            displacement_.x[triangle.upper] - displacement_.x[triangle.lower],
            size.z + displacement_.z[triangle.upper] - displacement_.z[triangle.lower]};
}

bool ReferenceBackend::triangleMoves(int number) const {
    const std::array<std::size_t, 4> ends = endsOf(at(number));
    return std::any_of(ends.begin(), ends.end(),
                       [&](std::size_t point) { return unknown_[point] >= 0; });
}

std::array<double, 4> ReferenceBackend::edgeForces(const Triangle& triangle,
                                                   const Matrix2<double>& P) const {
    const numerics::EdgePair<double> f =
        triangle.crossing >= 0 ? numerics::crossingForces(crossing_[std::size_t(triangle.crossing)],
                                                          P, triangle.inverseShape, triangle.area)
                               : numerics::edgeForces(P, triangle.inverseShape, triangle.area);
    return {f.hx, f.hz, f.vx, f.vz};
}

// Adds the gradient of a triangle's energy to the force on its moving points. Returns the sum of
// squares of the force on the triangle's horizontal edge.
double ReferenceBackend::addTriangleForces(int number, Eigen::VectorXd& force,
                                           numerics::StressState<double>& state) const {
    const Triangle& triangle = at(number);
    numerics::EdgePair<double> plane = edges(number);
    Matrix2<double> F;
    if (triangle.crossing >= 0) {
        const auto k = std::size_t(triangle.crossing);
        plane = numerics::unfoldedEdges(plane, crossing_[k]);
        F = floatingGradient(anchors_[k], gradientOf(plane, triangle.inverseShape));
    } else {
        F = gradientOf(plane, triangle.inverseShape);
    }
    const std::array<double, 4> f =
        edgeForces(triangle, stress(F, model().gatheredResistance, state));
    const std::array<std::size_t, 4> ends = endsOf(triangle);
    for (std::size_t end = 0; end < 4; ++end) {
        const int row = unknown_[ends[end]];
        if (row >= 0) {
            force[2 * row] += sign(end) * f[2 * (end / 2)];
            force[2 * row + 1] += sign(end) * f[2 * (end / 2) + 1];
        }
    }
    return f[0] * f[0] + f[1] * f[1];
}

// Adds the derivative of these forces with respect to each displacement of a moving point.
void ReferenceBackend::addTriangleJacobian(const Triangle& triangle,
                                           const numerics::StressState<double>& state,
                                           numerics::Tangent tangent,
                                           std::vector<Eigen::Triplet<double>>& entries) const {
    const std::array<std::size_t, 4> ends = endsOf(triangle);
    for (std::size_t moved = 0; moved < 4; ++moved) {
        const int column = unknown_[ends[moved]];
        for (int component = 0; column >= 0 && component < 2; ++component) {
            Matrix2<double> edges;
            const bool horizontal = moved < 2, isX = component == 0;
            (horizontal ? (isX ? edges.a : edges.c) : (isX ? edges.b : edges.d)) = sign(moved);
            Matrix2<double> dF = edges * triangle.inverseShape;
            if (triangle.crossing >= 0) {
                dF = floatingChange(anchors_[std::size_t(triangle.crossing)], dF);
            }
            const std::array<double, 4> df =
                edgeForces(triangle, stressDerivative(dF, state, tangent));
            for (std::size_t end = 0; end < 4; ++end) {
                const int row = unknown_[ends[end]];
                for (int k = 0; row >= 0 && k < 2; ++k) {
                    entries.emplace_back(2 * row + k, 2 * column + component,
                                         sign(end) * df[2 * (end / 2) + std::size_t(k)]);
                }
            }
        }
    }
}

numerics::FilmForce ReferenceBackend::force(double drag) {
    force_ = Eigen::VectorXd::Zero(2 * unknowns_);
    double squares = 0;
    for (int triangle = 0; triangle < int(triangles_.size()); ++triangle) {
        if (triangleMoves(triangle)) {
            squares += addTriangleForces(triangle, force_, states_[std::size_t(triangle)]);
        }
    }
    for (std::size_t point = 0; point < unknown_.size(); ++point) {
        const int row = unknown_[point];
        if (row >= 0) {
            const double own = drag * pointArea(model(), int(point));
            force_[2 * row] += own * (displacement_.x[point] - before_.x[point]);
            force_[2 * row + 1] += own * (displacement_.z[point] - before_.z[point]);
        }
    }
    return {force_.norm(), std::sqrt(squares)};
}

numerics::FilmForce ReferenceBackend::forceAlong(double length, double drag) {
    for (std::size_t point = 0; point < unknown_.size(); ++point) {
        if (unknown_[point] >= 0) {
            displacement_.x[point] = start_.x[point] + length * step_[2 * unknown_[point]];
            displacement_.z[point] = start_.z[point] + length * step_[2 * unknown_[point] + 1];
        }
    }
    return force(drag);
}

numerics::Vector2<double> ReferenceBackend::forceOn(int point) const {
    const int row = unknown_[std::size_t(point)];
    return row < 0 ? numerics::Vector2<double>{}
                   : numerics::Vector2<double>{force_[2 * row], force_[2 * row + 1]};
}

void ReferenceBackend::solveLinear(double drag, numerics::Tangent tangent, double, double) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int triangle = 0; triangle < int(triangles_.size()); ++triangle) {
        if (triangleMoves(triangle)) {
            addTriangleJacobian(at(triangle), states_[std::size_t(triangle)], tangent, entries);
        }
    }
    for (std::size_t point = 0; point < unknown_.size(); ++point) {
        const int row = unknown_[point];
        for (int k = 0; row >= 0 && k < 2; ++k) {
            entries.emplace_back(2 * row + k, 2 * row + k, drag * pointArea(model(), int(point)));
        }
    }
    Eigen::SparseMatrix<double> jacobian(2 * unknowns_, 2 * unknowns_);
    jacobian.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> factors;
    factors.compute(jacobian);
    step_ = -factors.solve(force_);
}

double ReferenceBackend::startOfStep() {
    start_ = displacement_;
    return step_.cwiseAbs().maxCoeff();
}

} // namespace dipwright::reference
