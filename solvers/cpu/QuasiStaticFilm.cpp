#include "cpu/QuasiStaticFilm.h"

#include "cpu/FilmEquilibrium.h"
#include "pbd/QuasiStaticDip.h"

#include <tbb/task_arena.h>

#include <optional>

namespace dipwright::cpu {

namespace {

class QuasiStaticFilm final : public solver::FilmSolver {
public:
    void begin(const solver::DipSetup& setup) override {
        dip_.reset();
        arena_.emplace(setup.settings.threads > 0 ? setup.settings.threads
                                                  : int(tbb::task_arena::automatic));
        points_ = setup.film.pointCount();
        dip_.emplace(setup);
    }

    solver::Progress advance(int maximumSteps) override {
        return arena_->execute([&] { return dip_->advance(maximumSteps); });
    }

    void read(std::span<float> positions, std::span<solver::PointState> states) const override {
        for (std::size_t point = 0; point < points_; ++point) {
            const pbd::Vector3<float> p = dip_->position(point);
            positions[3 * point] = p.x;
            positions[3 * point + 1] = p.y;
            positions[3 * point + 2] = p.z;
        }
        for (std::size_t point = 0; point < states.size(); ++point) {
            states[point] = dip_->state(point);
        }
    }

private:
    std::optional<tbb::task_arena> arena_;
    std::optional<pbd::QuasiStaticDip<FilmEquilibrium>> dip_;
    std::size_t points_ = 0;
};

} // namespace

std::unique_ptr<solver::FilmSolver> makeQuasiStaticFilm() {
    return std::make_unique<QuasiStaticFilm>();
}

} // namespace dipwright::cpu
