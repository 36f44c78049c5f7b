// The module pbd-cuda: a thin shell round the films of solvers on a GPU.

#include "common/cuda/Snapshot.h"
#include "measuring/cuda/DeviceCeiling.h"
#include "paper/cuda/PaperDips.h"
#include "production/cuda/ProductionDips.h"

#include <dipwright/FilmSolver.h>

#include <optional>
#include <stdexcept>

namespace dipwright {

namespace {

bool isProduction(const solver::DipSetup& setup) {
    return solver::isProductionFilm(setup.settings.lattice, setup.settings.support);
}

std::unique_ptr<cuda::Dips> makeDips(const cuda::Device& device, cuda::Setups setups) {
    return isProduction(*setups.front()) ? cuda::makeProductionDips(device, setups)
                                         : cuda::makePaperDips(device, setups);
}

std::size_t dipsAtOnce(const cuda::Device& device, const solver::DipSetup& setup) {
    return isProduction(setup) ? cuda::productionDipsAtOnce(device, setup)
                               : cuda::paperDipsAtOnce(device, setup);
}

class CudaFilm : public solver::FilmSolver {
public:
    explicit CudaFilm(const cuda::Device& device) : device_(device) {}

    void begin(const solver::DipSetup& setup) override {
        snapshot_.reset();
        dips_.reset();
        const solver::DipSetup* const only[] = {&setup};
        dips_ = makeDips(device_, only);
    }
    solver::DipState advance(int maximumSteps) override {
        begun().advance(maximumSteps);
        return begun().state(0);
    }
    void read(std::span<float> positions, std::span<solver::PointState> states) const override {
        begun().read(0, positions, states);
    }
    void readMarks(std::span<std::uint8_t> marks) const override { begun().readMarks(0, marks); }
    bool peek(std::span<float> positions, std::span<solver::PointState> states,
              solver::DipState& shown) override {
        if (!snapshot_) {
            snapshot_.emplace(begun(), 0);
        }
        return snapshot_->peek(positions, states, shown);
    }

private:
    cuda::Dips& begun() const {
        if (!dips_) {
            throw std::runtime_error("the dip has not begun");
        }
        return *dips_;
    }
    const cuda::Device& device_;
    std::unique_ptr<cuda::Dips> dips_;
    std::optional<cuda::Snapshot> snapshot_; // once the film is to be shown
};

// The items from `first` on that can run together, at most as many as the device holds.
std::size_t alikeFrom(std::span<const solver::BatchItem> items, std::size_t first,
                      std::size_t most) {
    std::size_t last = first + 1;
    while (last < items.size() && last - first < most &&
           cuda::areAlike(items[first].setup, items[last].setup)) {
        ++last;
    }
    return last;
}

class PbdCuda : public solver::SolverModule {
public:
    PbdCuda() : search_(cuda::findDevice()) {}

    const char* unavailableReason() const override {
        return search_.found ? nullptr : search_.reason.c_str();
    }
    const char* device() const override { return search_.device.name.c_str(); }
    std::unique_ptr<solver::FilmSolver> create() const override {
        requireDevice();
        return std::make_unique<CudaFilm>(search_.device);
    }
    bool runBatch(std::span<solver::BatchItem> items, solver::CancelFunction cancelled,
                  void* context) const override {
        requireDevice();
        for (std::size_t first = 0; first < items.size();) {
            const std::size_t most = dipsAtOnce(search_.device, items[first].setup);
            const std::size_t last = alikeFrom(items, first, most);
            if (!runTogether(items.subspan(first, last - first), cancelled, context)) {
                return false;
            }
            first = last;
        }
        return true;
    }
    std::optional<solver::Ceiling> measuredCeiling() const override {
        requireDevice();
        return cuda::measuredCeiling(search_.device);
    }

private:
    void requireDevice() const {
        if (!search_.found) {
            throw std::runtime_error(search_.reason);
        }
    }
    bool runTogether(std::span<solver::BatchItem> items, solver::CancelFunction cancelled,
                     void* context) const;

    cuda::DeviceSearch search_;
};

bool PbdCuda::runTogether(std::span<solver::BatchItem> items, solver::CancelFunction cancelled,
                          void* context) const {
    constexpr int stepsBetweenQuestions = 256;
    std::vector<const solver::DipSetup*> setups;
    for (const solver::BatchItem& item : items) {
        setups.push_back(&item.setup);
    }
    const auto dips = makeDips(search_.device, setups);
    for (bool finished = false; !finished;) {
        if (cancelled && cancelled(context)) {
            return false;
        }
        dips->advance(stepsBetweenQuestions);
        finished = true;
        for (std::size_t dip = 0; dip < items.size(); ++dip) {
            finished = finished && dips->state(dip).finished;
        }
    }
    for (std::size_t dip = 0; dip < items.size(); ++dip) {
        items[dip].finish(dips->state(dip), [&](auto positions, auto states, auto marks) {
            dips->read(dip, positions, states);
            dips->readMarks(dip, marks);
        });
    }
    return true;
}

} // namespace

} // namespace dipwright

extern "C" DIPWRIGHT_EXPORT const dipwright::solver::SolverModule*
dipwrightSolverModule(int hostInterfaceVersion) {
    if (hostInterfaceVersion != dipwright::solver::interfaceVersion) {
        return nullptr;
    }
    static const dipwright::PbdCuda module;
    return &module;
}
