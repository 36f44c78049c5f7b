// Tests drafts of a job: how coarse they are, what they take over, and that the job after them is
// the same as without them.
#include "pipeline/JobDraft.h"
#include "TestFolders.h"
#include "pipeline/Pipeline.h"
#include "project/Project.h"
#include "project/ProjectStore.h"

#include <QStandardPaths>
#include <QtTest>

using namespace dipwright;

namespace {

// Returns the sample sphere, dipped from two sides into a film of `points` × `points` points.
Project sphereOn(int points) {
    Project project = loadProject(sampleFolder("/sphere.dipw"));
    project.film = {}; // evenly spaced points
    project.film.width = project.film.height = Millimetres(160);
    project.film.columns = project.film.rows = points;
    project.fieldResolution = 64;
    project.sheet.resolution = DotsPerInch(100);
    project.immersions.resize(1);
    project.immersions.push_back(project.immersions.front());
    project.immersions.back().name = QStringLiteral("Second");
    project.immersions.back().rotation[2] = Degrees(180);
    return project;
}

} // namespace

class JobDraftTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    void coarsestDraft_evenFilms_keepsEnoughCells_data() {
        QTest::addColumn<int>("points");
        QTest::addColumn<int>("level");
        QTest::newRow("too coarse for drafts") << 40 << 0;
        QTest::newRow("one draft") << 41 << 1;
        QTest::newRow("two drafts") << 81 << 2;
        QTest::newRow("three drafts") << 300 << 3;
    }
    void coarsestDraft_evenFilms_keepsEnoughCells() {
        QFETCH(int, points);
        QFETCH(int, level);
        QCOMPARE(coarsestDraft(sphereOn(points), {}), level);
    }

    void coarsestDraft_gradedFilm_countsItsCells() {
        Project project = sphereOn(60);
        project.film.resolution = FilmResolution::Automatic;
        const int level = coarsestDraft(project, {});
        QVERIFY(level >= 1);
        project.film.refinement = 2;
        QCOMPARE(coarsestDraft(project, {}), level + 1);
    }

    void runJob_afterDrafts_isTheSame() {
        const Project project = sphereOn(61);
        const JobResult alone = runJob(project, registry_, {}, nullptr, {});
        JobDrafts drafts;
        drafts.add(1, std::make_shared<JobResult>(runLevel(project, 1, 1, registry_, {}, {})));
        const JobResult after = runLevel(project, 0, 1, registry_, drafts, {});
        for (std::size_t dip = 0; dip < 2; ++dip) {
            QCOMPARE(after.immersions[dip].sheet.job.hash, alone.immersions[dip].sheet.job.hash);
            QCOMPARE(after.immersions[dip].sheet.image, alone.immersions[dip].sheet.image);
        }
        QCOMPARE(after.proof, alone.proof);
        QCOMPARE(after.coverageTotal, alone.coverageTotal);
    }

    void runDraft_sphere_isNearTheJob() {
        const Project project = sphereOn(121);
        const auto coarse = std::make_shared<JobResult>(runLevel(project, 2, 2, registry_, {}, {}));
        JobDrafts drafts;
        drafts.add(2, coarse);
        const JobResult fine = runLevel(project, 1, 2, registry_, drafts, {});
        QVERIFY(coarse->proof.width() < fine.proof.width());
        QVERIFY(!coarse->immersions[0].readBack && !coarse->immersions[0].numericalError);
        QVERIFY2(std::abs(coarse->coverageTotal - fine.coverageTotal) < 0.05,
                 qPrintable(QString::number(coarse->coverageTotal)));
        const std::optional<double> moves = movesSince(*coarse, fine);
        QVERIFY(moves && *moves > 0.01 && *moves < 3);
    }

    void reusable_oneDipTurned_keepsTheOther() {
        Project project = sphereOn(61);
        JobDrafts drafts;
        const auto job = std::make_shared<JobResult>(runJob(project, registry_, {}, nullptr, {}));
        drafts.add(0, job);
        const auto before =
            std::make_shared<JobResult>(runLevel(project, 1, 1, registry_, drafts, {}));
        QVERIFY(before->immersions[0].body == job->immersions[0].body);
        QVERIFY(before->field == job->field && before->proofStage == job->proofStage);
        drafts.add(1, before);
        project.immersions[0].rotation[0] = Degrees(30);
        const JobResult turned = runLevel(project, 1, 1, registry_, drafts, {});
        QVERIFY(turned.immersions[0].laid != before->immersions[0].laid);
        QVERIFY(turned.immersions[1].laid == before->immersions[1].laid);
    }

private:
    const SolverRegistry registry_;
};

QTEST_MAIN(JobDraftTest)
#include "JobDraftTest.moc"
