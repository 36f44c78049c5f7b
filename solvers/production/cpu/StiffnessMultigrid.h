// The preconditioner of the film's equilibrium on the CPU: a multigrid V-cycle for the film's
// stiffness as it is now (GalerkinCycle.h).
#pragma once

#include "production/cpu/PlaneFilm.h"
#include "production/cpu/StencilKernels.h"
#include "production/formulas/GalerkinCycle.h"

#include <dipwright/FilmSolver.h>

#include <span>

namespace dipwright::cpu {

class StiffnessMultigrid {
public:
    explicit StiffnessMultigrid(const solver::FilmGrid& grid);

    // Takes the film's stiffness, and the drag of the water: so much a point, times the point's
    // entry in `area`. `free`: 1 where a point moves, 0 where it is held.
    void prepare(const PlaneFilm& film, const std::vector<float>& free,
                 const std::vector<float>& area, float drag);

    // result ≈ K⁻¹·right by one cycle; zero at held points.
    void apply(const PlaneVector& right, PlaneVector& result);

private:
    // One grid. A row of it, in all its arrays, is `pitch` numbers, the first of which stands
    // `margin` numbers from the row's begin; there are rows of zeros before the first row and after
    // the last.
    struct Level {
        int columns, rows;
        std::size_t pitch;
        std::vector<float> stencils, inverses; // stencilLines and inverseLines a row
        struct Vectors {
            std::vector<float> x, z;
        };
        Vectors right, now, next, direction;

        Level(int columns, int rows);
        std::size_t at(int row) const;
        Lines<float> stencil(int row);
        Lines<float> inverse(int row);
        RowOfVectors<float> row(Vectors& vectors, int row) const;
        RowOfVectors<const float> row(const Vectors& vectors, int row) const;
    };

    void assemble(const PlaneFilm& film, const std::vector<float>& free,
                  const std::vector<float>& area, float drag);
    static void coarsen(Level& fine, Level& coarse);
    static void invert(Level& level);
    static void smooth(Level& level, std::span<const numerics::galerkin::ChebyshevStep> steps,
                       bool fromZero);
    static void restrictResidual(Level& fine, Level& coarse);
    void addCorrection(const Level& coarse, Level& fine, bool isFinest) const;
    void cycle(std::size_t index);

    std::vector<Level> levels_;
    std::vector<float> free_; // of the finest grid, a number longer at the ends of each row
};

} // namespace dipwright::cpu
