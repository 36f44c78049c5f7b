// The film at the end of a dip, and what can be read off it.
#pragma once

#include <dipwright/FilmSolver.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace dipwright {

// Positions are in the body's pose frame (see dip/Pose.h), mm; arrays have one entry a film point,
// in the film's order.
struct DippedFilm {
    solver::FilmGrid grid;
    bool isotropic = true; // the lattice, which says which constraints there are
    std::vector<Eigen::Vector3f> positions;
    std::vector<solver::PointState> states;
    std::vector<std::uint8_t> marks; // solver::PointMark bits; empty: none
    // How many times as long as when the dip began film was, left to itself, when the point was
    // touched; means nothing of points that were not. Empty of film that does not grow.
    std::vector<float> grown;
    std::int64_t steps = 0;
    solver::EquilibriumAccount equilibrium;
    double wallSeconds = 0; // of the solver alone

    bool adhered(std::size_t point) const { return states[point] == solver::PointState::Adhered; }
};

using FilmTriangle = std::array<std::uint32_t, 3>; // point indices

// The flat film's resting place of a point: x to the right, y (the film's Z) down the sheet, mm,
// origin in the middle.
Eigen::Vector2f restPosition(const solver::FilmGrid& grid, std::size_t point);
// Two triangles a cell, cut as FilmSolver.h says; cell (i, j) owns triangles 2·(j·(columns−1)+i)
// and the next one. Wound counterclockwise seen from above (+Y).
std::vector<FilmTriangle> filmTriangles(const solver::FilmGrid& grid);
// Of a film triangle, flat, mm².
double restArea(const solver::FilmGrid& grid, std::size_t triangle);
// The longer side of the cell that a film triangle is in, and of the largest cell that a point
// belongs to, mm: what lengths near there are small or large against.
float cellOfTriangle(const solver::FilmGrid& grid, std::size_t triangle);
float cellOfPoint(const solver::FilmGrid& grid, std::size_t point);
// A place of the flat film in cells from its left and its upper edge, `share` of its width or depth
// from there: the column or row before it, and the share of the way to the next. Past the film its
// last cells go on.
double columnAt(const solver::FilmGrid& grid, double share);
double rowAt(const solver::FilmGrid& grid, double share);
// The number of distance constraints: columns·(rows−1) + rows·(columns−1), and two a cell more for
// an isotropic lattice (docs/film-model.md, "The paper's model").
std::size_t constraintCount(const solver::FilmGrid& grid, bool isotropic);

// Principal stretches of a film triangle from its deformation gradient (docs/film-model.md,
// "Measures").
struct PrincipalStretch {
    float larger = 1;                               // λ1
    float smaller = 1;                              // λ2
    float area() const { return larger * smaller; } // J
    // Film drawn out in one direction tears too, however much it shrinks across.
    bool isTorn(double limit) const { return std::max(larger, area()) > float(limit); }
};
// `places`: where the triangle's corners lie.
PrincipalStretch principalStretch(const solver::FilmGrid& grid, const FilmTriangle& triangle,
                                  const std::array<Eigen::Vector3f, 3>& places);
// Of each film triangle.
std::vector<PrincipalStretch> principalStretches(const DippedFilm& film);
// The smaller principal stretch of a film triangle against the film as it floated when the triangle
// was touched: below 1 it is compressed, which of film that grows is sooner than λ2.
float compression(const DippedFilm& film, const FilmTriangle& triangle,
                  const PrincipalStretch& stretch);
// Final over rest length of every horizontal and vertical constraint: first the
// rows·(columns−1) horizontal ones, then the columns·(rows−1) vertical ones.
std::vector<float> constraintStretches(const DippedFilm& film);
// The mean of the constraints that meet in a point.
std::vector<float> pointStretches(const DippedFilm& film);

struct Distribution {
    double minimum = 0, mean = 0, percentile95 = 0, maximum = 0;
};
Distribution distribution(std::vector<float> values); // all 0 for no values

} // namespace dipwright
