// A module that uses named parts: it tells which program loaded it, does without a part that no
// program has, and states a limit.
#include <dipwright/SolverParts.h>

#include <algorithm>
#include <string>

namespace {

using namespace dipwright::solver;

// A part that a later program might have.
struct MoonPart {
    static constexpr const char* name = "moon";
    static constexpr int version = 1;
};

std::string loadedBy = "nobody"; // set once, when the module is loaded

class NoFilm : public FilmSolver {
public:
    void begin(const DipSetup&) override {}
    DipState advance(int) override {
        DipState end;
        end.finished = true;
        return end;
    }
    void read(std::span<float> positions, std::span<PointState> states) const override {
        std::fill(positions.begin(), positions.end(), 0.0f);
        std::fill(states.begin(), states.end(), PointState::Free);
    }
};

class PartsModule : public SolverModule {
public:
    const char* unavailableReason() const override { return nullptr; }
    const char* device() const override { return loadedBy.c_str(); }
    std::unique_ptr<FilmSolver> create() const override { return std::make_unique<NoFilm>(); }
    bool runBatch(std::span<BatchItem>, CancelFunction, void*) const override { return false; }
};

} // namespace

extern "C" DIPWRIGHT_EXPORT void dipwrightUseProgram(GetPart getPart) {
    if (const auto* program = part<ProgramPart>(getPart)) {
        loadedBy = std::string(program->programName()) + ' ' + program->programVersion();
    }
    loadedBy += part<MoonPart>(getPart) ? ", moon" : ", no moon";
}

extern "C" DIPWRIGHT_EXPORT const void* dipwrightSolverPart(const char* name, int version) {
    static constexpr LimitsPart limits{[] { return std::size_t(100); }};
    return std::string(name) == LimitsPart::name && version == LimitsPart::version ? &limits
                                                                                   : nullptr;
}

extern "C" DIPWRIGHT_EXPORT const SolverModule* dipwrightSolverModule(int hostInterfaceVersion) {
    static const PartsModule module;
    return hostInterfaceVersion == interfaceVersion ? &module : nullptr;
}
