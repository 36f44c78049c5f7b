// The loop that runs a dip, tested with scripted solvers.
#include "dip/Dip.h"
#include "DippedByHand.h"
#include "base/Error.h"
#include "geometry/Shapes.h"

#include <QtTest>

#include <limits>
#include <optional>
#include <set>

using namespace dipwright;

namespace {

// Tells the scripted solver what to do, and records the calls that it gets.
struct Script {
    int steps = 50;
    bool touches = true;
    bool unstable = false;
    int throwsAtStep = -1;
    int begun = 0;
    int advanced = 0;
    int asked = 0; // calls of advance()
    bool showsLate = false;
    solver::EquilibriumAccount equilibrium;
    std::uint8_t mark = 0; // mark of the first film point
    solver::DipSetup setup;
};

// A solver whose film lies flat on the water; the film's middle point sticks to the body's lowest
// point.
class ScriptedSolver : public solver::FilmSolver {
public:
    explicit ScriptedSolver(Script& script) : script_(script) {}

    void begin(const solver::DipSetup& setup) override {
        ++script_.begun;
        script_.setup = setup;
    }
    solver::DipState advance(int maximumSteps) override {
        ++script_.asked;
        for (int step = 0; step < maximumSteps && done_ < script_.steps; ++step) {
            if (done_ == script_.throwsAtStep) {
                throw std::runtime_error("the film is upset");
            }
            ++done_;
            ++script_.advanced;
        }
        return {done_, script_.setup.motion.travel * done_ / script_.steps, done_ == script_.steps,
                script_.equilibrium};
    }
    void read(std::span<float> positions, std::span<solver::PointState> states) const override {
        const solver::FilmGrid& grid = script_.setup.film;
        for (std::size_t point = 0; point < grid.pointCount(); ++point) {
            const Eigen::Vector2f rest = restPosition(grid, point);
            positions[3 * point] = rest.x();
            positions[3 * point + 1] =
                script_.unstable ? std::numeric_limits<float>::quiet_NaN() : 0;
            positions[3 * point + 2] = rest.y();
            states[point] = solver::PointState::Free;
        }
        if (script_.touches) {
            states[grid.pointCount() / 2] = solver::PointState::Adhered;
        }
    }

    void readMarks(std::span<std::uint8_t> marks) const override {
        FilmSolver::readMarks(marks);
        marks[0] = script_.mark;
    }
    bool peek(std::span<float> positions, std::span<solver::PointState> states,
              solver::DipState& shown) override {
        if (!script_.showsLate) {
            return FilmSolver::peek(positions, states, shown);
        }
        if (!underWay_) {
            underWay_ = shown;
            return false;
        }
        shown = *std::exchange(underWay_, std::nullopt);
        std::ranges::fill(positions, float(shown.steps));
        return true;
    }

private:
    Script& script_;
    std::optional<solver::DipState> underWay_;
    int done_ = 0;
};

class ScriptedModule : public solver::SolverModule {
public:
    explicit ScriptedModule(Script& script) : script_(script) {}

    const char* unavailableReason() const override { return nullptr; }
    const char* device() const override { return "paper and pencil"; }
    std::unique_ptr<solver::FilmSolver> create() const override {
        return std::make_unique<ScriptedSolver>(script_);
    }
    bool runBatch(std::span<solver::BatchItem>, solver::CancelFunction, void*) const override {
        return false;
    }

private:
    Script& script_;
};

struct Dip {
    PosedBody body = test::posed(boxMesh({30, 40, 50}));
    DistanceField field;
    Immersion immersion;
    FilmSettings film;
    ProcessSettings process;
    Progress progress;

    // A box traps no air, so the solver gets `field` itself.
    solver::DipSetup setup() const {
        return dipSetup(body, FilledField(body, field), immersion, film, process);
    }
    DippedFilm run(Script& script, const FilmObserver& observer = {}) const {
        return simulateDip(body, field, immersion, film, process, ScriptedModule(script), progress,
                           observer);
    }
};

template <typename Work>
QString refusal(const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.sentence();
    }
    return {};
}

} // namespace

class DipTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void dipSetup_startsWithTheBodyJustAboveTheWater();
    void dipSetup_travel_followsMarginOrDepth();
    void dipSetup_carriesTheFilmSettings();
    void simulateDip_result_isInThePoseFrame();
    void simulateDip_result_carriesEquilibriumAndMarks();
    void dippedFilm_ofBatch_equalsTheSingleDip();
    void simulateDip_progress_growsTo1();
    void simulateDip_observer_seesTheLastFrame();
    void simulateDip_lateFrames_carryTheirOwnSteps();
    void simulateDip_gradedFilm_keepsItsGrid();
    void simulateDip_cancelled_stopsWithTheNextSteps();
    void simulateDip_failingSolver_throwsError();
    void simulateDip_unstableFilm_throwsError();
    void simulateDip_bodyNeverTouches_throwsError();
    void simulateDip_bodyBesideTheFilm_isRefusedWithoutSimulation();
};

void DipTest::dipSetup_startsWithTheBodyJustAboveTheWater() {
    Dip dip;
    dip.immersion.rotation = {Degrees(20), Degrees(30), Degrees(-40)};
    dip.immersion.offset = {Millimetres(12), Millimetres(-7)};
    dip.body = posedBody(boxMesh({30, 40, 50}), dip.immersion);
    const auto motion = dip.setup().motion;
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rotation(motion.rotation.data());
    const Eigen::Vector3d start(motion.start.data());
    double lowest = 1000;
    const TriangleMesh box = boxMesh({30, 40, 50});
    for (std::size_t corner = 0; corner < box.positions.size(); ++corner) {
        const Eigen::Vector3d world = rotation * box.positions[corner].cast<double>() + start;
        const Eigen::Vector3d pose = dip.body.mesh.positions[corner].cast<double>();
        QVERIFY((world - pose - Eigen::Vector3d(12, startHeight, -7)).norm() < 1e-4);
        lowest = std::min(lowest, world.y());
    }
    QVERIFY(std::abs(lowest - startHeight) < 1e-4);
}

void DipTest::dipSetup_travel_followsMarginOrDepth() {
    Dip dip;
    dip.process.margin = Millimetres(3);
    const auto travel = [&] { return dip.setup().motion.travel; };
    QVERIFY(std::abs(travel() - (startHeight + 40 + 3)) < 1e-4);
    dip.process.depth = Millimetres(12);
    QVERIFY(std::abs(travel() - (startHeight + 12)) < 1e-4);
}

void DipTest::dipSetup_carriesTheFilmSettings() {
    Dip dip;
    dip.film.swellX = 1.25;
    dip.film.edges.topPinned = true;
    dip.film.relaxationTime = Seconds(0);
    dip.film.contactDistance = Millimetres(0.25);
    dip.film.growthRate = 0.004;
    dip.film.growthLimit = 0.2;
    dip.film.gripFade = Degrees(9);
    dip.film.gatheringStretch = 0.75;
    const auto setup = dip.setup();
    QCOMPARE(setup.film.width, 262.5);
    QCOMPARE(setup.pinned.size(), setup.film.pointCount());
    QCOMPARE(int(setup.pinned.front()), 1);
    QCOMPARE(int(setup.pinned.back()), 0);
    QCOMPARE(setup.settings.relaxationTime, 0.0);
    QCOMPARE(setup.settings.contactDistance, 0.25);
    QCOMPARE(setup.settings.growthRate, 0.004);
    QCOMPARE(setup.settings.growthLimit, 0.2);
    QCOMPARE(setup.settings.gripFade, pi / 20);
    QCOMPARE(setup.settings.gatheringStretch, 0.75);
    // Settings that are not set keep the solver's defaults.
    const auto usual = dipSetup(dip.body, FilledField(dip.body, dip.field), dip.immersion, {}, {});
    QCOMPARE(usual.settings.gripFade, solver::Settings().gripFade);
    QCOMPARE(usual.settings.gatheringStretch, solver::Settings().gatheringStretch);
    QCOMPARE(usual.settings.growthLimit, 0.0);
}

