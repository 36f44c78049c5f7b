// Takes screenshots of the program's windows, for the guide, the README and checks of the layout.
#include "WindowDriver.h"
#include "artwork/EditArtwork.h"
#include "base/Error.h"
#include "project/Profiles.h"
#include "project/ProjectStore.h"
#include "workbench/compare/CompareWindow.h"
#include "workbench/compare/SnapshotsDialog.h"
#include "workbench/document/RecentProjects.h"
#include "workbench/help/GuidePictures.h"
#include "workbench/help/GuideWindow.h"
#include "workbench/preferences/PreferencesDialog.h"
#include "workbench/printing/CalibrationDialog.h"
#include "workbench/printing/PackDialog.h"
#include "workbench/printing/PrintDialog.h"
#include "workbench/printing/PrintHistoryDialog.h"
#include "workbench/profiles/ProfilesDialog.h"
#include "workbench/project/NewProjectDialog.h"
#include "workbench/project/ProjectTree.h"
#include "workbench/queue/QueueDialog.h"
#include "workbench/results/Timeline.h"
#include "workbench/widgets/Languages.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/Theme.h"

#include <QApplication>
#include <QComboBox>
#include <QCommandLineParser>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>
#include <QTableWidget>
#include <QTimer>
#include <QToolButton>

using namespace dipwright;

namespace {

class Photographer {
public:
    Photographer(const QString& folder, const QString& prefix) : folder_(folder), prefix_(prefix) {
        if (!folder.isEmpty()) {
            QDir().mkpath(folder);
        }
    }
    void take(QWidget& widget, const QString& name) const {
        QTest::qWait(300); // layouts
        if (auto* view = widget.findChild<DipView*>()) {
            view->picture();
        }
        keep(widget.grab().toImage(), name);
    }

