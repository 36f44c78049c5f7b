// Tests how users plan jobs in the window: results kept with a project, the queue, a proposed
// smaller film, turning and moving the body by menu, arrows and keys, and help for the focused
// place.
#include "Patience.h"
#include "TestFolders.h"
#include "WindowDriver.h"
#include "project/ProjectStore.h"
#include "workbench/compare/CompareWindow.h"
#include "workbench/compare/ProjectDifferences.h"
#include "workbench/compare/SnapshotsDialog.h"
#include "workbench/document/PoseEdits.h"
#include "workbench/help/GuideWindow.h"
#include "workbench/poses/SearchPage.h"
#include "workbench/preferences/PreferencesDialog.h"
#include "workbench/project/ProjectTree.h"
#include "workbench/queue/QueueDialog.h"
#include "workbench/results/ReportPanel.h"
#include "workbench/results/ResultsPanel.h"
#include "workbench/results/Timeline.h"
#include "workbench/widgets/NoticeBar.h"
#include "workbench/widgets/PicturePanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableWidget>
#include <QTextBrowser>
#include <QTranslator>

#include <cmath>

using namespace dipwright;

namespace {

const QString model = sampleFolder("/models/turtle.obj");
const QString texture = sampleFolder("/models/turtle.png");

Eigen::Vector3d inWorld(const Immersion& immersion, const Eigen::Vector3d& ofModel) {
    return rotationMatrix(immersion.rotation) * ofModel;
}

} // namespace

class PlanningTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        workbench_ = std::make_unique<Workbench>(folder_.filePath(QStringLiteral("recovery")));
        Preferences preferences = workbench_->preferences();
        preferences.liveUpdate = false;
        preferences.keepsResults = true;
        workbench_->setPreferences(preferences);
        openWindow();
    }
    void cleanup() {
        window_.reset();
        workbench_.reset();
    }

    void projectDifferences_otherMarks_areNamed() {
        Project first;
        first.masks.resize(1);
        Project second = first;
        QVERIFY(projectDifferences(first, second, LengthUnit::Millimetre).empty());
        second.masks[0].erases = true;
        const auto found = projectDifferences(first, second, LengthUnit::Millimetre);
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0].first, QStringLiteral("1"));
        QCOMPARE(found[0].second, QStringLiteral("1 others"));
    }

    void openProject_keptResults_areShown() {
        const QString path = savedProject("kept");
        QVERIFY(WindowDriver(*window_).run());
        const QImage sheet = firstSheet();
        openWindow();
        QVERIFY(QFile::exists(folder_.filePath(QStringLiteral("kept.dips"))));
        WindowDriver driver(*window_);
        QVERIFY(driver.open(path));
        QTRY_VERIFY_WITH_TIMEOUT(window_->document()->result(), patience());
        QVERIFY(window_->document()->isFresh());
        QVERIFY(!window_->document()->isModified());
        QCOMPARE(firstSheet(), sheet);
        QVERIFY(window_->session().reading()); // maps and view can be read
        QVERIFY(driver.action("print")->isEnabled());
        // Only the start and the end of the dip are kept. Playing it simulates it again.
        auto* timeline = window_->findChild<Timeline*>();
        QCOMPARE(timeline->frames(), 1);
        QVERIFY(driver.action("play")->isEnabled());
        driver.trigger("play");
        QVERIFY(window_->session().isRunning());
        QTRY_VERIFY_WITH_TIMEOUT(timeline->isPlaying(), patience());
        QVERIFY(timeline->frames() > 1);
        QCOMPARE(firstSheet(), sheet);
        QVERIFY(window_->document()->isFresh() && !window_->document()->isModified());
    }

    void openProject_changedSinceRun_hasNoResults() {
        const QString path = savedProject("other");
        QVERIFY(WindowDriver(*window_).run());
        window_->document()->edit(QStringLiteral("turn"), {}, [](Project& project) {
            project.immersions[0].rotation[1] = Degrees(20);
        });
        QVERIFY(WindowDriver(*window_).save());
        openWindow();
        QVERIFY(WindowDriver(*window_).open(path));
        QTRY_VERIFY(window_->isEmpty() == false && !window_->session().isRunning());
        QTest::qWait(300);
        QVERIFY(!window_->document()->result());
    }

    void run_keepResultsOff_writesNoDipsFile() {
        PreferencesDialog dialog(workbench_->preferences(), workbench_->registry(), {});
        dialog.findChild<QCheckBox*>(QStringLiteral("keepResults"))->setChecked(false);
        workbench_->setPreferences(dialog.preferences());
        QVERIFY(!loadPreferences().keepsResults);
        savedProject("unkept");
        QVERIFY(WindowDriver(*window_).run());
        openWindow();
        QVERIFY(!QFile::exists(folder_.filePath(QStringLiteral("unkept.dips"))));
    }

    void openProject_damagedDipsFile_opensWithoutResults() {
        const QString path = savedProject("damaged");
        QFile file(folder_.filePath(QStringLiteral("damaged.dips")));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("nonsense") == 8);
        file.close();
        openWindow();
        WindowDriver driver(*window_);
        QVERIFY(driver.open(path));
        QTest::qWait(300);
        QVERIFY(!window_->document()->result());
        QVERIFY(driver.run());
        openWindow(); // the old window rewrites the .dips file
        QVERIFY(WindowDriver(*window_).open(path));
        QTRY_VERIFY_WITH_TIMEOUT(window_->document()->result(), patience());
    }

    void report_smallerFilmLink_setsFilm() {
        WindowDriver driver(*window_);
        QVERIFY(driver.create(model, texture, 60, makeCoarse));
        Document& document = *window_->document();
        document.edit(QStringLiteral("move"), {}, [](Project& project) {
            project.immersions[0].offset = {Millimetres(40), Millimetres(-30)};
        });
        QVERIFY(driver.run());
        auto* report = driver.find<QTextBrowser>("report");
        QVERIFY2(report->toPlainText().contains(QStringLiteral("A5")),
                 qPrintable(report->toPlainText()));
        const double coverage = document.result()->coverageTotal;
        emit report->anchorClicked(QUrl(QStringLiteral("smaller-film")));
        QCOMPARE(document.project().film.preset, QStringLiteral("A5"));
        QVERIFY(driver.run());
        const double now = document.result()->coverageTotal; // differs: the film has other cells
        QVERIFY2(std::abs(now - coverage) < 0.05,
                 qPrintable(QStringLiteral("coverage was %1, is %2 with A5, expected within 0.05")
                                .arg(coverage)
                                .arg(now)));
        QVERIFY(!report->toPlainText().contains(QStringLiteral("Use this film")));
        document.undoStack().undo();
        QCOMPARE(document.project().film.preset, QStringLiteral("A4"));
        QCOMPARE(document.project().immersions[0].offset[0].value(), 40.0);
    }

    void report_placeOfLargestStretch_turnsViewThere() {
        WindowDriver driver(*window_);
        QVERIFY(driver.create(model, texture, 60, makeCoarse));
        QVERIFY(driver.run());
        auto* report = driver.find<QTextBrowser>("report");
        QVERIFY2(report->toPlainText().contains(QLatin1String("99 % below")) &&
                     report->toPlainText().contains(QLatin1String("on the model")),
                 qPrintable(report->toPlainText()));
        const QRegularExpression link(QStringLiteral("place:\\d+"));
        const QString place = link.match(report->toHtml()).captured();
        QVERIFY(!place.isEmpty());
        Eigen::Vector3f chosen = Eigen::Vector3f::Constant(1e9f);
        connect(driver.find<ResultsPanel>("results"), &ResultsPanel::modelPlaceChosen, this,
                [&chosen](const Eigen::Vector3f& shown) { chosen = shown; });
        window_->view().look(ViewDirection::Top);
        const QImage before = window_->view().picture();
        emit report->anchorClicked(QUrl(place));
        const BoundingBox box = boundingBox(window_->document()->project().model->mesh);
        QVERIFY(box.exteriorDistance(chosen) < 1); // mm
        QVERIFY(window_->view().picture() != before);
    }

    void bodyMenu_actions_markFaceAndLayItDown() {
        WindowDriver driver(*window_);
        QVERIFY(driver.create(model, texture, 90, makeCoarse));
        Document& document = *window_->document();
        const QMenu& menu = bodyMenu();
        const auto trigger = [&](const char* name) {
            auto* action = menu.findChild<QAction*>(QLatin1String(name));
            QVERIFY(action && action->isEnabled());
            action->trigger();
        };
        trigger("faceMustBeGood");
        const auto& marks = document.project().tolerance.marks;
        QCOMPARE(marks.size(), 1U);
        QVERIFY(marks[0].zone == Zone::A && marks[0].extent == MarkExtent::Face);
        trigger("maskFace");
        QCOMPARE(document.project().masks.size(), 1U);
        QVERIFY(document.project().masks[0].extent == MarkExtent::Face);
        document.undoStack().undo();
        QVERIFY(document.project().masks.empty());
        const Immersion before = document.project().immersions[0];
        trigger("layFaceDown");
        QVERIFY(document.project().immersions[0] != before);
        document.undoStack().undo();
        QVERIFY(document.project().immersions[0] == before);
        document.undoStack().undo();
        QVERIFY(document.project().tolerance.marks.empty());
    }

    // The user turns a preset into poses, and changes one of them by its list, the rings and the
    // arrows of the view.
    void pathPoses_listRingsAndArrows_changeThePath() {
        savedProject("poses");
        WindowDriver driver(*window_);
        Document& document = *window_->document();
        const auto path = [&]() -> const DipPath& { return document.project().immersions[0].path; };
        document.edit(QStringLiteral("tilt"), {}, [](Project& project) {
            project.immersions[0].path.kind = PathKind::Tilt;
            project.immersions[0].path.angle = Degrees(30);
        });
        window_->findChild<ProjectTree*>()->select({ProjectPart::Immersion, 0});
        auto* kind = driver.find<QComboBox>("immersions[0].path.kind");
        auto* poses = driver.find<QListWidget>("pathKeys");
        QVERIFY(kind && poses && !poses->isVisible());
        kind->setCurrentIndex(kind->findData(QStringLiteral("poses")));
        emit kind->activated(kind->currentIndex());
        QCOMPARE(path().kind, PathKind::Poses);
        QCOMPARE(path().keys.size(), std::size_t(5));
        QVERIFY(std::abs(path().keys[0].turn[2].value() + 30) < 0.11); // +X lower
        QTRY_VERIFY(poses->isVisible());
        poses->setCurrentRow(2);
        auto* depth = driver.find<QDoubleSpinBox>("keyDepth");
        depth->setValue(9);
        QCOMPARE(path().keys[2].depth, std::optional(Millimetres(9)));
        DipView& view = window_->view();
        const std::array<Degrees, 3> before = path().keys[2].turn;
        emit view.rotationDragged(0, 12);
        emit view.rotationFinished();
        QVERIFY(path().keys[2].turn != before);
        QCOMPARE(document.project().immersions[0].rotation, (std::array<Degrees, 3>{}));
        emit view.moveDragged(2, 7.5);
        emit view.moveFinished();
        QCOMPARE(path().keys[2].beside[1].value(), 7.5);
        document.undoStack().undo();
        QCOMPARE(path().keys[2].beside[1].value(), 0.0);
        document.undoStack().undo();
        QCOMPARE(path().keys[2].turn, before);
        emit driver.find<QPushButton>("addPathKey")->clicked();
        QCOMPARE(path().keys.size(), std::size_t(6));
        QCOMPARE(poses->currentRow(), 3);
        QVERIFY(driver.run());
        QVERIFY(document.isFresh());
    }

    // A part that enters tilted is shown tilted, and turns as its rings are dragged.
    void turned_tiltedAtTheBeginning_turnsAsSeen() {
        const Eigen::Matrix3d tilt =
            Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()).toRotationMatrix();
        const Immersion immersion = turned(Immersion{}, 0, 40, {std::nullopt, tilt});
        const Eigen::Matrix3d seen = tilt * rotationMatrix(immersion.rotation);
        const Eigen::Matrix3d wanted =
            Eigen::AngleAxisd(radians(Degrees(40)), Eigen::Vector3d::UnitX()) * tilt;
        QVERIFY((seen - wanted).norm() < 0.01); // 0.1° steps
    }

    void withFaceDown_anyFace_pointsDown() {
        Immersion immersion;
        immersion.rotation = {Degrees(20), Degrees(-70), Degrees(130)};
        const Eigen::Vector3d down = -Eigen::Vector3d::UnitY();
        for (const Eigen::Vector3d& face : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0),
                                            Eigen::Vector3d(0, -1, 0), Eigen::Vector3d(1, 2, -3)}) {
            const Eigen::Vector3d normal = face.normalized();
            QVERIFY((inWorld(withFaceDown(immersion, normal), normal) - down).norm() < 0.01);
        }
        // A face that already points down stays.
        const Eigen::Vector3d lowest = rotationMatrix(immersion.rotation).transpose() * down;
        QVERIFY(withFaceDown(immersion, lowest) == immersion);
    }

    // A small screen has 1024 × 700; one with 1440 lines at scale 2 has 720. The queue fits, too.
    void window_allPagesShown_fits1024By700() {
        WindowDriver driver(*window_);
        QVERIFY(driver.create(model, texture, 90, makeCoarse));
        QVERIFY(driver.run());
        for (const char* page : {"searchDock", "inspectionDock", "logDock"}) {
            if (auto* dock = driver.find<QWidget>(page)) {
                dock->show();
            }
        }
        window_->resize(1024, 700);
        QTest::qWait(100); // layouts
        QCOMPARE(window_->size(), QSize(1024, 700));
        const QSize least = QueueDialog(workbench_->queue()).minimumSizeHint();
        QVERIFY2(
            least.width() <= 1024 && least.height() <= 660,
            qPrintable(QStringLiteral("the queue needs %1 × %2 px, expected at most 1024 × 660")
                           .arg(least.width())
                           .arg(least.height())));
    }

    void moveArrows_drag_changeOffsetAndDepth() {
        WindowDriver driver(*window_);
        QVERIFY(driver.create(model, texture, 90, [](Project& project) {
            makeCoarse(project);
            project.process.depth = Millimetres(20);
        }));
        Document& document = *window_->document();
        const int steps = document.undoStack().count();
        const TriangleMesh& mesh = document.project().model->mesh;
        const double out = 1.24 * 0.58 * double(boundingBox(mesh).diagonal().norm());
        const auto dragAlong = [&](int axis, double way) {
            DipView& view = window_->view();
            view.picture();
            const Immersion& immersion = document.project().immersions[0];
            Eigen::Vector3f place =
                (Eigen::Translation3d(poseToWorld(immersion, 0)) * poseTransform(mesh, immersion) *
                 boundingBox(mesh).center().cast<double>())
                    .cast<float>();
            place[axis] += float(out);
            const QPointF from = view.positionOf(place);
            place[axis] += float(way);
            const QPointF to = view.positionOf(place);
            const auto share = [&](const QPointF& at) {
                return QPointF(at.x() / view.width(), at.y() / view.height());
            };
            WindowDriver::drag(view, share(from), share(to));
        };
        const auto near = [](double value, double wanted) { return std::abs(value - wanted) < 2; };
        const auto& offset = document.project().immersions[0].offset;
        dragAlong(0, 12);
        QVERIFY2(
            near(offset[0].value(), 12),
            qPrintable(
                QStringLiteral("x offset is %1 mm, expected 12 ± 2 mm").arg(offset[0].value())));
        QVERIFY(driver.find<QLabel>("reading")->text().contains(QLatin1Char('X')));
        dragAlong(2, -8);
        QVERIFY2(
            near(offset[1].value(), -8),
            qPrintable(
                QStringLiteral("z offset is %1 mm, expected -8 ± 2 mm").arg(offset[1].value())));
        dragAlong(1, -6); // deeper
        QVERIFY(near(document.project().process.depth->value(), 26));
        QCOMPARE(document.undoStack().count(), steps + 3);
        document.undoStack().setIndex(steps);
        QCOMPARE(offset[0].value(), 0.0);
        QCOMPARE(document.project().process.depth->value(), 20.0);
    }

    void searchPage_weightsAndLimits_areSavedWithProject() {
        const QString path = savedProject("aims");
        auto* page = window_->findChild<SearchPage*>();
        auto* weight = page->findChild<QDoubleSpinBox*>(QStringLiteral("weight_coverage"));
        auto* isLimited = page->findChild<QCheckBox*>(QStringLiteral("limited_coverage"));
        Document* document = window_->document();
        QVERIFY(!document->isModified());
        weight->setValue(2.5);
        weight->setValue(2.75);
        emit weight->editingFinished();
        QCOMPARE(document->undoStack().count(), 1); // merged into one step
        isLimited->setChecked(true);
        const PoseAims wanted = document->project().poseAims;
        QCOMPARE(wanted.weights[Measure::Coverage], 2.75);
        QVERIFY(wanted.limits[Measure::Coverage].has_value());
        document->undoStack().undo();
        QVERIFY(!isLimited->isChecked());
        document->undoStack().undo();
        QCOMPARE(weight->value(), PoseAims().weights[Measure::Coverage]);
        document->undoStack().redo();
        document->undoStack().redo();
        QVERIFY(WindowDriver(*window_).save());
        openWindow();
        QVERIFY(WindowDriver(*window_).open(path));
        QVERIFY(window_->document()->project().poseAims == wanted);
        page = window_->findChild<SearchPage*>();
        QVERIFY(page->settings().aims == wanted);
        QVERIFY(!window_->document()->isModified());
    }

    void compareWindow_twoStates_shareCamera() {
        WindowDriver driver(*window_);
        QVERIFY(driver.create(model, texture, 90, makeCoarse));
        const Document& document = *window_->document();
        takeSnapshot(*window_->document(), QStringLiteral("As drawn"));
        window_->document()->edit(QStringLiteral("turn"), {}, [](Project& project) {
            project.immersions[0].rotation[2] = Degrees(90);
        });
        const Project before = document.project();
        driver.trigger("snapshots");
        auto* snapshots = window_->findChild<SnapshotsDialog*>();
        snapshots->findChild<QPushButton*>(QStringLiteral("sideBySide"))->click();
        const QPointer<CompareWindow> compared = window_->findChild<CompareWindow*>();
        QVERIFY(compared && compared->isVisible());
        auto* figures = compared->findChild<QTableWidget*>(QStringLiteral("comparedFigures"));
        const auto text = [&](int column) { return figures->item(0, column)->text(); };
        QTRY_VERIFY_WITH_TIMEOUT(text(1).endsWith(QLatin1Char('%')) &&
                                     text(2).endsWith(QLatin1Char('%')),
                                 patience()); // both have been dipped
        QVERIFY2(text(3).contains(QLatin1String("better")) ||
                     text(3).contains(QLatin1String("worse")),
                 qPrintable(text(3)));
        // Turning one camera turns the other, too.
        const auto places = [&](std::size_t side) {
            compared->view(side).picture();
            return compared->view(side).positionOf({40, 0, 20});
        };
        const auto together = [&] { return QLineF(places(0), places(1)).length() < 1; };
        QTRY_VERIFY(together());
        for (const std::size_t side : {0U, 1U}) {
            const QPointF was = places(side);
            WindowDriver::drag(compared->view(side), {0.3, 0.3}, {0.5, 0.4});
            QTRY_VERIFY(together() && QLineF(places(side), was).length() > 5);
        }
        auto* look = compared->findChild<QComboBox*>(QStringLiteral("comparedLook"));
        const QImage film = compared->view(1).picture();
        look->setCurrentIndex(1);
        QVERIFY(compared->view(1).picture() != film);
        QTest::keyClick(&compared->view(0), Qt::Key_Escape);
        QTRY_VERIFY(!compared);
        QVERIFY(document.project() == before);
        snapshots->close();
    }

    void compareWindow_bodyMovedBy2mm_showsDifferenceOf2mm() {
        WindowDriver driver(*window_);
        QVERIFY(driver.create(sampleFolder("/models/sphere.obj"),
                              sampleFolder("/models/sphere.png"), 40, [](Project& project) {
                                  makeCoarse(project);
                                  project.film.width = project.film.height = Millimetres(120);
                                  project.film.columns = project.film.rows = 61; // 2 mm apart
                              }));
        takeSnapshot(*window_->document(), QStringLiteral("As drawn"));
        window_->document()->edit(QStringLiteral("move"), {}, [](Project& project) {
            project.immersions[0].offset[0] = Millimetres(2);
        });
        driver.trigger("snapshots");
        auto* snapshots = window_->findChild<SnapshotsDialog*>();
        snapshots->findChild<QPushButton*>(QStringLiteral("sideBySide"))->click();
        const QPointer<CompareWindow> compared = window_->findChild<CompareWindow*>();
        QVERIFY(compared);
        auto* look = compared->findChild<QComboBox*>(QStringLiteral("comparedLook"));
        look->setCurrentIndex(look->count() - 1);
        const auto* note = compared->findChild<QLabel*>(QStringLiteral("differenceNote"));
        QVERIFY2(note->text().contains(QLatin1String("needs the dips of both states")),
                 qPrintable(note->text()));
        auto* dips = compared->findChild<QTableWidget*>(QStringLiteral("comparedDifferences"));
        QTRY_COMPARE_WITH_TIMEOUT(dips->rowCount(), 1, patience());
        QVERIFY(dips->isVisible());
        const auto millimetres = [&](int column) {
            return dips->item(0, column)->text().section(QLatin1Char(' '), 0, 0).toDouble();
        };
        const double most = millimetres(1), largest = millimetres(2);
        QVERIFY2(std::abs(most - 2) < 0.1, qPrintable(QString::number(most)));
        QVERIFY2(std::abs(largest - 2) < 0.3, qPrintable(QString::number(largest)));
        const auto* map = compared->findChild<PicturePanel*>();
        QVERIFY(map->isVisible());
        emit dips->cellClicked(0, 0); // turns to the largest
        QVERIFY(!compared->view(0).picture().isNull());
        look->setCurrentIndex(0);
        QVERIFY(!map->isVisible() && !dips->isVisible());
        compared->close();
        snapshots->close();
    }

    void shortcuts_turnAndMoveKeys_changePose() {
        WindowDriver driver(*window_);
        QVERIFY(driver.create(model, texture, 90, makeCoarse));
        Document& document = *window_->document();
        const auto press = [&](int key, Qt::KeyboardModifiers modifiers) {
            window_->activateWindow();
            QVERIFY(QTest::qWaitForWindowActive(window_.get()));
            QTest::keyClick(window_.get(), Qt::Key(key), modifiers);
        };
        press(Qt::Key_Y, Qt::ControlModifier | Qt::AltModifier);
        QCOMPARE(document.project().immersions[0].rotation[1].value(), 15.0);
        press(Qt::Key_Y, Qt::ControlModifier | Qt::AltModifier | Qt::ShiftModifier);
        QCOMPARE(document.project().immersions[0].rotation[1].value(), 0.0);
        press(Qt::Key_Right, Qt::AltModifier);
        press(Qt::Key_Down, Qt::AltModifier);
        QCOMPARE(document.project().immersions[0].offset[0].value(), 5.0);
        QCOMPARE(document.project().immersions[0].offset[1].value(), 5.0);
        press(Qt::Key_Home, Qt::AltModifier);
        QCOMPARE(document.project().immersions[0].offset[0].value(), 0.0);
        document.undoStack().undo();
        QCOMPARE(document.project().immersions[0].offset[0].value(), 5.0);
    }

    void guide_helpKey_opensAtFocusedPlace() {
        WindowDriver driver(*window_);
        QVERIFY(driver.create(model, texture, 90, makeCoarse));
        driver.find<ProjectTree>("projectTree")->select({ProjectPart::Tolerance, 0});
        const auto wordsAt = [](const QWidget* widget) { return guidePlaceOf(widget).words; };
        QCOMPARE(wordsAt(driver.find<QWidget>("tellTolerances")),
                 QStringLiteral("Dip ▸ Tolerances"));
        QCOMPARE(guidePlaceOf(driver.find<QWidget>("report")).chapter, 7); // chapter of the verdict
        driver.find<ResultsPanel>("results")->setCurrentIndex(5);
        QCOMPARE(wordsAt(driver.find<QWidget>("report")), QStringLiteral("Report"));
        QCOMPARE(wordsAt(driver.find<QWidget>("startSearch")), QStringLiteral("Dip ▸ Find poses"));
        QCOMPARE(guidePlaceOf(nullptr).chapter, 0);
        // In the window, the action opens the guide …
        window_->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window_.get()));
        window_->view().setFocus();
        QTest::keyClick(&window_->view(), Qt::Key_F1);
        const auto* guide = window_->findChild<GuideWindow*>();
        QVERIFY(guide && guide->isVisible());
        QCOMPARE(guide->findChild<QTextBrowser*>()->textCursor().selectedText(),
                 QStringLiteral("Middle"));
        // … and in a dialog, the key F1.
        driver.trigger("printHistory");
        auto* history = driver.find<QDialog>("printHistory");
        QVERIFY(history);
        window_->setEnabled(false); // like under a modal dialog
        QKeyEvent press(QEvent::KeyPress, Qt::Key_F1, Qt::NoModifier);
        QApplication::sendEvent(history->findChild<QLineEdit*>(), &press);
        window_->setEnabled(true);
        guide = history->findChild<GuideWindow*>();
        QVERIFY(guide && guide->isVisible());
        QCOMPARE(guide->findChild<QTextBrowser*>()->textCursor().selectedText(),
                 QStringLiteral("File ▸ Print history"));
    }

    void guide_everyPlace_isFound_data() {
        QTest::addColumn<QString>("language");
        QTest::newRow("en") << QStringLiteral("en");
        QTest::newRow("de") << QStringLiteral("de");
        QTest::newRow("pt_BR") << QStringLiteral("pt_BR");
    }

    void guide_everyPlace_isFound() {
        QFETCH(QString, language);
        const QLocale before;
        QTranslator translator;
        if (translator.load(QStringLiteral(":/translations/dipwright_") + language)) {
            QCoreApplication::installTranslator(&translator);
        }
        QLocale::setDefault(QLocale(language));
        GuideWindow guide;
        for (const GuidePlace& place : guidePlaces()) {
            QVERIFY2(guide.showPlace(place), qPrintable(place.words));
        }
        QLocale::setDefault(before);
    }

    void jobQueue_oneProjectFails_othersRun() {
        const QStringList projects{savedProject("one"), folder_.filePath("missing.dipw"),
                                   savedProject("two")};
        WindowDriver driver(*window_);
        driver.trigger("jobQueue");
        auto* dialog = queueDialog();
        QVERIFY(dialog && dialog->isVisible());
        JobQueue& queue = workbench_->queue();
        QSignalSpy ended(&queue, &JobQueue::ended);
        queue.add(projects, folder_.filePath("results"));
        QVERIFY(queue.isBusy());
        QVERIFY(ended.wait(patience()));
        QCOMPARE(int(queue.projects()[0].state), int(QueuedState::Done));
        QCOMPARE(int(queue.projects()[1].state), int(QueuedState::Failed));
        QVERIFY(!queue.projects()[1].text.isEmpty());
        QCOMPARE(int(queue.projects()[2].state), int(QueuedState::Done));
        for (const char* name : {"one", "two"}) {
            QVERIFY(QFile::exists(folder_.filePath(
                QStringLiteral("results/%1/report.json").arg(QLatin1String(name)))));
            QVERIFY(QFile::exists(
                folder_.filePath(QStringLiteral("%1.dips").arg(QLatin1String(name)))));
        }
        const auto* table = dialog->findChild<QTableWidget*>();
        QCOMPARE(table->rowCount(), 3);
        QCOMPARE(table->item(1, 1)->text(), QStringLiteral("Failed"));
        const auto* details = dialog->findChild<QPlainTextEdit*>(QStringLiteral("queueDetails"));
        QVERIFY(!details->isVisible()); // no project is selected
        dialog->findChild<QTableWidget*>()->selectRow(0);
        QVERIFY(details->isVisible());
        QCOMPARE(details->toPlainText(), queue.projects()[0].text);
        QVERIFY(!details->toPlainText().contains(QStringLiteral("..")));
        const auto* notice = window_->findChild<NoticeBar*>();
        QVERIFY2(notice->text().contains(QStringLiteral("failed: 1")), qPrintable(notice->text()));
        dialog->findChild<QPushButton*>(QStringLiteral("removeEnded"))->click();
        QCOMPARE(table->rowCount(), 0);
        dialog->close();
    }

    void jobQueue_keptDips_areUsed() {
        const QString path = savedProject("again");
        JobQueue& queue = workbench_->queue();
        QSignalSpy ended(&queue, &JobQueue::ended);
        const auto secondsOfDip = [&](const char* folder) {
            queue.add({path}, folder_.filePath(QLatin1String(folder)));
            ended.wait(patience());
            QFile report(folder_.filePath(QLatin1String(folder) + "/again/report.json"));
            report.open(QIODevice::ReadOnly);
            return QJsonDocument::fromJson(report.readAll())[QLatin1String("immersions")][0]
                                                            [QLatin1String("wall_seconds")]
                                                                .toDouble();
        };
        const double first = secondsOfDip("queue1");
        QVERIFY(first > 0);
        QCOMPARE(secondsOfDip("queue2"), first); // a dip that is repeated takes another time
    }

    void jobQueue_oneCancelled_othersRun() {
        const QStringList projects{savedProject("first"), savedProject("second"),
                                   savedProject("third")};
        JobQueue& queue = workbench_->queue();
        QSignalSpy ended(&queue, &JobQueue::ended);
        queue.add(projects, folder_.filePath("cancelled"));
        queue.cancel(1);
        QCOMPARE(int(queue.projects()[1].state), int(QueuedState::Cancelled));
        QVERIFY(ended.wait(patience()));
        QCOMPARE(int(queue.projects()[0].state), int(QueuedState::Done));
        QCOMPARE(int(queue.projects()[1].state), int(QueuedState::Cancelled));
        QCOMPARE(int(queue.projects()[2].state), int(QueuedState::Done));
        QVERIFY(!QFile::exists(folder_.filePath("cancelled/second")));
        queue.add(projects, folder_.filePath("cancelled"));
        queue.cancelAll();
        QVERIFY(ended.wait(patience()));
        QVERIFY(queue.projects()[5].state == QueuedState::Cancelled);
        QCOMPARE(queue.projects()[3].folder, folder_.filePath("cancelled/first-2"));
    }