void DipTest::simulateDip_result_isInThePoseFrame() {
    Dip dip;
    dip.immersion.offset = {Millimetres(12), Millimetres(-7)};
    Script script;
    const DippedFilm film = dip.run(script);
    QCOMPARE(film.steps, std::int64_t(50));
    QCOMPARE(film.positions.size(), film.grid.pointCount());
    // The film stayed on the water, and the body's lowest point is now 42 mm below it.
    const Eigen::Vector2f rest = restPosition(film.grid, 5);
    QVERIFY((film.positions[5] - Eigen::Vector3f(rest.x() - 12, 42, rest.y() + 7)).norm() < 1e-3f);
    QVERIFY(film.adhered(film.grid.pointCount() / 2));
    QVERIFY(!film.adhered(0));
}

void DipTest::simulateDip_result_carriesEquilibriumAndMarks() {
    Dip dip;
    Script script;
    const DippedFilm sure = dip.run(script);
    QCOMPARE(sure.equilibrium.stepsWithout, std::int64_t(0));
    QCOMPARE(std::ranges::count(sure.marks, 0), std::ptrdiff_t(sure.grid.pointCount()));
    script.equilibrium = {3, 0.25, 900};
    script.mark = std::uint8_t(solver::PointMark::LetGo) | std::uint8_t(solver::PointMark::Torn);
    const DippedFilm film = dip.run(script);
    QCOMPARE(film.equilibrium.stepsWithout, std::int64_t(3));
    QCOMPARE(film.equilibrium.worstForceLeft, 0.25);
    QCOMPARE(film.equilibrium.linearIterations, std::int64_t(900));
    QVERIFY(has(film.marks[0], solver::PointMark::LetGo));
    QVERIFY(has(film.marks[0], solver::PointMark::Torn));
    QVERIFY(!has(film.marks[0], solver::PointMark::Unbalanced));
    QCOMPARE(int(film.marks[1]), 0);
}

void DipTest::dippedFilm_ofBatch_equalsTheSingleDip() {
    Dip dip;
    dip.immersion.offset = {Millimetres(12), Millimetres(-7)};
    Script script;
    const DippedFilm alone = dip.run(script);

    solver::BatchItem item;
    item.setup = dip.setup();
    item.positions.resize(3 * item.setup.film.pointCount());
    item.states.resize(item.setup.film.pointCount());
    ScriptedSolver solver(script);
    solver.begin(item.setup);
    item.steps = solver.advance(script.steps).steps;
    solver.read(item.positions, item.states);
    const DippedFilm batched = dippedFilm(item, dip.immersion);
    QCOMPARE(batched.steps, alone.steps);
    QVERIFY(batched.positions == alone.positions);
    QVERIFY(batched.states == alone.states);
}

void DipTest::simulateDip_progress_growsTo1() {
    Dip dip;
    std::vector<double> shares;
    dip.progress.report = [&](double share, const QString& text) {
        QVERIFY(!text.isEmpty());
        shares.push_back(share);
    };
    Script script;
    dip.run(script);
    QVERIFY(std::is_sorted(shares.begin(), shares.end()));
    QCOMPARE(shares.front(), 0.0);
    QCOMPARE(shares.back(), 1.0);
}

