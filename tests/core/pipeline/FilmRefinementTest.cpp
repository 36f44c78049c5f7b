// Tests that films with automatic cells are refined until their sheets can be printed, and that the
// limit of work holds. Takes a quarter of a minute, because it runs a job of two films several
// times.
#include "pipeline/FilmRefinement.h"
#include "TestFolders.h"

#include "pipeline/DipCache.h"
#include "pipeline/JobDraft.h"
#include "pipeline/Pipeline.h"
#include "project/ProjectStore.h"

#include <QtTest>

using namespace dipwright;

namespace {

// The turtle with a zone limit that the automatic cells of the first dip do not keep.
Project exactTurtle() {
    Project project = loadProject(sampleFolder("/turtle.dipw"));
    project.film.resolution = FilmResolution::Automatic;
    project.film.wantedError.reset(); // only the tolerance requires smaller cells
    project.tolerance.limits.back() = Millimetres(0.6);
    project.sheet.resolution = DotsPerInch(50);
    return project;
}

JobOptions smallPictures(bool refines = true) {
    JobOptions options;
    options.draftPictures = 0.1; // this test looks at no picture
    options.refines = refines;
    return options;
}

bool isCertain(const Verdict& verdict) {
    return std::any_of(
        verdict.reasons.begin(), verdict.reasons.end(),
        [](const VerdictReason& reason) { return reason.kind == VerdictReason::Kind::Certain; });
}

QStringList hashes(const JobResult& result) {
    QStringList hashes;
    for (const ImmersionResult& dip : result.immersions) {
        hashes << dip.sheet.job.hash;
    }
    return hashes;
}

// Returns the numerical errors of all film points; -1 where they are unknown.
std::vector<float> errors(const JobResult& result) {
    std::vector<float> all;
    for (const ImmersionResult& dip : result.immersions) {
        for (const float error : dip.knownError()->pointErrors) {
            all.push_back(std::isnan(error) ? -1 : error);
        }
    }
    return all;
}

bool notesContain(const JobResult& result, const char* text) {
    return result.notes.join(u' ').contains(QString::fromUtf8(text));
}

} // namespace

class FilmRefinementTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        turtle_ = exactTurtle();
        coarse_ = std::make_unique<JobResult>(
            runJob(turtle_, registry_, smallPictures(false), nullptr, {}));
        refined_ =
            std::make_unique<JobResult>(runJob(turtle_, registry_, smallPictures(), nullptr, {}));
    }

    void runJob_errorTooLarge_isRefinedUntilItCanBePrinted() {
        const ImmersionResult& dip = refined_->immersions[0];
        QVERIFY(!isCertain(coarse_->immersions[0].verdict) && isCertain(dip.verdict));
        QVERIFY(dip.refinement > 1 && !dip.finer);
        QVERIFY(dip.laid->film().grid.leastSpacing() <
                coarse_->immersions[0].laid->film().grid.leastSpacing());
        QCOMPARE(refined_->project, turtle_); // the settings stay
        QVERIFY(refinementRemarks(*coarse_).isEmpty() && !refinementRemarks(*refined_).isEmpty());
        QVERIFY2(notesContain(*refined_, "cells were reduced to"),
                 qPrintable(refined_->notes.join(u' ')));
        QVERIFY(dip.sheet.job.hash != coarse_->immersions[0].sheet.job.hash);
    }

    void runJob_stoppedBeforeRefinement_goesOnToTheSameSheet() {
        QVERIFY(canBeRefined(*coarse_) && !canBeRefined(*refined_));
        const JobResult result = runJob(turtle_, registry_, smallPictures(), coarse_.get(), {});
        QCOMPARE(hashes(result), hashes(*refined_));
        QCOMPARE(errors(result), errors(*refined_));
        const JobResult again = runJob(turtle_, registry_, smallPictures(), &result, {});
        QCOMPARE(again.immersions[0].laid, result.immersions[0].laid); // nothing is left to do
    }

    void runJob_cachedDips_goOnToTheSameSheets() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("turtle.dipw"));
        for (const JobResult* result : {coarse_.get(), refined_.get()}) {
            cacheDips(*result, path);
            const auto kept = cachedDips(turtle_, registry_, path, {});
            QVERIFY(kept && !kept->field);
            QCOMPARE(kept->immersions[0].refinement, result->immersions[0].refinement);
            const JobResult continued = runJob(turtle_, registry_, smallPictures(), kept.get(), {});
            QCOMPARE(hashes(continued), hashes(*refined_));
            QCOMPARE(errors(continued), errors(*refined_));
        }
    }

    void runJob_otherLimits_doNotTakeOverTheRefinedFilm() {
        Project project = turtle_;
        project.tolerance.limits.back() = Millimetres(1.5);
        const JobResult result = runJob(project, registry_, smallPictures(), refined_.get(), {});
        QCOMPARE(result.immersions[0].refinement, 1.0);
        QCOMPARE(result.immersions[0].sheet.job.hash, coarse_->immersions[0].sheet.job.hash);
        // The film before refinement is the same for all limits.
        const JobResult taken = runJob(project, registry_, smallPictures(), coarse_.get(), {});
        QCOMPARE(taken.immersions[0].laid, coarse_->immersions[0].laid);
    }

    void runJob_littleWork_keepsTheFilmAndSaysWhy() {
        Project project = turtle_;
        project.film.work = 1;
        const JobResult result = runJob(project, registry_, smallPictures(), coarse_.get(), {});
        QCOMPARE(result.immersions[0].laid, coarse_->immersions[0].laid);
        QVERIFY(result.immersions[0].verdict.advice > Advice::Print);
        QVERIFY2(notesContain(result, "points × steps"), qPrintable(result.notes.join(u' ')));
    }

    void nextRefinement_otherFilms_areNotRefined() {
        const ImmersionResult& dip = coarse_->immersions[0];
        QVERIFY(nextRefinement(dip, dip.verdict, turtle_.film));
        Project none = turtle_;
        none.film.work = 0;
        QVERIFY(!nextRefinement(dip, dip.verdict, none.film));
        Project fixed = turtle_;
        fixed.film.resolution = FilmResolution::Points;
        QVERIFY(!nextRefinement(dip, dip.verdict, fixed.film));
    }

    void nextRefinement_wantedError_refinesSheetsThatCanBePrinted() {
        const ImmersionResult& dip = refined_->immersions[0];
        const double offBy = dip.numericalError->offBy.percentile95;
        const auto next = [&](std::optional<Millimetres> wanted) {
            FilmSettings film = turtle_.film;
            film.wantedError = wanted;
            return nextRefinement(dip, dip.verdict, film);
        };
        QVERIFY(!next({}) && !next(Millimetres(1.01 * offBy)));
        const std::optional<double> refinement = next(Millimetres(0.9 * offBy));
        QVERIFY(refinement && *refinement > 1.2 * dip.refinement);
    }

private:
    SolverRegistry registry_;
    Project turtle_;
    std::unique_ptr<JobResult> coarse_, refined_;
};

QTEST_MAIN(FilmRefinementTest)
#include "FilmRefinementTest.moc"
