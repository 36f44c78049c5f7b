#include "solver/CheckedSolver.h"

#include "base/Error.h"
#include "base/Progress.h"
#include "solver/ModuleText.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(CheckedSolver)
};

constexpr int mostIdleCalls = 10'000; // calls of advance() without a step
// Limit for the steps of one dip: more than the fastest solver does in a day with the smallest
// film.
constexpr std::int64_t mostSteps = 1'000'000'000;
// After this many steps the body's mean descent is checked.
constexpr std::int64_t stepsToJudge = 1'000'000;
// Least mean descent in one step, mm: 10 % of the slowest dip with the shortest step that a
// project may have.
constexpr double leastMeanDescent = 1e-8;
// Without any descent a film may take as many steps as the dip has time steps, plus these.
constexpr std::int64_t stepsAtRest = 1000;
constexpr std::int64_t mostIterationsOfAStep = 1'000'000; // of the linear solver
constexpr double travelTolerance = 1e-6;                  // share of the travel, for rounding
constexpr std::uint8_t allMarks = std::uint8_t(solver::PointMark::Torn) |
                                  std::uint8_t(solver::PointMark::LetGo) |
                                  std::uint8_t(solver::PointMark::Unbalanced);

[[noreturn]] void fail(const QString& fault) {
    throw std::runtime_error(fault.toStdString());
}

void require(bool isGood, const QString& fault) {
    if (!isGood) {
        fail(fault);
    }
}

[[noreturn]] void failUnknown() {
    fail(Text::tr("it threw an unknown exception"));
}

// Turns the module's exceptions into std::runtime_error with a message that can be shown.
template <typename Call>
auto guarded(const Call& call) {
    try {
        return call();
    } catch (const Cancelled&) {
        throw;
    } catch (const Error&) {
        throw; // not an exception of the module
    } catch (const std::exception& failure) {
        const QString said = moduleText(QString::fromUtf8(failure.what()));
        said.isEmpty() ? failUnknown() : fail(said);
    } catch (...) {
        failUnknown();
    }
}

void requireStates(std::span<const solver::PointState> states) {
    require(std::all_of(states.begin(), states.end(),
                        [](solver::PointState state) {
                            return std::uint8_t(state) <= std::uint8_t(solver::PointState::Trapped);
                        }),
            Text::tr("it returned an invalid state for some points"));
}

void requireMarks(std::span<const std::uint8_t> marks) {
    require(std::all_of(marks.begin(), marks.end(),
                        [](std::uint8_t mark) { return (mark & ~allMarks) == 0; }),
            Text::tr("it returned an invalid mark for some points"));
}

bool areFinite(std::span<const float> positions) {
    return std::all_of(positions.begin(), positions.end(),
                       [](float position) { return std::isfinite(position); });
}

bool isNumberOfSteps(std::int64_t steps) {
    return steps >= 0 && steps <= mostSteps;
}

bool isWithin(double travel, double descent) {
    return descent >= 0 && descent <= travel * (1 + travelTolerance); // false for NaN
}

// Checks the convergence values of a dip with `steps` steps.
void requireEquilibrium(const solver::EquilibriumAccount& account, std::int64_t steps) {
    const bool isGood =
        account.stepsWithout >= 0 && account.stepsWithout <= steps &&
        account.linearIterations >= 0 &&
        account.linearIterations <= std::max<std::int64_t>(steps, 1) * mostIterationsOfAStep &&
        std::isfinite(account.worstForceLeft) && account.worstForceLeft >= 0;
    require(isGood, Text::tr("it reported impossible convergence values"));
}

void requireForward(const solver::DipState& now, const solver::DipState& before, double travel) {
    require(isWithin(travel, now.descent) && now.descent >= before.descent &&
                isNumberOfSteps(now.steps) && now.steps >= before.steps,
            Text::tr("it reported an impossible number of steps or an impossible descent"));
    requireEquilibrium(now.equilibrium, now.steps);
}

bool isCrawling(const solver::DipState& state) {
    return state.steps >= stepsToJudge && state.descent < double(state.steps) * leastMeanDescent;
}

std::int64_t mostStepsAtRest(const solver::DipSetup& setup) {
    const double step = setup.motion.speed * setup.settings.timeStep; // mm
    const double steps = setup.motion.travel / step;
    return steps > 0 && steps < double(mostSteps) ? stepsAtRest + std::int64_t(steps) : mostSteps;
}

void requireEnd(bool comesForward) {
    require(comesForward, Text::tr("it makes no progress"));
}

class CheckedFilm : public StoppableFilm {
public:
    explicit CheckedFilm(std::unique_ptr<solver::FilmSolver> film) : film_(std::move(film)) {}

