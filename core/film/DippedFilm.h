// The film at the end of a dip, and measures of it.
#pragma once

#include <dipwright/FilmSolver.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace dipwright {

// Positions are in the body's pose frame (see dip/Pose.h), in mm. Arrays have one entry for each
// film point, in the film's order.
struct DippedFilm {
    solver::FilmGrid grid;
    bool isotropic = true; // whether the lattice is isotropic, which determines the constraints
    std::vector<Eigen::Vector3f> positions;
    std::vector<solver::PointState> states;
    std::vector<std::uint8_t> marks; // solver::PointMark bits; empty: none
    // How much freely floating film had grown when the body touched the point: its length divided
    // by its length at the start of the dip. Meaningless for points that were not touched. Empty if
    // the film does not grow.
    std::vector<float> grown;
    std::int64_t steps = 0;
    solver::EquilibriumAccount equilibrium;
    double wallSeconds = 0; // spent by the solver alone

    bool adhered(std::size_t point) const { return states[point] == solver::PointState::Adhered; }
    bool adheresAnywhere() const;
};

using FilmTriangle = std::array<std::uint32_t, 3>; // point indices

// Returns the rest position of a point in the flat film: x to the right, y (the film's Z) down the
// sheet, in mm from the film's centre.
Eigen::Vector2f restPosition(const solver::FilmGrid& grid, std::size_t point);
// Returns the two triangles of each cell, cut as FilmSolver.h says. Cell (i, j) owns triangles
// 2·(j·(columns−1)+i) and the next one. They run counterclockwise seen from above (+Y).
std::vector<FilmTriangle> filmTriangles(const solver::FilmGrid& grid);
// Returns the area of a film triangle in the flat film, mm².
double restArea(const solver::FilmGrid& grid, std::size_t triangle);
// Returns the longer side of the cell that contains a triangle, mm. Use it as the length scale
// there.
float cellOfTriangle(const solver::FilmGrid& grid, std::size_t triangle);
// Returns the longer side of the largest cell at a point, mm.
float cellOfPoint(const solver::FilmGrid& grid, std::size_t point);
// Returns the column at a place on the flat film, as a real number. `share` is the place's distance
// from the left edge as a share of the film's width. The integer part of the result is the column
// to the left of the place. The fraction is the share of the way to the next column. Outside the
// film, the outermost cells are continued.
double columnAt(const solver::FilmGrid& grid, double share);
// Returns the row in the same way. `share` is the distance from the upper edge as a share of the
// film's depth.
double rowAt(const solver::FilmGrid& grid, double share);
// Returns the index in filmTriangles() of the triangle that contains a place, given as columnAt()
// and rowAt().
std::size_t triangleAt(const solver::FilmGrid& grid, double column, double row);
// Returns the number of distance constraints: columns·(rows−1) + rows·(columns−1), plus two for
// each cell of an isotropic lattice (docs/film-model.md, "The paper's model").
std::size_t constraintCount(const solver::FilmGrid& grid, bool isotropic);

// Principal stretches of a film triangle from its deformation gradient (docs/film-model.md,
// "Measures").
struct PrincipalStretch {
    float larger = 1;                               // λ1
    float smaller = 1;                              // λ2
    float area() const { return larger * smaller; } // J
    // Film tears if one direction is stretched too far, even if the film shrinks across that
    // direction.
    bool isTorn(double limit) const { return std::max(larger, area()) > float(limit); }
};
// `places` are the positions of the triangle's corners.
PrincipalStretch principalStretch(const solver::FilmGrid& grid, const FilmTriangle& triangle,
                                  const std::array<Eigen::Vector3f, 3>& places);
// Returns one entry for each film triangle.
std::vector<PrincipalStretch> principalStretches(const DippedFilm& film);
// Returns the smaller principal stretch of a film triangle. It is relative to the floating film at
// the time when the body touched the triangle. Below 1 the film is compressed. If the film grows,
// the result is smaller than λ2.
float compression(const DippedFilm& film, const FilmTriangle& triangle,
                  const PrincipalStretch& stretch);
// Returns the final length divided by the rest length of each horizontal and vertical constraint:
// first the rows·(columns−1) horizontal ones, then the columns·(rows−1) vertical ones.
std::vector<float> constraintStretches(const DippedFilm& film);
// Returns for each point the mean stretch of the constraints that meet there.
std::vector<float> pointStretches(const DippedFilm& film);

struct Distribution {
    double minimum = 0, mean = 0, percentile95 = 0, maximum = 0;
};
Distribution distribution(std::vector<float> values); // all 0 for no values

} // namespace dipwright
