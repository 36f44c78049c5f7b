// Holds the film's constants that a step of the production film needs, and the state of its dip.
#pragma once

#include "common/Vector3.h"
#include "production/formulas/GridTriangle.h"

#include <dipwright/FilmSolver.h>

#include <algorithm>
#include <vector>

namespace dipwright::numerics {

// Two numbers of a film point, along X and Z in the water plane.
template <typename Real>
struct Vector2 {
    Real x{}, z{};
};

// A film's lines along one axis: columns along X or rows along Z. `places` are the rest positions
// in mm, and `edges` the lengths from each line to the next, as the forces use them. `spans` are
// the film lengths per line, relative to the finest cell. The film owns the arrays, on its device.
template <typename Real>
struct FilmLines {
    const double* places = nullptr;
    const Real* edges = nullptr;
    const Real* spans = nullptr;
};

// The arrays that FilmLines points to.
template <typename Real>
struct FilmLineValues {
    std::vector<double> places;
    std::vector<Real> edges, spans;

    FilmLines<Real> lines() const { return {places.data(), edges.data(), spans.data()}; }
};

// Returns the arrays for `count` lines. rest(line) and spacing(line) are functions such as restX()
// and spacingX() of solver::FilmGrid.
template <typename Real, typename Rest, typename Spacing>
FilmLineValues<Real> filmLineValues(int count, double leastSpacing, const Rest& rest,
                                    const Spacing& spacing) {
    FilmLineValues<Real> values;
    for (int line = 0; line < count; ++line) {
        const double before = spacing(std::max(line - 1, 0));
        const double after = spacing(std::min(line, count - 2));
        values.places.push_back(rest(line));
        values.spans.push_back(Real((before + after) / 2 / leastSpacing));
        if (line + 1 < count) {
            values.edges.push_back(1 / Real(1 / spacing(line)));
        }
    }
    return values;
}
template <typename Real>
FilmLineValues<Real> columnsOf(const solver::FilmGrid& film) {
    return filmLineValues<Real>(
        film.columns, film.leastSpacingX(), [&](int line) { return film.restX(line); },
        [&](int line) { return film.spacingX(line); });
}
template <typename Real>
FilmLineValues<Real> rowsOf(const solver::FilmGrid& film) {
    return filmLineValues<Real>(
        film.rows, film.leastSpacingZ(), [&](int line) { return film.restZ(line); },
        [&](int line) { return film.spacingZ(line); });
}

// The point about which untouched film grows along one axis, mm. It is the film's middle if neither
// side is held, or the held side if one is. If both sides are held, there is no free growth.
struct GrowthOrigin {
    double place = 0;
    bool growsFreely = true;
};

// Returns the growth origin of a film with this length, given which of its two sides are held.
inline GrowthOrigin growthOrigin(double length, bool isFirstHeld, bool isLastHeld) {
    return {isFirstHeld ? -length / 2 : isLastHeld ? length / 2 : 0, !(isFirstHeld && isLastHeld)};
}

// The constants of all steps of a dip.
template <typename Real>
struct FilmModel {
    int columns = 0, rows = 0;
    double spacingX = 0, spacingZ = 0; // mm, size of the finest cells
    Real cell{};                       // mm, the smaller of the two spacings
    double longestEdge = 0;            // mm, longest edge of all cells
    FilmLines<Real> alongX, alongZ;
    double contactTravel = 0, residual = 0, tearStretch = 0,
           relaxationTime = 0; // see solver::Settings
    double growthRate = 0, growthLimit = 0;
    GrowthOrigin alongXFrom, alongZFrom;
    Real gatheredResistance{}; // see gatheredResistance() in PlaneStress.h
};

template <typename Real>
FilmModel<Real> filmModel(const solver::DipSetup& setup, const FilmLines<Real>& alongX,
                          const FilmLines<Real>& alongZ) {
    const solver::FilmGrid& film = setup.film;
    FilmModel<Real> model;
    model.columns = film.columns;
    model.rows = film.rows;
    model.spacingX = film.leastSpacingX();
    model.spacingZ = film.leastSpacingZ();
    model.cell = Real(film.leastSpacing());
    for (int column = 0; column + 1 < film.columns; ++column) {
        model.longestEdge = std::max(model.longestEdge, film.spacingX(column));
    }
    for (int row = 0; row + 1 < film.rows; ++row) {
        model.longestEdge = std::max(model.longestEdge, film.spacingZ(row));
    }
    model.alongX = alongX;
    model.alongZ = alongZ;
    model.contactTravel = setup.settings.contactTravel;
    model.residual = setup.settings.residual;
    model.tearStretch = setup.settings.tearStretch;
    model.relaxationTime = setup.settings.relaxationTime;
    model.growthRate = setup.settings.growthRate;
    model.growthLimit = setup.settings.growthLimit;
    // A side counts as held if its middle is held.
    const auto isHeld = [&](int column, int row) {
        return !setup.pinned.empty() &&
               setup.pinned[std::size_t(row) * std::size_t(film.columns) + std::size_t(column)] !=
                   0;
    };
    model.alongXFrom =
        growthOrigin(film.width, isHeld(0, film.rows / 2), isHeld(film.columns - 1, film.rows / 2));
    model.alongZFrom = growthOrigin(film.depth, isHeld(film.columns / 2, 0),
                                    isHeld(film.columns / 2, film.rows - 1));
    model.gatheredResistance = Real(gatheredResistance(setup.settings.gatheringStretch));
    return model;
}

template <typename Real>
DIPWRIGHT_HOST_DEVICE inline int pointCount(const FilmModel<Real>& model) {
    return model.columns * model.rows;
}
// Returns the number of triangles: two per cell, numbered cell by cell.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline int triangleCount(const FilmModel<Real>& model) {
    return 2 * (model.columns - 1) * (model.rows - 1);
}

