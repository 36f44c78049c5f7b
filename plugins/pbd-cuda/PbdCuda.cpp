// The module pbd-cuda: a thin shell round the films of solvers/cuda.

#include "cuda/Dips.h"

#include <dipwright/FilmSolver.h>

#include <stdexcept>

namespace dipwright {

namespace {

bool isQuasiStatic(const solver::DipSetup& setup) {
    return setup.settings.lattice == solver::Lattice::Isotropic &&
           setup.settings.support == solver::Support::Water;
}

std::unique_ptr<cuda::Dips> makeDips(const cuda::Device& device, cuda::Setups setups) {
    return isQuasiStatic(*setups.front()) ? cuda::makeQuasiStaticDips(device, setups)
                                          : cuda::makePaperDips(device, setups);
}

std::size_t dipsAtOnce(const cuda::Device& device, const solver::DipSetup& setup) {
    return isQuasiStatic(setup) ? cuda::quasiStaticDipsAtOnce(device, setup)
                                : cuda::paperDipsAtOnce(device, setup);
}

class CudaFilm : public solver::FilmSolver {
public:
    explicit CudaFilm(const cuda::Device& device) : device_(device) {}

    void begin(const solver::DipSetup& setup) override {
        dips_.reset();
        const solver::DipSetup* const only[] = {&setup};
        dips_ = makeDips(device_, only);
    }
    solver::Progress advance(int maximumSteps) override {
        begun().advance(maximumSteps);
        return begun().progress(0);
    }
    void read(std::span<float> positions, std::span<solver::PointState> states) const override {
        begun().read(0, positions, states);
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
        if (!search_.found) {
            throw std::runtime_error(search_.reason);
        }
        return std::make_unique<CudaFilm>(search_.device);
    }
    bool runBatch(std::span<solver::BatchItem> items, solver::CancelFunction cancelled,
                  void* context) const override {
        if (!search_.found) {
            throw std::runtime_error(search_.reason);
        }
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

private:
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
            finished = finished && dips->progress(dip).finished;
        }
    }
    for (std::size_t dip = 0; dip < items.size(); ++dip) {
        const std::size_t points = items[dip].setup.film.pointCount();
        items[dip].positions.resize(3 * points);
        items[dip].states.resize(points);
        items[dip].steps = dips->progress(dip).steps;
        dips->read(dip, items[dip].positions, items[dip].states);
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
