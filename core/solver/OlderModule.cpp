#include "solver/OlderModule.h"

#include <algorithm>
#include <cstddef>

// The dynamic type of an older module is not known here, so it cannot be checked.
#if defined(__clang__) || defined(__GNUC__)
#define DIPWRIGHT_UNKNOWN_TYPE __attribute__((no_sanitize("vptr")))
#else
#define DIPWRIGHT_UNKNOWN_TYPE
#endif

namespace dipwright {

using namespace solver;

// The types of version 3 that differ from the present ones. Their layout never changes. They are in
// no unnamed namespace: the compiler must not assume that it knows every class derived from them.
namespace version3 {

struct DipSetup {
    FilmGrid film;
    FieldView field;
    BodyMotion motion;
    solver::Settings settings;
    std::vector<std::uint8_t> pinned;
};

struct BatchItem {
    DipSetup setup;
    std::vector<float> positions;
    std::vector<PointState> states;
    std::vector<std::uint8_t> marks;
    std::int64_t steps = 0;
    EquilibriumAccount equilibrium;
};

class SolverModule {
public:
    virtual ~SolverModule() = default;
    virtual const char* unavailableReason() const = 0;
    virtual const char* device() const = 0;
    virtual std::unique_ptr<FilmSolver> create() const = 0;
    virtual bool runBatch(std::span<BatchItem> items, CancelFunction cancelled,
                          void* context) const = 0;
    virtual std::optional<Ceiling> measuredCeiling() const = 0;
};

} // namespace version3

namespace {

// A film of version 3 reads the beginning of the present DipSetup. The rest of FilmSolver is the
// same in both versions.
static_assert(offsetof(DipSetup, pinned) == offsetof(version3::DipSetup, pinned));
static_assert(offsetof(DipSetup, settings) == offsetof(version3::DipSetup, settings));

class PresentModule : public SolverModule {
public:
    explicit PresentModule(const version3::SolverModule& older) : older_(older) {}

    DIPWRIGHT_UNKNOWN_TYPE const char* unavailableReason() const override {
        return older_.unavailableReason();
    }
    DIPWRIGHT_UNKNOWN_TYPE const char* device() const override { return older_.device(); }
    DIPWRIGHT_UNKNOWN_TYPE std::unique_ptr<FilmSolver> create() const override {
        return older_.create();
    }
    DIPWRIGHT_UNKNOWN_TYPE bool runBatch(std::span<BatchItem> items, CancelFunction cancelled,
                                         void* context) const override {
        std::vector<version3::BatchItem> older(items.size());
        for (std::size_t item = 0; item < items.size(); ++item) {
            const DipSetup& setup = items[item].setup;
            older[item].setup = {setup.film, setup.field, setup.motion, setup.settings,
                                 setup.pinned};
        }
        const bool isDone = older_.runBatch(older, cancelled, context);
        for (std::size_t item = 0; item < items.size(); ++item) {
            items[item].positions = std::move(older[item].positions);
            items[item].states = std::move(older[item].states);
            items[item].marks = std::move(older[item].marks);
            items[item].steps = older[item].steps;
            items[item].equilibrium = older[item].equilibrium;
        }
        return isDone;
    }
    bool followsPaths() const override { return false; }
    DIPWRIGHT_UNKNOWN_TYPE std::optional<Ceiling> measuredCeiling() const override {
        return older_.measuredCeiling();
    }

private:
    const version3::SolverModule& older_;
};

} // namespace

std::shared_ptr<const SolverModule> presentModule(const void* older) {
    return std::make_shared<const PresentModule>(
        *static_cast<const version3::SolverModule*>(older));
}

} // namespace dipwright