// The edges (mm) and the area (mm²) of an undeformed triangle in one column and row of cells.
template <typename Real>
struct TriangleSize {
    Real x{}, z{};
    DIPWRIGHT_HOST_DEVICE Real area() const { return x * z / Real(2); }
};
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline TriangleSize<Real> triangleSize(const FilmModel<Real>& model,
                                                             int column, int row) {
    return {model.alongX.edges[column], model.alongZ.edges[row]};
}
// Does the same by the triangle's number: two triangles per cell, cell by cell.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline TriangleSize<Real> triangleSize(const FilmModel<Real>& model,
                                                             int triangle) {
    const int cell = triangle / 2, row = cell / (model.columns - 1);
    return triangleSize(model, cell - row * (model.columns - 1), row);
}

// Returns the film area per point, relative to the finest cell.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Real pointArea(const FilmModel<Real>& model, int column, int row) {
    return model.alongX.spans[column] * model.alongZ.spans[row];
}

template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Real pointArea(const FilmModel<Real>& model, int point) {
    const int row = point / model.columns;
    return pointArea(model, point - row * model.columns, row);
}

// Returns the world position of a floating point.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Vector3<Real>
planePosition(const FilmModel<Real>& model, std::uint32_t point, Vector2<Real> displacement) {
    const std::uint32_t row = point / std::uint32_t(model.columns);
    const std::uint32_t column = point - row * std::uint32_t(model.columns);
    return {Real(model.alongX.places[column]) + displacement.x, Real(0),
            Real(model.alongZ.places[row]) + displacement.z};
}

// The state of a dip between two steps.
template <typename Real>
struct StepState {
    // Descent of the body, mm: in total, and in the last step.
    double descent = 0, increment = 0;
    Real steepness{1}; // smallest steepness of the contact line
    int steps = 0;
    bool anyAdhered = false;
    bool driven = false; // the contact line still moves the film
    double grown = 1;    // rest length of floating film, relative to its length at the start
    solver::EquilibriumAccount equilibrium;
};

} // namespace dipwright::numerics