private:
    void openWindow() {
        window_.reset();
        window_ = std::make_unique<MainWindow>(*workbench_);
        window_->show();
    }
    // Makes a coarse project in the window and saves it. Returns its path.
    QString savedProject(const char* name) {
        if (window_->document()) {
            openWindow();
        }
        const QString path = folder_.filePath(QStringLiteral("%1.dipw").arg(QLatin1String(name)));
        WindowDriver driver(*window_);
        if (driver.create(model, texture, 60, makeCoarse)) {
            driver.saveAs(path);
        }
        return path;
    }
    QImage firstSheet() const {
        return window_->document()->result()->immersions.front().sheet.image;
    }
    const QMenu& bodyMenu() {
        DipView& view = window_->view();
        view.picture(); // the body must be drawn to be clicked
        const QPoint onBody = view.positionOf({0, 10, 0}).toPoint();
        QTest::mouseClick(&view, Qt::RightButton, {}, onBody);
        return *view.findChild<QMenu*>(QStringLiteral("bodyMenu"));
    }
    static QueueDialog* queueDialog() {
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (auto* dialog = qobject_cast<QueueDialog*>(widget)) {
                return dialog;
            }
        }
        return nullptr;
    }

    QTemporaryDir folder_;
    std::unique_ptr<Workbench> workbench_;
    std::unique_ptr<MainWindow> window_;
};

int main(int argc, char* argv[]) {
    const WindowApplication application(argc, argv);
    PlanningTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "PlanningTest.moc"