    void keep(const QImage& picture, const QString& name) const {
        picture.save(QStringLiteral("%1/%2%3.png").arg(folder_, prefix_, name));
    }

private:
    QString folder_, prefix_;
};

void photographParts(WindowDriver& driver, MainWindow& window, const Photographer& camera) {
    auto* tree = driver.find<ProjectTree>("projectTree");
    const std::vector<std::pair<ProjectPart, const char*>> parts{
        {ProjectPart::Model, "model"},         {ProjectPart::Film, "film"},
        {ProjectPart::Process, "process"},     {ProjectPart::Share, "join"},
        {ProjectPart::Sheet, "sheet"},         {ProjectPart::Ink, "ink"},
        {ProjectPart::Tolerance, "tolerance"}, {ProjectPart::Immersion, "immersion"}};
    for (const auto& [part, name] : parts) {
        tree->select({part, 0});
        camera.take(window, QStringLiteral("part-%1").arg(QLatin1String(name)));
    }
}

void photographTabs(QTabWidget& tabs, MainWindow& window, const Photographer& camera,
                    const QString& name) {
    for (int tab = 0; tab < tabs.count(); ++tab) {
        tabs.setCurrentIndex(tab);
        camera.take(window, QStringLiteral("%1-%2").arg(name).arg(tab));
    }
    tabs.setCurrentIndex(0);
}

void photographInspection(WindowDriver& driver, MainWindow& window, const Photographer& camera) {
    auto* dock = driver.find<QDockWidget>("inspectionDock");
    dock->show();
    dock->raise();
    photographTabs(*dock->findChild<QTabWidget*>(), window, camera, QStringLiteral("inspection"));
    dock->hide();
}

// Takes the pictures that exist only if two dips share the body.
void photographShares(WindowDriver& driver, MainWindow& window, const Photographer& camera) {
    driver.trigger("filmShares");
    camera.take(window, QStringLiteral("film-shares"));
    driver.trigger("sheetShares");
    driver.find<QTabWidget>("results")->setCurrentIndex(4);
    camera.take(window, QStringLiteral("sheet-shares"));
    driver.trigger("sheetShares");
    driver.trigger("proofShares");
    driver.find<QTabWidget>("results")->setCurrentIndex(3); // the proof
    driver.find<ProjectTree>("projectTree")->select({ProjectPart::Share, 0});
    driver.trigger("coverage");
    driver.find<QComboBox>("joinBrush")->setCurrentIndex(3);
    window.view().picture(); // draws the view first
    driver.drag(window.view(), {0.5, 0.5}, {0.56, 0.5});
    camera.take(window, QStringLiteral("marks"));
    driver.trigger("undo");
    driver.trigger("proofShares");
    driver.trigger("bodyPrint");
    driver.find<QComboBox>("printDips")->setCurrentIndex(1);
    camera.take(window, QStringLiteral("after-first-dip"));
    driver.find<QComboBox>("printDips")->setCurrentIndex(0);
    driver.find<QDoubleSpinBox>("slipX")->setValue(3);
    camera.take(window, QStringLiteral("slipped"));
    driver.find<QDoubleSpinBox>("slipX")->setValue(0);
    driver.find<QDoubleSpinBox>("slipDepth")->setValue(8); // has an effect only with a depth
    camera.take(window, QStringLiteral("deeper"));
    driver.trigger("bodyPrint");
    driver.find<QTabWidget>("results")->setCurrentIndex(0);
}

// Takes the body cut open, and through a translucent film.
void photographInside(const WindowDriver& driver, MainWindow& window, const Photographer& camera,
                      const QString& name) {
    driver.trigger("section");
    camera.take(window, name + QStringLiteral("-cut"));
    driver.trigger("seeThrough");
    camera.take(window, name + QStringLiteral("-both"));
    driver.trigger("section");
    camera.take(window, name + QStringLiteral("-through"));
    driver.trigger("seeThrough");
}

void photographResults(WindowDriver& driver, MainWindow& window, const Photographer& camera) {
    photographTabs(*driver.find<QTabWidget>("results"), window, camera, QStringLiteral("result"));
    photographInspection(driver, window, camera);
    window.view().look(ViewDirection::Oblique);
    auto* timeline = window.findChild<Timeline*>();
    timeline->setPosition(timeline->frames() / 2);
    photographInside(driver, window, camera, QStringLiteral("inside-dipping"));
    driver.trigger("filmStretch");
    camera.take(window, QStringLiteral("dipping"));
    timeline->setPosition(timeline->frames());
    driver.trigger("filmSheet");
    driver.trigger("filmOnBody");
    camera.take(window, QStringLiteral("dipped"));
    driver.trigger("filmOnBody");
    driver.trigger("coverage");
    camera.take(window, QStringLiteral("coverage"));
    driver.trigger("coverage");
    driver.trigger("bodyPrint");
    camera.take(window, QStringLiteral("print-on-body"));
    driver.trigger("bodyPrint");
    if (window.document()->result()->share) {
        photographShares(driver, window, camera);
    }
    driver.trigger("filmLines");
}

// Takes the open menus.
void photographMenus(MainWindow& window, const Photographer& camera) {
    int number = 0;
    for (const QAction* entry : window.menuBar()->actions()) {
        QMenu* menu = entry->menu();
        menu->popup(window.mapToGlobal(QPoint(0, 30)));
        camera.take(*menu, QStringLiteral("menu-%1").arg(number++));
        menu->close();
    }
}

// Takes a question that waits for its answer, then closes it.
void photographQuestion(const char* name, const QString& picture, const Photographer& camera,
                        const std::function<void()>& ask) {
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (widget->objectName() == QLatin1String(name) && widget->isVisible()) {
                timer.stop();
                camera.take(*widget, picture);
                widget->close();
            }
        }
    });
    timer.start(50);
    ask();
}

void photographQuestions(MainWindow& window, Workbench& workbench, const Photographer& camera) {
    const QString copy = workbench.recovery() + QStringLiteral("/kept.dipw");
    QDir().mkpath(workbench.recovery());
    saveProject(window.document()->project(), copy);
    photographQuestion("recoveryQuestion", QStringLiteral("recovery"), camera,
                       [&] { workbench.offerRecovery(); });
    photographQuestion("closeQuestion", QStringLiteral("close"), camera, [&] { window.close(); });
    photographQuestion("failure", QStringLiteral("failure"), camera, [&] {
        const QString noPicture = workbench.recovery() + QStringLiteral("/kept.png");
        QFile::copy(copy, noPicture);
        WindowDriver(window).drop(noPicture);
        QTest::qWait(2000);
    });
}

