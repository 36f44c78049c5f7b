// The elastic energy of the film in the water plane: its gradient and Hessian on the regular grid.
//
// Every triangle of the film has one horizontal and one vertical grid edge, so that forces live on
// edges and a whole row of cells is a few plain loops; the diagonal of a cell only says which edges
// its two triangles take (FilmSolver.h, FilmGrid).
#pragma once

#include "production/cpu/PlaneVector.h"
#include "production/formulas/CrossingTriangle.h"

#include <dipwright/FilmSolver.h>

#include <cstdint>
#include <utility>

namespace dipwright::cpu {

class PlaneFilm {
public:
    using Crossing = numerics::CrossingTriangle<float>;

    explicit PlaneFilm(const solver::FilmGrid& grid);

    // One entry a film point: 1 where it moves, 0 where it is held.
    void setFree(const std::vector<float>& free);

    // The triangles that cross the contact line from now on, sorted by cell; their floating parts
    // have the gradient that they have now.
    void setCrossing(std::vector<Crossing> triangles, const PlaneVector& displacement);
    // The same triangles as the contact line goes on.
    void moveCrossing(std::vector<Crossing> triangles);

    // The gradient of the energy at `displacement` (from rest, mm), kept as the point at which
    // hessian() is taken. Returns the root of the sum of squares of the forces on
    // horizontal edges, the measure
    // against which a residual counts as small; triangles without a free corner do not count.
    double gradient(const PlaneVector& displacement, PlaneVector& result);

    // The Hessian, made positive semi-definite, times `direction`.
    void hessian(const PlaneVector& direction, PlaneVector& result) const;

    // The triangles, with a corner that moves, that are stretched to more than `limit` times their
    // length or area before the dip (FilmTriangle.h).
    std::vector<numerics::TriangleCorners> tornTriangles(const PlaneVector& displacement,
                                                         float limit) const;

    // Ends a step: lets the stretch of all triangles decay by `keep`, rest shapes creeping to
    // current ones (PlaneStress.h), and makes the floating part of a crossing triangle stand for
    // all of it.
    void relax(const PlaneVector& displacement, double keep);
    // The inverse rest shape of a triangle times `change`.
    void reshape(std::size_t cell, bool second, const numerics::Matrix2<float>& change);

    int columns() const { return columns_; }
    int rows() const { return rows_; }

private:
    // Four numbers a triangle, one array each; of lower and upper triangles apart.
    struct TriangleArrays {
        std::vector<float> a, b, c, d;
    };
    struct States {
        std::vector<float> cosine, sine, turn;
    };

    void relaxAll(const PlaneVector& displacement, float keep);
    // Begin and end in crossing_ of the triangles in a row of cells.
    std::pair<std::size_t, std::size_t> crossingInRow(int row) const;
    numerics::Matrix2<float> inverseShape(std::size_t cell, bool second) const;
    void setInverseShape(std::size_t cell, bool second, const numerics::Matrix2<float>& shape);
    bool mayTear(int row, const PlaneVector& displacement, float limit) const;
    void findTorn(int row, const PlaneVector& displacement, float limit,
                  std::vector<numerics::TriangleCorners>& torn) const;
    numerics::EdgePair<float> unfoldedEdges(const Crossing& triangle,
                                            const PlaneVector& displacement) const;
    numerics::Matrix2<float> wholeGradient(const Crossing& triangle,
                                           const PlaneVector& displacement) const;

    int columns_, rows_;
    float inverseX_, inverseZ_, area_;
    std::vector<std::uint8_t> crept_; // a row of cells each: 0 where all rest shapes are the same
    TriangleArrays inverseShape_[2];
    States state_[2];
    std::vector<float> moving_[2];   // first and second triangles: 1 where a corner is free
    std::vector<Crossing> crossing_; // sorted by cell
    std::vector<numerics::CrossingAnchor<float>> anchors_; // of crossing_
    std::vector<std::size_t> firstCrossing_;               // of each row of cells, and the end
};

} // namespace dipwright::cpu
