#include "production/cpu/ProductionFilm.h"

#include "common/SetupLimits.h"
#include "common/cpu/FlushDenormals.h"
#include "parallel/Threads.h"
#include "production/cpu/CpuBackend.h"

#include <optional>

namespace dipwright::cpu {

namespace {

// Measured: a film with fewer points is no faster on several threads, which then wait for each
// other most of the time.
constexpr std::size_t fewestForThreads = 1500;

class ProductionFilm final : public solver::FilmSolver {
public:
    void begin(const solver::DipSetup& setup) override {
        numerics::requireValid(setup);
        film_.reset();
        const bool isSmall = setup.film.pointCount() < fewestForThreads;
        team_.emplace(isSmall ? 1 : setup.settings.threads);
        team_->run([&] {
            const FlushDenormals flush;
            film_.emplace(setup);
        });
    }

    solver::DipState advance(int maximumSteps) override {
        solver::DipState state;
        team_->run([&] {
            const FlushDenormals flush;
            state = numerics::advance(*film_, maximumSteps);
        });
        return state;
    }

    void read(std::span<float> positions, std::span<solver::PointState> states) const override {
        film_->read(positions, states);
    }
    void readMarks(std::span<std::uint8_t> marks) const override { film_->readMarks(marks); }

private:
    std::optional<ThreadTeam> team_;
    std::optional<CpuBackend> film_;
};

} // namespace

std::unique_ptr<solver::FilmSolver> makeProductionFilm() {
    return std::make_unique<ProductionFilm>();
}

} // namespace dipwright::cpu
