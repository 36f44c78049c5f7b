// Works with the real window as a user typically does in a day: create, run, scrub, read values,
// change, undo, save, close and reopen. Also tries to open invalid files.
#include "Patience.h"
#include "TestFolders.h"
#include "WindowDriver.h"
#include "base/Error.h"
#include "disk/ZipWriter.h"
#include "project/ProjectStore.h"
#include "project/ZipReader.h"
#include "workbench/compare/SnapshotsDialog.h"
#include "workbench/project/ProjectTree.h"
#include "workbench/results/Timeline.h"
#include "workbench/widgets/PictureView.h"

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QJsonDocument>
#include <QLabel>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QSlider>
#include <QTabWidget>
#include <QTextBlock>
#include <QTextBrowser>

using namespace dipwright;

namespace {

const QString model = sampleFolder("/models/turtle.obj");
const QString texture = sampleFolder("/models/turtle.png");

void makeTwoCoarseDips(Project& project) {
    makeCoarse(project);
    project.immersions = {Immersion{}, Immersion{}};
    project.immersions[0].name = QStringLiteral("Bottom");
    project.immersions[1].name = QStringLiteral("Top");
    project.immersions[1].rotation[0] = Degrees(180);
}

void writeNewerProject(const QString& original, const QString& path) {
    ZipReader reader(original);
    QJsonObject json =
        QJsonDocument::fromJson(reader.read(QStringLiteral("project.json"))).object();
    json[QStringLiteral("version")] = 99;
    ZipWriter writer;
    writer.add(QStringLiteral("mimetype"), reader.read(QStringLiteral("mimetype")),
               ZipWriter::Packing::Stored);
    writer.add(QStringLiteral("project.json"), QJsonDocument(json).toJson(),
               ZipWriter::Packing::Deflated);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(writer.finish());
}

// Scrolls to the link and returns its place in the browser's viewport.
QPoint placeOfLink(QTextBrowser& browser, const QString& link) {
    for (QTextBlock block = browser.document()->begin(); block.isValid(); block = block.next()) {
        for (auto part = block.begin(); !part.atEnd(); ++part) {
            if (part.fragment().charFormat().anchorHref() == link) {
                QTextCursor cursor(browser.document());
                cursor.setPosition(part.fragment().position() + 2);
                browser.setTextCursor(cursor);
                browser.ensureCursorVisible();
                return browser.cursorRect(cursor).center();
            }
        }
    }
    return {-1, -1};
}

QMessageBox* shownMessage(const char* name) {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        auto* box = qobject_cast<QMessageBox*>(widget);
        if (box && box->isVisible() && box->objectName() == QLatin1String(name)) {
            return box;
        }
    }
    return nullptr;
}

void answerWhenAsked(const char* name, QMessageBox::StandardButton answer) {
    auto* timer = new QTimer(qApp);
    QObject::connect(timer, &QTimer::timeout, qApp, [timer, name, answer] {
        if (QMessageBox* box = shownMessage(name)) {
            timer->deleteLater();
            box->button(answer)->click();
        }
    });
    timer->start(20);
}

// Shows the finished part in the view and returns the picture.
QImage printOnTheBody(MainWindow& window, const WindowDriver& driver) {
    driver.find<ProjectTree>("projectTree")->select({ProjectPart::Share, 0});
    const QImage own = window.view().picture();
    driver.trigger("bodyPrint");
    [&] { QTRY_VERIFY_WITH_TIMEOUT(window.view().picture() != own, patience()); }();
    QTest::qWait(patience() / 240); // until the preview is complete
    return window.view().picture();
}

} // namespace

class DayTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        workbench_ = std::make_unique<Workbench>(folder_.filePath(QStringLiteral("recovery")));
        Preferences preferences = workbench_->preferences();
        preferences.liveUpdate = false;
        workbench_->setPreferences(preferences);
    }
    void cleanupTestCase() { workbench_.reset(); }

    void window_newRunSaveReopen_givesSameSheets() {
        auto window = std::make_unique<MainWindow>(*workbench_);
        window->show();
        WindowDriver driver(*window);
        QVERIFY(!driver.action("run")->isEnabled()); // no project yet

        // New, from a model.
        QVERIFY(driver.create(model, texture, 90, makeTwoCoarseDips));
        Document& document = *window->document();
        QCOMPARE(document.project().immersions.size(), std::size_t(2));
        QVERIFY(window->isWindowModified());

        // Run both dips.
        QVERIFY(driver.run());
        QVERIFY(document.isFresh());
        const QImage sheet = document.result()->immersions[0].sheet.image;
        const QImage otherSheet = document.result()->immersions[1].sheet.image;
        QVERIFY(!sheet.isNull() && sheet != otherSheet);

        scrub(*window);
        readValue(*window, driver);
        changeAndUndo(*window, driver);
        switchImmersion(*window, driver);
        plan(*window, driver);

        // Save, close, reopen: the same sheets, bit for bit.
        const QString path = folder_.filePath(QStringLiteral("turtle.dipw"));
        QVERIFY(driver.saveAs(path));
        QVERIFY(!window->isWindowModified());
        QVERIFY(window->close());
        window.reset();

        auto again = std::make_unique<MainWindow>(*workbench_);
        again->show();
        WindowDriver driverAgain(*again);
        QVERIFY(driverAgain.open(path));
        QVERIFY(driverAgain.run());
        QCOMPARE(again->document()->result()->immersions[0].sheet.image, sheet);
        QCOMPARE(again->document()->result()->immersions[1].sheet.image, otherSheet);
        QVERIFY(again->close());
    }

    void verdict_clickOnPlace_showsItInView() {
        MainWindow window(*workbench_);
        window.show();
        WindowDriver driver(window);
        QVERIFY(driver.create(model, {}, 90, [](Project& project) {
            makeTwoCoarseDips(project);
            project.film.columns = 24; // far too few
            project.film.rows = 34;
        }));
        QVERIFY(driver.run());
        const ImmersionResult& result = window.document()->result()->immersions[0];
        QVERIFY(result.verdict.advice > Advice::Print && !result.verdict.places.empty());
        driver.find<QTabWidget>("results")->setCurrentIndex(0);
        window.view().look(ViewDirection::Oblique);
        auto* timeline = window.findChild<Timeline*>();
        timeline->setPosition(0);
        const QImage before = window.view().picture();

        auto* words = driver.find<QTextBrowser>("verdict");
        const QPoint link = placeOfLink(*words, QStringLiteral("0"));
        QVERIFY2(words->viewport()->rect().contains(link), qPrintable(words->toPlainText()));
        QTest::mouseClick(words->viewport(), Qt::LeftButton, {}, link);
        QCOMPARE(timeline->position(), timeline->frames()); // the end of the dip
        QVERIFY(window.view().picture() != before);
        // The place, transformed from the model to the tank, is in the middle of the view.
        const Eigen::Isometry3d pose = result.body->modelToPose;
        const Eigen::Vector3d world =
            poseToWorld(result.immersion,
                        dipTravel(window.document()->project().process, *result.body)) +
            pose * result.verdict.places.front().place.cast<double>();
        const QPointF shown = window.view().positionOf(world.cast<float>());
        const QPointF middle = QRectF(window.view().rect()).center();
        QVERIFY2(
            (shown - middle).manhattanLength() < 20,
            qPrintable(QStringLiteral("the place is shown at (%1, %2) px, expected (%3, %4) px")
                           .arg(shown.x())
                           .arg(shown.y())
                           .arg(middle.x())
                           .arg(middle.y())));
        QVERIFY(driver.find<QLabel>("reading")->text().contains(QStringLiteral("on the part")));
        answerWhenAsked("closeQuestion", QMessageBox::Discard);
        QVERIFY(window.close());
    }

    void run_cancelled_windowStaysUsable() {
        MainWindow window(*workbench_);
        window.show();
        WindowDriver driver(window);
        QVERIFY(driver.create(model, {}, 90, makeTwoCoarseDips));
        QSignalSpy stopped(&window.session(), &DipSession::stopped);
        driver.trigger("run");
        QVERIFY(window.session().isRunning());
        QVERIFY(driver.action("cancel")->isEnabled());
        driver.trigger("cancel");
        QCOMPARE(stopped.count(), 1); // at once
        QVERIFY(!window.session().isRunning());
        QVERIFY(driver.action("run")->isEnabled());
        QVERIFY(!window.document()->result());
        QVERIFY(driver.run()); // runs to the end
        answerWhenAsked("closeQuestion", QMessageBox::Discard);
        QVERIFY(window.close());
    }

    void close_unsavedChanges_asksFirst() {
        MainWindow window(*workbench_);
        window.show();
        WindowDriver driver(window);
        QVERIFY(driver.open(folder_.filePath(QStringLiteral("turtle.dipw"))));
        QVERIFY(window.close()); // no changes, so no question
        window.show();
        window.document()->edit({}, {}, [](Project& project) { project.name.append(u'!'); });
        answerWhenAsked("closeQuestion", QMessageBox::Cancel);
        QVERIFY(!window.close());
        answerWhenAsked("closeQuestion", QMessageBox::Save);
        QVERIFY(window.close());
        QCOMPARE(loadProject(window.document()->path()).name, QStringLiteral("turtle!"));
    }

    void close_whileSaving_fileIsComplete() {
        const QString path = folder_.filePath(QStringLiteral("turtle.dipw"));
        const auto rename = [](Document& document, const QString& name) {
            document.edit({}, {}, [&](Project& project) { project.name = name; });
        };
        MainWindow window(*workbench_);
        window.show();
        WindowDriver driver(window);
        QVERIFY(driver.open(path));
        rename(*window.document(), QStringLiteral("First"));
        driver.trigger("save");
        QVERIFY(window.documents().isSaving());
        QVERIFY(window.close()); // no question: nothing was changed since
        QCOMPARE(loadProject(path).name, QStringLiteral("First"));

        window.show();
        rename(*window.document(), QStringLiteral("Second"));
        driver.trigger("save");
        rename(*window.document(), QStringLiteral("Third"));
        answerWhenAsked("closeQuestion", QMessageBox::Discard);
        QVERIFY(window.close());
        QCOMPARE(loadProject(path).name, QStringLiteral("Second"));
    }

    void openProject_damagedFile_namesFile_data() {
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("not a project") << QByteArray("This is a letter.");
        QFile whole(folder_.filePath(QStringLiteral("turtle.dipw")));
        QVERIFY(whole.open(QIODevice::ReadOnly));
        const QByteArray bytes = whole.readAll();
        QTest::newRow("truncated") << bytes.left(bytes.size() / 2);
    }
    void openProject_damagedFile_namesFile() {
        QFETCH(QByteArray, content);
        const QString path = folder_.filePath(QStringLiteral("damaged.dipw"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
        file.close();
        MainWindow window(*workbench_);
        window.show();
        window.documents().openProject(path);
        QTRY_VERIFY(shownMessage("failure") != nullptr);
        QVERIFY(shownMessage("failure")->text().contains(QStringLiteral("damaged.dipw")));
        QVERIFY(window.document() == nullptr);
        shownMessage("failure")->accept();
    }

    void openProject_newerVersion_namesVersion() {
        const QString path = folder_.filePath(QStringLiteral("newer.dipw"));
        writeNewerProject(folder_.filePath(QStringLiteral("turtle.dipw")), path);
        MainWindow window(*workbench_);
        window.show();
        window.documents().openProject(path);
        QTRY_VERIFY(shownMessage("failure") != nullptr);
        QVERIFY(shownMessage("failure")->text().contains(QStringLiteral("99")));
        shownMessage("failure")->accept();
    }

    void openProject_missingFile_showsFailure() {
        MainWindow window(*workbench_);
        window.show();
        window.documents().openProject(folder_.filePath(QStringLiteral("nowhere.dipw")));
        QTRY_VERIFY(shownMessage("failure") != nullptr);
        shownMessage("failure")->accept();
    }

    void droppedPicture_onWindow_becomesTexture() {
        MainWindow window(*workbench_);
        window.show();
        WindowDriver driver(window);
        QVERIFY(driver.open(folder_.filePath(QStringLiteral("turtle.dipw"))));
        QImage picture(64, 64, QImage::Format_RGB32);
        picture.fill(Qt::darkGreen);
        const QString path = folder_.filePath(QStringLiteral("green.png"));
        QVERIFY(picture.save(path));
        driver.drop(path);
        QTRY_COMPARE(window.document()->project().model->textures.at(0).size(), QSize(64, 64));
        QCOMPARE(window.document()->project().immersions.size(), std::size_t(2));
        driver.trigger("undo");
        QVERIFY(window.document()->project().model->textures.at(0).size() != QSize(64, 64));
        QVERIFY(!window.document()->isModified());
    }

    void seamBrush_click_movesSeamUntilUndo() {
        MainWindow window(*workbench_);
        window.show();
        WindowDriver driver(window);
        // On coarse film, both dips reach only a narrow band. A small registration error keeps the
        // overlap narrow, so that the seam can move.
        QVERIFY(driver.create(model, texture, 90, [](Project& project) {
            makeTwoCoarseDips(project);
            project.share.registrationError = Millimetres(0.1);
        }));
        QVERIFY(driver.run());
        const Document& document = *window.document();
        const double before = document.result()->share->areas.second;
        driver.find<ProjectTree>("projectTree")->select({ProjectPart::Share, 0});
        driver.find<QDoubleSpinBox>("joinBrushRadius")->setValue(15);
        driver.trigger("coverage"); // hides the film over the body
        auto* timeline = window.findChild<Timeline*>();
        timeline->setPosition(timeline->frames());
        driver.trigger("right"); // shows where both dips reach
        const auto areaGivenTo = [&](ShareMarkKind kind) {
            auto* brush = driver.find<QComboBox>("joinBrush");
            brush->setCurrentIndex(brush->findData(int(kind)));
            window.view().picture();
            const ImmersionResult& dip = document.result()->immersions[0];
            const double travel = dipTravel(document.project().process, *dip.body);
            const Eigen::Vector3d middle =
                poseToWorld(dip.immersion, travel) + Eigen::Vector3d(0, dip.body->height / 2, 0);
            QTest::mouseClick(&window.view(), Qt::LeftButton, {},
                              window.view().positionOf(middle.cast<float>()).toPoint());
            const bool isMarked = document.project().share.marks.size() == 1 && !document.isFresh();
            return isMarked && driver.run() ? document.result()->share->areas.second : -1;
        };
        const double more = areaGivenTo(ShareMarkKind::Second);
        driver.trigger("undo");
        QVERIFY(document.project().share.marks.empty());
        const double less = areaGivenTo(ShareMarkKind::First);
        QVERIFY2(
            less > 0 && less <= before && before <= more && less + 20 < more,
            qPrintable(QStringLiteral("dip 2 paints %1 mm² after a mark for dip 1, %2 mm² without "
                                      "marks, %3 mm² after a mark for dip 2")
                           .arg(less)
                           .arg(before)
                           .arg(more)));
        driver.trigger("undo");
        QVERIFY(driver.run());
        QCOMPARE(document.result()->share->areas.second, before);
    }

    void seamBrush_drag_isOneUndoStep() {
        MainWindow window(*workbench_);
        window.show();
        WindowDriver driver(window);
        QVERIFY(driver.create(model, texture, 90, makeTwoCoarseDips));
        QVERIFY(driver.run());
        const Document& document = *window.document();
        driver.find<ProjectTree>("projectTree")->select({ProjectPart::Share, 0});
        driver.find<QDoubleSpinBox>("joinBrushRadius")->setValue(2);
        driver.trigger("coverage");
        driver.trigger("top");
        auto* brush = driver.find<QComboBox>("joinBrush");
        brush->setCurrentIndex(brush->findData(int(ShareMarkKind::Avoid)));
        const QImage unmarked = window.view().picture();
        WindowDriver::drag(window.view(), {0.5, 0.5}, {0.56, 0.52});
        QCOMPARE(document.project().share.marks.size(), std::size_t(1));
        QVERIFY(document.project().share.marks[0].path.size() > 2);
        QVERIFY(window.view().picture() != unmarked); // the marks are drawn
        driver.trigger("undo");
        QVERIFY(document.project().share.marks.empty());
        QTRY_VERIFY(window.view().picture() == unmarked); // after the banner is hidden
    }

    void finishedPart_firstDipOrSlip_changesPreview() {
        MainWindow window(*workbench_);
        window.show();
        WindowDriver driver(window);
        QVERIFY(driver.create(model, texture, 90, makeTwoCoarseDips));
        QVERIFY(driver.run());
        const QImage both = printOnTheBody(window, driver);
        auto* dips = driver.find<QComboBox>("printDips");
        dips->setCurrentIndex(1);
        QTRY_VERIFY_WITH_TIMEOUT(window.view().picture() != both, patience());
        dips->setCurrentIndex(0);
        QTRY_VERIFY_WITH_TIMEOUT(window.view().picture() == both, patience());
        driver.find<QDoubleSpinBox>("slipX")->setValue(4);
        QTRY_VERIFY_WITH_TIMEOUT(window.view().picture() != both, patience());
        driver.find<QDoubleSpinBox>("slipX")->setValue(0);
        QTRY_VERIFY_WITH_TIMEOUT(window.view().picture() == both, patience());
        window.document()->edit(QStringLiteral("Part's Colour"), {}, [](Project& project) {
            project.baseColour = QStringLiteral("#2040a0");
        });
        QTRY_VERIFY_WITH_TIMEOUT(window.view().picture() != both, patience());
        driver.trigger("undo");
        QTRY_VERIFY_WITH_TIMEOUT(window.view().picture() == both, patience());
    }

    void finishedPart_secondDipDeeper_changesPreview() {
        MainWindow window(*workbench_);
        window.show();
        WindowDriver driver(window);
        QVERIFY(driver.create(model, texture, 90, [](Project& project) {
            makeTwoCoarseDips(project);
            project.process.depth = Millimetres(20);
        }));
        QVERIFY(driver.run());
        const QImage both = printOnTheBody(window, driver);
        auto* deeper = driver.find<QDoubleSpinBox>("slipDepth");
        deeper->setValue(8);
        QTRY_VERIFY_WITH_TIMEOUT(window.view().picture() != both, patience());
        deeper->setValue(-8);
        QTest::qWait(patience() / 240);
        const QImage lessDeep = window.view().picture();
        QVERIFY(lessDeep != both);
        deeper->setValue(0);
        QTRY_VERIFY_WITH_TIMEOUT(window.view().picture() == both, patience());
    }

    void swapDips_undo_restoresOrder() {
        MainWindow window(*workbench_);
        window.show();
        WindowDriver driver(window);
        QVERIFY(driver.create(model, texture, 90, makeTwoCoarseDips));
        const Document& document = *window.document();
        const Project before = document.project();
        driver.trigger("swapImmersions");
        QCOMPARE(document.project().immersions[0].name, before.immersions[1].name);
        QCOMPARE(document.project().immersions[1].name, before.immersions[0].name);
        driver.trigger("undo");
        QVERIFY(document.project() == before);
    }

private:
    // Changes a weight of the pose search, moves the body as a dragged arrow does (the signal
    // moveDragged), and compares a snapshot with the project. Then undoes all of it.
    void plan(MainWindow& window, const WindowDriver& driver) {
        Document& document = *window.document();
        const Project before = document.project();
        driver.find<QDoubleSpinBox>("weight_quality")->setValue(2);
        QCOMPARE(document.project().poseAims.weights[Measure::Quality], 2.0);
        emit window.view().moveDragged(0, 10);
        emit window.view().moveFinished();
        QCOMPARE(document.project().immersions[0].offset[0].value(), 10.0);
        driver.trigger("undo");
        driver.trigger("undo");
        QVERIFY(document.project() == before);
        takeSnapshot(document, QStringLiteral("Noon"));
        driver.trigger("snapshots");
        auto* snapshots = window.findChild<SnapshotsDialog*>();
        snapshots->findChild<QPushButton*>(QStringLiteral("sideBySide"))->click();
        const QPointer<QDialog> compared =
            window.findChild<QDialog*>(QStringLiteral("compareWindow"));
        QVERIFY(compared && compared->isVisible());
        QTest::keyClick(compared.data(), Qt::Key_Escape);
        QTRY_VERIFY(!compared);
        snapshots->close();
        driver.trigger("undo");
        QVERIFY(document.project() == before);
    }
    void scrub(MainWindow& window) {
        auto* timeline = window.findChild<Timeline*>();
        QVERIFY(timeline->frames() > 2);
        timeline->setPosition(timeline->frames());
        const QImage end = window.view().picture();
        timeline->setPosition(timeline->frames() / 2);
        const QImage middle = window.view().picture();
        QVERIFY(middle != end);
        timeline->setPosition(0);
        QVERIFY(window.view().picture() != middle);
        timeline->setPosition(timeline->frames());
        QCOMPARE(window.view().picture(), end);
    }

    // Reads the stretch under the cursor in the map of the flat film. Meanwhile the 3D view marks
    // the same place.
    void readValue(MainWindow& window, const WindowDriver& driver) {
        driver.find<QTabWidget>("results")->setCurrentIndex(1); // after the verdict
        auto* map = driver.find<PictureView>("stretchMap");
        auto* reading = driver.find<QLabel>("reading");
        QVERIFY(reading->text().isEmpty());
        // In the upper part of the sheet. There the film stays on the water, so the view shows it.
        QTest::mouseMove(map, QPoint(map->width() / 2, map->height() / 5));
        QTRY_VERIFY(reading->text().contains(QStringLiteral("stretch")));
        const QImage marked = window.view().picture();
        QTest::mouseMove(map, QPoint(2, 2)); // outside the film
        QTRY_VERIFY(reading->text().isEmpty());
        QVERIFY(window.view().picture() != marked); // the linked cursor is gone
    }

    void changeAndUndo(MainWindow& window, const WindowDriver& driver) {
        Document& document = *window.document();
        auto* tree = driver.find<ProjectTree>("projectTree");
        tree->select({ProjectPart::Ink, 0});
        auto* limit = driver.find<QDoubleSpinBox>("ink.limit");
        QVERIFY(limit != nullptr);
        limit->setValue(1.25);
        QCOMPARE(document.project().ink.limit, 1.25);
        QVERIFY(driver.find<QLabel>("staleBanner")->isVisible());
        QVERIFY(document.isFresh(JobStep::Dip, 0));
        QVERIFY(!document.isFresh(JobStep::Sheet, 0));
        driver.trigger("undo");
        QVERIFY(document.project().ink.limit != 1.25);
        QVERIFY(document.isFresh());
        QVERIFY(!driver.find<QLabel>("staleBanner")->isVisible());
        driver.trigger("redo");
        QCOMPARE(document.project().ink.limit, 1.25);
        QCOMPARE(driver.find<QDoubleSpinBox>("ink.limit")->value(), 1.25);
        driver.trigger("undo");
    }

    void switchImmersion(MainWindow& window, const WindowDriver& driver) {
        const QImage first = driver.find<PictureView>("stretchMap")->picture();
        window.session().lookAt(1);
        QVERIFY(driver.find<PictureView>("stretchMap")->picture() != first);
        window.session().lookAt(0);
        QCOMPARE(driver.find<PictureView>("stretchMap")->picture(), first);
    }

    QTemporaryDir folder_;
    std::unique_ptr<Workbench> workbench_;
};

int main(int argc, char** argv) {
    return runWindowTest<DayTest>(argc, argv);
}
#include "DayTest.moc"
