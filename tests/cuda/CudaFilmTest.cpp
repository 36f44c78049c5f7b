// Compares the films on the GPU with those on the CPU and of the reference solvers. Skipped without
// a GPU.

#include "TestFolders.h"
#include "dip/Dip.h"
#include "film/FilmGrid.h"
#include "geometry/Shapes.h"
#include "model/TexturedMesh.h"
#include "paper/reference/PlainPaperFilm.h"
#include "production/reference/ReferenceFilm.h"
#include "project/Project.h"
#include "project/ProjectStore.h"
#include "solver/SolverRegistry.h"
#include "solvers/TestFilm.h"

#include <QLibrary>
#include <QStandardPaths>
#include <QTest>

#include <algorithm>
#include <array>
#include <limits>

using namespace dipwright;
using namespace dipwright::test;

namespace {

const QString paper = QStringLiteral("paper-2020");
const QString production = QStringLiteral("production");

struct Body {
    PosedBody posed;
    std::shared_ptr<const DistanceField> own;
    FilledField field{posed, *own};
};

Body bodyOf(const TriangleMesh& mesh, const Immersion& immersion = {},
            const ProcessSettings& process = {}) {
    return {posedBody(mesh, immersion, process),
            std::make_shared<const DistanceField>(buildDistanceField(mesh, 128, {}))};
}

TriangleMesh cone() {
    return coneMesh(pi / 4, 40, 256);
}

Body bodyNamed(const QString& name) {
    if (name == QLatin1String("sphere")) {
        return bodyOf(sphereMesh(35, 128, 256));
    }
    if (name == QLatin1String("cone")) {
        return bodyOf(cone());
    }
    const Project project = loadProject(sampleFolder("/turtle.dipw"));
    return bodyOf(project.model->mesh, project.immersions.front());
}

solver::DipSetup wholeDip(const Body& body, const QString& preset) {
    Project project;
    applyPreset(project, preset);
    return dipSetup(body.posed, body.field, {}, project.film, project.process);
}

// Returns lines that are closest to each other in the middle of the film.
std::vector<double> unevenPlaces(int count, double length) {
    std::vector<double> places;
    for (int line = 0; line < count; ++line) {
        const double along = (2.0 * line - (count - 1)) / (count - 1); // −1 … 1
        places.push_back(length / 2 * (along * (1 + along * along / 2) / 1.5));
    }
    return places;
}

// Returns a dip that is coarse enough for the reference solvers.
solver::DipSetup coarseDip(const Body& body, const QString& preset, double depth) {
    Project project;
    applyPreset(project, preset);
    project.film.width = project.film.height = Millimetres(150);
    project.film.columns = project.film.rows = 61;
    project.process.depth = Millimetres(depth);
    return dipSetup(body.posed, body.field, {}, project.film, project.process);
}

bool haveSameBits(const Ending& a, const Ending& b) {
    return a.states == b.states && a.positions == b.positions &&
           a.progress.steps == b.progress.steps;
}

// Returns the end of a dip with the paper's reference solver.
Ending plainPaperDip(const solver::DipSetup& setup) {
    reference::PlainPaperFilm plain(setup);
    plain.dip();
    Ending end;
    for (std::size_t point = 0; point < setup.film.pointCount(); ++point) {
        const auto place = plain.position(point);
        for (const double coordinate : {place.x, place.y, place.z}) {
            end.positions.push_back(float(coordinate));
        }
        end.states.push_back(plain.isAdhered(point) ? solver::PointState::Adhered
                                                    : solver::PointState::Free);
    }
    return end;
}

// Returns the distance, in mm, between a point and the surface at the end of the dip, minus the
// contact distance.
double clearanceOf(const Ending& end, std::size_t point, const solver::DipSetup& setup) {
    const auto frame = numerics::bodyFrame<double>(setup.motion, setup.motion.travel);
    const auto field = numerics::fieldGrid<double>(setup.field);
    return numerics::sampleField(field, frame.toBody(end.position(point))).distance -
           setup.settings.contactDistance;
}

// Returns the setup with growing film. `isHeld`: whether the film's left side is pinned.
solver::DipSetup growing(solver::DipSetup setup, double rate, bool isHeld) {
    setup.settings.growthRate = rate;
    setup.settings.growthLimit = rate > 0 ? 0.2 : 0;
    if (isHeld) {
        setup.pinned = pinnedPoints({.leftPinned = true}, setup.film);
    }
    return setup;
}

// Requires that the CPU gives the same bits as the GPU.
void requireSameBits(const Ending& gpu, const Ending& cpu) {
    const auto adhered =
        std::count(gpu.states.begin(), gpu.states.end(), solver::PointState::Adhered);
    qInfo("%lld points adhered, %d steps", (long long)adhered, int(gpu.progress.steps));
    QVERIFY(adhered > 100);
    QCOMPARE(gpu.progress.equilibrium.linearIterations, cpu.progress.equilibrium.linearIterations);
    QVERIFY(haveSameBits(gpu, cpu));
}

// Requires positions within 0.02 mm. Requires the same points to be adhered, except points within
// 0.01 mm of touching.
void requireAgreement(const Ending& gpu, const Ending& other, const solver::DipSetup& setup) {
    double farthest = 0, farthestDiffering = 0;
    int differing = 0, adhered = 0;
    for (std::size_t point = 0; point < gpu.states.size(); ++point) {
        farthest = std::max(farthest, length(gpu.position(point) - other.position(point)));
        adhered += gpu.isAdhered(point);
        if (gpu.isAdhered(point) != other.isAdhered(point)) {
            ++differing;
            farthestDiffering = std::max({farthestDiffering, clearanceOf(gpu, point, setup),
                                          clearanceOf(other, point, setup)});
        }
    }
    qInfo("%d points adhered, %d in one film only; largest distance %g mm", adhered, differing,
          farthest);
    QVERIFY(adhered > 100);
    QVERIFY(farthest <= 0.02);
    QVERIFY(farthestDiffering <= 0.01);
}

// Returns the number of NVIDIA GPUs that the driver reports. The plugin is not asked: a plugin that
// fails to find the GPUs must not make the test skip.
int gpusByDriver() {
#ifdef Q_OS_WIN
    QLibrary driver(QStringLiteral("nvcuda"));
#else
    QLibrary driver(QStringLiteral("cuda"), 1);
#endif
    using Init = int(unsigned);
    using Count = int(int*);
    auto* const init = reinterpret_cast<Init*>(driver.resolve("cuInit"));
    auto* const count = reinterpret_cast<Count*>(driver.resolve("cuDeviceGetCount"));
    int gpus = 0;
    return init && count && init(0) == 0 && count(&gpus) == 0 ? gpus : 0;
}

} // namespace

class CudaFilmTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void cudaFilm_dip_equalsTheCpus_data();
    void cudaFilm_dip_equalsTheCpus();
    void cudaFilm_tiltedBody_equalsTheCpus();
    void cudaFilm_unevenLines_equalsTheCpus();
    void cudaFilm_dip_agreesWithTheReference_data();
    void cudaFilm_dip_agreesWithTheReference();
    void cudaFilm_sameDipTwice_givesTheSameBits_data();
    void cudaFilm_sameDipTwice_givesTheSameBits();
    void cudaFilm_peek_showsWholeStepsAndChangesNothing_data() {
        cudaFilm_sameDipTwice_givesTheSameBits_data();
    }
    void cudaFilm_peek_showsWholeStepsAndChangesNothing();
    void cudaFilm_smallerFilmDippedMeanwhile_changesNothing_data() {
        cudaFilm_sameDipTwice_givesTheSameBits_data();
    }
    void cudaFilm_smallerFilmDippedMeanwhile_changesNothing();
    void cudaBatch_unlikeDips_equalsSingleDips_data() {
        cudaFilm_sameDipTwice_givesTheSameBits_data();
    }
    void cudaBatch_unlikeDips_equalsSingleDips();
    void cudaBatch_cancelled_stops();

private:
    Ending dipOnGpu(const solver::DipSetup& setup) const {
        return dip(*registry_.module(QStringLiteral("pbd-cuda")).create(), setup);
    }
    Ending dipOnCpu(const solver::DipSetup& setup) const {
        return dip(*registry_.module(QStringLiteral("pbd-cpu")).create(), setup);
    }

    SolverRegistry registry_;
};

void CudaFilmTest::initTestCase() {
    QStandardPaths::setTestModeEnabled(true);
#ifndef DIPWRIGHT_HAS_CUDA
    QSKIP("no GPU: built without the plugin pbd-cuda");
#endif
    const auto info = registry_.found(QStringLiteral("pbd-cuda"));
    QVERIFY2(info, "the plugin pbd-cuda is built, but not found");
    if (!info->available) {
        QVERIFY(!info->reason.isEmpty());
        QVERIFY2(gpusByDriver() == 0, qPrintable(QStringLiteral("there is a GPU, but the plugin "
                                                                "does not use it: ") +
                                                 info->reason));
        QSKIP(qPrintable(QStringLiteral("no GPU: ") + info->reason));
    }
    qInfo("%s", qPrintable(info->device));
}

