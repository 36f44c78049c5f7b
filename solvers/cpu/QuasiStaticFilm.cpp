#include "cpu/QuasiStaticFilm.h"

#include "cpu/FilmEquilibrium.h"
#include "pbd/QuasiStaticDip.h"
#include "pbd/SetupLimits.h"

#include <tbb/task_arena.h>

#include <optional>

namespace dipwright::cpu {

namespace {

class QuasiStaticFilm final : public solver::FilmSolver {
public:
    void begin(const solver::DipSetup& setup) override {
        pbd::requireValid(setup);
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
        pbd::readFilm(*dip_, points_, positions, states);
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
