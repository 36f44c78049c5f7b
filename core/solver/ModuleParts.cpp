#include "solver/ModuleParts.h"

#include "base/ProgramName.h"

#include <QCoreApplication>

#include <cstring>
#include <stdexcept>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(SolverRegistry)
};

const char* programName() {
    return "Dipwright";
}

const char* versionText() {
    static const QByteArray version = programVersion().toUtf8();
    return version.constData();
}

void requireWithin(std::size_t mostPoints, const solver::DipSetup& setup) {
    if (setup.film.pointCount() > mostPoints) {
        throw std::runtime_error(
            Text::tr("It handles films of at most %1 points, but this film has %2; choose another "
                     "solver, or a coarser film")
                .arg(mostPoints)
                .arg(setup.film.pointCount())
                .toStdString());
    }
}

class LimitedFilm : public solver::FilmSolver {
public:
    LimitedFilm(std::unique_ptr<FilmSolver> film, std::size_t mostPoints)
        : film_(std::move(film)), mostPoints_(mostPoints) {}

    void begin(const solver::DipSetup& setup) override {
        requireWithin(mostPoints_, setup);
        film_->begin(setup);
    }
    solver::DipState advance(int maximumSteps) override { return film_->advance(maximumSteps); }
    void read(std::span<float> positions, std::span<solver::PointState> states) const override {
        film_->read(positions, states);
    }
    void readMarks(std::span<std::uint8_t> marks) const override { film_->readMarks(marks); }
    bool peek(std::span<float> positions, std::span<solver::PointState> states,
              solver::DipState& shown) override {
        return film_->peek(positions, states, shown);
    }

private:
    std::unique_ptr<FilmSolver> film_;
    std::size_t mostPoints_;
};

class LimitedModule : public solver::SolverModule {
public:
    LimitedModule(std::shared_ptr<const SolverModule> module, std::size_t mostPoints)
        : module_(std::move(module)), mostPoints_(mostPoints) {}

    const char* unavailableReason() const override { return module_->unavailableReason(); }
    const char* device() const override { return module_->device(); }
    std::unique_ptr<solver::FilmSolver> create() const override {
        auto film = module_->create();
        return film ? std::make_unique<LimitedFilm>(std::move(film), mostPoints_) : nullptr;
    }
    bool runBatch(std::span<solver::BatchItem> items, solver::CancelFunction cancelled,
                  void* context) const override {
        for (const solver::BatchItem& item : items) {
            requireWithin(mostPoints_, item.setup);
        }
        return module_->runBatch(items, cancelled, context);
    }
    bool followsPaths() const override { return module_->followsPaths(); }
    std::optional<solver::Ceiling> measuredCeiling() const override {
        return module_->measuredCeiling();
    }

private:
    std::shared_ptr<const SolverModule> module_;
    std::size_t mostPoints_;
};

} // namespace

const void* programPart(const char* name, int version) {
    static constexpr solver::ProgramPart program{&programName, &versionText};
    const bool isProgram =
        name != nullptr && std::strcmp(name, program.name) == 0 && version == program.version;
    return isProgram ? &program : nullptr;
}

std::shared_ptr<const solver::SolverModule>
limitedModule(std::shared_ptr<const solver::SolverModule> module,
              const solver::LimitsPart* limits) {
    const std::size_t mostPoints = limits ? limits->mostPoints() : 0;
    return mostPoints == 0 ? module
                           : std::make_shared<const LimitedModule>(std::move(module), mostPoints);
}

} // namespace dipwright
