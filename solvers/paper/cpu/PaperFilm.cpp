#include "paper/cpu/PaperFilm.h"

#include "common/SetupLimits.h"
#include "common/cpu/FlushDenormals.h"
#include "paper/cpu/PaperBand.h"
#include "paper/cpu/SelfContact.h"
#include "parallel/ParallelFor.h"
#include "parallel/Threads.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace dipwright::cpu {

namespace {

constexpr int maximumSweepsPerPass = 8; // more sweeps would recompute too many rows
constexpr int pointsPerBand = 4000;     // a band of fewer points is not worth a thread

void require(bool holds, const char* sentence) {
    if (!holds) {
        throw std::invalid_argument(sentence);
    }
}

class PaperFilm : public solver::FilmSolver {
public:
    explicit PaperFilm(PaperKernels kernels) : kernels_(std::move(kernels)) {}

    void begin(const solver::DipSetup& setup) override;
    solver::DipState advance(int maximumSteps) override;
    void read(std::span<float> positions, std::span<solver::PointState> states) const override;

private:
    void layFlat(const std::vector<std::uint8_t>& pinned);
    void cutIntoBands(int threads);
    void step();
    void sweep(double descent);
    void sweepWithSelfContact(double descent);
    void pass(const PaperPass& pass);
    PaperPass passAt(double descent) const;
    FilmPoints pointsAt(double descent) const;
    void keepApart(const FilmPoints& before, const FilmPoints& after);
    void shift(int row, int column, const numerics::Vector3<float>& move);

