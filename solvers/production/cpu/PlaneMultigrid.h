// A multigrid V-cycle for the flat film's linear elasticity, the preconditioner of the equilibrium.
//
// The operator is that of the undeformed isotropic film, averaged over both ways to cut a cell: one
// constant 9-point stencil on every level. Grids of any size are coarsened to half as many points
// (bilinear interpolation and its transpose); points that are held stay out on every level.
// Smoothing is by Chebyshev polynomials, so that the cycle is symmetric and positive definite, as
// conjugate gradients need, and the same for any number of threads.
#pragma once

#include "production/cpu/PlaneVector.h"
#include "production/formulas/MultigridCycle.h"

#include <dipwright/FilmSolver.h>

#include <cstdint>

namespace dipwright::cpu {

class PlaneMultigrid {
public:
    explicit PlaneMultigrid(const solver::FilmGrid& grid);

    // One entry a film point: 1 where it moves, 0 where it is held.
    void setFree(const std::vector<float>& free);

    // result ≈ K⁻¹·right by one V-cycle; zero at held points.
    void apply(const PlaneVector& right, PlaneVector& result);

private:
    struct Level {
        int columns = 0, rows = 0;
        numerics::multigrid::Stencil stencil;    // inside the film
        numerics::multigrid::CellStiffness cell; // for the border
        std::vector<float> free;
        PlaneVector diagonal; // 1 / diagonal, 0 where held
        PlaneVector right, result, residual, direction;
        numerics::multigrid::Interpolation toCoarseColumns, toCoarseRows;
    };

    static Level makeLevel(int columns, int rows, double width, double depth);
    static void holdCoarse(const Level& fine, Level& coarse);
    static void setDiagonal(Level& level);
    static void applyStiffness(const Level& level, const PlaneVector& v, PlaneVector& result);
    static void smooth(Level& level, int degree, bool fromZero);
    static void restrictResidual(const Level& fine, Level& coarse);
    static void addCorrection(const Level& coarse, Level& fine);
    void cycle(std::size_t index);

    std::vector<Level> levels_; // finest first
};

} // namespace dipwright::cpu
