// The module pbd-cpu: provides the CPU films of the folder solvers.

#include "measuring/cpu/CpuCeiling.h"
#include "measuring/cpu/CpuName.h"
#include "paper/cpu/PaperFilm.h"
#include "parallel/ParallelFor.h"
#include "parallel/Threads.h"
#include "production/cpu/ProductionFilm.h"

#include <dipwright/FilmSolver.h>

#include <atomic>
#include <mutex>
#include <stdexcept>
#include <string>

namespace dipwright {

namespace {

std::unique_ptr<solver::FilmSolver> makeFilm(const solver::Settings& settings) {
    if (solver::isProductionFilm(settings.lattice, settings.support)) {
        return cpu::makeProductionFilm();
    }
    return cpu::makePaperFilm();
}

// Creates the film that the dip's settings require.
class CpuFilm : public solver::FilmSolver {
public:
    void begin(const solver::DipSetup& setup) override {
        film_ = makeFilm(setup.settings);
        film_->begin(setup);
    }
    solver::DipState advance(int maximumSteps) override { return begun().advance(maximumSteps); }
    void read(std::span<float> positions, std::span<solver::PointState> states) const override {
        begun().read(positions, states);
    }
    void readMarks(std::span<std::uint8_t> marks) const override { begun().readMarks(marks); }

private:
    solver::FilmSolver& begun() const {
        if (!film_) {
            throw std::runtime_error("the dip has not begun");
        }
        return *film_;
    }
    std::unique_ptr<solver::FilmSolver> film_;
};

// Asks the host whether to cancel, from one thread at a time. Once the host has said yes, does not
// ask again.
class Cancellation {
public:
    Cancellation(solver::CancelFunction cancelled, void* context)
        : cancelled_(cancelled), context_(context) {}

    bool isCancelled() const { return isCancelled_; }
    bool operator()() {
        const std::lock_guard lock(mutex_);
        isCancelled_ = isCancelled_ || (cancelled_ && cancelled_(context_));
        return isCancelled_;
    }

private:
    std::mutex mutex_;
    solver::CancelFunction cancelled_;
    void* context_;
    bool isCancelled_ = false;
};

void simulate(solver::BatchItem& item, Cancellation& cancelled) {
    constexpr int stepsBetweenQuestions = 4;
    CpuFilm film;
    film.begin(item.setup);
    solver::DipState state;
    while (!state.finished) {
        if (cancelled()) {
            return;
        }
        state = film.advance(stepsBetweenQuestions);
    }
    item.finish(state, [&](auto positions, auto states, auto marks) {
        film.read(positions, states);
        film.readMarks(marks);
    });
}

class PbdCpu : public solver::SolverModule {
public:
    PbdCpu()
        : device_(std::to_string(coreCount()) + " × " + cpuName() + ", " +
                  cpu::paperFilmInstructionSet()) {}

    const char* unavailableReason() const override { return nullptr; }
    const char* device() const override { return device_.c_str(); }
    std::unique_ptr<solver::FilmSolver> create() const override {
        return std::make_unique<CpuFilm>();
    }
    bool runBatch(std::span<solver::BatchItem> items, solver::CancelFunction cancelled,
                  void* context) const override {
        Cancellation cancellation(cancelled, context);
        parallelFor(std::size_t(0), items.size(),
                    [&](std::size_t index) { simulate(items[index], cancellation); });
        return !cancellation.isCancelled();
    }
    bool followsPaths() const override { return true; }
    std::optional<solver::Ceiling> measuredCeiling() const override { return cpuCeiling(); }

private:
    std::string device_;
};

} // namespace

} // namespace dipwright

extern "C" DIPWRIGHT_EXPORT const dipwright::solver::SolverModule*
dipwrightSolverModule(int hostInterfaceVersion) {
    if (hostInterfaceVersion != dipwright::solver::interfaceVersion) {
        return nullptr;
    }
    static const dipwright::PbdCpu module;
    return &module;
}
