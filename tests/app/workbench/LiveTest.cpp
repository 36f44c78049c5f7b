// Tests that results appear while the user drags: drafts while the part is dragged, then the
// result, in a real window. Takes half a minute, because each case runs a job of two films.
#include "Patience.h"
#include "TestFolders.h"
#include "WindowDriver.h"
#include "pipeline/Pipeline.h"
#include "workbench/project/ProjectTree.h"
#include "workbench/results/Timeline.h"

#include <QLabel>
#include <QTextBrowser>
#include <QUndoStack>

using namespace dipwright;

class LiveTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        workbench_ = std::make_unique<Workbench>(home_.path());
        window_ = std::make_unique<MainWindow>(*workbench_);
        window_->show();
        WindowDriver driver(*window_);
        QVERIFY(driver.open(sampleFolder("/sphere.dipw")));
        document().edit({}, {}, [](Project& project) {
            makeCoarse(project);
            project.film.columns = project.film.rows = 44; // one draft before the result
        });
        QVERIFY(driver.run());
        before_ = document().result();
    }
    void cleanup() {
        window_ = nullptr;
        workbench_ = nullptr;
    }

    void dip_finished_staysWithTheHand() {
        const auto* timeline = window_->findChild<Timeline*>();
        QCOMPARE(timeline->position(), 0);
        QVERIFY(timeline->frames() > 1); // it can be played
        QVERIFY(!banner().isVisible());
    }

    void drawnFilm_onBody_followsItsSurface() {
        const DrapedFilm& drawn = session().reading()->draped();
        const SurfaceQuery& body = before_->immersions[0].body->query;
        QCOMPARE(drawn.onAllPoints(session().reading()->values(FilmQuantity::Area)).size(),
                 drawn.positions.size());
        float deepest = 0;
        int checked = 0;
        for (std::size_t t = 0; t < drawn.triangles.size(); t += 3) {
            const auto& [a, b, c] = drawn.triangles[t];
            const Eigen::Vector3f middle =
                (drawn.positions[a] + drawn.positions[b] + drawn.positions[c]) / 3;
            if (drawn.painted[t] && ++checked && body.isInside(middle)) {
                deepest = std::max(deepest, body.closest(middle).distance);
            }
        }
        QVERIFY(checked > 100);
        QVERIFY2(deepest < 0.05f,
                 qPrintable(
                     QStringLiteral("film is drawn %1 mm below the surface").arg(double(deepest))));
    }

    void finishedRun_portrait_showsThePrintedPart() {
        const QImage portrait = session().outcome().portrait;
        QCOMPARE(portrait.size(), QSize(384, 240));
        int coloured = 0;
        for (int y = 0; y < portrait.height(); ++y) {
            for (int x = 0; x < portrait.width(); ++x) {
                coloured += portrait.pixelColor(x, y).hsvSaturation() > 60;
            }
        }
        QVERIFY(coloured > 5000); // the bare part and the table are grey
    }

    void finishedRun_tree_showsTheVerdictOnTheDip() {
        auto* tree = window_->findChild<ProjectTree*>();
        tree->select({ProjectPart::Immersion, 0});
        const Advice advice = worst(before_->immersions[0].verdict.advice, before_->verdict.advice);
        QVERIFY2(tree->currentItem()->toolTip(1).startsWith(adviceText(advice)),
                 qPrintable(tree->currentItem()->toolTip(1)));
    }

    void select_otherItems_duringRun_keepsShowingTheFilm() {
        auto* tree = window_->findChild<ProjectTree*>();
        drag(10);
        release();
        QTRY_VERIFY_WITH_TIMEOUT(session().isRunning(), patience());
        for (int part = int(ProjectPart::Project); part <= int(ProjectPart::Tolerance); ++part) {
            for (const std::size_t dip : {1, 0}) {
                tree->select({ProjectPart(part), dip});
                QTest::qWait(5);
            }
        }
        tree->select({ProjectPart::Immersion, 0});
        tree->select({ProjectPart::Film});
        QTRY_VERIFY_WITH_TIMEOUT(isDraftShown(), patience());
        const QImage draft = window_->view().picture();
        WindowDriver(*window_).trigger("wearsFilm");
        QVERIFY(window_->view().picture() != draft);
        WindowDriver(*window_).trigger("wearsFilm");
        QTRY_VERIFY_WITH_TIMEOUT(document().isFresh() && !session().isRunning(), patience());
        const QImage result = window_->view().picture();
        WindowDriver(*window_).trigger("wearsFilm");
        QVERIFY(window_->view().picture() != result);
    }

    void drag_ring_showsDraftsButKeepsResult() {
        drag(10);
        QTRY_VERIFY_WITH_TIMEOUT(isDraftShown(), patience());
        QVERIFY(banner().isVisible() && banner().text().contains(QStringLiteral("Draft with")));
        QVERIFY(window_->findChild<QTextBrowser*>(QStringLiteral("verdict"))
                    ->toPlainText()
                    .contains(QStringLiteral("draft")));
        QCOMPARE(document().result(), before_); // sheets are printed from it
        drag(20);
        QTRY_VERIFY_WITH_TIMEOUT(isDraftShown(), patience());
        // No further drafts while the ring is held.
        QTRY_VERIFY_WITH_TIMEOUT(!session().isRunning(), patience());
        QCOMPARE(document().result(), before_);
    }

    void release_ring_givesTheResultOfRun() {
        drag(15);
        release();
        QTRY_VERIFY_WITH_TIMEOUT(document().isFresh() && !session().isRunning(), patience());
        QVERIFY(!session().shown().fineness.isDraft() && !banner().isVisible());
        const JobResult alone =
            runJob(document().project(), workbench_->registry(), {}, nullptr, {});
        QCOMPARE(document().result()->immersions[0].sheet.image, alone.immersions[0].sheet.image);
        QCOMPARE(document().result()->immersions[0].sheet.job.hash,
                 alone.immersions[0].sheet.job.hash);
    }

    void run_dipTakenOver_hasNoRecordingOfTheDipBefore() {
        const auto turn = [](Project& project) { project.immersions[0].rotation[0] = Degrees(30); };
        Project turned = document().project();
        turn(turned);
        const auto kept = std::make_shared<const JobResult>(
            runJob(turned, workbench_->registry(), {}, nullptr, {}));
        session().setKept(kept);
        document().edit({}, {}, turn);
        QVERIFY(WindowDriver(*window_).run());
        QTRY_VERIFY_WITH_TIMEOUT(document().isFresh() && !session().isRunning(), patience());
        QCOMPARE(document().result()->immersions[0].laid, kept->immersions[0].laid);
        QVERIFY(!session().recording());
        QVERIFY(session().canRecord());
    }

    void undo_whileRefining_showsTheResultBefore() {
        drag(15);
        QTRY_VERIFY_WITH_TIMEOUT(isDraftShown(), patience());
        release();
        document().undoStack().undo();
        QVERIFY(document().isFresh());
        QCOMPARE(session().shown().result, before_);
        QTRY_VERIFY_WITH_TIMEOUT(!session().isRunning(), patience());
        QCOMPARE(session().shown().result, before_);
        QVERIFY(!banner().isVisible());
    }

    void undo_beforeFirstDraft_keepsTheResult() {
        drag(15);
        release();
        QTRY_VERIFY_WITH_TIMEOUT(session().isRunning(), patience());
        document().undoStack().undo();
        QTRY_VERIFY_WITH_TIMEOUT(!session().isRunning(), patience());
        QCOMPARE(session().shown().result, before_);
        QVERIFY(document().isFresh() && !banner().isVisible());
    }

    void undoAndRedo_whileRefining_givesTheResult() {
        drag(15);
        release();
        QTRY_VERIFY_WITH_TIMEOUT(isDraftShown(), patience());
        document().undoStack().undo();
        document().undoStack().redo();
        QTRY_VERIFY_WITH_TIMEOUT(document().isFresh() && !session().isRunning(), patience());
        QVERIFY(document().result() != before_ && !session().shown().fineness.isDraft());
    }

    void draft_onShow_isNeitherExportedNorPrinted() {
        const auto areEnabled = [this](bool enabled) {
            const WindowDriver driver(*window_);
            return driver.action("exportPdf")->isEnabled() == enabled &&
                   driver.action("print")->isEnabled() == enabled;
        };
        QVERIFY(areEnabled(true));
        drag(15);
        QTRY_VERIFY_WITH_TIMEOUT(isDraftShown(), patience());
        QVERIFY(areEnabled(false));
        release();
        QTRY_VERIFY_WITH_TIMEOUT(document().isFresh() && !session().isRunning(), patience());
        QVERIFY(areEnabled(true));
    }

    void cancel_whileRefining_saysThatItIsADraft() {
        drag(15);
        QTRY_VERIFY_WITH_TIMEOUT(isDraftShown(), patience());
        release();
        QTRY_VERIFY_WITH_TIMEOUT(session().isRunning(), patience());
        WindowDriver(*window_).trigger("cancel");
        QTRY_VERIFY_WITH_TIMEOUT(!session().isRunning(), patience());
        if (!document().isFresh()) { // else it was too late
            QVERIFY(banner().isVisible() &&
                    banner().text().contains(QStringLiteral("run the dip")));
            QVERIFY(window_->findChild<QTextBrowser*>(QStringLiteral("verdict"))
                        ->toPlainText()
                        .contains(QStringLiteral("cancelled")));
        }
    }

    void tryPose_errorTooLarge_isRefinedOnlyWhenRunAgain() {
        const WindowDriver driver(*window_);
        driver.action("live")->setChecked(false);
        limitError();
        session().run(1000, DipReach::Unrefined);
        QTRY_VERIFY_WITH_TIMEOUT(document().isFresh() && !session().isRunning(), patience());
        QTRY_VERIFY_WITH_TIMEOUT(!driver.action("cancel")->isEnabled(), patience()); // idle
        QCoreApplication::processEvents(); // a refinement would begin now
        QVERIFY(!session().isRunning() && session().canRefine());
        session().run(1000, DipReach::Unrefined);
        QVERIFY(!session().isRunning());
        session().run(1000);
        QVERIFY(session().isRefining());
        session().cancel();
    }

    void result_errorTooLarge_isRefinedByItself() {
        limitError();
        WindowDriver driver(*window_);
        driver.trigger("run");
        QTRY_VERIFY_WITH_TIMEOUT(session().isRefining(), patience());
        const auto first = document().result();
        QVERIFY(document().isFresh() && banner().isVisible());
        driver.trigger("cancel");
        QTRY_VERIFY_WITH_TIMEOUT(!session().isRunning(), patience());
        QCOMPARE(document().result(), first); // it can be used
        QVERIFY(document().isFresh() && session().canRefine() && banner().isVisible());
        driver.trigger("run"); // starts when the cancelled job has ended
        QTRY_VERIFY_WITH_TIMEOUT(session().isRefining(), patience());
        // A change stops it; after an undo it continues.
        document().edit({}, {}, [](Project& project) { project.sheet.bleed = Millimetres(4); });
        QTRY_VERIFY_WITH_TIMEOUT(!session().isRefining(), patience());
        document().undoStack().undo();
        QTRY_VERIFY_WITH_TIMEOUT(!session().isRunning() && !session().canRefine(), patience());
        QVERIFY(document().isFresh() && !banner().isVisible());
        const ImmersionResult& dip = document().result()->immersions[0];
        QVERIFY(dip.refinement > 1);
        QCOMPARE(session().recording()->grid().pointCount(), dip.laid->film().grid.pointCount());
    }

    void close_whileRefining_ends() {
        drag(15);
        release();
        document().markUnmodified();
        window_ = nullptr; // waits for the job
    }

private:
    Document& document() const { return *window_->document(); }
    DipSession& session() const { return window_->session(); }
    const QLabel& banner() const {
        return *window_->findChild<QLabel*>(QStringLiteral("staleBanner"));
    }
    // The limit is so small that automatic cells do not keep it, but cells of half the size do.
    void limitError() const {
        document().edit({}, {}, [](Project& project) {
            project.immersions.resize(1);
            project.film.resolution = FilmResolution::Automatic;
            project.tolerance.limits.back() = Millimetres(0.12);
            project.film.work = 20;
        });
    }
    void drag(double degrees) const { emit window_->view().rotationDragged(0, degrees); }
    void release() const { emit window_->view().rotationFinished(); }
    // Tells whether a draft of the part as it is turned now is on show.
    bool isDraftShown() const {
        const DipOutcome& shown = session().shown();
        return shown.fineness.isDraft() &&
               shown.project.immersions == document().project().immersions;
    }

    QTemporaryDir home_;
    std::unique_ptr<Workbench> workbench_;
    std::unique_ptr<MainWindow> window_;
    std::shared_ptr<const JobResult> before_;
};

int main(int argc, char** argv) {
    return runWindowTest<LiveTest>(argc, argv);
}
#include "LiveTest.moc"