void CudaFilmTest::cudaFilm_dip_equalsTheCpus_data() {
    cudaFilm_dip_agreesWithTheReference_data();
    QTest::newRow("turtle, viscous film") << "turtle" << production << 0.0 << false << 0.0;
    QTest::newRow("cone, film that relaxes") << "cone" << production << 0.0 << false << 2.0;
    QTest::newRow("turtle, growing film that relaxes")
        << "turtle" << production << 0.02 << false << 2.0;
}

void CudaFilmTest::cudaFilm_dip_equalsTheCpus() {
    QFETCH(QString, body);
    QFETCH(QString, preset);
    QFETCH(double, growth);
    QFETCH(bool, held);
    QFETCH(double, relaxation);
    const Body dipped = bodyNamed(body);
    solver::DipSetup setup = growing(wholeDip(dipped, preset), growth, held);
    setup.settings.relaxationTime = relaxation;
    requireSameBits(dipOnGpu(setup), dipOnCpu(setup));
}

void CudaFilmTest::cudaFilm_tiltedBody_equalsTheCpus() {
    Project project;
    applyPreset(project, production);
    Immersion immersion;
    immersion.path.kind = PathKind::Tilt;
    immersion.path.angle = Degrees(20);
    const Body body = bodyOf(cone(), immersion, project.process);
    const auto setup = dipSetup(body.posed, body.field, immersion, project.film, project.process);
    QVERIFY(!setup.path.isStraightDown());
    requireSameBits(dipOnGpu(setup), dipOnCpu(setup));
}

void CudaFilmTest::cudaFilm_unevenLines_equalsTheCpus() {
    const Body sphere = bodyNamed(QStringLiteral("sphere"));
    solver::DipSetup setup = wholeDip(sphere, production);
    solver::FilmGrid& film = setup.film;
    film.columnPlaces = unevenPlaces(film.columns, film.width);
    film.rowPlaces = unevenPlaces(film.rows, film.depth);
    requireSameBits(dipOnGpu(setup), dipOnCpu(setup));
}

void CudaFilmTest::cudaFilm_dip_agreesWithTheReference_data() {
    QTest::addColumn<QString>("body");
    QTest::addColumn<QString>("preset");
    QTest::addColumn<double>("growth");     // 1/s
    QTest::addColumn<bool>("held");         // left side pinned
    QTest::addColumn<double>("relaxation"); // s
    const double elastic = std::numeric_limits<double>::infinity();
    for (const QString& preset : {paper, production}) {
        for (const char* body : {"sphere", "cone", "turtle"}) {
            QTest::addRow("%s, %s", body, qPrintable(preset))
                << QString(body) << preset << 0.0 << false << elastic;
        }
    }
    QTest::newRow("sphere, growing film") << "sphere" << production << 0.02 << false << elastic;
    QTest::newRow("sphere, growing film held at one side")
        << "sphere" << production << 0.02 << true << elastic;
}

void CudaFilmTest::cudaFilm_dip_agreesWithTheReference() {
    QFETCH(QString, body);
    QFETCH(QString, preset);
    QFETCH(double, growth);
    QFETCH(bool, held);
    const Body dipped = bodyNamed(body);
    const solver::DipSetup setup =
        growing(coarseDip(dipped, preset, body == QLatin1String("turtle") ? 12 : 30), growth, held);
    const Ending exact =
        preset == paper ? plainPaperDip(setup) : dip(*reference::makeReferenceFilm(), setup);
    requireAgreement(dipOnGpu(setup), exact, setup);
}

void CudaFilmTest::cudaFilm_sameDipTwice_givesTheSameBits_data() {
    QTest::addColumn<QString>("preset");
    for (const QString& preset : {paper, production}) {
        QTest::addRow("%s", qPrintable(preset)) << preset;
    }
}

void CudaFilmTest::cudaFilm_sameDipTwice_givesTheSameBits() {
    QFETCH(QString, preset);
    const Body body = bodyNamed(QStringLiteral("turtle"));
    const solver::DipSetup setup = wholeDip(body, preset);
    const Ending first = dipOnGpu(setup);
    QVERIFY(haveSameBits(first, dipOnGpu(setup)));

    // The result does not depend on the number of steps per call either.
    const auto film = registry_.module(QStringLiteral("pbd-cuda")).create();
    film->begin(setup);
    solver::DipState progress;
    while (!progress.finished) {
        progress = film->advance(7);
    }
    Ending inSmallSteps = ending(*film, setup.film);
    inSmallSteps.progress = progress;
    QVERIFY(haveSameBits(first, inSmallSteps));
}

