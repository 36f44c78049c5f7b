// Tests everyday functions of the window: named layouts, shortcut conflicts, copying the report,
// notices, accuracy dialogs, zones, history, snapshots, guide and new projects.
#include "Patience.h"
#include "PluginFolder.h"
#include "TestFolders.h"
#include "WindowDriver.h"
#include "artwork/EditArtwork.h"
#include "geometry/Shapes.h"
#include "printing/PrintHistory.h"
#include "project/ProjectStore.h"
#include "project/Snapshots.h"
#include "viewport/DipView.h"
#include "workbench/accuracy/NumericalErrorDialog.h"
#include "workbench/appearance/BodyAppearance.h"
#include "workbench/document/ModelEdits.h"
#include "workbench/help/GuideWindow.h"
#include "workbench/preferences/PreferencesDialog.h"
#include "workbench/project/NewProjectDialog.h"
#include "workbench/project/ProjectTree.h"
#include "workbench/project/PropertyPanel.h"
#include "workbench/results/StretchPanel.h"
#include "workbench/widgets/NoticeBar.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/PictureView.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QInputDialog>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QStatusBar>
#include <QTableWidget>
#include <QTextBrowser>
#include <QToolButton>

using namespace dipwright;
using test::PluginFolder;

namespace {

const QString model = sampleFolder("/models/turtle.obj");
const QString texture = sampleFolder("/models/turtle.png");

// Adds a GPU solver that every run prefers and that fails at its first step.
void addFailingGpu(const PluginFolder& folder) {
    const QString name = QStringLiteral("advance");
    folder.add(name, badModuleFolder("/") + PluginFolder::moduleName(name));
    QJsonObject description = PluginFolder::description(name);
    description[QLatin1String("device")] = QStringLiteral("gpu");
    description[QLatin1String("priority")] = 1000;
    folder.describe(description);
}

} // namespace

class HabitsTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        workbench_ = std::make_unique<Workbench>(folder_.filePath(QStringLiteral("recovery")));
        window_ = std::make_unique<MainWindow>(*workbench_);
        window_->show();
    }
    void cleanup() {
        window_.reset();
        workbench_.reset();
    }

    // A dialog's own parts are gone when its base class hides it.
    void window_destroyedWhileNumberIsTyped_isReadByWholeDialog() {
        WindowDriver(*window_).trigger("packJobs");
        auto* spacing = window_->findChild<NumberBox*>(QStringLiteral("packSpacing"));
        QVERIFY(spacing && spacing->isVisible());
        QTest::keyClick(spacing, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(spacing, QStringLiteral("12"));
        bool isWhole = false;
        connect(spacing, &NumberBox::valueChanged, spacing, [&] {
            isWhole = spacing->window()->metaObject()->className() !=
                      QDialog::staticMetaObject.className();
        });
        window_.reset();
        QVERIFY(isWhole);
    }

    void refusedNumber_laterOneIsAccepted_messageGoes() {
        QVERIFY(makeProject());
        const auto* panel = window_->findChild<PropertyPanel*>();
        const auto boxes = panel->findChildren<NumberBox*>();
        const auto shown = std::ranges::find_if(
            boxes, [](const NumberBox* box) { return box->isVisible() && box->isEnabled(); });
        QVERIFY(shown != boxes.end());
        const auto enter = [&](double number) {
            (*shown)->selectAll();
            QTest::keyClicks(*shown, QString::number(number));
            QTest::keyClick(*shown, Qt::Key_Return);
        };
        enter(1e9);
        QVERIFY(window_->statusBar()->currentMessage().contains("outside the range"));
        enter(std::round(((*shown)->value() + (*shown)->maximum()) / 2));
        QVERIFY(!window_->statusBar()->currentMessage().contains("outside the range"));
    }

    void layout_savedByName_isRestored() {
        const WindowDriver driver(*window_);
        QVERIFY(makeProject());
        auto* log = driver.find<QDockWidget>("logDock");
        auto* results = driver.find<QDockWidget>("resultsDock");
        log->show();
        results->hide();
        driver.trigger("saveLayout");
        auto* question = driver.find<QInputDialog>("layoutName");
        QVERIFY(question && question->isVisible());
        question->setTextValue(QStringLiteral("Small / screen"));
        question->accept();
        driver.trigger("resetLayout");
        QVERIFY(results->isVisible() && !log->isVisible());
        QAction* entry = layoutEntry(QStringLiteral("Small / screen"));
        QVERIFY(entry);
        entry->trigger();
        QVERIFY(!results->isVisible() && log->isVisible());
    }

    void shortcuts_keyUsedTwice_isRefused() {
        PreferencesDialog dialog(workbench_->preferences(), workbench_->registry(),
                                 window_->actions());
        dialog.show();
        auto* clash = dialog.findChild<QLabel*>(QStringLiteral("shortcutClash"));
        const auto* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        QVERIFY(clash->text().isEmpty() && ok->isEnabled());
        QKeySequenceEdit* save = nullptr;
        for (auto* edit : dialog.findChildren<QKeySequenceEdit*>()) {
            save = edit->keySequence() == QKeySequence(QKeySequence::Save) ? edit : save;
        }
        save->setKeySequence(QKeySequence(QStringLiteral("Ctrl+R")));
        QVERIFY(clash->text().contains(QStringLiteral("Run")));
        QVERIFY(!ok->isEnabled());
        save->setKeySequence(QKeySequence(QStringLiteral("Ctrl+Alt+K")));
        QVERIFY(ok->isEnabled());
        QCOMPARE(dialog.preferences().shortcuts.value(QStringLiteral("save")),
                 QKeySequence(QStringLiteral("Ctrl+Alt+K")));
    }

    void copyReport_text_namesProgramMachineAndSolvers() {
        window_->findChild<QPushButton*>(QStringLiteral("copyReport"))->click();
        const QString report = QGuiApplication::clipboard()->text();
        for (const char* fact : {"Dipwright ", "Qt ", "OpenGL: ", "pbd-cpu"}) {
            QVERIFY2(report.contains(QLatin1String(fact)), qPrintable(report));
        }
    }

    void run_preferredSolverFails_showsNotice() {
        window_.reset();
        const PluginFolder folder;
        addFailingGpu(folder);
        const QByteArray before = qgetenv("DIPWRIGHT_PLUGIN_PATH");
        qputenv("DIPWRIGHT_PLUGIN_PATH",
                (folder.path() + QDir::listSeparator()).toLocal8Bit() + before);
        workbench_ = std::make_unique<Workbench>(folder_.filePath(QStringLiteral("recovery")));
        qputenv("DIPWRIGHT_PLUGIN_PATH", before);
        window_ = std::make_unique<MainWindow>(*workbench_);
        window_->show();
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        auto* notice = window_->findChild<NoticeBar*>();
        QVERIFY(!notice->isVisible());
        QVERIFY(driver.run());
        QVERIFY(notice->isVisible());
        QVERIFY2(notice->text().contains(QStringLiteral("took over")), qPrintable(notice->text()));
    }

    void numericalErrorDialog_automaticCells_showsNumericalError() {
        const WindowDriver driver(*window_);
        QVERIFY(!driver.action("certainty")->isEnabled());
        QVERIFY(WindowDriver(*window_).create(model, texture, 90, [](Project& project) {
            makeCoarse(project);
            project.film.resolution = FilmResolution::Automatic; // coarse film is too inaccurate
        }));
        driver.trigger("certainty");
        QVERIFY(!driver.action("certainty")->isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(driver.find<QDialog>("certaintyDialog"), patience());
        auto* dialog = driver.find<QDialog>("certaintyDialog");
        const auto* verdict = dialog->findChild<QLabel*>(QStringLiteral("verdict"));
        QVERIFY2(verdict->text().contains(QStringLiteral("this sheet is accurate enough")),
                 qPrintable(verdict->text()));
        const auto* figures = dialog->findChild<QTableWidget*>(QStringLiteral("figures"));
        QCOMPARE(figures->rowCount(), 2);
        QVERIFY2(figures->item(1, 2)->text().endsWith(QStringLiteral(" mm")),
                 qPrintable(figures->item(1, 2)->text()));
        QVERIFY(!dialog->findChild<PictureView*>()->isEmpty());
        emit qobject_cast<NumericalErrorDialog*>(dialog)->saveAsked(folder_.path());
        QTRY_VERIFY_WITH_TIMEOUT(
            QFileInfo::exists(folder_.filePath(QStringLiteral("certainty-1.png"))), patience());
        dialog->close();
    }

    void numericalErrorCheck_cancelled_showsNoDialog() {
        const WindowDriver driver(*window_);
        QVERIFY(makeProject());
        driver.trigger("certainty");
        driver.trigger("cancel");
        QTRY_VERIFY_WITH_TIMEOUT(driver.action("certainty")->isEnabled(), patience());
        QVERIFY(!driver.find<QDialog>("certaintyDialog"));
        QVERIFY(!driver.find<QMessageBox>("failure"));
    }

    void toleranceDialog_computed_showsZones() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        Document& document = *window_->document();
        document.edit({}, {}, [](Project& project) { project.tolerance.samples = 0; });
        QVERIFY(driver.run());
        driver.trigger("tolerances");
        QVERIFY(!driver.action("tolerances")->isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(driver.find<QDialog>("toleranceDialog"), patience());
        auto* dialog = driver.find<QDialog>("toleranceDialog");
        const auto* verdicts = dialog->findChild<QLabel*>(QStringLiteral("zoneVerdicts"));
        QVERIFY2(verdicts->text().contains(QStringLiteral("Zone C")), qPrintable(verdicts->text()));
        const auto* table = dialog->findChild<QTableWidget*>(QStringLiteral("contributions"));
        QCOMPARE(table->rowCount(), int(contributorCount) - 2); // no path, no timing
        QVERIFY2(table->item(0, 0)->text().endsWith(QStringLiteral(" mm")),
                 qPrintable(table->item(0, 0)->text()));
        QVERIFY(!dialog->findChild<PictureView*>()->isEmpty());
        dialog->close();

        // The report and the body show the zones until the result is stale.
        const auto* report = driver.find<QTextBrowser>("report");
        QVERIFY(report->toPlainText().contains(QStringLiteral("Zone C")));
        driver.trigger("zones");
        const QImage withZones = window_->view().picture();
        document.edit({}, {}, [](Project& project) { project.tolerance.swell = 0.02; });
        QVERIFY(window_->view().picture() != withZones);
        QVERIFY(!report->toPlainText().contains(QStringLiteral("Zone C")));
        driver.trigger("undo");
        QCOMPARE(window_->view().picture(), withZones);
    }

    void tolerances_cancelled_showsNoDialog() {
        const WindowDriver driver(*window_);
        QVERIFY(makeProject());
        driver.trigger("tolerances");
        driver.trigger("cancel");
        QTRY_VERIFY_WITH_TIMEOUT(driver.action("tolerances")->isEnabled(), patience());
        QVERIFY(!driver.find<QDialog>("toleranceDialog"));
        QVERIFY(!driver.find<QMessageBox>("failure"));
    }

    void zoneBrush_click_marksZone() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        const Document& document = *window_->document();
        driver.find<ProjectTree>("projectTree")->select({ProjectPart::Tolerance, 0});
        auto* brush = driver.find<QComboBox>("zoneBrush");
        brush->setCurrentIndex(brush->findData(int(Zone::A)));
        driver.find<QDoubleSpinBox>("zoneBrushRadius")->setValue(12);
        QVERIFY(driver.action("zones")->isChecked()); // marking shows the zones
        const QImage before = window_->view().picture();
        const Eigen::Vector3f middle = boundingBox(document.project().model->mesh).center();
        const QPointF place = window_->view().positionOf(middle + Eigen::Vector3f(0, 10, 0));
        QTest::mouseClick(&window_->view(), Qt::LeftButton, {}, place.toPoint());
        const std::vector<ZoneMark>& marks = document.project().tolerance.marks;
        QCOMPARE(marks.size(), std::size_t(1));
        QCOMPARE(marks[0].zone, Zone::A);
        QCOMPARE(marks[0].radius, Millimetres(12));
        QVERIFY(window_->view().picture() != before);
        driver.trigger("undo");
        QVERIFY(document.project().tolerance.marks.empty());
        QCOMPARE(window_->view().picture(), before);
    }

    void zoneBrush_drag_isOneUndoStep() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        const Document& document = *window_->document();
        driver.find<ProjectTree>("projectTree")->select({ProjectPart::Tolerance, 0});
        auto* brush = driver.find<QComboBox>("zoneBrush");
        brush->setCurrentIndex(brush->findData(int(Zone::B)));
        driver.find<QDoubleSpinBox>("zoneBrushRadius")->setValue(4);
        window_->view().picture();
        WindowDriver::drag(window_->view(), {0.45, 0.5}, {0.55, 0.5});
        const std::vector<ZoneMark>& marks = document.project().tolerance.marks;
        QCOMPARE(marks.size(), std::size_t(1));
        QVERIFY2(marks[0].path.size() > 3, qPrintable(QString::number(marks[0].path.size())));
        QCOMPARE(marks[0].extent, MarkExtent::Stroke);
        driver.trigger("undo");
        QVERIFY(marks.empty());
    }

    void maskBrush_drag_masksErasesAndUndoes() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        const Document& document = *window_->document();
        driver.trigger("fitPart");
        driver.find<ProjectTree>("projectTree")->select({ProjectPart::Model, 0});
        auto* brush = driver.find<QComboBox>("maskBrush");
        brush->setCurrentIndex(brush->findData(int(MarkExtent::Stroke)));
        driver.find<QDoubleSpinBox>("maskBrushRadius")->setValue(4);
        const auto& masks = document.project().masks;
        const auto area = [&] {
            const auto mask = surfaceMask(document.project().model, masks);
            return mask ? maskedAreas(*mask).area : 0;
        };
        const QImage before = window_->view().picture();
        WindowDriver::drag(window_->view(), {0.45, 0.5}, {0.55, 0.5});
        QCOMPARE(masks.size(), std::size_t(1));
        const double drawn = area();
        QVERIFY(drawn > 50);
        QVERIFY(window_->view().picture() != before);
        driver.find<QAbstractButton>("maskBrushEraser")->setChecked(true);
        WindowDriver::drag(window_->view(), {0.5, 0.5}, {0.6, 0.5});
        QCOMPARE(masks.size(), std::size_t(2));
        QVERIFY(masks[1].erases);
        QVERIFY(area() < 0.9 * drawn && area() > 0);
        driver.trigger("undo");
        QCOMPARE(area(), drawn);
        driver.trigger("redo");
        QVERIFY(area() < 0.9 * drawn);
        driver.trigger("undo");
        driver.trigger("undo");
        QVERIFY(masks.empty());
    }

    // The step that is undone is that of another size, so that the body is another one.
    void maskBrush_undoDuringStroke_dropsIt() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        Document& document = *window_->document();
        resizeModel(document, Millimetres(70));
        driver.trigger("fitPart");
        driver.find<ProjectTree>("projectTree")->select({ProjectPart::Model, 0});
        auto* brush = driver.find<QComboBox>("maskBrush");
        brush->setCurrentIndex(brush->findData(int(MarkExtent::Stroke)));
        window_->view().picture();
        const auto undo =
            connect(&window_->view(), &DipView::stroked, this, [&, number = 0]() mutable {
                if (++number == 5) {
                    document.undoStack().undo();
                }
            });
        WindowDriver::drag(window_->view(), {0.45, 0.5}, {0.55, 0.5});
        disconnect(undo);
        QVERIFY(document.project().masks.empty());
        WindowDriver::drag(window_->view(), {0.45, 0.5}, {0.55, 0.5});
        QCOMPARE(document.project().masks.size(), std::size_t(1));
    }

    void maskBrush_largeBrushOverManyTriangles_isShownAsCircle() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        driver.trigger("fitPart");
        window_->document()->edit(
            {}, {}, [](Project& project) { project.model = plainBody(sphereMesh(30, 96, 192)); });
        driver.find<ProjectTree>("projectTree")->select({ProjectPart::Model, 0});
        auto* brush = driver.find<QComboBox>("maskBrush");
        brush->setCurrentIndex(brush->findData(int(MarkExtent::Stroke)));
        driver.find<QDoubleSpinBox>("maskBrushRadius")->setValue(25);
        const QImage before = window_->view().picture();
        QTest::mouseMove(&window_->view(), window_->view().rect().center());
        QTRY_VERIFY_WITH_TIMEOUT(window_->view().picture() != before, patience());
    }

    void maskBrush_hover_showsWhatItWouldMask() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        driver.trigger("fitPart");
        driver.find<ProjectTree>("projectTree")->select({ProjectPart::Model, 0});
        auto* brush = driver.find<QComboBox>("maskBrush");
        brush->setCurrentIndex(brush->findData(int(MarkExtent::Stroke)));
        const QImage before = window_->view().picture();
        const QPoint middle = window_->view().rect().center();
        QTest::mouseMove(&window_->view(), middle);
        QTRY_VERIFY_WITH_TIMEOUT(window_->view().picture() != before, patience());
        QVERIFY(window_->document()->project().masks.empty());
    }

    void brushKeys_changeTheRadius() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        driver.find<ProjectTree>("projectTree")->select({ProjectPart::Model, 0});
        auto* radius = driver.find<QDoubleSpinBox>("maskBrushRadius");
        auto* brush = driver.find<QComboBox>("maskBrush");
        brush->setCurrentIndex(brush->findData(int(MarkExtent::Stroke)));
        const double before = radius->value();
        window_->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window_.get()));
        window_->view().setFocus();
        QTest::keyClick(&window_->view(), Qt::Key_BracketRight);
        QVERIFY(radius->value() > 1.1 * before);
        QTest::keyClick(&window_->view(), Qt::Key_BracketLeft);
        QVERIFY(std::abs(radius->value() - before) < 0.02);
        driver.find<QSlider>("maskBrushSize")->setValue(200);
        QVERIFY(radius->value() > 199);
    }

    void stretchPanel_quantityAndIsolines_changePicture() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        QVERIFY(driver.run());
        auto* stretch = window_->findChild<StretchPanel*>();
        const QImage plain = stretch->picture();
        QVERIFY(plain.height() > 2400);
        driver.find<QComboBox>("stretchQuantity")->setCurrentIndex(1);
        const QImage area = stretch->picture();
        QVERIFY(area != plain);
        driver.find<QCheckBox>("isolines")->setChecked(true);
        QVERIFY(stretch->picture() != area);
    }

    void droppedPicture_modelFileGone_replacesTexture() {
        const WindowDriver driver(*window_);
        QVERIFY(makeProject());
        window_->document()->edit({}, {}, [](Project& project) {
            project.modelOrigin.source = QStringLiteral("/gone/away.obj");
        });
        QImage picture(32, 32, QImage::Format_RGB32);
        picture.fill(Qt::red);
        const QString path = folder_.filePath(QStringLiteral("red.png"));
        QVERIFY(picture.save(path));
        driver.drop(path);
        QTRY_COMPARE(window_->document()->project().model->textures.at(0).size(), QSize(32, 32));
    }

    void draggedWebAddress_isNotAccepted() {
        QMimeData data;
        data.setUrls({QUrl(QStringLiteral("https://example.org/turtle.obj"))});
        for (QWidget* target : {static_cast<QWidget*>(window_.get()),
                                static_cast<QWidget*>(window_->findChild<DipView*>())}) {
            QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
            enter.ignore();
            QApplication::sendEvent(target, &enter);
            QVERIFY(!enter.isAccepted());
        }
    }

    void printHistory_openProject_opensProjectOfSheet() {
        QVERIFY(makeProject());
        const QString path = folder_.filePath(QStringLiteral("shelf.dipw"));
        QVERIFY(WindowDriver(*window_).saveAs(path));
        PrintRecord record;
        record.job = QStringLiteral("0123456789ab");
        record.source = printSource(window_->document()->project(), path);
        record.fate = PrintOutcome::Printed;
        QVERIFY(PrintHistory().keep(record).isEmpty());
        QTest::qWait(5); // so that the second record is newer
        PrintRecord other;
        other.job = QStringLiteral("ba9876543210");
        other.fate = PrintOutcome::Failed;
        other.reason = QStringLiteral("no such ink");
        QVERIFY(PrintHistory().keep(other).isEmpty());
        window_ = std::make_unique<MainWindow>(*workbench_);
        window_->show();
        const WindowDriver fresh(*window_);
        fresh.trigger("printHistory");
        auto* dialog = fresh.find<QDialog>("printHistory");
        auto* table = dialog->findChild<QTableWidget*>();
        QTRY_COMPARE(table->rowCount(), 2);
        const auto* facts = dialog->findChild<QLabel*>(QStringLiteral("facts"));
        QVERIFY2(facts->text().contains(other.reason), qPrintable(facts->text()));
        auto* open = dialog->findChild<QPushButton*>(QStringLiteral("openProject"));
        QVERIFY(!open->isEnabled()); // the newer sheet's project was never saved
        auto* search = dialog->findChild<QLineEdit*>(QStringLiteral("search"));
        search->setText(QStringLiteral("01234567"));
        QVERIFY(table->isRowHidden(0) && !table->isRowHidden(1));
        open->click();
        QTRY_VERIFY_WITH_TIMEOUT(window_->document() != nullptr, patience());
        QCOMPARE(window_->document()->path(), path);
    }

    void droppedPicture_afterRun_clearsResults() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        QVERIFY(driver.run());
        auto* map = driver.find<PictureView>("stretchMap");
        QVERIFY(!map->isEmpty());
        QVERIFY(driver.action("print")->isEnabled());
        QImage picture(32, 32, QImage::Format_RGB32);
        picture.fill(Qt::blue);
        const QString path = folder_.filePath(QStringLiteral("blue.png"));
        QVERIFY(picture.save(path));
        driver.drop(path);
        QTRY_VERIFY(map->isEmpty());
        QVERIFY(!driver.action("print")->isEnabled());
        QVERIFY(!driver.action("play")->isEnabled());
        QTest::mouseMove(map, map->rect().center()); // there are no values
        QTest::qWait(50);
        QVERIFY(driver.find<QLabel>("reading")->text().isEmpty());
    }

    void propertyPages_minimumSize_fits1024By700() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        auto* tree = driver.find<ProjectTree>("projectTree");
        for (const ProjectPart part :
             {ProjectPart::Model, ProjectPart::Film, ProjectPart::Process, ProjectPart::Immersion,
              ProjectPart::Sheet, ProjectPart::Ink, ProjectPart::Tolerance}) {
            tree->select({part, 0});
            QTest::qWait(20); // until the widgets are laid out
            const QSize least = window_->minimumSizeHint();
            QVERIFY2(
                least.width() <= 1024 && least.height() <= 700,
                qPrintable(QStringLiteral("page %1 needs %2 × %3 px, expected at most 1024 × 700")
                               .arg(int(part))
                               .arg(least.width())
                               .arg(least.height())));
        }
    }

    void propertyPages_afterTolerances_dockHasItsWidthAgain() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        window_->resize(1024, 700);
        auto* tree = driver.find<ProjectTree>("projectTree");
        auto* dock = driver.find<QDockWidget>("projectDock");
        tree->select({ProjectPart::Model, 0});
        QTest::qWait(50);
        const int before = dock->width();
        tree->select({ProjectPart::Tolerance, 0});
        QTest::qWait(50);
        QVERIFY2(dock->width() <= 360,
                 qPrintable(QStringLiteral("%1 px with the tolerances").arg(dock->width())));
        QVERIFY2(window_->view().width() >= 300,
                 qPrintable(QString::number(window_->view().width())));
        tree->select({ProjectPart::Model, 0});
        QTRY_COMPARE(dock->width(), before);
    }

    void windowMenu_pageBehindAnotherTab_isRaised() {
        const WindowDriver driver(*window_);
        QVERIFY(makeProject());
        auto* artwork = driver.find<QDockWidget>("artworkDock");
        auto* search = driver.find<QDockWidget>("searchDock");
        const auto isInFront = [](const QDockWidget* dock) {
            return dock->isVisible() && !dock->visibleRegion().isEmpty();
        };
        artwork->toggleViewAction()->trigger();
        QTRY_VERIFY(isInFront(artwork));
        search->toggleViewAction()->trigger();
        QTRY_VERIFY(isInFront(search) && !isInFront(artwork));
        artwork->toggleViewAction()->trigger(); // open, but behind
        QTRY_VERIFY(isInFront(artwork));
        QVERIFY(artwork->toggleViewAction()->isChecked());
        artwork->toggleViewAction()->trigger();
        QTRY_VERIFY(!artwork->isVisible());
        QVERIFY(!artwork->toggleViewAction()->isChecked());
    }

    void placeWarning_bodyPastFilmEdge_isShown() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        auto* warning = driver.find<QToolButton>("placeWarning");
        QVERIFY(!warning->isVisible());
        Document& document = *window_->document();
        document.edit(QStringLiteral("Move"), {},
                      [](Project& project) { project.immersions[0].offset[0] = Millimetres(80); });
        QVERIFY(warning->isVisible());
        QVERIFY2(warning->text().contains(QLatin1String("past the film's edge")),
                 qPrintable(warning->text()));
        document.undoStack().undo();
        QVERIFY(!warning->isVisible());
    }

    void poseSearch_takePose_canBeUndone() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        driver.trigger("findPoses");
        auto* start = driver.find<QPushButton>("startSearch");
        QVERIFY(start->isVisible());
        driver.find<NumberBox>("searchedPoses")->setValue(6);
        start->click();
        QVERIFY(!start->isEnabled());
        auto* table = driver.find<QTableWidget>("poseTable");
        QTRY_VERIFY_WITH_TIMEOUT(start->isEnabled() && table->rowCount() > 1, patience());
        Document& document = *window_->document();
        const std::vector<Immersion> before = document.project().immersions;
        const int steps = document.undoStack().count();
        table->selectRow(1); // the best pose may be the project's own
        driver.find<QPushButton>("takePose")->click();
        QVERIFY(document.project().immersions != before);
        QCOMPARE(document.undoStack().count(), steps + 1);
        document.undoStack().undo();
        QVERIFY(document.project().immersions == before);
        // After a search is stopped at once, a new one can start.
        start->click();
        driver.find<QPushButton>("stopSearch")->click();
        QTRY_VERIFY_WITH_TIMEOUT(start->isEnabled(), patience());
    }

    void poseSearch_poseClickedWhileSearching_isDippedAndTheSearchGoesOn() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        driver.trigger("findPoses");
        driver.find<NumberBox>("searchedPoses")->setValue(30);
        auto* start = driver.find<QPushButton>("startSearch");
        start->click();
        auto* table = driver.find<QTableWidget>("poseTable");
        Document& document = *window_->document();
        const std::vector<Immersion> before = document.project().immersions;
        QTRY_VERIFY_WITH_TIMEOUT(table->rowCount() > 0, patience());
        QVERIFY(!start->isEnabled()); // it is still searching
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                          table->visualItemRect(table->item(0, 0)).center());
        const std::vector<Immersion> clicked = document.project().immersions;
        QVERIFY(clicked != before);
        QTRY_VERIFY_WITH_TIMEOUT(document.result() && document.isFresh(), patience());
        QTRY_VERIFY_WITH_TIMEOUT(start->isEnabled(), patience());
        QVERIFY(table->rowCount() > 0);
        QVERIFY(document.project().immersions == clicked && document.isFresh());
        document.undoStack().undo();
        QVERIFY(document.project().immersions == before);
    }

    void snapshot_goBack_restoresProject() {
        const WindowDriver driver(*window_);
        QVERIFY(!driver.action("snapshots")->isEnabled());
        QVERIFY(makeProject());
        Document& document = *window_->document();
        const Project before = document.project();
        driver.trigger("snapshots");
        auto* dialog = driver.find<QDialog>("snapshots");
        const auto button = [dialog](const char* name) {
            return dialog->findChild<QPushButton*>(QLatin1String(name));
        };
        QVERIFY(!button("takeSnapshot")->isEnabled() && !button("goBack")->isEnabled());
        dialog->findChild<QLineEdit*>(QStringLiteral("snapshotName"))
            ->setText(QStringLiteral("As drawn"));
        button("takeSnapshot")->click();
        const auto* said = dialog->findChild<QLabel*>(QStringLiteral("difference"));
        QVERIFY2(said->text().contains(QStringLiteral("same")), qPrintable(said->text()));
        document.edit(QStringLiteral("Change"), {}, [](Project& project) {
            project.ink.limit = 1.25;
            project.immersions[0].offset[0] = Millimetres(7);
            addLayer(project.artwork, newLayer(LayerKind::Wood, QStringLiteral("Walnut")),
                     *project.model);
        });
        const auto* table = dialog->findChild<QTableWidget*>();
        QStringList rows;
        for (int row = 0; row < table->rowCount(); ++row) {
            rows << table->item(row, 0)->text() + u'|' + table->item(row, 1)->text() + u'|' +
                        table->item(row, 2)->text();
        }
        const QString all = rows.join(u'\n');
        QVERIFY2(all.contains(QStringLiteral("1.25")) && all.contains(QStringLiteral("7 mm")),
                 qPrintable(all));
        QVERIFY2(all.contains(QStringLiteral("layer 1|–|Walnut, 50 × 50 mm")), qPrintable(all));
        // The snapshot is saved in the file.
        const QString path = folder_.filePath(QStringLiteral("snapshots.dipw"));
        saveProject(document.project(), path);
        QCOMPARE(snapshots(loadProject(path)).size(), std::size_t(1));
        button("goBack")->click();
        QCOMPARE(document.project().ink.limit, before.ink.limit);
        QVERIFY(document.project().immersions == before.immersions);
        QVERIFY(document.project().artwork.isEmpty());
        QCOMPARE(document.project().model, before.model);
        QCOMPARE(snapshots(document.project()).size(), std::size_t(1));
        document.undoStack().undo();
        QCOMPARE(document.project().ink.limit, 1.25);
        button("removeSnapshot")->click();
        QVERIFY(snapshots(document.project()).empty());
        dialog->close();
    }

    void view_sectionAndSeeThrough_showInside() {
        const WindowDriver driver(*window_);
        QVERIFY(!driver.action("section")->isEnabled());
        QVERIFY(makeProject());
        DipView& view = window_->view();
        QTest::qWait(100); // until the widgets are laid out
        const QImage whole = view.picture();
        const auto* place = driver.find<QSlider>("sectionPlace");
        QVERIFY(!place->isVisible());
        driver.trigger("section");
        QVERIFY(place->isVisible());
        const QImage cut = view.picture();
        QVERIFY(cut != whole);
        driver.find<QSlider>("sectionPlace")->setValue(300);
        QVERIFY(view.picture() != cut);
        emit view.sectionDragged(0); // to the middle of the film
        const auto* text = driver.find<QLabel>("sectionPlaceText");
        QVERIFY2(std::abs(text->text().section(u' ', 0, 0).toDouble()) < 0.2,
                 qPrintable(text->text()));
        driver.trigger("section");
        QTRY_COMPARE(view.picture(), whole);
        auto* opacity = driver.find<QSlider>("filmOpacity");
        QVERIFY(!opacity->isVisible());
        driver.trigger("seeThrough");
        QVERIFY(opacity->isVisible() && !place->isVisible());
        QVERIFY(view.picture() != whole);
        driver.trigger("seeThrough");
        QTRY_COMPARE(view.picture(), whole);
    }

    void guide_search_findsChapters() {
        GuideWindow guide;
        auto* chapters = guide.findChild<QListWidget*>();
        auto* text = guide.findChild<QTextBrowser*>();
        const auto shown = [chapters] {
            int count = 0;
            for (int row = 0; row < chapters->count(); ++row) {
                count += !chapters->item(row)->isHidden();
            }
            return count;
        };
        const int all = shown();
        auto* search = guide.findChild<QLineEdit*>(QStringLiteral("search"));
        search->setText(QStringLiteral("calibrate printer"));
        QCOMPARE(shown(), 1);
        const int first = text->textCursor().selectionStart();
        QVERIFY(text->textCursor().hasSelection());
        search->setText(QStringLiteral("printer"));
        const qsizetype places = text->extraSelections().size();
        QVERIFY(places > 3 && shown() < all && first > 0);
        const int second = text->textCursor().selectionStart();
        emit search->returnPressed();
        QVERIFY(text->textCursor().selectionStart() > second);
        for (qsizetype place = 1; place < places; ++place) {
            emit search->returnPressed();
        }
        QCOMPARE(text->textCursor().selectionStart(), second); // wraps round to the first
        search->setText(QStringLiteral("no such word"));
        QCOMPARE(shown(), 0);
        search->clear();
        QCOMPARE(shown(), all);
        QVERIFY(text->extraSelections().isEmpty());
    }

    void measureTool_escapeKey_endsIt() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        QAction* measure = driver.action("measure");
        measure->trigger();
        QVERIFY(measure->isChecked());
        window_->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window_.get()));
        QTest::keyClick(window_.get(), Qt::Key_Escape);
        QVERIFY(!measure->isChecked());
    }

    void view_bodyBeingTurned_previewsCoverage() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        DipView& view = window_->view();
        emit view.rotationDragged(0, 30);
        const QImage turning = view.picture();
        emit view.rotationDragged(0, 60);
        QVERIFY(view.picture() != turning);
        emit view.rotationDragged(0, 30);
        QCOMPARE(view.picture(), turning);
        emit view.rotationFinished();
        QVERIFY(view.picture() != turning); // own appearance again, in the same pose
        QCOMPARE(window_->document()->project().immersions[0].rotation[0].value(), 30.0);
    }

    void view_bodyTurnedBack_leavesNoUndoStep() {
        WindowDriver driver(*window_);
        QVERIFY(makeProject());
        Document& document = *window_->document();
        document.edit({}, {}, [](Project& project) {
            project.immersions[0].rotation[1] = Degrees(12.34567);
            project.immersions[0].offset[0] = Millimetres(2.54321);
            project.process.depth = Millimetres(50.12345);
        });
        const Project before = document.project();
        const int steps = document.undoStack().count();
        DipView& view = window_->view();
        emit view.rotationDragged(0, 30);
        emit view.rotationDragged(0, 0); // as Escape does
        emit view.rotationFinished();
        for (int axis = 0; axis < 3; ++axis) {
            emit view.moveDragged(axis, 10);
            emit view.moveDragged(axis, 0);
            emit view.moveFinished();
        }
        QVERIFY(document.project() == before);
        QCOMPARE(document.undoStack().count(), steps);
        document.undoStack().undo();
        emit view.rotationDragged(0, 30);
        emit view.rotationDragged(0, 0);
        emit view.rotationFinished();
        QVERIFY(document.undoStack().canRedo());
    }

    void newProjectDialog_chosenFilm_isUsed() {
        NewProjectDialog dialog(model, workbench_->preferences());
        auto* films = dialog.findChild<QComboBox*>(QStringLiteral("filmProfile"));
        QVERIFY(films->count() > 1);
        QVERIFY2(films->itemText(1).contains(QLatin1String("not measured")),
                 qPrintable(films->itemText(1)));
        films->setCurrentIndex(1);
        Project project;
        dialog.completion()(project);
        QVERIFY(project.profiles.film);
        QCOMPARE(project.profiles.film->name, films->currentData().toString());
    }

    void newProjectDialog_chosenSize_isShown() {
        NewProjectDialog dialog(model, workbench_->preferences());
        auto* extent = dialog.findChild<QLabel*>(QStringLiteral("extent"));
        const auto said = [&](const char* text) {
            return extent->text().contains(QLatin1String(text));
        };
        QTRY_VERIFY_WITH_TIMEOUT(said("The part measures") && said("guess"), patience());
        for (auto* choice : dialog.findChildren<QRadioButton*>()) {
            if (!choice->isChecked()) {
                choice->click();
                break;
            }
        }
        dialog.findChild<QDoubleSpinBox*>()->setValue(123);
        QVERIFY2(said("123.00 mm") && !said("guess"), qPrintable(extent->text()));
    }

    void newProjectDialog_damagedModel_keepsDialogAndSaysWhy() {
        const QTemporaryDir folder;
        const QString damaged = folder.filePath(QStringLiteral("damaged.obj"));
        QFile file(damaged);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("f 1 2 3\n") > 0);
        file.close();
        NewProjectDialog dialog(damaged, workbench_->preferences());
        dialog.show();
        auto* extent = dialog.findChild<QLabel*>(QStringLiteral("extent"));
        dialog.accept(); // before the model has been read
        QVERIFY(dialog.isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(extent->text().contains(QLatin1String("damaged.obj")), patience());
        QVERIFY(dialog.isVisible());
        QVERIFY(extent->height() >= extent->heightForWidth(extent->width()));
        auto* line = dialog.findChild<QLineEdit*>();
        QCOMPARE(line->text(), damaged);
        QSignalSpy accepted(&dialog, &QDialog::accepted);
        line->setText(model);
        dialog.accept();
        QTRY_COMPARE_WITH_TIMEOUT(accepted.count(), 1, patience());
    }

    void newProjectDialog_preferredPrinter_isUsed() {
        Preferences preferences = workbench_->preferences();
        const QString wanted = firstPrinter();
        preferences.printerProfile = wanted;
        const NewProjectDialog dialog(model, preferences);
        Project project;
        project.immersions = {Immersion{}};
        dialog.completion()(project);
        QVERIFY(project.profiles.printer.has_value());
        QCOMPARE(project.profiles.printer->name, wanted);
    }

private:
    bool makeProject() { return WindowDriver(*window_).create(model, texture, 90, makeCoarse); }
    QString firstPrinter() const {
        const PreferencesDialog dialog(workbench_->preferences(), workbench_->registry(), {});
        return dialog.findChild<QComboBox*>(QStringLiteral("defaultPrinter"))->itemText(1);
    }
    QAction* layoutEntry(const QString& name) const {
        auto* menu = window_->findChild<QMenu*>(QStringLiteral("layouts"));
        emit menu->aboutToShow();
        for (QAction* action : menu->actions()) {
            if (action->text() == name) {
                return action;
            }
        }
        return nullptr;
    }

    QTemporaryDir folder_;
    std::unique_ptr<Workbench> workbench_;
    std::unique_ptr<MainWindow> window_;
};

int main(int argc, char** argv) {
    return runWindowTest<HabitsTest>(argc, argv);
}
#include "HabitsTest.moc"