void DipTest::simulateDip_observer_seesTheLastFrame() {
    Dip dip;
    Script script;
    double descent = -1;
    std::int64_t steps = -1;
    std::set<const float*> buffers;
    dip.run(script, [&](const FilmFrame& frame) {
        QCOMPARE(frame.positions.size(), 3 * script.setup.film.pointCount());
        descent = frame.descent;
        steps = frame.steps;
        buffers.insert(frame.positions.data());
    });
    QCOMPARE(descent, script.setup.motion.travel);
    QCOMPARE(steps, std::int64_t(50));
    QCOMPARE(buffers.size(), std::size_t(1));
}

// A device that computes at the same time as the host shows frames late.
void DipTest::simulateDip_lateFrames_carryTheirOwnSteps() {
    Dip dip;
    Script script;
    script.showsLate = true;
    std::vector<std::int64_t> steps;
    dip.run(script, [&](const FilmFrame& frame) {
        steps.push_back(frame.steps);
        QCOMPARE(frame.descent, script.setup.motion.travel * double(frame.steps) / 50);
        if (frame.steps < 50) {
            QCOMPARE(frame.positions.front(), float(frame.steps));
        }
    });
    QVERIFY(steps.size() >= 2);
    QCOMPARE(steps.front(), std::int64_t(0));
    QCOMPARE(steps.back(), std::int64_t(50));
}

void DipTest::simulateDip_gradedFilm_keepsItsGrid() {
    Dip dip;
    dip.film.resolution = FilmResolution::Cell;
    dip.film.cell = Millimetres(4);
    dip.film.edges.bottomPinned = true;
    Script script;
    const DippedFilm film =
        dip.run(script, [&](const FilmFrame& frame) { QCOMPARE(frame.grid, script.setup.film); });
    QVERIFY(!film.grid.isEven());
    QCOMPARE(film.grid, script.setup.film);
    QCOMPARE(film.positions.size(), film.grid.pointCount());
    QCOMPARE(std::ranges::count(script.setup.pinned, 1), std::ptrdiff_t(film.grid.columns));
}

void DipTest::simulateDip_cancelled_stopsWithTheNextSteps() {
    Dip dip;
    Script script;
    script.steps = 1 << 20;
    int askedWhenCancelled = -1;
    dip.progress.report = [&](double, const QString&) {
        if (script.advanced >= 20 && askedWhenCancelled < 0) {
            askedWhenCancelled = script.asked;
            dip.progress.cancelToken.cancel();
        }
    };
    QVERIFY_EXCEPTION_THROWN(dip.run(script), Cancelled);
    QVERIFY(askedWhenCancelled > 0);
    QVERIFY(script.asked <= askedWhenCancelled + 1);
}

void DipTest::simulateDip_failingSolver_throwsError() {
    Dip dip;
    dip.immersion.name = "Top";
    Script script;
    script.throwsAtStep = 10;
    const QString sentence = refusal([&] { dip.run(script); });
    QVERIFY2(sentence.contains("the film is upset"), qPrintable(sentence));
    QVERIFY2(sentence.contains("(Top)"), qPrintable(sentence));
}

void DipTest::simulateDip_unstableFilm_throwsError() {
    Dip dip;
    Script script;
    script.unstable = true;
    const QString sentence = refusal([&] { dip.run(script); });
    QVERIFY2(sentence.contains("time step"), qPrintable(sentence));
}

void DipTest::simulateDip_bodyNeverTouches_throwsError() {
    Dip dip;
    Script script;
    script.touches = false;
    const QString sentence = refusal([&] { dip.run(script); });
    QVERIFY2(sentence.contains("does not meet the film"), qPrintable(sentence));
}

void DipTest::simulateDip_bodyBesideTheFilm_isRefusedWithoutSimulation() {
    Dip dip;
    dip.immersion.offset = {Millimetres(121), Millimetres(0)};
    Script script;
    const QString sentence = refusal([&] { dip.run(script); });
    QVERIFY2(sentence.contains("does not meet the film"), qPrintable(sentence));
    QCOMPARE(script.begun, 0);
}

QTEST_APPLESS_MAIN(DipTest)
#include "DipTest.moc"
