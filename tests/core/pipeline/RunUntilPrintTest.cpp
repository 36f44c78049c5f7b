// Tests that a job is refined until its sheets can be printed, and that the limit of work holds.
#include "pipeline/RunUntilPrint.h"
#include "TestFolders.h"

#include "project/ProjectStore.h"

#include <QtTest>

using namespace dipwright;

namespace {

// The turtle with cells that are too coarse for its legs, and one dip.
Project coarseTurtle() {
    Project project = loadProject(sampleFolder("/turtle.dipw"));
    project.immersions.resize(1);
    project.film.resolution = FilmResolution::Cell;
    project.film.cell = Millimetres(3);
    project.sheet.resolution = DotsPerInch(50);
    return project;
}

JobOptions smallPictures() {
    JobOptions options;
    options.draftPictures = 0.1; // this test looks at no picture
    return options;
}

} // namespace

class RunUntilPrintTest : public QObject {
    Q_OBJECT

private slots:
    void runUntilPrint_coarseFilm_isRefinedUntilItCanBePrinted() {
        const JobResult result =
            runUntilPrint(coarseTurtle(), registry_, smallPictures(), defaultWork, {});
        const std::vector<VerdictReason>& reasons = result.immersions[0].verdict.reasons;
        QVERIFY(std::any_of(reasons.begin(), reasons.end(), [](const VerdictReason& reason) {
            return reason.kind == VerdictReason::Kind::Certain;
        }));
        QVERIFY(result.project.film.cell.value() < 2.7);
        QVERIFY(std::abs(result.immersions[0].laid->film().grid.leastSpacing() -
                         result.project.film.cell.value()) < 0.2);
        QVERIFY2(result.notes.join(u' ').contains(QLatin1String("cells were reduced to")),
                 qPrintable(result.notes.join(u' ')));
    }

    void runUntilPrint_littleWork_keepsTheFilmAndSaysWhy() {
        const Project project = coarseTurtle();
        const JobResult result = runUntilPrint(project, registry_, smallPictures(), 1e5, {});
        QCOMPARE(result.project.film, project.film);
        QVERIFY(result.immersions[0].verdict.advice > Advice::Print);
        QVERIFY2(result.notes.join(u' ').contains(QStringLiteral("points × steps")),
                 qPrintable(result.notes.join(u' ')));
    }

    void runUntilPrint_fixedPoints_areKept() {
        Project project = coarseTurtle();
        project.film.resolution = FilmResolution::Points;
        project.film.columns = 40;
        project.film.rows = 57;
        const JobResult result =
            runUntilPrint(project, registry_, smallPictures(), defaultWork, {});
        QCOMPARE(result.project.film, project.film);
        QVERIFY2(result.notes.join(u' ').contains(QLatin1String("is fixed")),
                 qPrintable(result.notes.join(u' ')));
    }

private:
    SolverRegistry registry_;
};

QTEST_MAIN(RunUntilPrintTest)
#include "RunUntilPrintTest.moc"
