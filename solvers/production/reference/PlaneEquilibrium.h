// The film in the water plane in equilibrium, the plain way: double precision, one triangle after
// the other, Newton's method with the exact Jacobian and a direct sparse solver. Slow; the oracle
// for the fast solvers. The same model (film-physics §2) and the same formulae
// (production/formulas).
#pragma once

#include "production/formulas/CrossingTriangle.h"
#include "production/formulas/WaterDrag.h"

#include <dipwright/FilmSolver.h>

#include <Eigen/SparseCore>
#include <array>
#include <vector>

namespace dipwright::reference {

struct PlaneVector {
    using Real = double;
    std::vector<double> x, z;

    PlaneVector() = default;
    explicit PlaneVector(std::size_t points) : x(points), z(points) {}
};

// What numerics::FilmDip asks of an equilibrium.
class PlaneEquilibrium {
public:
    using Vector = PlaneVector;
    using Crossing = numerics::CrossingTriangle<double>;
    using Drag = numerics::Drag<PlaneVector>;

    explicit PlaneEquilibrium(const solver::FilmGrid& grid);

    void setFree(const std::vector<float>& free);
    void setCrossing(std::vector<Crossing> triangles, const PlaneVector& displacement);
    void moveCrossing(std::vector<Crossing> triangles);
    // Newton's method to `residual` (force left over elastic force). Returns what was reached.
    double solve(PlaneVector& displacement, const Drag& drag, double residual);
    std::vector<numerics::TriangleCorners> tornTriangles(const PlaneVector& displacement,
                                                         double limit) const;
    void relax(const PlaneVector& displacement, double keep);
    // The inverse rest shape of a triangle times `change`.
    void reshape(std::size_t cell, bool second, const numerics::Matrix2<double>& change);
    template <typename Piece>
    static void forEach(std::size_t count, const Piece& work) {
        for (std::size_t i = 0; i < count; ++i) {
            work(i);
        }
    }

private:
    // A triangle by its grid edges: the horizontal one from `left` to `right`, the vertical one
    // from `lower` to `upper` (grid index); one corner belongs to both.
    struct Triangle {
        std::size_t left, right, lower, upper;
        numerics::Matrix2<double> inverseShape;
        int crossing = -1; // index into crossing_
    };

    Triangle& triangleOf(const Crossing& crossing);
    const Triangle& triangleOf(const Crossing& crossing) const;
    numerics::EdgePair<double> edges(const Triangle& triangle,
                                     const PlaneVector& displacement) const;
    numerics::Matrix2<double> wholeGradient(const Triangle& triangle,
                                            const PlaneVector& displacement) const;
    bool moves(const Triangle& triangle) const;
    double assemble(const PlaneVector& displacement, const Drag& drag, Eigen::VectorXd& force,
                    Eigen::SparseMatrix<double>* jacobian) const;

    solver::FilmGrid grid_;
    std::vector<Triangle> triangles_; // first and second of every cell
    std::vector<Crossing> crossing_;
    std::vector<numerics::CrossingAnchor<double>> anchors_;
    std::vector<int> unknown_; // of a point: its place among the moving points, or −1
    int unknowns_ = 0;
};

} // namespace dipwright::reference
