// Computes the production film in the simplest way: in double precision, one triangle after the
// other, with Newton's method, the exact Jacobian and a direct sparse solver. It is slow; the fast
// backends are tested against it. All backends share the same model, formulas and step
// (production/formulas).
#pragma once

#include "production/formulas/HostFilm.h"

#include <Eigen/SparseCore>
#include <array>
#include <cmath>
#include <vector>

namespace dipwright::reference {

struct PlaneVector {
    using Real = double;
    std::vector<double> x, z;

    PlaneVector() = default;
    explicit PlaneVector(std::size_t points) : x(points), z(points) {}
};

class ReferenceBackend : public numerics::HostFilm<PlaneVector> {
public:
    explicit ReferenceBackend(const solver::DipSetup& setup);

    numerics::Matrix2<double> shape(int triangle) const { return at(triangle).inverseShape; }
    void setShape(int triangle, const numerics::Matrix2<double>& shape) {
        triangles_[std::size_t(triangle)].inverseShape = shape;
    }
    numerics::EdgePair<double> edges(int triangle) const;
    bool triangleMoves(int triangle) const;

    template <typename Crosses, typename Unfold>
    numerics::LineState<double> findCrossing(const Crosses& crosses, const Unfold& unfold);
    template <typename Work>
    void forCrossing(const Work& work) {
        for (std::size_t k = 0; k < crossing_.size(); ++k) {
            work(numberOf(crossing_[k]), crossing_[k], anchors_[k]);
        }
    }
    template <typename OnLine, typename Floating>
    void forTriangles(const OnLine& onLine, const Floating& floating) {
        forCrossing(onLine);
        for (int triangle = 0; triangle < int(triangles_.size()); ++triangle) {
            if (at(triangle).crossing < 0) {
                floating(triangle);
            }
        }
    }
    template <typename OnLine, typename Floating>
    void forStretched(double, const OnLine& onLine, const Floating& floating) {
        forTriangles(onLine, floating);
    }

    static constexpr numerics::NewtonLimits newtonLimits() {
        numerics::NewtonLimits limits;
        limits.newtonSteps = 40;
        limits.shortenings = 8;
        limits.sufficientDecrease = 0;
        limits.flatForce = 1e-12;
        return limits;
    }
    void setFree();
    numerics::FilmForce force(double drag);
    numerics::FilmForce forceAlong(double length, double drag);
    numerics::Vector2<double> forceOn(int point) const;
    static void prepareLinear(double) {} // the direct solver needs no preparation
    void solveLinear(double drag, numerics::Tangent tangent, double start, double tolerance);
    double startOfStep();
    void keepBest() { best_ = displacement_; }
    void takeBest() { displacement_ = best_; }

private:
    using Crossing = numerics::CrossingTriangle<double>;
    // A triangle, defined by its grid edges: the horizontal edge from point `left` to point `right`
    // and the vertical edge from point `lower` to point `upper`. The edges share one corner.
    struct Triangle {
        std::size_t left, right, lower, upper;
        double area; // rest area, mm²
        numerics::Matrix2<double> inverseShape;
        int crossing = -1; // index into crossing_; −1 if the triangle does not cross
    };

    static int numberOf(const Crossing& crossing) {
        return 2 * int(crossing.cell) + crossing.second;
    }
    const Triangle& at(int triangle) const { return triangles_[std::size_t(triangle)]; }
    std::array<double, 4> edgeForces(const Triangle& triangle,
                                     const numerics::Matrix2<double>& P) const;
    double addTriangleForces(int triangle, Eigen::VectorXd& force,
                             numerics::StressState<double>& state) const;
    void addTriangleJacobian(const Triangle& triangle, const numerics::StressState<double>& state,
                             numerics::Tangent tangent,
                             std::vector<Eigen::Triplet<double>>& entries) const;

    std::vector<Triangle> triangles_; // the first and second triangle of every cell
    std::vector<Crossing> crossing_;
    std::vector<numerics::CrossingAnchor<double>> anchors_;
    std::vector<int> unknown_; // per point: its index among the moving points, or −1
    int unknowns_ = 0;
    Eigen::VectorXd force_, step_;
    std::vector<numerics::StressState<double>>
        // States of the triangles at the last force computation.
        states_;
    PlaneVector start_, best_;
};

template <typename Crosses, typename Unfold>
numerics::LineState<double> ReferenceBackend::findCrossing(const Crosses& crosses,
                                                           const Unfold& unfold) {
    numerics::LineState<double> line;
    crossing_.clear();
    for (int triangle = 0; triangle < int(triangles_.size()); ++triangle) {
        const auto corners = numerics::triangleCorners(model().columns, std::size_t(triangle));
        triangles_[std::size_t(triangle)].crossing = -1;
        if (crosses(corners)) {
            const auto unfolded = unfold(triangle, corners);
            triangles_[std::size_t(triangle)].crossing = int(crossing_.size());
            crossing_.push_back(unfolded.crossing);
            line = {std::min(line.steepness, unfolded.steepness), true,
                    std::fmax(line.upwards, unfolded.crossing.upwards)};
        }
    }
    anchors_.resize(crossing_.size());
    return line;
}

} // namespace dipwright::reference
