#include "solver/CheckedSolver.h"

#include "base/Progress.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(CheckedSolver)
};

constexpr int mostIdleCalls = 10'000; // of advance(), without a step
constexpr std::uint8_t allMarks = std::uint8_t(solver::PointMark::Torn) |
                                  std::uint8_t(solver::PointMark::LetGo) |
                                  std::uint8_t(solver::PointMark::Unbalanced);

void require(bool isGood, const QString& fault) {
    if (!isGood) {
        throw std::runtime_error(fault.toStdString());
    }
}

// Turns what is no std::exception into one.
template <typename Call>
auto guarded(const Call& call) {
    try {
        return call();
    } catch (const std::exception&) {
        throw;
    } catch (...) {
        throw std::runtime_error(Text::tr("it threw an unknown exception").toStdString());
    }
}

void requireStates(std::span<const solver::PointState> states) {
    require(std::all_of(states.begin(), states.end(),
                        [](solver::PointState state) {
                            return std::uint8_t(state) <= std::uint8_t(solver::PointState::Trapped);
                        }),
            Text::tr("it gave points a state that there is none of"));
}

void requireMarks(std::span<const std::uint8_t> marks) {
    require(std::all_of(marks.begin(), marks.end(),
                        [](std::uint8_t mark) { return (mark & ~allMarks) == 0; }),
            Text::tr("it gave points a mark that there is none of"));
}

bool areFinite(std::span<const float> positions) {
    return std::all_of(positions.begin(), positions.end(),
                       [](float position) { return std::isfinite(position); });
}

void requireForward(const solver::DipState& now, const solver::DipState& before) {
    require(std::isfinite(now.descent) && now.descent >= before.descent &&
                now.steps >= before.steps,
            Text::tr("it told steps or a descent that cannot be"));
}

void requireEnd(bool comesForward) {
    require(comesForward, Text::tr("it does not come forward"));
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
        guarded([&] { film_->begin(setup); });
    }
    solver::DipState advance(int maximumSteps) override {
        const solver::DipState now = guarded([&] { return film_->advance(maximumSteps); });
        requireForward(now, state_);
        idleCalls_ = now.steps == state_.steps ? idleCalls_ + 1 : 0;
        requireEnd(now.finished || idleCalls_ < mostIdleCalls);
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
        return areFinite(positions) && std::isfinite(shown.descent);
    }

private:
    std::unique_ptr<solver::FilmSolver> film_;
    solver::DipState state_;
    int idleCalls_ = 0;
};

// Asks whoever may stop a batch, and remembers the answer.
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

class CheckedModule : public solver::SolverModule {
public:
    explicit CheckedModule(const solver::SolverModule& module) : module_(module) {}

    const char* unavailableReason() const override { return module_.unavailableReason(); }
    const char* device() const override { return module_.device(); }
    std::unique_ptr<solver::FilmSolver> create() const override {
        auto film = guarded([&] { return module_.create(); });
        requireFilm(film.get());
        return std::make_unique<CheckedFilm>(std::move(film));
    }
    bool runBatch(std::span<solver::BatchItem> items, solver::CancelFunction isCancelled,
                  void* context) const override {
        Stop stop{isCancelled, context};
        const bool isDone = guarded([&] { return module_.runBatch(items, &Stop::ask, &stop); });
        require(isDone || stop.said, Text::tr("it stopped by itself"));
        if (isDone) {
            std::for_each(items.begin(), items.end(), requireItem);
        }
        return isDone;
    }
    std::optional<solver::Ceiling> measuredCeiling() const override {
        return guarded([&] { return module_.measuredCeiling(); });
    }

private:
    static void requireItem(solver::BatchItem& item) {
        const std::size_t points = item.setup.film.pointCount();
        if (item.marks.empty()) {
            item.marks.assign(points, 0); // as readMarks, which need not be there
        }
        require(item.positions.size() == 3 * points && item.states.size() == points &&
                    item.marks.size() == points && item.steps >= 0,
                Text::tr("it left films of a batch empty"));
        requireStates(item.states);
        requireMarks(item.marks);
    }

    const solver::SolverModule& module_;
};

} // namespace

void requireFilm(const solver::FilmSolver* film) {
    require(film != nullptr, Text::tr("it gave no film"));
}

std::unique_ptr<solver::SolverModule> checkedSolver(const solver::SolverModule& module) {
    return std::make_unique<CheckedModule>(module);
}

} // namespace dipwright
