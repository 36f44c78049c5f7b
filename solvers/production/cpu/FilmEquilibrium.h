// The film in the water plane at rest under its forces: Newton's method, each step by conjugate
// gradients with a multigrid cycle as preconditioner, warm-started by the caller.
#pragma once

#include "production/cpu/PlaneFilm.h"
#include "production/cpu/PlaneMultigrid.h"
#include "production/formulas/WaterDrag.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace dipwright::cpu {

class FilmEquilibrium {
public:
    using Vector = PlaneVector;

    explicit FilmEquilibrium(const solver::FilmGrid& grid);

    // One entry a film point: 1 where it moves, 0 where it is held.
    void setFree(const std::vector<float>& free);

    // The triangles that cross the contact line (PlaneFilm::setCrossing, moveCrossing).
    void setCrossing(std::vector<PlaneFilm::Crossing> triangles, const PlaneVector& displacement) {
        film_.setCrossing(std::move(triangles), displacement);
    }
    void moveCrossing(std::vector<PlaneFilm::Crossing> triangles) {
        film_.moveCrossing(std::move(triangles));
    }

    std::vector<numerics::TriangleCorners> tornTriangles(const PlaneVector& displacement,
                                                         double limit) const {
        return film_.tornTriangles(displacement, float(limit));
    }

    using Drag = numerics::Drag<PlaneVector>;

    // Moves the free points of `displacement` until the forces left on them are `residual` times
    // the elastic forces in the film (both as root of the sum of squares). Returns the ratio
    // reached.
    double solve(PlaneVector& displacement, const Drag& drag, double residual);

    void reshape(std::size_t cell, bool second, const numerics::Matrix2<float>& change) {
        film_.reshape(cell, second, change);
    }
    void relax(const PlaneVector& displacement, double keep) { film_.relax(displacement, keep); }

    template <typename Piece>
    static void forEach(std::size_t count, const Piece& work) {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, trianglesAtOnce),
                          [&](const tbb::blocked_range<std::size_t>& range) {
                              for (std::size_t i = range.begin(); i != range.end(); ++i) {
                                  work(i);
                              }
                          });
    }

    struct Work {
        std::int64_t newtonSteps = 0, conjugateSteps = 0;
    };
    const Work& work() const { return work_; }

private:
    static constexpr std::size_t trianglesAtOnce = 32;

    double force(const PlaneVector& displacement, const Drag& drag, double& elastic);
    void conjugateGradients(const Drag& drag, double tolerance);
    double advance(PlaneVector& displacement, const Drag& drag, double before, double& elastic);
    double dot(const PlaneVector& a, const PlaneVector& b) const;
    void maskHeld(PlaneVector& v) const;

    PlaneFilm film_;
    PlaneMultigrid multigrid_;
    std::vector<float> free_;
    PlaneVector gradient_, step_, residual_, preconditioned_, direction_, product_, start_, best_;
    double longestStep_; // mm that a point moves at most in one Newton step
    Work work_;
};

} // namespace dipwright::cpu