    PaperKernels kernels_;
    PaperModel model_;
    std::unique_ptr<SharedFilm> shared_;
    std::vector<PaperBand> bands_;
    std::unique_ptr<SelfContact> selfContact_;
    std::unique_ptr<ThreadTeam> team_;
    solver::DipState progress_;
};

void PaperFilm::begin(const solver::DipSetup& setup) {
    numerics::requireValid(setup);
    numerics::requireEven(setup.film);
    numerics::requireStraightDown(setup);
    numerics::requireNoGrowth(setup.settings);
    require(setup.settings.lattice == solver::Lattice::Structural ||
                setup.settings.support == solver::Support::None,
            "this solver does not support isotropic film on water");
    bands_.clear();
    model_ = PaperModel(setup, kernels_);
    const int threads = setup.settings.threads > 0 ? setup.settings.threads : coreCount();
    team_ = std::make_unique<ThreadTeam>(std::min(threads, coreCount()));
    layFlat(setup.pinned);
    cutIntoBands(threads);
    selfContact_ = setup.settings.selfContact ? std::make_unique<SelfContact>(setup.film) : nullptr;
    progress_ = {0, 0, setup.motion.travel <= 0};
}

void PaperFilm::layFlat(const std::vector<std::uint8_t>& pinned) {
    const int rows = model_.grid.rows, columns = model_.grid.columns;
    shared_ = std::make_unique<SharedFilm>();
    shared_->film = FilmRows(rows, model_.stride);
    shared_->activity = FilmActivity(rows, model_.chunks);
    const bool sleeps = model_.settings.relaxation == solver::Relaxation::Jacobi;
    for (int row = 0; row < rows; ++row) {
        std::fill_n(shared_->activity.hasMoved(row), model_.chunks, std::uint8_t(!sleeps));
        const StoredRow points = shared_->film.row(row);
        std::uint8_t* freePoints = shared_->activity.freePoints(row);
        for (int column = 0; column < columns; ++column) {
            const auto index = std::size_t(row) * std::size_t(columns) + std::size_t(column);
            const bool isFree = pinned.empty() || pinned[index] == 0;
            points.weight[column] = isFree ? 1.0f : 0.0f;
            freePoints[column / chunkColumns] += isFree ? 1 : 0;
        }
    }
    shared_->published = {shared_->film, shared_->film};
}

void PaperFilm::cutIntoBands(int threads) {
    const int pairs = (model_.grid.rows + 1) / 2;
    const auto points = model_.grid.pointCount();
    const int bands = int(std::clamp<std::size_t>(points / pointsPerBand, 1, std::size_t(threads)));
    const int sweeps = std::min(model_.settings.iterations, maximumSweepsPerPass);
    for (int band = 0; band < bands; ++band) {
        const int first = pairs * band / bands * 2;
        const int last = std::min(model_.grid.rows, pairs * (band + 1) / bands * 2);
        if (first < last) {
            bands_.emplace_back(model_, *shared_, first, last, sweeps);
        }
    }
}

solver::DipState PaperFilm::advance(int maximumSteps) {
    require(team_ != nullptr, "the dip has not begun");
    team_->run([&] {
        for (int i = 0; i < maximumSteps && !progress_.finished; ++i) {
            step();
        }
    });
    return progress_;
}

void PaperFilm::step() {
    const double travel = model_.motion.travel;
    const double descent = std::min(travel, double(progress_.steps + 1) * model_.stepLength());
    if (selfContact_) {
        sweepWithSelfContact(descent);
    } else {
        sweep(descent);
    }
    progress_ = {progress_.steps + 1, descent, descent >= travel};
}

PaperPass PaperFilm::passAt(double descent) const {
    return {false, 0, descent, numerics::bodyFrame<double>(model_.motion, descent)};
}

void PaperFilm::sweep(double descent) {
    PaperPass next = passAt(descent);
    next.predicts = true;
    for (int left = model_.settings.iterations; left > 0; left -= next.sweeps) {
        next.sweeps = std::min(left, maximumSweepsPerPass);
        pass(next);
        next.predicts = false;
    }
}

// Self-contacts may connect distant points of the film, so the bands synchronize after every sweep.
void PaperFilm::sweepWithSelfContact(double descent) {
    PaperPass next = passAt(descent);
    next.predicts = true;
    pass(next);
    selfContact_->find(pointsAt(descent));
    next.predicts = false;
    next.sweeps = 1;
    for (int left = model_.settings.iterations; left > 0; --left) {
        if (selfContact_->hasCandidates()) {
            const FilmPoints before = pointsAt(descent);
            pass(next);
            keepApart(before, pointsAt(descent));
        } else {
            pass(next);
        }
    }
}

// Adds the contacts' corrections to the corrections of the sweep from `before` to `after`. A Jacobi
// sweep averages them with the point's other constraints. A Gauss–Seidel sweep applies them last.
void PaperFilm::keepApart(const FilmPoints& before, const FilmPoints& after) {
    const bool isJacobi = model_.settings.relaxation == solver::Relaxation::Jacobi;
    for (const ContactPush& push : selfContact_->pushes(isJacobi ? before : after)) {
        const int row = int(push.point) / model_.grid.columns;
        const int column = int(push.point) % model_.grid.columns;
        const auto contacts = float(push.contacts);
        numerics::Vector3<float> move = push.sum * (1 / contacts);
        if (isJacobi) {
            const auto swept = after.positions[push.point] - before.positions[push.point];
            const auto& shares = model_.isBorderRow(row) ? model_.borderShare : model_.innerShare;
            const float others = 1 / shares[std::size_t(column)];
            move = (push.sum - swept * contacts) * (1 / (others + contacts));
        }
        shift(row, column, move);
    }
}

void PaperFilm::shift(int row, int column, const numerics::Vector3<float>& move) {
    for (FilmRows* rows : {&shared_->film, &shared_->published[std::size_t(shared_->read)]}) {
        const StoredRow points = rows->row(row);
        points.x[column] += move.x;
        points.y[column] += move.y * model_.vertical;
        points.z[column] += move.z;
    }
    shared_->activity.hasMoved(row)[column / chunkColumns] = 1;
}

void PaperFilm::pass(const PaperPass& pass) {
    shared_->activity.update();
    const auto run = [&](std::size_t band) {
        const FlushDenormals flush;
        bands_[band].run(pass);
    };
    if (bands_.size() == 1) {
        run(0);
    } else {
        parallelForEvenly(std::size_t(0), bands_.size(), run);
    }
    shared_->read = 1 - shared_->read;
}

FilmPoints PaperFilm::pointsAt(double descent) const {
    FilmPoints points;
    points.positions.reserve(model_.grid.pointCount());
    points.weights.reserve(model_.grid.pointCount());
    for (int row = 0; row < model_.grid.rows; ++row) {
        const StoredRow stored = shared_->film.row(row);
        for (int column = 0; column < model_.grid.columns; ++column) {
            points.positions.push_back({float(model_.grid.restX(column) + double(stored.x[column])),
                                        stored.y[column] - stored.sinking[column] * float(descent),
                                        float(model_.grid.restZ(row) + double(stored.z[column]))});
            points.weights.push_back(stored.weight[column]);
        }
    }
    return points;
}

void PaperFilm::read(std::span<float> positions, std::span<solver::PointState> states) const {
    require(shared_ != nullptr, "the dip has not begun");
    require(positions.size() == 3 * model_.grid.pointCount() &&
                (states.empty() || states.size() == model_.grid.pointCount()),
            "the size of the arrays does not match the film");
    const auto columns = std::size_t(model_.grid.columns);
    for (int row = 0; row < model_.grid.rows; ++row) {
        const StoredRow stored = shared_->film.row(row);
        float* position = &positions[3 * std::size_t(row) * columns];
        for (std::size_t column = 0; column < columns; ++column, position += 3) {
            const bool isAdhered = stored.sinking[column] != 0;
            position[0] = float(model_.grid.restX(int(column)) + double(stored.x[column]));
            position[1] = float(double(stored.y[column]) - (isAdhered ? progress_.descent : 0.0));
            position[2] = float(model_.grid.restZ(row) + double(stored.z[column]));
            if (!states.empty()) {
                states[std::size_t(row) * columns + column] =
                    isAdhered ? solver::PointState::Adhered : solver::PointState::Free;
            }
        }
    }
}

} // namespace

std::unique_ptr<solver::FilmSolver> makePaperFilm(Arithmetic arithmetic) {
    return std::make_unique<PaperFilm>(arithmetic == Arithmetic::Vector ? vectorPaperKernels()
                                                                        : scalarPaperKernels());
}

std::string paperFilmInstructionSet() {
    return vectorPaperKernels().instructionSet;
}

} // namespace dipwright::cpu
