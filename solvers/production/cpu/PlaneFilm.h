// Computes the elastic energy of the film in the water plane: its gradient and its Hessian on the
// regular grid.
//
// Each triangle has one horizontal and one vertical grid edge. So forces act on edges, and a row of
// cells needs only a few simple loops. The diagonal of a cell only decides which edges its two
// triangles use (FilmSolver.h, FilmGrid).
#pragma once

#include "common/cpu/RowParallel.h"
#include "production/cpu/PlaneVector.h"
#include "production/cpu/RowKernels.h"
#include "production/formulas/CrossingTriangle.h"
#include "production/formulas/FilmModel.h"

#include <dipwright/FilmSolver.h>

#include <cstdint>
#include <functional>
#include <utility>

namespace dipwright::cpu {

class PlaneFilm {
public:
    using Crossing = numerics::CrossingTriangle<float>;

    // `model` must outlive the film.
    explicit PlaneFilm(const numerics::FilmModel<float>& model);

    // `free` has one entry per film point: 1 if the point moves, 0 if it is held.
    void setFree(const std::vector<float>& free);

    // Sets the triangles that cross the contact line, sorted by cell. If the triangles are the same
    // as before, their anchors are kept. Otherwise the caller must set the anchors.
    void setCrossing(std::vector<Crossing> triangles);

    // Computes the gradient at `displacement` (from rest, mm) and keeps the states for hessian().
    // Returns the root of the sum of the squared forces on horizontal edges; the residual is
    // relative to this number. Triangles without a free corner do not count. Calls finish(row) for
    // each row of points whose result is complete, in any order and on several threads; it may
    // change the row's result.
    using RowWork = std::function<void(int row)>;
    double gradient(const PlaneVector& displacement, PlaneVector& result, const RowWork& finish);

    // Multiplies the Hessian at the last gradient by `direction`. `finish` is as in gradient().
    void hessian(const PlaneVector& direction, numerics::Tangent tangent, PlaneVector& result,
                 const RowWork& finish) const;
    // Computes the projected stiffness of the first and second triangles in a row of cells. `first`
    // and `second` have the lines that stiffnessRow() describes.
    void stiffness(int row, const Lines<float>& first, const Lines<float>& second) const;

    // Triangles are numbered cell by cell, two per cell. Returns the inverse of the rest shape.
    numerics::Matrix2<float> shape(int triangle) const {
        return inverseShape(std::size_t(triangle / 2), triangle % 2 != 0);
    }
    void setShape(int triangle, const numerics::Matrix2<float>& shape) {
        setInverseShape(std::size_t(triangle / 2), triangle % 2 != 0, shape);
        crept_[std::size_t(triangle / 2 / (columns_ - 1))] = 1;
    }
    numerics::EdgePair<float> edges(int triangle, const PlaneVector& displacement) const;
    bool moves(int triangle) const { // whether a corner is free
        return moving_[triangle % 2][std::size_t(triangle / 2)] > 0;
    }

    // See numerics::FilmBackend.
    template <typename Work>
    void forCrossing(const Work& work);
    // Calls work(column, row) for the cell of each crossing triangle.
    template <typename Work>
    void forCrossingCells(const Work& work) const {
        for (const Crossing& triangle : crossing_) {
            const std::size_t cells = std::size_t(columns_ - 1);
            work(triangle.cell % cells, triangle.cell / cells);
        }
    }
    template <typename OnLine, typename Floating>
    void forTriangles(const OnLine& onLine, const Floating& floating);
    // Relaxes the triangles that do not cross the contact line; see relaxedInverseShape().
    void relaxFloating(const PlaneVector& displacement, float keep);
    template <typename OnLine, typename Floating>
    void forStretched(const PlaneVector& displacement, float limit, const OnLine& onLine,
                      const Floating& floating);

    int columns() const { return columns_; }
    int rows() const { return rows_; }

private:
    // Four numbers per triangle, each in a separate array. The first and the second triangles of
    // the cells are stored separately.
    struct TriangleArrays {
        AlignedVector<float> a, b, c, d;
    };
    struct States {
        AlignedVector<float> cosine, sine, turn, resists;
    };

    template <typename Floating>
    void forFloating(int row, const Floating& floating) const;
    RowOfSizes sizesOf(int row) const; // sizes of the cells in the row
    RowOfShapes shapesOf(int row) const;
    float areaOf(const Crossing& triangle) const;
    RowOfStates<const float*> statesOf(int row) const;
    numerics::StressState<float> stateOf(const Crossing& triangle) const;
    // Returns the range of crossing_ that holds the triangles of a row of cells: begin and end.
    std::pair<std::size_t, std::size_t> crossingInRow(int row) const;
    numerics::Matrix2<float> inverseShape(std::size_t cell, bool second) const;
    void setInverseShape(std::size_t cell, bool second, const numerics::Matrix2<float>& shape);
    bool mayBeTornOrFolded(int row, const PlaneVector& displacement, float limit) const;
    static int numberOf(const Crossing& triangle) {
        return 2 * int(triangle.cell) + triangle.second;
    }
    numerics::Matrix2<float> wholeGradient(const Crossing& triangle,
                                           const PlaneVector& displacement) const;

    int columns_, rows_;
    const numerics::FilmModel<float>& model_;
    std::vector<float> inversesX_, inversesZ_; // inverse lengths of the undeformed edges
    // Per row of cells; 0: all rest shapes in the row are undeformed.
    std::vector<std::uint8_t> crept_;
    TriangleArrays inverseShape_[2];
    States state_[2];
    std::vector<float> moving_[2];   // first and second triangles: 1 if a corner is free
    std::vector<Crossing> crossing_; // sorted by cell
    std::vector<numerics::CrossingAnchor<float>> anchors_; // one per entry of crossing_
    // Per row of cells, plus the end: index into crossing_.
    std::vector<std::size_t> firstCrossing_;
};

template <typename Work>
void PlaneFilm::forCrossing(const Work& work) {
    for (std::size_t k = 0; k < crossing_.size(); ++k) {
        work(numberOf(crossing_[k]), crossing_[k], anchors_[k]);
    }
}

// Visits the triangles of a row of cells that do not cross the contact line.
template <typename Floating>
void PlaneFilm::forFloating(int row, const Floating& floating) const {
    auto [next, last] = crossingInRow(row);
    const int triangles = 2 * (columns_ - 1);
    for (int triangle = row * triangles; triangle < (row + 1) * triangles; ++triangle) {
        if (next < last && numberOf(crossing_[next]) == triangle) {
            ++next;
        } else {
            floating(triangle);
        }
    }
}

template <typename OnLine, typename Floating>
void PlaneFilm::forTriangles(const OnLine& onLine, const Floating& floating) {
    forCrossing(onLine);
    forRows(rows_ - 1, columns_, [&](int row) { forFloating(row, floating); });
}

template <typename OnLine, typename Floating>
void PlaneFilm::forStretched(const PlaneVector& displacement, float limit, const OnLine& onLine,
                             const Floating& floating) {
    forCrossing(onLine);
    std::vector<std::uint8_t> mayBe(static_cast<std::size_t>(rows_ - 1));
    forRows(rows_ - 1, columns_, [&](int row) {
        mayBe[std::size_t(row)] = mayBeTornOrFolded(row, displacement, limit);
    });
    for (int row = 0; row + 1 < rows_; ++row) {
        if (mayBe[std::size_t(row)] != 0) {
            forFloating(row, floating);
        }
    }
}

} // namespace dipwright::cpu
