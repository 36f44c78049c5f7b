#include "production/reference/ReferenceFilm.h"

#include "production/reference/ReferenceBackend.h"

#include <optional>
#include <stdexcept>

namespace dipwright::reference {

namespace {

class ReferenceFilm final : public solver::FilmSolver {
public:
    void begin(const solver::DipSetup& setup) override {
        if (!solver::isProductionFilm(setup.settings.lattice, setup.settings.support)) {
            throw std::runtime_error("the reference film is isotropic and floats on water");
        }
        solver::DipSetup exact = setup;
        exact.settings.residual = 1e-9;
        film_.emplace(exact);
    }
    solver::DipState advance(int maximumSteps) override {
        return numerics::advance(*film_, maximumSteps);
    }
    void read(std::span<float> positions, std::span<solver::PointState> states) const override {
        film_->read(positions, states);
    }
    void readMarks(std::span<std::uint8_t> marks) const override { film_->readMarks(marks); }

private:
    std::optional<ReferenceBackend> film_;
};

} // namespace

std::unique_ptr<solver::FilmSolver> makeReferenceFilm() {
    return std::make_unique<ReferenceFilm>();
}

} // namespace dipwright::reference
