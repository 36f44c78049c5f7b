// The preconditioner for the film's equilibrium on the CPU: a multigrid V-cycle for the current
// stiffness of the film (GalerkinCycle.h).
#pragma once

#include "common/cpu/AlignedVector.h"
#include "production/cpu/PlaneFilm.h"
#include "production/cpu/StencilKernels.h"
#include "production/formulas/GalerkinCycle.h"

#include <dipwright/FilmSolver.h>

namespace dipwright::cpu {

class StiffnessMultigrid {
public:
    explicit StiffnessMultigrid(const solver::FilmGrid& grid);

    // Uses the film's current stiffness from now on. The drag of a point is `drag` times its entry
    // in `area`. `free` is 1 if a point moves, 0 if it is held.
    void prepare(const PlaneFilm& film, const std::vector<float>& free,
                 const std::vector<float>& area, float drag);

    // Computes result ≈ K⁻¹·(factor·right) with one cycle; zero at held points.
    void apply(const PlaneVector& right, float factor, PlaneVector& result);

private:
    // One grid. In all its arrays, a row has `pitch` numbers, and its first point is `margin`
    // numbers after the start of the row. Rows of zeros precede the first row and follow the last.
    struct Level {
        int columns, rows;
        std::size_t pitch;
        AlignedVector<float> stencils, inverses; // stencilLines and inverseLines lines per row
        std::vector<StencilKind> kinds;          // StencilRow::kinds of all rows, or empty
        struct Vectors {
            AlignedVector<float> x, z;
        };
        Vectors right, now, next, direction;

        Level(int columns, int rows);
        std::size_t at(int row) const;
        Lines<float> stencil(int row);
        // Whether smoothing reads all of a row's lines, not only those from middleLine on.
        bool readsAll(int row);
        // A row's stencils, with what is known about them.
        StencilRow stencilRow(int row);
        Lines<float> inverse(int row);
        RowOfVectors<float> row(Vectors& vectors, int row) const;
        RowOfVectors<const float> row(const Vectors& vectors, int row) const;
    };

    struct Restriction {
        const Level* fine;
        Level* coarse;
        void operator()(int row) const;
    };

    // Computes the stencils of the finest and of the next coarser grid.
    void assemble(const PlaneFilm& film, const std::vector<float>& area, float drag);
    // Sets free_, and finds the kinds of the finest grid's stencils. Triangles on the contact line
    // make them unsymmetric.
    void findKinds(const PlaneFilm& film, const std::vector<float>& free);
    // `stencil(row)` returns the lines of a fine row. `scratch` has stencilLines lines of the fine
    // grid's pitch.
    template <typename StencilOf>
    static void coarsenRow(Level& fine, const StencilOf& stencil, Level& coarse, int row,
                           AlignedVector<float>& scratch);
    static auto allLines(Level& level) {
        return [&level](int row) -> StencilLines<float> {
            return {level.stencil(row), level.stencil(row)};
        };
    }
    static void coarsen(Level& fine, Level& coarse);
    static void invert(Level& level, int row);
    static void smoothRowOf(Level& level, int row, const numerics::galerkin::ChebyshevStep& step,
                            const Level::Vectors* now, Level::Vectors& result);
    static void solveCoarsest(Level& level);
    template <typename Take>
    static void smoothFromZero(Level& level, const Take& take);
    void addCorrection(const Level& coarse, Level& fine, bool isFinest, int row) const;
    // Calls take(row) before it uses the right side of a row, and give(row) when the row's result
    // is in `now`.
    template <typename Take, typename Give>
    void cycle(std::size_t index, const Take& take, const Give& give);

    std::vector<Level> levels_;
    std::vector<float> free_; // finest grid, with one extra number at both ends of each row
};

} // namespace dipwright::cpu