void photographNumericalError(WindowDriver& driver, const Photographer& camera) {
    driver.trigger("certainty");
    const auto dialog = [&] { return driver.find<QDialog>("certaintyDialog"); };
    if (QTest::qWaitFor([&] { return dialog() != nullptr; }, 300000)) {
        camera.take(*dialog(), QStringLiteral("certainty"));
        dialog()->close();
    }
}

// Takes the tolerances, and the body with one marked zone.
void photographTolerances(WindowDriver& driver, MainWindow& window, const Photographer& camera) {
    driver.find<ProjectTree>("projectTree")->select({ProjectPart::Tolerance, 0});
    window.document()->edit({}, {}, [](Project& project) {
        const Eigen::Vector3f place = project.model->mesh.positions.front();
        ZoneMark mark;
        mark.radius = Millimetres(15);
        for (int axis = 0; axis < 3; ++axis) {
            mark.place[std::size_t(axis)] = Millimetres(double(place[axis]));
        }
        project.tolerance.marks.push_back(mark);
    });
    driver.trigger("zones");
    camera.take(window, QStringLiteral("zones"));
    // The edit has started a job, and the action is off until the job ends.
    if (QTest::qWaitFor([&] { return driver.action("tolerances")->isEnabled(); }, 300000)) {
        driver.trigger("tolerances");
    }
    const auto dialog = [&] { return driver.find<QDialog>("toleranceDialog"); };
    if (QTest::qWaitFor([&] { return dialog() != nullptr; }, 900000)) {
        camera.take(*dialog(), QStringLiteral("tolerances"));
        dialog()->close();
    }
    camera.take(window, QStringLiteral("tolerances-on-body"));
    driver.trigger("zones");
    driver.trigger("undo");
}

// Takes the artwork page with each layer chosen.
void photographArtwork(const WindowDriver& driver, MainWindow& window, const Photographer& camera) {
    driver.trigger("artwork");
    auto* list = driver.find<QListWidget>("artworkLayers");
    for (int row = 0; row < list->count(); ++row) {
        list->setCurrentRow(row);
        QTest::qWait(1500); // until the layer is painted
        camera.take(window, QStringLiteral("artwork-%1").arg(row));
    }
}

// Takes a running pose search and its result.
void photographSearch(const WindowDriver& driver, MainWindow& window, const Photographer& camera) {
    driver.trigger("findPoses");
    auto* start = driver.find<QPushButton>("startSearch");
    driver.find<NumberBox>("searchedPoses")->setValue(24);
    start->click();
    auto* table = driver.find<QTableWidget>("poseTable");
    if (QTest::qWaitFor([&] { return table->rowCount() > 0 || start->isEnabled(); }, 900000)) {
        camera.take(window, QStringLiteral("searching"));
    }
    if (QTest::qWaitFor([&] { return start->isEnabled(); }, 900000)) {
        table->selectRow(0);
        camera.take(window, QStringLiteral("searched"));
    }
    driver.find<QToolButton>("weightsShown")->click();
    camera.take(window, QStringLiteral("search-weights"));
}

void photographHistory(MainWindow& window, Workbench& workbench, const Photographer& camera) {
    const PrintHistory history;
    for (const ImmersionResult& immersion : window.session().outcome().result->immersions) {
        PrintRecord record = recordOf(
            immersion.sheet, printSource(window.document()->project(), window.document()->path()),
            {}, pageSize(immersion.sheet));
        record.printer = QStringLiteral("pigment");
        for (const PrintOutcome fate :
             {PrintOutcome::Printed, PrintOutcome::Cancelled, PrintOutcome::Failed}) {
            record.id.clear();
            record.fate = fate;
            record.reason = QStringLiteral("The printer stopped in the middle of the job: media "
                                           "jam; the rest was cancelled, so print the sheet again");
            history.keep(record);
        }
    }
    PrintHistoryDialog dialog(history, workbench.preferences().unit);
    dialog.show();
    QTest::qWait(500); // until the history is read
    camera.take(dialog, QStringLiteral("print-history"));
}