// A frame of a running dip is the film after a whole number of steps, bit for bit. Reading a frame
// does not change the dip.
void CudaFilmTest::cudaFilm_peek_showsWholeStepsAndChangesNothing() {
    QFETCH(QString, preset);
    const Body body = bodyNamed(QStringLiteral("sphere"));
    const solver::DipSetup setup = wholeDip(body, preset);
    const Ending runIsolated = dipOnGpu(setup);
    const auto shown = registry_.module(QStringLiteral("pbd-cuda")).create();
    const auto readAlong = registry_.module(QStringLiteral("pbd-cuda")).create();
    shown->begin(setup);
    readAlong->begin(setup);
    solver::DipState progress, reached;
    Ending frame = ending(*shown, setup.film);
    int frames = 0;
    while (!progress.finished) {
        frame.progress = progress;
        if (shown->peek(frame.positions, frame.states, frame.progress)) {
            QVERIFY(frame.progress.steps < progress.steps);
            reached = readAlong->advance(int(frame.progress.steps - reached.steps));
            Ending then = ending(*readAlong, setup.film);
            then.progress = reached;
            QVERIFY(haveSameBits(frame, then));
            QCOMPARE(frame.progress.descent, reached.descent);
            ++frames;
        }
        progress = shown->advance(2);
    }
    QVERIFY(frames > 5);
    Ending end = ending(*shown, setup.film);
    end.progress = progress;
    QVERIFY(haveSameBits(end, runIsolated));
}

// A job's film runs at the same time as the coarser films that estimate the numerical error.
void CudaFilmTest::cudaFilm_smallerFilmDippedMeanwhile_changesNothing() {
    QFETCH(QString, preset);
    const Body body = bodyNamed(QStringLiteral("sphere"));
    const solver::DipSetup setup = wholeDip(body, preset);
    const auto film = registry_.module(QStringLiteral("pbd-cuda")).create();
    const auto smaller = registry_.module(QStringLiteral("pbd-cuda")).create();
    film->begin(setup);
    solver::DipState progress = film->advance(3);
    smaller->begin(coarseDip(body, preset, 8));
    smaller->advance(3);
    while (!progress.finished) {
        progress = film->advance(1000);
    }
    Ending end = ending(*film, setup.film);
    end.progress = progress;
    QVERIFY(haveSameBits(end, dipOnGpu(setup)));
}

// Bodies, films, fields and settings of the dips differ. They are too many for one launch on a GPU
// with fewer multiprocessors.
void CudaFilmTest::cudaBatch_unlikeDips_equalsSingleDips() {
    QFETCH(QString, preset);
    const std::array bodies{bodyNamed(QStringLiteral("sphere")),
                            bodyNamed(QStringLiteral("turtle"))};
    std::vector<solver::BatchItem> items;
    for (int number = 0; number < 80; ++number) {
        solver::DipSetup setup =
            coarseDip(bodies[std::size_t(number / 2 % 2)], preset, 4 + 3 * (number % 5));
        setup.motion.start[0] += number / 8;
        if (number % 3 == 0) {
            setup.film.columns -= 8;
        } else if (number % 3 == 1) {
            setup.settings.contactTravel *= 0.7;
        }
        items.emplace_back().setup = setup;
    }
    QVERIFY(registry_.module(QStringLiteral("pbd-cuda")).runBatch(items, nullptr, nullptr));
    for (const solver::BatchItem& item : items) {
        const Ending single = dipOnGpu(item.setup);
        QCOMPARE(item.steps, single.progress.steps);
        QVERIFY(item.states == single.states);
        QVERIFY(item.positions == single.positions);
    }
}

void CudaFilmTest::cudaBatch_cancelled_stops() {
    const Body body = bodyNamed(QStringLiteral("sphere"));
    std::vector<solver::BatchItem> items(2);
    items[0].setup = items[1].setup = wholeDip(body, paper);
    int questions = 0;
    const auto cancelledLater = [](void* context) { return ++*static_cast<int*>(context) > 2; };
    QVERIFY(
        !registry_.module(QStringLiteral("pbd-cuda")).runBatch(items, cancelledLater, &questions));
    QCOMPARE(questions, 3);
}

QTEST_GUILESS_MAIN(CudaFilmTest)
#include "CudaFilmTest.moc"
