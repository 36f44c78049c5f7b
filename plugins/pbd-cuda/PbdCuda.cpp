// The module pbd-cuda: provides the GPU films of the folder solvers.

#include "common/cuda/AlikeDevices.h"
#include "common/cuda/Snapshot.h"
#include "measuring/cuda/DeviceCeiling.h"
#include "paper/cuda/PaperDips.h"
#include "production/cuda/ProductionDips.h"

#include <dipwright/FilmSolver.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>

namespace dipwright {

namespace {

bool isProduction(const solver::DipSetup& setup) {
    return solver::isProductionFilm(setup.settings.lattice, setup.settings.support);
}

std::unique_ptr<cuda::Dips> makeDips(const cuda::Device& device, cuda::Setups setups) {
    return isProduction(*setups.front()) ? cuda::makeProductionDips(device, setups)
                                         : cuda::makePaperDips(device, setups);
}

// Returns how many of the first dips, all of the production film or all of the paper's, should be
// on the device at the same time.
std::size_t dipsAtOnce(const cuda::Device& device, cuda::Setups setups) {
    return isProduction(*setups.front()) ? cuda::productionDipsAtOnce(device, setups)
                                         : cuda::paperDipsAtOnce(device, setups);
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
    std::optional<cuda::Snapshot> snapshot_; // made when the film is first displayed
};

using Group = std::span<solver::BatchItem>;

// Groups consecutive items that run together on one device. Distributes the items evenly over the
// devices.
std::vector<Group> groupsOf(Group items, const std::vector<cuda::Device>& devices) {
    std::vector<const solver::DipSetup*> setups;
    for (const solver::BatchItem& item : items) {
        setups.push_back(&item.setup);
    }
    std::vector<Group> groups;
    for (auto first = setups.begin(); first != setups.end();) {
        const auto last = std::find_if(first, setups.end(), [&](const solver::DipSetup* setup) {
            return isProduction(*setup) != isProduction(**first);
        });
        const std::size_t each = std::size_t(last - first + devices.size() - 1) / devices.size();
        while (first != last) {
            const cuda::Setups next(first, std::min(first + each, last));
            std::size_t size = next.size();
            for (const cuda::Device& device : devices) {
                size = std::min(size, dipsAtOnce(device, next));
            }
            groups.push_back(items.subspan(std::size_t(first - setups.begin()), size));
            first += std::ptrdiff_t(size);
        }
    }
    return groups;
}

// Runs groups on all devices. A device takes the next group as soon as it is free.
class SharedBatch {
public:
    SharedBatch(std::vector<Group> groups, solver::CancelFunction cancelled, void* context)
        : groups_(std::move(groups)), cancelled_(cancelled), context_(context) {}

    // Runs the groups. Returns whether all of them were run. Rethrows the first exception of a
    // device.
    bool runOn(const std::vector<cuda::Device>& devices) {
        std::vector<std::jthread> others;
        for (std::size_t device = 1; device < std::min(devices.size(), groups_.size()); ++device) {
            others.emplace_back([this, &devices, device] { work(devices[device]); });
        }
        work(devices.front());
        others.clear(); // waits for the other devices' threads
        if (failure_) {
            std::rethrow_exception(failure_);
        }
        return !isStopped_;
    }

private:
    void work(const cuda::Device& device) {
        try {
            for (std::size_t group = next_++; group < groups_.size(); group = next_++) {
                runTogether(device, groups_[group]);
            }
        } catch (...) {
            const std::lock_guard lock(mutex_);
            failure_ = failure_ ? failure_ : std::current_exception();
            isStopped_ = true;
        }
    }

    void runTogether(const cuda::Device& device, Group items) {
        std::vector<const solver::DipSetup*> setups;
        std::size_t points = 0;
        for (const solver::BatchItem& item : items) {
            setups.push_back(&item.setup);
            points += item.setup.film.pointCount();
        }
        // A GPU that drives a display stops kernels that run for seconds.
        constexpr std::size_t mostSteps = 256, mostPointSteps = 30'000'000;
        const int steps = int(std::clamp(mostPointSteps / points, std::size_t(1), mostSteps));
        if (isStopped()) {
            return;
        }
        const auto dips = makeDips(device, setups);
        for (bool finished = false; !finished;) {
            if (isStopped()) {
                return;
            }
            dips->advance(steps);
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
    }

    // Asks the host whether to stop. Only one thread at a time asks.
    bool isStopped() {
        const std::lock_guard lock(mutex_);
        isStopped_ = isStopped_ || (cancelled_ && cancelled_(context_));
        return isStopped_;
    }

    const std::vector<Group> groups_;
    const solver::CancelFunction cancelled_;
    void* const context_;
    std::atomic<std::size_t> next_ = 0;
    std::mutex mutex_;
    bool isStopped_ = false;
    std::exception_ptr failure_;
};

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
        const std::vector<cuda::Device> devices = cuda::alikeDevices(search_.device);
        return SharedBatch(groupsOf(items, devices), cancelled, context).runOn(devices);
    }
    bool followsPaths() const override { return true; }
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

    cuda::DeviceSearch search_;
};

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
