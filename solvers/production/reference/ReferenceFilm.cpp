#include "production/reference/ReferenceFilm.h"

#include "production/formulas/FilmStep.h"
#include "production/reference/PlaneEquilibrium.h"

#include <optional>
#include <stdexcept>

namespace dipwright::reference {

namespace {

class ReferenceFilm final : public solver::FilmSolver {
public:
    void begin(const solver::DipSetup& setup) override {
        if (setup.settings.lattice != solver::Lattice::Isotropic ||
            setup.settings.support != solver::Support::Water) {
            throw std::runtime_error("the reference film is isotropic and floats on water");
        }
        solver::DipSetup exact = setup;
        exact.settings.residual = 1e-9;
        points_ = setup.film.pointCount();
        dip_.emplace(exact);
    }
    solver::DipState advance(int maximumSteps) override { return dip_->advance(maximumSteps); }
    void read(std::span<float> positions, std::span<solver::PointState> states) const override {
        numerics::readFilm(*dip_, points_, positions, states);
    }

private:
    std::optional<numerics::FilmDip<PlaneEquilibrium>> dip_;
    std::size_t points_ = 0;
};

} // namespace

std::unique_ptr<solver::FilmSolver> makeReferenceFilm() {
    return std::make_unique<ReferenceFilm>();
}

} // namespace dipwright::reference
