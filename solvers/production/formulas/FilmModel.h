// What a step of the production film's dip knows of its film, and where it stands.
#pragma once

#include "common/Vector3.h"
#include "production/formulas/GridTriangle.h"

#include <dipwright/FilmSolver.h>

#include <algorithm>

namespace dipwright::numerics {

// Two numbers of a film point, in the water plane.
template <typename Real>
struct Vector2 {
    Real x{}, z{};
};

// What all steps of a dip have in common.
template <typename Real>
struct FilmModel {
    int columns = 0, rows = 0;
    double width = 0, depth = 0, spacingX = 0, spacingZ = 0; // mm
    Real cell{};                                             // mm, the smaller spacing
    Real edgeX{}, edgeZ{}, area{};                           // of an undeformed triangle, mm, mm²
    double contactTravel = 0, residual = 0, tearStretch = 0, relaxationTime = 0; // as in Settings
};

template <typename Real>
FilmModel<Real> filmModel(const solver::DipSetup& setup) {
    const solver::FilmGrid& film = setup.film;
    FilmModel<Real> model;
    model.columns = film.columns;
    model.rows = film.rows;
    model.width = film.width;
    model.depth = film.depth;
    model.spacingX = film.spacingX(0);
    model.spacingZ = film.spacingZ(0);
    model.cell = Real(std::min(film.spacingX(0), film.spacingZ(0)));
    model.edgeX = 1 / Real(1 / film.spacingX(0));
    model.edgeZ = 1 / Real(1 / film.spacingZ(0));
    model.area = Real(film.spacingX(0) * film.spacingZ(0) / 2);
    model.contactTravel = setup.settings.contactTravel;
    model.residual = setup.settings.residual;
    model.tearStretch = setup.settings.tearStretch;
    model.relaxationTime = setup.settings.relaxationTime;
    return model;
}

template <typename Real>
DIPWRIGHT_HOST_DEVICE inline int pointCount(const FilmModel<Real>& model) {
    return model.columns * model.rows;
}
// Two triangles a cell, cell after cell.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline int triangleCount(const FilmModel<Real>& model) {
    return 2 * (model.columns - 1) * (model.rows - 1);
}

// World place of a floating point.
template <typename Real>
DIPWRIGHT_HOST_DEVICE inline Vector3<Real>
planePosition(const FilmModel<Real>& model, std::uint32_t point, Vector2<Real> displacement) {
    const std::uint32_t row = point / std::uint32_t(model.columns);
    const std::uint32_t column = point - row * std::uint32_t(model.columns);
    return {Real(-model.width / 2 + double(column) * model.spacingX) + displacement.x, Real(0),
            Real(-model.depth / 2 + double(row) * model.spacingZ) + displacement.z};
}

// Where a dip stands between two steps.
template <typename Real>
struct StepState {
    double descent = 0, increment = 0; // mm: of the body, and in the last step
    Real steepness{1};                 // the least of all places on the contact line
    int steps = 0;
    bool anyAdhered = false;
    bool driven = false; // the contact line still pulls at the film
    solver::EquilibriumAccount equilibrium;
};

} // namespace dipwright::numerics
