// Stores the production films of a launch in the form that the GPU uses.
#pragma once

#include "common/HostDevice.h"
#include "production/formulas/Adhesion.h"
#include "production/formulas/FilmModel.h"
#include "production/formulas/GalerkinCycle.h"
#include "production/formulas/Tolerances.h"

#include <cuda_runtime_api.h>

#include <cstdint>

namespace dipwright::cuda {

// A rectangle of grid points: columns x0 … x1 − 1, rows z0 … z1 − 1.
struct PlaneRange {
    int x0 = 0, x1 = 0, z0 = 0, z1 = 0;

    constexpr int width() const { return x1 - x0; }
    constexpr int height() const { return z1 - z0; }
    constexpr int count() const { return (x1 - x0) * (z1 - z0); }
};

// A division of a grid into across × down tiles. A thread block works on one tile at a time.
struct PlaneTiles {
    int across = 1, down = 1;

    constexpr int count() const { return across * down; }
};

// One grid of the multigrid cycle.
struct PlaneLevel {
    int columns = 0, rows = 0;
    std::uint32_t offset = 0; // index of its first point in the arrays over all levels
    PlaneTiles tiles;         // tiles of the coarser level
};

struct ProductionModel : numerics::FilmModel<float> {
    static constexpr int mostLevels = 12;

    PlaneTiles tiles; // tiles of the film's points
    int levelCount = 0;
    int wholeLevel = 0; // this level and all coarser ones fit into one block
    PlaneLevel levels[mostLevels];
    numerics::galerkin::ChebyshevStep smoothing[numerics::galerkin::smoothingDegree];
    numerics::galerkin::ChebyshevStep coarsest[numerics::galerkin::coarsestDegree];
};

struct ProductionDip {
    numerics::ContactBody<float> body;
    numerics::StepState<float>* state = nullptr; // the state between two launches

    // All arrays up to `marks` have one entry per film point.
    // Displacement from rest, mm: now, and one step ago.
    float2 *displacement = nullptr, *before = nullptr;
    float2 *start = nullptr, *best = nullptr, *forces = nullptr, *newtonStep = nullptr;
    // The basis vectors, which must be multiplied by their factors in the team's small problem.
    float2* basis[numerics::mostBasisVectors + 1] = {};
    // The basis vectors after smoothing.
    float2* smoothed[numerics::mostBasisVectors] = {};
    float3* attached = nullptr; // place of an adhered point, body coordinates
    float* free = nullptr;      // 1 if the equilibrium moves the point, else 0
    float* masked = nullptr;    // `free` at the last setFree()
    float* clearance = nullptr; // lower bound of the distance to contact, mm
    std::uint8_t* states = nullptr;
    unsigned* marks = nullptr; // solver::PointMark bits

    // These arrays have one entry per triangle, two triangles per cell.
    float4* inverseShape = nullptr;
    float4* stress = nullptr; // StressState
    std::uint8_t* crosses = nullptr;
    numerics::CrossingTriangle<float>* crossing = nullptr;
    numerics::CrossingAnchor<float>* anchors = nullptr;
    numerics::LaidCorners<float>* laid = nullptr;

    // These arrays hold all levels, one after the other.
    // per level: all points' blocks with the first neighbour, then with the second …
    float4* stencils = nullptr;
    float2 *right = nullptr, *result = nullptr, *solution = nullptr;
};

// All that a team needs to know of its film.
struct ProductionFilm {
    ProductionModel model;
    ProductionDip dip;
};

} // namespace dipwright::cuda
