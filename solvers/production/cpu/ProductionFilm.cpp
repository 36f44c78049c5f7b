#include "production/cpu/ProductionFilm.h"

#include "common/SetupLimits.h"
#include "production/cpu/FilmEquilibrium.h"
#include "production/formulas/FilmStep.h"

#include <tbb/task_arena.h>

#include <optional>

namespace dipwright::cpu {

namespace {

class ProductionFilm final : public solver::FilmSolver {
public:
    void begin(const solver::DipSetup& setup) override {
        numerics::requireValid(setup);
        dip_.reset();
        arena_.emplace(setup.settings.threads > 0 ? setup.settings.threads
                                                  : int(tbb::task_arena::automatic));
        points_ = setup.film.pointCount();
        dip_.emplace(setup);
    }

    solver::DipState advance(int maximumSteps) override {
        return arena_->execute([&] { return dip_->advance(maximumSteps); });
    }

    void read(std::span<float> positions, std::span<solver::PointState> states) const override {
        numerics::readFilm(*dip_, points_, positions, states);
    }

private:
    std::optional<tbb::task_arena> arena_;
    std::optional<numerics::FilmDip<FilmEquilibrium>> dip_;
    std::size_t points_ = 0;
};

} // namespace

std::unique_ptr<solver::FilmSolver> makeProductionFilm() {
    return std::make_unique<ProductionFilm>();
}

} // namespace dipwright::cpu