void photographComparison(const std::array<ComparedState, 2>& states, Workbench& workbench,
                          const Photographer& camera) {
    auto* compared =
        new CompareWindow(states, nullptr, workbench.registry(), workbench.preferences());
    compared->show();
    camera.take(*compared, QStringLiteral("side-by-side-before"));
    auto* figures = compared->findChild<QTableWidget*>(QStringLiteral("comparedFigures"));
    const auto isDipped = [&] { return !figures->item(0, 3)->text().isEmpty(); };
    auto* look = compared->findChild<QComboBox*>(QStringLiteral("comparedLook"));
    for (int shown = 0; QTest::qWaitFor(isDipped, 900000) && shown < look->count(); ++shown) {
        look->setCurrentIndex(shown);
        compared->view(0).picture();
        compared->view(1).picture();
        camera.take(*compared, QStringLiteral("side-by-side-%1").arg(shown));
    }
    compared->close();
}

void photographSnapshots(MainWindow& window, Workbench& workbench, const Photographer& camera) {
    Document& document = *window.document();
    takeSnapshot(document, QStringLiteral("As drawn"));
    document.edit({}, {}, [](Project& project) {
        project.ink.limit = 1.25;
        project.film.swellX = 1.04;
        project.immersions.front().rotation[1] = Degrees(20);
        addLayer(project.artwork, newLayer(LayerKind::Carbon, QStringLiteral("Carbon")),
                 *project.model);
    });
    takeSnapshot(document, QStringLiteral("Turned, and with the swell of Tuesday's film"));
    SnapshotsDialog dialog(document, workbench.preferences().unit);
    dialog.show();
    camera.take(dialog, QStringLiteral("snapshots"));
    const std::vector<Snapshot> kept = snapshots(document.project());
    photographComparison({ComparedState{kept[0].name, atSnapshot(document.project(), kept[0]), {}},
                          ComparedState{kept[1].name, atSnapshot(document.project(), kept[1]), {}}},
                         workbench, camera);
    for (int step = 0; step < 3; ++step) {
        document.undoStack().undo();
    }
}

// Takes the packing dialog with copies of the project on one film.
void photographPacking(const MainWindow& window, const Workbench& workbench,
                       const Photographer& camera) {
    PackDialog dialog(workbench.registry());
    dialog.add({window.document()->path()});
    dialog.show();
    camera.take(dialog, QStringLiteral("pack-empty"));
    auto* films = dialog.findChild<QComboBox*>(QStringLiteral("packFilm"));
    films->setCurrentIndex(films->findData(QStringLiteral("roll")));
    dialog.findChild<QTableWidget*>()->cellWidget(0, 1)->setProperty("value", 4);
    dialog.findChild<QPushButton*>(QStringLiteral("packLayOut"))->click();
    const auto* write = dialog.findChild<QPushButton*>(QStringLiteral("packExport"));
    if (QTest::qWaitFor([&] { return write->isEnabled(); }, 600000)) {
        camera.take(dialog, QStringLiteral("pack"));
    }
}

