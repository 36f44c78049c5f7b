// Modules that misbehave, one for each way, chosen by DIPWRIGHT_BAD_<WAY>.

#include <dipwright/FilmSolver.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace {

using namespace dipwright;

// A film that fails where it is told to.
class Film : public solver::FilmSolver {
public:
    void begin(const solver::DipSetup&) override {
#if defined(DIPWRIGHT_BAD_BEGIN)
        throw std::runtime_error("out of film");
#endif
    }
    solver::DipState advance(int steps) override {
#if defined(DIPWRIGHT_BAD_ADVANCE)
        throw std::runtime_error("out of water");
#elif defined(DIPWRIGHT_BAD_ADVANCE_UNKNOWN)
        throw 42;
#endif
        return {steps, 1, true};
    }
    void read(std::span<float>, std::span<solver::PointState>) const override {
#if defined(DIPWRIGHT_BAD_READ)
        throw std::runtime_error("out of ink");
#endif
    }
};

class Module : public solver::SolverModule {
public:
    const char* unavailableReason() const override {
#if defined(DIPWRIGHT_BAD_DEVICE)
        return "There is no such device here";
#elif defined(DIPWRIGHT_BAD_QUESTION)
        throw std::runtime_error("do not ask");
#else
        return nullptr;
#endif
    }
    const char* device() const override {
        return "A device";
    }
    std::unique_ptr<solver::FilmSolver> create() const override {
#if defined(DIPWRIGHT_BAD_CREATE)
        throw std::runtime_error("out of memory");
#endif
        return std::make_unique<Film>();
    }
    bool runBatch(std::span<solver::BatchItem>, solver::CancelFunction, void*) const override {
        return true;
    }
};

} // namespace

#if defined(DIPWRIGHT_BAD_LOAD)
namespace {
// Runs as soon as the module is loaded: nobody may get that far.
[[maybe_unused]] const int harm = (std::abort(), 0);
} // namespace
#endif

#if !defined(DIPWRIGHT_BAD_NAME)
#define DIPWRIGHT_BAD_NAME dipwrightSolverModule
#endif

extern "C" DIPWRIGHT_EXPORT const solver::SolverModule*
DIPWRIGHT_BAD_NAME([[maybe_unused]] int hostInterfaceVersion) {
#if defined(DIPWRIGHT_BAD_ENTRY)
    throw std::runtime_error("not today");
#elif defined(DIPWRIGHT_BAD_ENTRY_UNKNOWN)
    throw 42;
#elif defined(DIPWRIGHT_BAD_OLD)
    if (hostInterfaceVersion != 2) { // as a module does that was built for version 2
        return nullptr;
    }
#elif defined(DIPWRIGHT_BAD_ABORT)
    std::abort();
#elif defined(DIPWRIGHT_BAD_KILLED)
    std::raise(SIGKILL); // as the system does for want of memory
#endif
    static const Module module;
    return &module;
}
