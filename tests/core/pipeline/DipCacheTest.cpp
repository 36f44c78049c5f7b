// Tests the dip cache beside a project. With unchanged inputs it gives the same sheets as a fresh
// run, it keeps its size limit, and damage does no harm.
#include "pipeline/DipCache.h"
#include "BallJob.h"
#include "TestFolders.h"

#include "TestFiles.h"
#include "WholeSample.h"
#include "base/Error.h"
#include "pipeline/Pipeline.h"

#include <QGuiApplication>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>
#include <random>

using namespace dipwright;
using namespace dipwright::test;

namespace {

// A ball that is dipped twice, with film that grows.
Project twoDips() {
    Project project = ballJob();
    project.film.columns = project.film.rows = 31;
    project.film.growthRate = 0.01;
    project.film.growthLimit = 0.05;
    project.immersions.resize(2);
    project.immersions[1].rotation = {Degrees(180), Degrees(0), Degrees(0)};
    return project;
}

void compareFilms(const LaidFilm& now, const LaidFilm& before) {
    QVERIFY(now.film().grid == before.film().grid);
    QVERIFY(now.film().positions == before.film().positions);
    QVERIFY(now.film().states == before.film().states);
    QVERIFY(now.film().marks == before.film().marks);
    QVERIFY(now.film().grown == before.film().grown);
    QVERIFY(!now.film().grown.empty());
    QCOMPARE(now.film().steps, before.film().steps);
}

} // namespace

class DipCacheTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        registry_ = std::make_unique<SolverRegistry>(QStringList{pluginFolder()});
        job_ = twoDips();
        result_ = runJob(job_, *registry_, {}, nullptr, {});
        path_ = folder_.filePath(QStringLiteral("ball.dipw"));
        file_ = folder_.filePath(QStringLiteral("ball.dips"));
    }
    void init() { QFile::remove(file_); }

    void dipCacheFile_liesBesideTheProject() {
        QCOMPARE(dipCacheFile(QStringLiteral("/jobs/cow.dipw")), QStringLiteral("/jobs/cow.dips"));
        QCOMPARE(dipCacheFile(QStringLiteral("/jobs/v1.2.dipw")),
                 QStringLiteral("/jobs/v1.2.dips"));
        QCOMPARE(dipCacheFile(QStringLiteral("/jobs/cow")), QStringLiteral("/jobs/cow.dips"));
        QVERIFY(!cachedDips(job_, *registry_, path_, {}));
        cacheDips(result_, path_);
        QCOMPARE(filesBelow(folder_.path()), QStringList{QStringLiteral("ball.dips")});
    }

    void cachedDips_sameInputs_giveTheSheetsOfAFreshRun() {
        cacheDips(result_, path_);
        Project opened = job_; // a project from a file has another model object
        opened.model = std::make_shared<const TexturedMesh>(*job_.model);
        const auto kept = cachedDips(opened, *registry_, path_, {});
        QVERIFY(kept);
        JobOptions options;
        bool isDipped = false;
        options.observer = [&](std::size_t, const FilmFrame&) { isDipped = true; };
        const JobResult now = runJob(opened, *registry_, options, kept.get(), {});
        QVERIFY(!isDipped);
        QCOMPARE(now.immersions.size(), result_.immersions.size());
        for (std::size_t number = 0; number < now.immersions.size(); ++number) {
            const ImmersionResult& dip = now.immersions[number];
            const ImmersionResult& before = result_.immersions[number];
            compareFilms(*dip.laid, *before.laid);
            QCOMPARE(dip.sheet.image, before.sheet.image);
            QCOMPARE(dip.sheet.job.hash, before.sheet.job.hash);
            QCOMPARE(dip.coverage->share, before.coverage->share);
            QCOMPARE(dip.readBack->samples, before.readBack->samples);
            QCOMPARE(int(dip.verdict.advice), int(before.verdict.advice));
            QCOMPARE(dip.numericalError->offBy.percentile95,
                     before.numericalError->offBy.percentile95);
        }
        QCOMPARE(now.proof, result_.proof);
        QCOMPARE(now.coverageTotal, result_.coverageTotal);
    }

    // Dips that a server simulated with a solver that does not exist here.
    void cachedDipsOf_solverFromElsewhere_giveTheSheetsOfItsRun() {
        JobResult there = result_;
        there.chosenSolver = QStringLiteral("elsewhere");
        there.project.process.solver = QStringLiteral("auto");
        for (ImmersionResult& dip : there.immersions) {
            dip.solver.id = there.chosenSolver;
        }
        cacheDips(there, path_);
        QVERIFY(!cachedDips(there.project, *registry_, path_, {}));
        const auto fetched = cachedDipsOf(there.project, there.immersions[0].solver, path_, {});
        QVERIFY(fetched);
        JobOptions options;
        bool isDipped = false;
        options.observer = [&](std::size_t, const FilmFrame&) { isDipped = true; };
        for (const bool refines : {false, true}) {
            options.refines = refines;
            const JobResult now = runJob(there.project, *registry_, options, fetched.get(), {});
            QVERIFY(!isDipped);
            QCOMPARE(now.immersions[0].sheet.image, result_.immersions[0].sheet.image);
            QCOMPARE(now.solver.id, there.chosenSolver);
            QCOMPARE(now.chosenSolver, there.chosenSolver);
        }
        // The project may even name a solver that is missing here.
        auto named = std::make_shared<JobResult>(*fetched);
        named->project.process.solver = named->wantedSolver = there.chosenSolver;
        QCOMPARE(runJob(named->project, *registry_, options, named.get(), {}).chosenSolver,
                 there.chosenSolver);
        QVERIFY(!isDipped);
        // What has to be simulated here is simulated as a whole here.
        options.refines = false;
        Project turned = there.project;
        turned.immersions[1].rotation[0] = Degrees(170);
        const JobResult now = runJob(turned, *registry_, options, fetched.get(), {});
        QVERIFY(isDipped);
        for (const ImmersionResult& dip : now.immersions) {
            QVERIFY(dip.solver.id != there.chosenSolver);
        }
    }

    void cachedDips_otherInputs_areNotFound_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("value");
        const auto row = [](const char* path, const char* value) {
            QTest::newRow(path) << QString(path) << QString(value);
        };
        row("immersions[0].rotation_deg", "0;10;0");
        row("immersions[1].offset_mm", "3;4");
        row("body.sdf_resolution", "65");
        row("film.swell", "1.1x1.1");
        row("film.points", "32x31");
        row("film.growth_limit", "0.2");
        row("film.gathering_stretch", "0.75");
        row("film.edges.left", "pinned");
        row("process.overhang_deg", "30");
        row("process.depth_mm", "12");
        row("sheet.dpi", "100");
        row("ink.limit", "1.5");
        row("ink.tones", "cyan 0.3 0.5 0.1 2.5");
        row("process.solver", "auto");
    }

    // The cache finds a dip if and only if a run would reuse it.
    void cachedDips_otherInputs_areNotFound() {
        QFETCH(QString, path);
        QFETCH(QString, value);
        cacheDips(result_, path_);
        Project changed = job_;
        setByPath(changed, path, value);
        QVERIFY(changed != job_);
        bool isSame = true;
        for (std::size_t number = 0; number < job_.immersions.size(); ++number) {
            isSame = isSame && dipInputs(changed, number, result_.chosenSolver) ==
                                   dipInputs(job_, number, result_.chosenSolver);
        }
        QCOMPARE(cachedDips(changed, *registry_, path_, {}) != nullptr, isSame);
    }

    // The verdict does not judge masked surface, so masks decide how far a film is refined.
    void cachedDips_automaticCellsAndOtherMasksOrMaterials_areNotFound() {
        Project automatic = job_;
        automatic.film.resolution = FilmResolution::Automatic;
        JobOptions options;
        options.refines = false;
        options.draftPictures = 0.1;
        cacheDips(runJob(automatic, *registry_, options, nullptr, {}), path_);
        QVERIFY(cachedDips(automatic, *registry_, path_, {}));
        Project masked = automatic;
        masked.masks.emplace_back().path.emplace_back();
        QVERIFY(!cachedDips(masked, *registry_, path_, {}));
        auto renamed = std::make_shared<TexturedMesh>(*job_.model);
        renamed->materials.front().name += QLatin1Char('2');
        automatic.model = renamed;
        QVERIFY(!cachedDips(automatic, *registry_, path_, {}));
    }

    void cachedDips_otherBody_areNotFound() {
        cacheDips(result_, path_);
        auto dented = std::make_shared<TexturedMesh>(*job_.model);
        dented->mesh.positions.front().y() += 0.001F;
        Project changed = job_;
        changed.model = dented;
        QVERIFY(!cachedDips(changed, *registry_, path_, {}));
    }

    void cacheDips_dipsOfFallbackSolver_areNotKept() {
        JobResult other = result_;
        other.immersions[1].solver.id = QStringLiteral("another");
        cacheDips(other, path_);
        QVERIFY(!cachedDips(job_, *registry_, path_, {}));
    }

    void cacheDips_full_removesTheOldest() {
        cacheDips(result_, path_);
        const qint64 bytes = QFileInfo(file_).size();
        JobResult turned = result_;
        turned.project.immersions[0].offset = {Millimetres(1), Millimetres(0)};
        turned.immersions[0].immersion = turned.project.immersions[0];
        cacheDips(turned, path_);
        QVERIFY(cachedDips(job_, *registry_, path_, {}));
        QVERIFY(cachedDips(turned.project, *registry_, path_, {}));
        turned.project.immersions[0].offset = {Millimetres(2), Millimetres(0)};
        turned.immersions[0].immersion = turned.project.immersions[0];
        cacheDips(turned, path_, bytes + 1000);
        QVERIFY(QFileInfo(file_).size() <= bytes + 1000);
        QVERIFY(cachedDips(turned.project, *registry_, path_, {}));
        QVERIFY(!cachedDips(job_, *registry_, path_, {}));
    }

    void cacheDips_largerThanTheLimit_writesNothing() {
        cacheDips(result_, path_, 1000);
        QVERIFY(!QFile::exists(file_));
    }

    void cacheDips_alreadyKept_doesNotWriteAgain() {
        cacheDips(result_, path_);
        QFile file(file_);
        QVERIFY(file.open(QIODevice::ReadWrite));
        const QDateTime old = QDateTime::fromSecsSinceEpoch(1000);
        QVERIFY(file.setFileTime(old, QFileDevice::FileModificationTime));
        file.close();
        cacheDips(result_, path_);
        QCOMPARE(QFileInfo(file_).lastModified(), old);
    }

    void cachedDips_truncatedFile_isRefusedAndReplaced() {
        cacheDips(result_, path_);
        const QByteArray whole = bytesOf(file_);
        for (qsizetype length = 0; length < whole.size(); length += whole.size() / 60 + 1) {
            writeFile(file_, whole.first(length));
            QVERIFY_EXCEPTION_THROWN(cachedDips(job_, *registry_, path_, {}), Error);
        }
        cacheDips(result_, path_); // replaces the damaged file
        QVERIFY(cachedDips(job_, *registry_, path_, {}));
    }

    void cachedDips_damagedFile_isRefusedOrHarmless() {
        cacheDips(result_, path_);
        const QByteArray whole = bytesOf(file_);
        std::mt19937 random(1);
        for (int round = 0; round < sampleOf(40, 200); ++round) {
            QByteArray damaged = whole;
            for (int flips = 0; flips < 3; ++flips) {
                damaged[qsizetype(random() % std::uint32_t(whole.size()))] ^=
                    char(1U << (random() % 8));
            }
            writeFile(file_, damaged);
            try {
                const auto kept = cachedDips(job_, *registry_, path_, {});
                if (kept) { // only a name or a date in the zip is damaged
                    compareFilms(*kept->immersions[0].laid, *result_.immersions[0].laid);
                    compareFilms(*kept->immersions[1].laid, *result_.immersions[1].laid);
                }
            } catch (const Error&) {
                continue;
            }
        }
    }

    void cachedDips_valuesOutOfRange_areRefused() {
        const auto isRefused = [&](const std::function<void(DippedFilm&)>& change) {
            DippedFilm film = result_.immersions[0].laid->film();
            change(film);
            JobResult forged = result_;
            forged.immersions[0].laid = std::make_shared<const LaidFilm>(
                result_.immersions[0].body, std::move(film), result_.immersions[0].laid->contact());
            QFile::remove(file_);
            cacheDips(forged, path_);
            try {
                cachedDips(job_, *registry_, path_, {});
            } catch (const Error&) {
                return true;
            }
            return false;
        };
        QVERIFY(!isRefused([](DippedFilm&) {}));
        QVERIFY(isRefused([](DippedFilm& film) {
            film.positions[40].x() = std::numeric_limits<float>::quiet_NaN();
        }));
        QVERIFY(isRefused([](DippedFilm& film) {
            film.positions[40].z() = std::numeric_limits<float>::infinity();
        }));
        QVERIFY(isRefused([](DippedFilm& film) { film.positions[40].y() = 5e5F; })); // not stable
        QVERIFY(isRefused([](DippedFilm& film) { film.states[7] = solver::PointState(9); }));
        QVERIFY(isRefused([](DippedFilm& film) { film.marks[7] = 64; }));
        QVERIFY(isRefused([](DippedFilm& film) { film.grown[3] = -1; }));
        QVERIFY(isRefused([](DippedFilm& film) { film.steps = -1; }));
        QVERIFY(isRefused([](DippedFilm& film) { // no film on the body at all
            std::fill(film.states.begin(), film.states.end(), solver::PointState::Free);
        }));
    }

    void cachedDips_otherFileOrFolderThere_isRefused() {
        writeFile(file_, "not a zip");
        QVERIFY_EXCEPTION_THROWN(cachedDips(job_, *registry_, path_, {}), Error);
        QFile::remove(file_);
        QVERIFY(QDir().mkdir(file_));
        QVERIFY_EXCEPTION_THROWN(cachedDips(job_, *registry_, path_, {}), Error);
        QVERIFY_EXCEPTION_THROWN(cacheDips(result_, path_), Error);
        QVERIFY(QDir().rmdir(file_));
    }

private:
    std::unique_ptr<SolverRegistry> registry_;
    Project job_;
    JobResult result_;
    QTemporaryDir folder_;
    QString path_, file_;
};

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication application(argc, argv);
    DipCacheTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "DipCacheTest.moc"