void photographDialogs(MainWindow& window, Workbench& workbench, const Photographer& camera) {
    NewProjectDialog create({}, workbench.preferences());
    create.show();
    camera.take(create, QStringLiteral("new-project"));
    PreferencesDialog preferences(workbench.preferences(), workbench.registry(), window.actions());
    preferences.show();
    auto* tabs = preferences.findChild<QTabWidget*>();
    for (int tab = 0; tab < tabs->count(); ++tab) {
        tabs->setCurrentIndex(tab);
        camera.take(preferences, QStringLiteral("preferences-%1").arg(tab));
    }
    photographHistory(window, workbench, camera);
    photographSnapshots(window, workbench, camera);
    photographPacking(window, workbench, camera);
    PrintDialog print(window.session().outcome(), 0, window.document()->path());
    print.show();
    QTest::qWait(1500); // until printers are found
    camera.take(print, QStringLiteral("print"));
    auto* proof = print.findChild<QComboBox*>(QStringLiteral("proof"));
    if (proof->isEnabled()) { // only with an ICC profile
        proof->setCurrentIndex(2);
        QTest::qWait(1500);
        camera.take(print, QStringLiteral("print-proof"));
    }
    CalibrationDialog calibration{ProfileLibrary()};
    calibration.show();
    camera.take(calibration, QStringLiteral("calibrate"));
    ProfilesDialog profiles(ProfileLibrary(), workbench.preferences().unit);
    profiles.show();
    for (const ProfileKind kind : {ProfileKind::Printer, ProfileKind::Film, ProfileKind::Tank}) {
        profiles.choose(kind, ProfileLibrary().profiles(kind).front().name);
        camera.take(profiles, QStringLiteral("profile-") + profileKindName(kind));
        QScrollBar* rest = profiles.findChild<QScrollArea*>()->verticalScrollBar();
        if (rest->maximum() > 0) {
            rest->setValue(rest->maximum());
            camera.take(profiles, QStringLiteral("profile-%1-rest").arg(profileKindName(kind)));
        }
    }
    GuideWindow guide;
    guide.show();
    camera.take(guide, QStringLiteral("guide"));
    for (const QString& name : guidePictures()) {
        camera.keep(guidePicture(name, 1160), name);
    }
    WindowDriver(window).trigger("tour");
    camera.take(window, QStringLiteral("tour"));
    window.findChild<QWidget*>(QStringLiteral("tour"))->close();
}

// Takes the report with a smaller film, the body's menu, the queue, and the guide at one place.
void photographPlanning(WindowDriver& driver, MainWindow& window, Workbench& workbench,
                        const Photographer& camera) {
    photographSnapshots(window, workbench, camera);
    driver.find<QTabWidget>("results")->setCurrentIndex(5);
    camera.take(window, QStringLiteral("report"));
    window.findChild<Timeline*>()->setPosition(0);
    camera.take(window, QStringLiteral("handles"));
    DipView& view = window.view();
    view.picture(); // the body must be drawn to be clicked
    QTest::mouseClick(&view, Qt::RightButton, {}, view.positionOf({0, 10, 0}).toPoint());
    auto* menu = view.findChild<QMenu*>(QStringLiteral("bodyMenu"));
    camera.take(*menu, QStringLiteral("body-menu"));
    menu->findChild<QAction*>(QStringLiteral("faceMustBeGood"))->trigger();
    menu->findChild<QAction*>(QStringLiteral("layFaceDown"))->trigger();
    menu->close();
    driver.trigger("zones");
    camera.take(window, QStringLiteral("laid-down"));
    driver.trigger("zones");
    const QString project = window.document()->path();
    workbench.showQueue(project);
    workbench.queue().add({project, project + QStringLiteral(".gone"), project, project},
                          workbench.recovery() + QStringLiteral("/results"));
    const auto isThird = [&] {
        const QueuedProject& third = workbench.queue().projects()[2];
        return third.state == QueuedState::Running && third.share > 0.3;
    };
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (qobject_cast<QueueDialog*>(widget) && QTest::qWaitFor(isThird, 900000)) {
            camera.take(*widget, QStringLiteral("queue"));
        }
    }
    workbench.queue().cancelAll();
    if (QTest::qWaitFor([&] { return !workbench.queue().isBusy(); }, 60000)) {
        camera.take(window, QStringLiteral("queue-ended"));
    }
    showGuide(driver.find<QWidget>("searchPage"), window);
    camera.take(*window.findChild<GuideWindow*>(), QStringLiteral("guide-place"));
}

} // namespace

