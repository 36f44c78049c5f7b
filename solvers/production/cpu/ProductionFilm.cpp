#include "production/cpu/ProductionFilm.h"

#include "common/SetupLimits.h"
#include "production/cpu/CpuBackend.h"

#include <tbb/task_arena.h>

#include <optional>

namespace dipwright::cpu {

namespace {

class ProductionFilm final : public solver::FilmSolver {
public:
    void begin(const solver::DipSetup& setup) override {
        numerics::requireValid(setup);
        film_.reset();
        arena_.emplace(setup.settings.threads > 0 ? setup.settings.threads
                                                  : int(tbb::task_arena::automatic));
        film_.emplace(setup);
    }

    solver::DipState advance(int maximumSteps) override {
        return arena_->execute([&] { return numerics::advance(*film_, maximumSteps); });
    }

    void read(std::span<float> positions, std::span<solver::PointState> states) const override {
        film_->read(positions, states);
    }

private:
    std::optional<tbb::task_arena> arena_;
    std::optional<CpuBackend> film_;
};

} // namespace

std::unique_ptr<solver::FilmSolver> makeProductionFilm() {
    return std::make_unique<ProductionFilm>();
}

} // namespace dipwright::cpu
