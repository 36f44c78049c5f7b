// Tests runJob(): what it computes again, what it reuses, and when the CPU takes over.
#include "pipeline/Pipeline.h"
#include "HollowBodies.h"
#include "PluginFolder.h"
#include "TestFiles.h"
#include "TestFolders.h"
#include "TexturedBall.h"
#include "base/Error.h"
#include "disk/FolderTransaction.h"
#include "geometry/Shapes.h"
#include "pipeline/DeeperDip.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/Report.h"
#include "pipeline/SheetMemory.h"
#include "pipeline/SmallerFilm.h"
#include "pipeline/ValidateJob.h"
#include "pipeline/WriteResults.h"
#include "project/DipKeys.h"
#include "results/Results.h"
#include "texture/Chessboard.h"

#include <QCryptographicHash>
#include <QGuiApplication>
#include <QJsonArray>
#include <QPainter>
#include <QProcess>
#include <QStandardPaths>
#include <QtTest>

using namespace dipwright;
using namespace dipwright::test;

namespace {

bool hasReason(const Verdict& verdict, VerdictReason::Kind kind) {
    return std::any_of(verdict.reasons.begin(), verdict.reasons.end(),
                       [&](const VerdictReason& reason) { return reason.kind == kind; });
}

Project ballJob() {
    Project project;
    project.name = QStringLiteral("ball");
    project.model = texturedBall(QColor(200, 80, 20));
    project.film.width = project.film.height = Millimetres(90);
    project.film.columns = project.film.rows = 31;
    project.fieldResolution = 64;
    project.sheet.resolution = DotsPerInch(72);
    project.immersions.resize(2);
    project.immersions[1].name = QStringLiteral("Turned");
    project.immersions[1].rotation = {Degrees(180), Degrees(0), Degrees(0)};
    return project;
}

std::shared_ptr<const TexturedMesh> plain(const TriangleMesh& mesh) {
    TexturedMesh model;
    model.mesh = mesh;
    model.materials.resize(1);
    model.material.resize(mesh.triangles.size());
    model.textureCoordinates.resize(mesh.triangles.size());
    for (auto& corners : model.textureCoordinates) {
        corners.fill(Eigen::Vector2f::Constant(std::nanf("")));
    }
    model.chart = findCharts(model);
    return std::make_shared<const TexturedMesh>(model);
}

QByteArray sha256(const QByteArray& bytes) {
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex();
}

QString builtModule(const QString& name) {
    return badModuleFolder("/") + PluginFolder::moduleName(name);
}

} // namespace