int main(int argc, char* argv[]) {
    const WindowApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addOptions(
        {{QStringLiteral("out"), {}, QStringLiteral("FOLDER")},
         {QStringLiteral("prefix"), {}, QStringLiteral("TEXT")},
         {QStringLiteral("size"), {}, QStringLiteral("WxH"), QStringLiteral("1280x800")},
         {QStringLiteral("theme"), {}, QStringLiteral("light|dark")},
         {QStringLiteral("language"), {}, QStringLiteral("CODE"), QStringLiteral("en")},
         {QStringLiteral("sample-thumbnail"), {}, QStringLiteral("FILE")},
         {QStringLiteral("only-window"), {}},
         {QStringLiteral("only-results"), {}},
         {QStringLiteral("only-dialogs"), {}},
         {QStringLiteral("only-inside"), {}},
         {QStringLiteral("only-planning"), {}},
         {QStringLiteral("only-tolerances"), {}},
         {QStringLiteral("only-artwork"), {}},
         {QStringLiteral("only-search"), {}}});
    parser.addPositionalArgument(QStringLiteral("PROJECT"), {});
    parser.process(*qApp);
    installLanguage(*qApp, parser.value(QStringLiteral("language")));
    const Photographer camera(parser.value(QStringLiteral("out")),
                              parser.value(QStringLiteral("prefix")));
    const QStringList size = parser.value(QStringLiteral("size")).split(QLatin1Char('x'));

    Workbench workbench(application.home());
    Preferences preferences = workbench.preferences();
    preferences.theme = parser.value(QStringLiteral("theme")) == QLatin1String("dark")
                            ? ThemeChoice::Dark
                            : ThemeChoice::Light;
    workbench.setPreferences(preferences);
    MainWindow window(workbench);
    window.resize(size[0].toInt(), size[1].toInt());
    window.show();
    WindowDriver driver(window);
    const bool all = !parser.isSet(QStringLiteral("only-window")) &&
                     !parser.isSet(QStringLiteral("only-tolerances")) &&
                     !parser.isSet(QStringLiteral("only-search")) &&
                     !parser.isSet(QStringLiteral("only-artwork")) &&
                     !parser.isSet(QStringLiteral("only-dialogs")) &&
                     !parser.isSet(QStringLiteral("only-inside")) &&
                     !parser.isSet(QStringLiteral("only-planning")) &&
                     !parser.isSet(QStringLiteral("sample-thumbnail"));
    if (all) {
        camera.take(window, QStringLiteral("start"));
    }
    if (!driver.open(parser.positionalArguments().value(0))) {
        qWarning("The project could not be opened");
        return 1;
    }
    if (parser.isSet(QStringLiteral("sample-thumbnail"))) {
        return driver.run() && window.session().outcome().portrait.save(
                                   parser.value(QStringLiteral("sample-thumbnail")))
                   ? 0
                   : 1;
    }
    if (all) {
        photographParts(driver, window, camera);
        photographTabs(*driver.find<QTabWidget>("results"), window, camera,
                       QStringLiteral("empty"));
    }
    if (!driver.run()) {
        qWarning("The dip did not end");
        return 1;
    }
    camera.take(window, QStringLiteral("window"));
    if (parser.isSet(QStringLiteral("only-inside"))) {
        auto* timeline = window.findChild<Timeline*>();
        timeline->setPosition(timeline->frames() / 2);
        photographInside(driver, window, camera, QStringLiteral("inside-dipping"));
        timeline->setPosition(timeline->frames());
        photographInside(driver, window, camera, QStringLiteral("inside-end"));
        return 0;
    }
    if (parser.isSet(QStringLiteral("only-dialogs"))) {
        photographDialogs(window, workbench, camera);
        return 0;
    }
    if (parser.isSet(QStringLiteral("only-planning"))) {
        photographPlanning(driver, window, workbench, camera);
        return 0;
    }
    if (parser.isSet(QStringLiteral("only-artwork"))) {
        photographArtwork(driver, window, camera);
        return 0;
    }
    if (parser.isSet(QStringLiteral("only-search"))) {
        photographSearch(driver, window, camera);
        return 0;
    }
    if (parser.isSet(QStringLiteral("only-tolerances"))) {
        photographTolerances(driver, window, camera);
        return 0;
    }
    if (all) {
        photographResults(driver, window, camera);
    }
    if (all && !parser.isSet(QStringLiteral("only-results"))) {
        photographNumericalError(driver, camera);
        photographTolerances(driver, window, camera);
        photographDialogs(window, workbench, camera);
        driver.action("live")->setChecked(false);
        window.document()->edit(
            QCoreApplication::translate("dipwright::BodyHandles", "Turn part"), {},
            [](Project& project) { project.immersions.front().rotation[1] = Degrees(20); });
        driver.find<QWidget>("logDock")->show();
        camera.take(window, QStringLiteral("stale"));
        photographMenus(window, camera);
        photographQuestions(window, workbench, camera);
    }
    return 0;
}