    void stopOn(std::function<bool()> isCancelled) override {
        if (auto* film = dynamic_cast<StoppableFilm*>(film_.get())) {
            film->stopOn(std::move(isCancelled));
        }
    }
    void begin(const solver::DipSetup& setup) override {
        state_ = {};
        idleCalls_ = 0;
        stepsDown_ = 0;
        mostAtRest_ = mostStepsAtRest(setup);
        travel_ = setup.motion.travel;
        guarded([&] { film_->begin(setup); });
    }
    solver::DipState advance(int maximumSteps) override {
        const solver::DipState now = guarded([&] { return film_->advance(maximumSteps); });
        requireForward(now, state_, travel_);
        idleCalls_ = now.steps == state_.steps ? idleCalls_ + 1 : 0;
        stepsDown_ = now.descent > state_.descent ? now.steps : stepsDown_;
        const bool isAtRest = idleCalls_ >= mostIdleCalls || now.steps - stepsDown_ > mostAtRest_;
        requireEnd(now.finished || (!isAtRest && !isCrawling(now)));
        return state_ = now;
    }
    void read(std::span<float> positions, std::span<solver::PointState> states) const override {
        guarded([&] { film_->read(positions, states); });
        requireStates(states);
    }
    void readMarks(std::span<std::uint8_t> marks) const override {
        guarded([&] { film_->readMarks(marks); });
        requireMarks(marks);
    }
    bool peek(std::span<float> positions, std::span<solver::PointState> states,
              solver::DipState& shown) override {
        if (!guarded([&] { return film_->peek(positions, states, shown); })) {
            return false;
        }
        requireStates(states);
        return areFinite(positions) && isWithin(travel_, shown.descent) &&
               isNumberOfSteps(shown.steps);
    }

private:
    std::unique_ptr<solver::FilmSolver> film_;
    solver::DipState state_;
    int idleCalls_ = 0;
    std::int64_t stepsDown_ = 0; // number of steps when the body last moved down
    std::int64_t mostAtRest_ = mostSteps;
    double travel_ = std::numeric_limits<double>::max(); // until begin()
};

// Calls the host's CancelFunction for a batch, and remembers the answer.
struct Stop {
    solver::CancelFunction isCancelled;
    void* context;
    bool said = false;

    static bool ask(void* self) {
        Stop& stop = *static_cast<Stop*>(self);
        stop.said = stop.said || (stop.isCancelled && stop.isCancelled(stop.context));
        return stop.said;
    }
};

bool isRate(double perSecond) {
    return std::isfinite(perSecond) && perSecond > 0;
}

std::string deviceOf(const solver::SolverModule& module) {
    const char* device = guarded([&] { return module.device(); });
    return moduleText(QString::fromUtf8(device)).toStdString();
}

class CheckedModule : public solver::SolverModule {
public:
    explicit CheckedModule(const solver::SolverModule& module)
        : module_(module), device_(deviceOf(module)) {}

    const char* unavailableReason() const override { return module_.unavailableReason(); }
    const char* device() const override { return device_.c_str(); }
    std::unique_ptr<solver::FilmSolver> create() const override {
        auto film = guarded([&] { return module_.create(); });
        requireFilm(film.get());
        return std::make_unique<CheckedFilm>(std::move(film));
    }
    bool runBatch(std::span<solver::BatchItem> items, solver::CancelFunction isCancelled,
                  void* context) const override {
        Stop stop{isCancelled, context};
        const bool isDone = guarded([&] { return module_.runBatch(items, &Stop::ask, &stop); });
        require(isDone || stop.said, Text::tr("it stopped without being cancelled"));
        if (isDone) {
            std::for_each(items.begin(), items.end(), requireItem);
        }
        return isDone;
    }
    bool followsPaths() const override {
        return guarded([&] { return module_.followsPaths(); });
    }
    std::optional<solver::Ceiling> measuredCeiling() const override {
        const auto ceiling = guarded([&] { return module_.measuredCeiling(); });
        const bool isMeasured =
            ceiling && isRate(ceiling->flopsPerSecond) && isRate(ceiling->bytesPerSecond);
        return isMeasured ? ceiling : std::nullopt;
    }

private:
    static void requireItem(solver::BatchItem& item) {
        const std::size_t points = item.setup.film.pointCount();
        if (item.marks.empty()) {
            item.marks.assign(points, 0); // as for readMarks(), which a module may lack
        }
        require(item.positions.size() == 3 * points && item.states.size() == points &&
                    item.marks.size() == points,
                Text::tr("it returned no result for some films of a batch"));
        require(isNumberOfSteps(item.steps),
                Text::tr("it reported an impossible number of steps or an impossible descent"));
        requireEquilibrium(item.equilibrium, item.steps);
        requireStates(item.states);
        requireMarks(item.marks);
    }

    const solver::SolverModule& module_;
    std::string device_;
};

} // namespace

void requireFilm(const solver::FilmSolver* film) {
    require(film != nullptr, Text::tr("it created no film"));
}

std::unique_ptr<solver::SolverModule> checkedSolver(const solver::SolverModule& module) {
    return std::make_unique<CheckedModule>(module);
}

} // namespace dipwright
