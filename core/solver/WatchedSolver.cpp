#include "solver/WatchedSolver.h"

#include "base/SuspendAwareTimer.h"
#include "solver/LoadMarker.h"

#include <QtGlobal>
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

namespace dipwright {
namespace {

// Watches the calls of one film or one batch.
class CallWatch {
public:
    explicit CallWatch(const QString& modulePath)
        : modulePath_(modulePath), limit_(callTimeoutSeconds()), watcher_([this] { watch(); }) {}
    ~CallWatch() {
        {
            const std::lock_guard lock(mutex_);
            isOver_ = true;
        }
        changed_.notify_all();
        watcher_.join();
    }
    CallWatch(const CallWatch&) = delete;
    CallWatch& operator=(const CallWatch&) = delete;

    template <typename Call>
    auto during(const Call& call) {
        const Span span(*this);
        return call();
    }
    void restart() { set(SuspendAwareTimer()); }

private:
    struct Span {
        explicit Span(CallWatch& of) : watch(of) { watch.set(SuspendAwareTimer()); }
        ~Span() { watch.set(std::nullopt); }
        CallWatch& watch;
    };
    void set(std::optional<SuspendAwareTimer> call) {
        const std::lock_guard lock(mutex_);
        call_ = call;
    }
    void watch() {
        std::unique_lock lock(mutex_);
        while (!isOver_) {
            if (call_ && call_->look() > limit_) {
                rememberCrash(modulePath_);
                return; // recorded once for each film
            }
            changed_.wait_for(lock, std::chrono::milliseconds(500));
        }
    }

    QString modulePath_;
    std::chrono::seconds limit_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<SuspendAwareTimer> call_; // the current call of the module
    bool isOver_ = false;
    std::thread watcher_; // the last member, because it uses all others
};

class WatchedFilm : public solver::FilmSolver {
public:
    WatchedFilm(std::unique_ptr<solver::FilmSolver> film, const QString& modulePath)
        : film_(std::move(film)), watch_(modulePath) {}

    void begin(const solver::DipSetup& setup) override {
        watch_.during([&] { film_->begin(setup); });
    }
    solver::DipState advance(int maximumSteps) override {
        return watch_.during([&] { return film_->advance(maximumSteps); });
    }
    void read(std::span<float> positions, std::span<solver::PointState> states) const override {
        watch_.during([&] { film_->read(positions, states); });
    }
    void readMarks(std::span<std::uint8_t> marks) const override {
        watch_.during([&] { film_->readMarks(marks); });
    }
    bool peek(std::span<float> positions, std::span<solver::PointState> states,
              solver::DipState& shown) override {
        return watch_.during([&] { return film_->peek(positions, states, shown); });
    }

private:
    std::unique_ptr<solver::FilmSolver> film_;
    mutable CallWatch watch_;
};

// Wraps a batch's CancelFunction. Each call also restarts the watch.
struct WatchedCancel {
    CallWatch& watch;
    solver::CancelFunction isCancelled;
    void* context;

    static bool ask(void* self) {
        const auto& cancel = *static_cast<WatchedCancel*>(self);
        cancel.watch.restart();
        return cancel.isCancelled != nullptr && cancel.isCancelled(cancel.context);
    }
};

class WatchedModule : public solver::SolverModule {
public:
    WatchedModule(const solver::SolverModule& module, const QString& modulePath)
        : module_(module), modulePath_(modulePath) {}

    const char* unavailableReason() const override { return module_.unavailableReason(); }
    const char* device() const override { return module_.device(); }
    std::unique_ptr<solver::FilmSolver> create() const override {
        auto film = module_.create();
        return film ? std::make_unique<WatchedFilm>(std::move(film), modulePath_) : nullptr;
    }
    bool runBatch(std::span<solver::BatchItem> items, solver::CancelFunction isCancelled,
                  void* context) const override {
        CallWatch watch(modulePath_);
        WatchedCancel cancel{watch, isCancelled, context};
        return watch.during([&] { return module_.runBatch(items, &WatchedCancel::ask, &cancel); });
    }
    bool followsPaths() const override { return module_.followsPaths(); }
    std::optional<solver::Ceiling> measuredCeiling() const override {
        return module_.measuredCeiling();
    }

private:
    const solver::SolverModule& module_;
    QString modulePath_;
};

int chosenSeconds(int withoutChoice) {
    const int chosen = qEnvironmentVariableIntValue("DIPWRIGHT_SOLVER_SECONDS");
    return chosen > 0 ? std::min(chosen, 86'400) : withoutChoice;
}

} // namespace

int callTimeoutSeconds() {
    return chosenSeconds(longestCall);
}

int descriptionTimeoutSeconds() {
    return chosenSeconds(longestDescription);
}

std::unique_ptr<solver::SolverModule> watchedSolver(const solver::SolverModule& module,
                                                    const QString& modulePath) {
    return std::make_unique<WatchedModule>(module, modulePath);
}

} // namespace dipwright
