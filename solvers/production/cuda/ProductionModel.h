// What the production films of a batch have in common, and what one dip has for itself, as the GPU
// sees them.
#pragma once

#include "common/HostDevice.h"
#include "production/formulas/Adhesion.h"
#include "production/formulas/FilmModel.h"
#include "production/formulas/MultigridCycle.h"

#include <cuda_runtime_api.h>

#include <cmath>
#include <cstdint>

namespace dipwright::cuda {

struct TeamMemory;

// A rectangle of grid points: columns x0 … x1 − 1, rows z0 … z1 − 1.
struct PlaneRange {
    int x0 = 0, x1 = 0, z0 = 0, z1 = 0;

    constexpr int width() const { return x1 - x0; }
    constexpr int height() const { return z1 - z0; }
    constexpr int count() const { return (x1 - x0) * (z1 - z0); }
};

// A cut of a grid into across × down tiles, one for each block of threads at a time.
struct PlaneTiles {
    int across = 1, down = 1;

    constexpr int count() const { return across * down; }
};

// How the points of a level lie between those of the next coarser one (MultigridCycle.h,
// interpolation), along one axis; where there is none, `coarse` is 0.
struct PlaneAxis {
    int fine = 0, coarse = 0;         // points
    float perFine = 0, perCoarse = 0; // 1 / (fine − 1), 1 / (coarse − 1)

    // The coarse point at or before a fine one that is not the last.
    DIPWRIGHT_HOST_DEVICE int below(int i) const {
        const int found = int((float(i * (coarse - 1)) + 0.5f) * perFine);
        return found < coarse - 2 ? found : coarse - 2;
    }
    // The share of a coarse point in a fine one; 0 or less where it has none.
    DIPWRIGHT_HOST_DEVICE float weight(int i, int c) const {
        return 1 - fabsf(float(i * (coarse - 1) - c * (fine - 1))) * perFine;
    }
    // The first fine point after coarse point c, or at or after it; c from −1 to `coarse`.
    DIPWRIGHT_HOST_DEVICE int firstAfter(int c) const {
        return c < 0 ? 0 : int((float(c * (fine - 1)) + 0.5f) * perCoarse) + 1;
    }
    DIPWRIGHT_HOST_DEVICE int firstFrom(int c) const {
        if (c == 0 || c == coarse) {
            return c == 0 ? 0 : fine;
        }
        return int((float(c * (fine - 1)) - 0.5f) * perCoarse) + 1;
    }
};

// One grid of the multigrid cycle.
struct PlaneLevel {
    int columns = 0, rows = 0;
    std::uint32_t offset = 0; // of its points in the arrays over all levels
    numerics::multigrid::Stencil stencil;
    PlaneAxis alongX, alongZ;
    PlaneTiles tiles; // of the coarser level
};

struct ProductionModel : numerics::FilmModel<float> {
    static constexpr int mostLevels = 12;

    PlaneTiles tiles; // of the film's points
    int levelCount = 0;
    int wholeLevel = 0; // this level and those after it fit into one block
    PlaneLevel levels[mostLevels];
    numerics::multigrid::ChebyshevStep smoothing[numerics::multigrid::smoothingDegree];
    numerics::multigrid::ChebyshevStep coarsest[numerics::multigrid::coarsestDegree];
};

struct ProductionDip {
    numerics::ContactBody<float> body;
    numerics::StepState<float>* state = nullptr; // between two launches
    TeamMemory* team = nullptr;

    // One entry a film point.
    float2 *displacement = nullptr, *before = nullptr; // mm from rest, now and a step ago
    float2 *start = nullptr, *best = nullptr, *newtonStep = nullptr, *product = nullptr;
    float2* direction[2] = {};
    float3* attached = nullptr; // where an adhered point sits, body coordinates
    float* free = nullptr;      // 1: the equilibrium moves it
    float* clearance = nullptr; // mm, at least so far from contact
    std::uint8_t* states = nullptr;

    // One entry a triangle, two a cell.
    float4* inverseShape = nullptr;
    float4* stress = nullptr; // StressState, and 1 where the triangle crosses the contact line
    std::uint8_t* crosses = nullptr;
    numerics::CrossingTriangle<float>* crossing = nullptr;
    numerics::CrossingAnchor<float>* anchors = nullptr;
    numerics::LaidCorners<float>* laid = nullptr;

    // Over all levels. `right` of the finest level is what is left of the forces.
    float2 *right = nullptr, *result = nullptr, *smoothed = nullptr;
    float* levelFree = nullptr;
};

} // namespace dipwright::cuda