class PipelineTest : public QObject {
    Q_OBJECT

private slots:
    // Project files may have equal names in different folders, or names that are unusable for a
    // folder.
    void resultFolders_clashingNames_areDistinct() {
        QCOMPARE(
            resultFolders({"a/job.dipw", "b/Job.dipw", "..dipw", "...dipw", ".dipw"}, "out"),
            QStringList({"out/job", "out/Job-2", "out/project", "out/project-2", "out/project-3"}));
    }

    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        registry_ = std::make_unique<SolverRegistry>(QStringList{pluginFolder()});
        job_ = ballJob();
        first_ = runJob(job_, *registry_, {}, nullptr, {});
    }

    void runJob_computesEveryStage() {
        QCOMPARE(first_.solver.id, QStringLiteral("pbd-cpu"));
        QVERIFY(first_.solver.device != QLatin1String("cpu")); // a description, not the id
        QCOMPARE(first_.immersions.size(), 2U);
        for (const ImmersionResult& immersion : first_.immersions) {
            QVERIFY(immersion.body && immersion.laid && immersion.coverage && immersion.texture);
            QVERIFY(immersion.readBack->samples > 0);
            QCOMPARE(immersion.sheet.image.size(), QSize(255, 255));
            QCOMPARE(immersion.sheet.job.project, QStringLiteral("ball"));
        }
        QVERIFY(first_.immersions[0].sheet.job.hash != first_.immersions[1].sheet.job.hash);
        QVERIFY(!first_.proof.isNull());
        QVERIFY(first_.notes.isEmpty());
    }

    void runJob_twoDips_coverMoreThanOne() {
        const double one = first_.immersions[0].coverage->share;
        const double other = first_.immersions[1].coverage->share;
        QVERIFY(one > 0.4 && other > 0.4);
        QVERIFY(first_.coverageTotal > one + 0.1);
        QVERIFY(first_.coverageTotal <= one + other + 0.01);
    }

    // The body passes through film that tears at a tenth of stretch, and stays bare.
    void runJob_weakFilm_mustNotBePrinted() {
        Project job = ballJob();
        job.immersions.resize(1);
        const auto isTornBare = [](const JobResult& result) {
            return hasReason(result.immersions.front().verdict, VerdictReason::Kind::TornBare);
        };
        const JobResult whole = runJob(job, *registry_, {}, nullptr, {});
        QVERIFY(!isTornBare(whole));
        job.process.tearStretch = 1.1;
        const JobResult torn = runJob(job, *registry_, {}, nullptr, {});
        QVERIFY(isTornBare(torn));
        QCOMPARE(torn.immersions.front().verdict.advice, Advice::DoNotPrint);
        const auto painted = [](const JobResult& result) {
            return result.immersions.front().coverage->paintedArea;
        };
        const double lost = painted(whole) - painted(torn);
        QVERIFY(std::abs(torn.immersions.front().coverage->tornBare / lost - 1) < 0.1);
    }

    // A cup, mouth down, with a vent: the film tears at its mouth, and its bottom catches it later.
    void runJob_cupCatchesTornFilm_isToBeChecked() {
        Project job = ballJob();
        job.immersions.resize(1);
        job.model =
            plain(turned({{20, 0}, {20, 40}, {4, 40}, {4, 37}, {17, 37}, {17, 0}, {20, 0}}, 60));
        const JobResult result = runJob(job, *registry_, {}, nullptr, {});
        const Coverage& found = *result.immersions.front().coverage;
        QVERIFY(found.tornBare > 0.5 * 2 * pi * 17 * 37); // half of the inner wall
        QVERIFY(hasReason(result.immersions.front().verdict, VerdictReason::Kind::TornBare));
    }

    // Nothing in a run compares two prints at full strength, so the verdict must.
    void runJob_dipsThatDoNotShare_areToBeChecked() {
        Project job = ballJob();
        job.share.enabled = false;
        const JobResult result = runJob(job, *registry_, {}, nullptr, {});
        QVERIFY(hasReason(result.verdict, VerdictReason::Kind::PaintedTwice));
        QVERIFY(!hasReason(first_.verdict, VerdictReason::Kind::PaintedTwice));
    }

    void runJob_dipThatEndsTooEarly_isToBeChecked() {
        Project job = ballJob();
        job.immersions.resize(1);
        job.process.depth = Millimetres(1);
        const JobResult result = runJob(job, *registry_, {}, nullptr, {});
        QVERIFY(hasReason(result.verdict, VerdictReason::Kind::LittlePainted));
    }

    void runJob_whatCannotBeSeenOrPrinted_isInTheVerdict() {
        const auto verdicts = [&](const auto& change) {
            Project job = ballJob();
            job.immersions.resize(1);
            change(job);
            const JobResult result = runJob(job, *registry_, {}, nullptr, {});
            return std::array{result.immersions.front().verdict, result.verdict};
        };
        const auto white =
            verdicts([](Project& job) { job.model = texturedBall(QColor(Qt::white)); });
        QVERIFY(hasReason(white[0], VerdictReason::Kind::NoInk));
        QCOMPARE(white[0].advice, Advice::DoNotPrint);
        const auto plates = verdicts([](Project& job) { job.sheet.white = WhiteLayer::Last; });
        QVERIFY(hasReason(plates[0], VerdictReason::Kind::LostPlates));
        QVERIFY(!hasReason(plates[0], VerdictReason::Kind::NoInk));
        const auto onColour = [&](const char* colour) {
            return verdicts([colour](Project& job) {
                auto model = std::make_shared<TexturedMesh>(*job.model);
                QImage half(64, 64, QImage::Format_RGBA8888);
                half.fill(Qt::black);
                QPainter(&half).fillRect(0, 0, 32, 64, Qt::white);
                model->textures = {half};
                job.model = model;
                job.baseColour = QString::fromLatin1(colour);
            })[1];
        };
        QVERIFY(!hasReason(onColour("#808080"), VerdictReason::Kind::FaintPicture));
        const Verdict faint = onColour("#282828"), lost = onColour("#080808");
        QVERIFY(hasReason(faint, VerdictReason::Kind::FaintPicture));
        QVERIFY(faint.advice == Advice::CheckFirst && lost.advice == Advice::DoNotPrint);
        const auto plainRedOn = [&](const char* colour) {
            return verdicts([colour](Project& job) {
                job.model = texturedBall(QColor(Qt::red));
                job.baseColour = QString::fromLatin1(colour);
            })[1];
        };
        QCOMPARE(plainRedOn("#080808").advice, Advice::DoNotPrint);
        QVERIFY(!hasReason(plainRedOn("#c0c0c0"), VerdictReason::Kind::FaintPicture));
    }

    // Sheets that were read upwards: the correction would print a mirrored sheet.
    void runJob_mirroringCorrection_isRefused() {
        Project job = ballJob();
        job.asBuilt.parts.resize(1);
        for (int i = 0; i < 25; ++i) {
            const double x = 8.0 * (i % 5 - 2), y = 8.0 * (i / 5 - 2);
            job.asBuilt.places.push_back({1,
                                          1,
                                          {Millimetres(x), Millimetres(y)},
                                          {Millimetres(x), Millimetres(0), Millimetres(y)},
                                          {Millimetres(0), Millimetres(-2 * y)}});
        }
        JobOptions options;
        options.estimatesNumericalError = false;
        runJob(job, *registry_, options, nullptr, {}); // does not correct
        job.asBuilt.corrects = true;
        QVERIFY_EXCEPTION_THROWN(runJob(job, *registry_, options, nullptr, {}), Error);
        QVERIFY_EXCEPTION_THROWN(validateJob(job, *registry_), Error);
    }

    // A part that was dipped with another pose says nothing about the next sheet.
    void runJob_partsOfAnotherDip_doNotCorrect() {
        Project job = ballJob();
        job.immersions.resize(1);
        job.asBuilt.corrects = true;
        job.asBuilt.parts.resize(1);
        job.asBuilt.places = {
            {1, 1, {}, {}, {Millimetres(1), Millimetres(-0.5)}}}; // shifts the whole sheet
        JobOptions options;
        options.estimatesNumericalError = false;
        const auto sheetOf = [&](const QString& dips, std::optional<VerdictReason::Kind> reason) {
            job.asBuilt.parts.front().dips = dips;
            const JobResult result = runJob(job, *registry_, options, nullptr, {});
            const Verdict& verdict = result.immersions.front().verdict;
            for (const auto kind :
                 {VerdictReason::Kind::OtherDips, VerdictReason::Kind::UnknownDips}) {
                const bool isExpected = hasReason(verdict, kind) == (kind == reason);
                if (!isExpected || (kind == reason && verdict.advice != Advice::CheckFirst)) {
                    return QImage();
                }
            }
            return result.immersions.front().sheet.image;
        };
        const QImage corrected = sheetOf(dipKeys(job).join(u' '), std::nullopt);
        QVERIFY(!corrected.isNull());
        QCOMPARE(sheetOf({}, VerdictReason::Kind::UnknownDips), corrected);
        const QImage other =
            sheetOf(QStringLiteral("0123456789abcdef"), VerdictReason::Kind::OtherDips);
        QVERIFY(!other.isNull() && other != corrected);
        job.asBuilt.corrects = false;
        QCOMPARE(sheetOf(QStringLiteral("0123456789abcdef"), std::nullopt), other);
    }

    void runJob_maskOnUnknownFace_isToBeChecked() {
        Project job = ballJob();
        job.masks.emplace_back().material = QStringLiteral("Thread");
        job.masks.back().extent = MarkExtent::Material;
        JobOptions options;
        options.estimatesNumericalError = false;
        const Verdict verdict = runJob(job, *registry_, options, nullptr, {}).verdict;
        QCOMPARE(verdict.advice, Advice::CheckFirst);
        QCOMPARE(verdict.reasons.front().kind, VerdictReason::Kind::UnknownName);
        QVERIFY(verdict.reasons.front().text.contains("Thread"));
    }

    void runJob_sameDipTwice_coversNoMoreThanOnce() {
        Project job = job_;
        job.immersions[1].rotation = job.immersions[0].rotation;
        const JobResult result = runJob(job, *registry_, {}, &first_, {});
        QVERIFY(std::abs(result.coverageTotal - first_.immersions[0].coverage->share) < 0.01);
    }

    // The deeper dip has the same laid film as the dip, plus the film above it that only the deeper
    // dip reaches.
    void deeperDip_laysTheSameFilmAndMore() {
        Project job = job_;
        job.immersions.resize(1);
        job.process.depth = Millimetres(10);
        const JobResult reckoned = runJob(job, *registry_, {}, nullptr, {});
        const ImmersionResult& dip = reckoned.immersions.front();
        const auto deeper = deeperDip(reckoned, 0, *registry_, {});
        QVERIFY(coverage(*deeper).share > dip.coverage->share + 0.1);
        const double cell = job.film.width.value() / (job.film.columns - 1);
        const RefinedMesh fine(job.model->mesh, 1);
        std::size_t same = 0, above = 0, laid = 0;
        for (std::size_t triangle = 0; triangle < fine.mesh().triangles.size(); ++triangle) {
            const SurfacePoint point = fine.middle(triangle);
            const double height = double(position(dip.body->mesh, point).y());
            const auto before = dip.laid->place(point);
            const auto after = deeper->place(point);
            if (height < 10 - 2 * cell) {
                QVERIFY(before && after);
                QVERIFY((before->rest - after->rest).norm() < 0.05f);
                ++same;
            } else if (height > 10 + cell && height < 15) {
                QVERIFY(!before);
                ++above;
                laid += std::size_t(after.has_value());
            }
        }
        QVERIFY(same > 500 && above > 500);
        QVERIFY(double(laid) > 0.99 * double(above)); // up to the equator
    }

    void runJob_nothingChanged_reusesEverything() {
        const JobResult again = runJob(job_, *registry_, {}, &first_, {});
        for (std::size_t index = 0; index < 2; ++index) {
            QVERIFY(again.immersions[index].laid == first_.immersions[index].laid);
            QVERIFY(again.immersions[index].texture == first_.immersions[index].texture);
        }
        QCOMPARE(again.proof.cacheKey(), first_.proof.cacheKey());
    }

    void runJob_otherResolution_reusesTheDip() {
        Project job = job_;
        job.sheet.resolution = DotsPerInch(100);
        const JobResult result = runJob(job, *registry_, {}, &first_, {});
        QVERIFY(result.immersions[0].laid == first_.immersions[0].laid);
        QVERIFY(result.immersions[0].texture != first_.immersions[0].texture);
        QCOMPARE(result.immersions[0].sheet.image.size(), QSize(354, 354));
    }

    void runJob_oneDipTurned_reusesTheOther() {
        Project job = job_;
        job.immersions[1].rotation[1] = Degrees(30);
        const JobResult result = runJob(job, *registry_, {}, &first_, {});
        QVERIFY(result.immersions[0].laid == first_.immersions[0].laid);
        QVERIFY(result.immersions[1].laid != first_.immersions[1].laid);
        QVERIFY(result.field == first_.field);
    }

    void runJob_otherFilm_dipsAgain() {
        Project job = job_;
        job.film.swellX = 1.05;
        const JobResult result = runJob(job, *registry_, {}, &first_, {});
        QVERIFY(result.immersions[0].body == first_.immersions[0].body);
        QVERIFY(result.immersions[0].laid != first_.immersions[0].laid);
        QVERIFY(result.immersions[1].laid != first_.immersions[1].laid);
    }

    void runJob_solverNamedThatAutoChose_reusesTheDip() {
        Project job = job_;
        job.process.solver = QStringLiteral("pbd-cpu");
        const JobResult named = runJob(job, *registry_, {}, &first_, {});
        for (std::size_t index = 0; index < 2; ++index) {
            QVERIFY(named.immersions[index].laid == first_.immersions[index].laid);
            QVERIFY(named.immersions[index].texture == first_.immersions[index].texture);
            QCOMPARE(named.immersions[index].sheet.job.hash,
                     first_.immersions[index].sheet.job.hash);
        }
        const JobResult back = runJob(job_, *registry_, {}, &named, {});
        QVERIFY(back.immersions[0].laid == first_.immersions[0].laid);
    }

    void runJob_otherSolver_dipsAgain() {
        const PluginFolder folder;
        folder.add(QStringLiteral("twin"), pluginFolder("/") + PluginFolder::moduleName("pbd-cpu"));
        const SolverRegistry registry({folder.path(), pluginFolder()});
        Project job = job_;
        job.process.solver = QStringLiteral("twin"); // the same solver module with another name
        const JobResult result = runJob(job, registry, {}, &first_, {});
        QCOMPARE(result.solver.id, QStringLiteral("twin"));
        QVERIFY(result.immersions[0].body == first_.immersions[0].body);
        QVERIFY(result.immersions[0].laid != first_.immersions[0].laid);
        QVERIFY(result.field == first_.field);
    }

    void runJob_otherDipName_changesOnlyTheSheet() {
        Project job = job_;
        job.immersions[0].name = QStringLiteral("Renamed");
        const JobResult result = runJob(job, *registry_, {}, &first_, {});
        QVERIFY(result.immersions[0].texture == first_.immersions[0].texture);
        QCOMPARE(result.immersions[0].sheet.job.immersion, QStringLiteral("Renamed"));
        QCOMPARE(result.proof.cacheKey(), first_.proof.cacheKey()); // not traced again
        QVERIFY(result.coverage != first_.coverage); // the picture's legend has the new name
    }

    void runJob_reusedResults_equalFreshOnes() {
        Project job = job_;
        job.ink.compensate = false;
        const JobResult reused = runJob(job, *registry_, {}, &first_, {});
        const JobResult fresh = runJob(job, *registry_, {}, nullptr, {});
        for (std::size_t index = 0; index < 2; ++index) {
            QCOMPARE(reused.immersions[index].sheet.image, fresh.immersions[index].sheet.image);
            QCOMPARE(reused.immersions[index].sheet.job.hash,
                     fresh.immersions[index].sheet.job.hash);
        }
        QCOMPARE(reused.proof, fresh.proof);
    }

    void runJob_chessboard_replacesTheTexture() {
        JobOptions options;
        options.chessboard = true;
        const JobResult result = runJob(job_, *registry_, options, &first_, {});
        QVERIFY(result.immersions[0].laid == first_.immersions[0].laid);
        // Four squares of 17 mm meet in the middle of the sheet.
        const QImage& image = result.immersions[0].sheet.image;
        const int middle = image.width() / 2;
        const int off = int(0.5 * chessSquare / 25.4 * 72);
        QVERIFY(qGray(image.pixel(middle + off, middle + off)) !=
                qGray(image.pixel(middle + off, middle - off)));
        QCOMPARE(qGray(image.pixel(middle + off, middle + off)),
                 qGray(image.pixel(middle - off, middle - off)));
    }

    void runJob_observer_seesEachDipsFilm() {
        JobOptions options;
        std::size_t frames[2] = {0, 0};
        options.observer = [&](std::size_t immersion, const FilmFrame& frame) {
            QCOMPARE(frame.positions.size(), std::size_t(3 * 31 * 31));
            ++frames[immersion];
        };
        runJob(job_, *registry_, options, nullptr, {});
        QVERIFY(frames[0] > 0 && frames[1] > 0);
    }

    void runJob_progress_grows() {
        Progress progress;
        double last = 0;
        progress.report = [&](double share, const QString& text) {
            QVERIFY2(share >= last - 1e-9 && share <= 1 + 1e-9, qPrintable(text));
            QVERIFY(!text.isEmpty());
            last = share;
        };
        runJob(job_, *registry_, {}, nullptr, progress);
        QVERIFY(last > 0.8);
    }

    void runJob_cancelled_throws() {
        Progress progress;
        CancelToken cancelToken = progress.cancelToken;
        progress.report = [&](double share, const QString&) {
            if (share > 0.3) {
                cancelToken.cancel();
            }
        };
        QVERIFY_EXCEPTION_THROWN(runJob(job_, *registry_, {}, nullptr, progress), Cancelled);
    }

    void runJob_gpuFails_cpuTakesOver() {
        const PluginFolder folder;
        QJsonObject description = PluginFolder::description(QStringLiteral("advance"));
        folder.add(QStringLiteral("advance"), builtModule(QStringLiteral("advance")));
        description[QLatin1String("device")] = QStringLiteral("gpu");
        description[QLatin1String("priority")] = 1000;
        folder.describe(description);
        const SolverRegistry registry({folder.path(), pluginFolder()});
        const JobResult result = runJob(job_, registry, {}, nullptr, {});
        QCOMPARE(result.solver.id, QStringLiteral("pbd-cpu"));
        QVERIFY2(result.notes.size() == 1 && result.notes[0].contains("The solver advance"),
                 qPrintable(result.notes.join('\n')));
        QCOMPARE(result.immersions[0].sheet.image, first_.immersions[0].sheet.image);
        // If nothing changes, the GPU is not tried again, and the result still names the solver
        // that took over.
        const JobResult again = runJob(job_, registry, {}, &result, {});
        QVERIFY(again.immersions[1].laid == result.immersions[1].laid);
        QCOMPARE(again.solver.id, QStringLiteral("pbd-cpu"));
        QCOMPARE(again.notes, result.notes);
    }

    void runJob_gpuMissing_cpuTakesOver() {
        const PluginFolder folder;
        QJsonObject description = PluginFolder::description(QStringLiteral("device"));
        folder.add(QStringLiteral("device"), builtModule(QStringLiteral("device")));
        description[QLatin1String("device")] = QStringLiteral("gpu");
        folder.describe(description);
        const SolverRegistry registry({folder.path(), pluginFolder()});
        Project job = job_;
        job.process.solver = QStringLiteral("device");
        QVERIFY(validateJob(job, registry).join('\n').contains("The CPU is used instead"));
        const JobResult result = runJob(job, registry, {}, nullptr, {});
        QCOMPARE(result.solver.id, QStringLiteral("pbd-cpu"));
        QCOMPARE(result.notes.size(), 1);
        QCOMPARE(result.immersions[0].sheet.image, first_.immersions[0].sheet.image);
    }

    void runJob_cpuFails_throwsError() {
        const PluginFolder folder;
        folder.add(QStringLiteral("advance"), builtModule(QStringLiteral("advance")));
        const SolverRegistry registry({folder.path(), pluginFolder()});
        JobOptions options;
        options.solver = QStringLiteral("advance");
        QVERIFY_EXCEPTION_THROWN(runJob(job_, registry, options, nullptr, {}), Error);
    }

    void runJob_expiredFilm_checkFirst() {
        Project job = job_;
        FilmProfile film;
        film.name = QStringLiteral("Blue box");
        film.lot = QStringLiteral("B-17");
        film.expiry = QStringLiteral("2001-03-31");
        job.profiles.film = film;
        const auto expiryReason = [&]() -> std::optional<VerdictReason> {
            const JobResult result = runJob(job, *registry_, {}, &first_, {});
            for (const VerdictReason& reason : result.verdict.reasons) {
                if (reason.kind == VerdictReason::Kind::ExpiredFilm) {
                    return reason;
                }
            }
            return std::nullopt;
        };
        const std::optional<VerdictReason> reason = expiryReason();
        QVERIFY(reason);
        QCOMPARE(reason->advice, Advice::CheckFirst);
        QVERIFY2(reason->text.contains("Blue box, lot B-17, expired on 2001-03-31"),
                 qPrintable(reason->text));
        QVERIFY(validateJob(job, *registry_).contains(reason->text));
        job.profiles.film->expiry = QStringLiteral("9999-12-31");
        QVERIFY(!expiryReason());
        job.profiles.film->expiry.clear();
        QVERIFY(!expiryReason());
    }

    void runJob_shallowTank_doNotPrint() {
        Project job = job_;
        TankProfile bath;
        bath.name = QStringLiteral("Bath");
        bath.waterDepth = Millimetres(20); // the ball is 30 mm high
        job.profiles.tank = bath;
        const JobResult result = runJob(job, *registry_, {}, &first_, {});
        QCOMPARE(adviceOf(result), Advice::DoNotPrint);
        const JobReason reason = reasonsOf(result).front();
        QCOMPARE(reason.reason.kind, VerdictReason::Kind::Tank);
        QVERIFY2(reason.reason.text.contains("only 20.0 mm deep"), qPrintable(reason.reason.text));
        QCOMPARE(reason.reason.limit, 20.0);
        QVERIFY(reason.reason.value > reason.reason.limit);
    }

    void runJob_tooSmallFilm_doNotPrint() {
        Project job = job_;
        job.film.width = job.film.height = Millimetres(36); // mm; the ball is 30 mm wide
        const JobResult result = runJob(job, *registry_, {}, nullptr, {});
        QCOMPARE(adviceOf(result), Advice::DoNotPrint);
        for (const ImmersionResult& dip : result.immersions) {
            QVERIFY(std::ranges::any_of(dip.verdict.reasons, [](const VerdictReason& reason) {
                return reason.kind == VerdictReason::Kind::FilmEdge &&
                       reason.advice == Advice::DoNotPrint;
            }));
        }
    }

    void smallerFilm_dipNearFilmEdge_isNotProposed() {
        Project job = job_;
        job.immersions.resize(1);
        job.film.width = job.film.height = Millimetres(240);
        QVERIFY(smallerFilm(runJob(job, *registry_, {}, nullptr, {})));
        job.immersions.front().offset[0] = Millimetres(100); // 5 mm between the ball and the edge
        const JobResult result = runJob(job, *registry_, {}, nullptr, {});
        QVERIFY(std::ranges::any_of(reasonsOf(result), [](const JobReason& each) {
            return each.reason.kind == VerdictReason::Kind::FilmEdge;
        }));
        QVERIFY(!smallerFilm(result));
    }

    void validateJob_largeSheets_reportsMemory() {
        Project job = job_;
        QVERIFY(!validateJob(job, *registry_).join('\n').contains("memory"));
        job.film.width = Millimetres(700);
        job.film.height = Millimetres(1000);
        job.sheet.resolution = DotsPerInch(600);
        QVERIFY(!validateJob(job, *registry_).join('\n').contains("memory"));
        QVERIFY(memoryNote(job, Printed::WholeFilm).contains("GB of memory"));
        const double whole = sheetMemory(job, Printed::WholeFilm);
        QVERIFY(whole > 3.3e9 && whole < 9e9); // 3.3 GB with a chessboard, measured
        QVERIFY(sheetMemory(job, Printed::Texture) < 0.2 * whole); // blank film needs none
        job.immersions.pop_back();
        QVERIFY(sheetMemory(job, Printed::WholeFilm) < whole);
    }

    // The plate is thinner than a cell of the default distance field.
    void runJob_thinPlate_isPainted() {
        Project job = job_;
        job.immersions.resize(1);
        job.model = plain(boxMesh({50, 0.4, 40}));
        const JobResult result = runJob(job, *registry_, {}, nullptr, {});
        QVERIFY(result.coverageTotal > 0.3);
        QVERIFY2(result.notes.isEmpty(), qPrintable(result.notes.join('\n')));
    }

    void validateJob_partsTooThinForTheField_areReported() {
        Project job = job_;
        job.model = plain(transformed(
            boxMesh({60, 0.03, 60}),
            Eigen::Isometry3d(Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 0, 1).normalized()))));
        const QString warnings = validateJob(job, *registry_).join('\n');
        QVERIFY2(warnings.contains("Some places of the model are only 0.03 mm thick"),
                 qPrintable(warnings));
    }

    void validateJob_bodyLargerThanFilm_isRefusedWithTheNeededSize() {
        Project job = job_;
        job.model = plain(boxMesh({204, 30, 130}));
        const auto refusalOf = [](const auto& work) {
            try {
                work();
            } catch (const Error& error) {
                return error.sentence();
            }
            return QString();
        };
        const auto validate = [&] { validateJob(job, *registry_); };
        QVERIFY2(refusalOf(validate).contains("larger than 230 × 150 mm"),
                 qPrintable(refusalOf(validate)));
        QVERIFY(refusalOf([&] {
                    runJob(job, *registry_, {}, nullptr, {});
                }).contains("larger than 230 × 150 mm"));
        job.film.swellX = 1.2;
        QVERIFY(refusalOf(validate).contains("larger than 190 × 150 mm"));
        job.model = plain(boxMesh({5000, 5000, 5000}));
        QVERIFY2(refusalOf(validate).contains("size and unit"), qPrintable(refusalOf(validate)));
        job.film.swellX = 1;
        job.model = plain(boxMesh({80, 30, 130})); // larger than the film in one direction
        QVERIFY(validateJob(job, *registry_).join('\n').contains("larger than 100 × 150 mm"));
    }

    void validateJob_importRepairs_areReported() {
        Project job = job_;
        job.modelOrigin.remarks = "Parts of the surface turned that were inside out: 2";
        QVERIFY(validateJob(job, *registry_).join('\n').contains(job.modelOrigin.remarks));
    }

    // An older project may contain a body that the import has not turned.
    void validateJob_insideOutBody_isReported() {
        Project job = job_;
        job.immersions.resize(1);
        TexturedMesh turned = *job.model;
        for (auto& triangle : turned.mesh.triangles) {
            std::swap(triangle[0], triangle[1]);
        }
        job.model = std::make_shared<const TexturedMesh>(turned);
        QVERIFY(validateJob(job, *registry_).join('\n').contains("inside out"));
        QVERIFY(runJob(job, *registry_, {}, nullptr, {}).notes.join('\n').contains("inside out"));
    }

    void misplacement_bodyPastFilmOrTank_isReported() {
        Project job = job_; // a ball of 30 mm on a film of 90 mm
        const auto said = [&job](double x, double z) {
            job.immersions[0].offset = {Millimetres(x), Millimetres(z)};
            return misplacement(job, job.immersions[0]);
        };
        QCOMPARE(said(0, 0), QString());
        QCOMPARE(said(29, -29), QString());
        QVERIFY(said(31, 0).contains("past the film's edge"));
        QVERIFY(validateJob(job, *registry_).join('\n').contains("past the film's edge"));
        QVERIFY(said(0, 61).contains("does not meet the film"));
        TankProfile bath;
        bath.name = QStringLiteral("Bath");
        bath.width = Millimetres(80);
        job.profiles.tank = bath;
        QVERIFY(said(26, 0).contains("past the edge of the tank “Bath”"));
        QVERIFY(!said(0, 26).contains("past the edge"));
        QVERIFY(said(0, 26).contains("The film measures 90.0 × 90.0 mm on the water"));
    }

    void runJob_withoutModel_isRefused() {
        Project job = job_;
        job.model = nullptr;
        QVERIFY_EXCEPTION_THROWN(runJob(job, *registry_, {}, nullptr, {}), Error);
        QVERIFY_EXCEPTION_THROWN(validateJob(job, *registry_), Error);
    }

    void report_countsPointsConstraintsAndStretch() {
        const QJsonObject json = report(job_, first_);
        const QJsonObject immersion = json["immersions"].toArray()[1].toObject();
        QCOMPARE(immersion["name"].toString(), QStringLiteral("Turned"));
        QCOMPARE(immersion["film"].toObject()["points"].toInt(), 31 * 31);
        QCOMPARE(immersion["film"].toObject()["constraints"].toInt(), 2 * 31 * 30 + 2 * 30 * 30);
        QCOMPARE(immersion["equilibrium"].toObject().keys(),
                 QStringList({"linear_iterations", "steps_without", "worst_force_left"}));
        const ImmersionResult& result = first_.immersions[1];
        qint64 adhered = 0;
        for (std::size_t point = 0; point < result.laid->film().states.size(); ++point) {
            adhered += result.laid->film().adhered(point) ? 1 : 0;
        }
        QCOMPARE(immersion["adhered"].toInteger(), adhered);
        QCOMPARE(immersion["coverage"].toDouble(), result.coverage->share);
        // On a ball, the film is stretched along the meridians and compressed around the axis.
        const QJsonObject stretch = immersion["stretch"].toObject();
        QVERIFY(stretch["mean"].toDouble() > 0.8 && stretch["mean"].toDouble() < 1.2);
        QVERIFY(stretch["min"].toDouble() > 0 && stretch["max"].toDouble() < 2);
    }

    void folderTransaction_uncommitted_leavesNothing() {
        QTemporaryDir home;
        const QString target = home.filePath("deep/down/results");
        {
            const FolderTransaction folder(target, {"proof.png"});
            folder.write("proof.png", "half of it");
        }
        QVERIFY(filesBelow(home.path()).isEmpty());
        FolderTransaction folder(target,
                                 {"proof.png", "immersion-1/sheet.png", "immersion-2/sheet.png"});
        folder.write("proof.png", "new");
        folder.write("immersion-1/sheet.png", "sheet");
        folder.commit();
        QCOMPARE(filesBelow(target), (QStringList{"immersion-1/sheet.png", "proof.png"}));
        QVERIFY(!QFileInfo::exists(target + "/immersion-2"));
    }

    void writeResults_otherFilesInTheFolder_stay() {
        QTemporaryDir home;
        writeResults(job_, first_, home.path(), {});
        for (const char* name : {"immersion-1/job.dipw", "immersion-2/notes.txt"}) {
            QFile file(home.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
        JobResult single = first_;
        single.immersions.pop_back();
        single.coverage = {};
        writeResults(job_, single, home.path(), {});
        QCOMPARE(filesBelow(home.path()).size(), 13 + 2);
        QVERIFY(QFileInfo::exists(home.filePath("immersion-1/job.dipw")));
        QCOMPARE(filesBelow(home.filePath("immersion-2")), QStringList("notes.txt"));
    }

    void writeResults_obstacleInTheWay_isRefusedAndKept() {
        QTemporaryDir home;
        QVERIFY(QDir(home.path()).mkpath("proof.png"));
        QFile file(home.filePath("immersion-1"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.close();
        try {
            writeResults(job_, first_, home.path(), {});
            QFAIL("the obstacle was overwritten, expected a refusal");
        } catch (const Error& error) {
            QVERIFY2(error.sentence().contains("cannot be replaced"), qPrintable(error.sentence()));
        }
        QVERIFY(QFileInfo(home.filePath("immersion-1")).isFile());
        QCOMPARE(filesBelow(home.path()), QStringList("immersion-1"));
    }

    void runAndWrite_writesTheSameFilesAsWriteResults() {
        QTemporaryDir home;
        writeResults(job_, first_, home.filePath("after"), {});
        const JobResult result =
            runAndWrite(job_, *registry_, {}, nullptr, home.filePath("during"), {});
        QCOMPARE(result.proof, first_.proof);
        const QStringList files = filesBelow(home.filePath("after"));
        QCOMPARE(filesBelow(home.filePath("during")), files);
        for (const QString& name : files) {
            const QByteArray during = bytesOf(home.filePath("during/" + name));
            QVERIFY(!during.isEmpty());
            if (name.endsWith(".png") || name.endsWith(".vtp") ||
                name == "ticket.json") { // the other files contain the time
                QVERIFY2(during == bytesOf(home.filePath("after/" + name)), qPrintable(name));
            }
        }
    }

    void ticket_listsFilesWithTheirHashes() {
        QTemporaryDir home;
        Project job = job_;
        FilmProfile film;
        film.name = "Thin film";
        film.lot = "L-77";
        job.profiles.film = film;
        JobResult result = first_;
        result.project = job;
        writeResults(job, result, home.path(), {});
        const QJsonObject ticket =
            QJsonDocument::fromJson(bytesOf(home.filePath("ticket.json"))).object();
        QCOMPARE(ticket["film"].toObject()["profile"].toObject()["lot"].toString(), "L-77");
        QCOMPARE(ticket["dwell"].toObject()["soak_s"].toDouble(), film.soakTime.value());
        const QJsonArray dips = ticket["dips"].toArray();
        QCOMPARE(dips.size(), 2);
        for (qsizetype number = 0; number < dips.size(); ++number) {
            const QJsonObject dip = dips[number].toObject();
            QCOMPARE(dip["job"].toString(), first_.immersions[number].sheet.job.hash);
            QCOMPARE(dip["files"].toArray().size(), 4);
            for (const QJsonValue& entry : dip["files"].toArray()) {
                const QByteArray bytes = bytesOf(home.filePath(entry["file"].toString()));
                QVERIFY(!bytes.isEmpty());
                QCOMPARE(entry["bytes"].toInteger(), bytes.size());
                QCOMPARE(entry["sha256"].toString().toLatin1(), sha256(bytes));
            }
            const QImage sheet =
                QImage(home.filePath(QStringLiteral("immersion-%1/sheet.png").arg(number + 1)))
                    .convertToFormat(QImage::Format_RGB888);
            QByteArray pixels;
            for (int row = 0; row < sheet.height(); ++row) {
                pixels.append(reinterpret_cast<const char*>(sheet.constScanLine(row)),
                              3 * qsizetype(sheet.width()));
            }
            QCOMPARE(dip["sheet"]["picture_sha256"].toString().toLatin1(), sha256(pixels));
        }
        QProcess schema;
        schema.start("python3", {"-c",
                                 "import json, jsonschema, sys\n"
                                 "jsonschema.Draft202012Validator(json.load(open(sys.argv[1])))"
                                 ".validate(json.load(open(sys.argv[2])))",
                                 sourceFolder("/resources/schemas/ticket.schema.json"),
                                 home.filePath("ticket.json")});
        QVERIFY(schema.waitForFinished());
        QVERIFY2(schema.exitCode() == 0, schema.readAllStandardError().constData());
    }

    void runAndWrite_cancelled_leavesNothing_data() {
        QTest::addColumn<double>("cancelled"); // share of the work after which the job is cancelled
        for (const double share : {0.05, 0.3, 0.6, 0.9, 0.97}) {
            QTest::newRow(qPrintable(QString::number(share))) << share;
        }
    }
    void runAndWrite_cancelled_leavesNothing() {
        QFETCH(double, cancelled);
        QTemporaryDir home;
        Progress progress;
        CancelToken cancelToken = progress.cancelToken;
        progress.report = [&](double share, const QString&) {
            if (share >= cancelled) {
                cancelToken.cancel();
            }
        };
        QVERIFY_EXCEPTION_THROWN(
            runAndWrite(job_, *registry_, {}, nullptr, home.filePath("results"), progress),
            Cancelled);
        QVERIFY(QDir(home.path()).isEmpty(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot));
    }

    void writeResults_cancelled_keepsEarlierResults() {
        QTemporaryDir home;
        writeResults(job_, first_, home.path(), {});
        const QStringList before = filesBelow(home.path());
        QCOMPARE(before.size(), 23);
        Progress progress;
        CancelToken cancelToken = progress.cancelToken;
        progress.report = [&](double share, const QString&) {
            if (share > 0.4) {
                cancelToken.cancel();
            }
        };
        QVERIFY_EXCEPTION_THROWN(writeResults(job_, first_, home.path(), progress), Cancelled);
        QCOMPARE(filesBelow(home.path()), before);
    }

private:
    std::unique_ptr<SolverRegistry> registry_;
    Project job_;
    JobResult first_;
};

QTEST_MAIN(PipelineTest)
#include "PipelineTest.moc"
