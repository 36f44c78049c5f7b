// How a window is put together: docks, actions, menus and tool bars.
#include "document/SavedLayouts.h"
#include "look/Icons.h"
#include "main/MainWindowActions.h"
#include "main/Workbench.h"
#include "panels/LogPanel.h"
#include "panels/NoticeBar.h"
#include "panels/PropertyPanel.h"
#include "panels/ResultsPanel.h"
#include "panels/StartPage.h"
#include "panels/Timeline.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QProgressBar>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWhatsThis>

namespace dipwright {

namespace {

QKeySequence key(const char* text) {
    return QKeySequence(QLatin1String(text));
}

} // namespace

void MainWindow::makeCentre() {
    pages_ = new QStackedWidget;
    startPage_ = new StartPage;
    view_ = new DipView;
    view_->setObjectName(QStringLiteral("view"));
    view_->setAccessibleName(tr("3D view of the dip"));
    view_->setWhatsThis(tr("The body above the film. Drag to turn the view, drag with the right "
                           "button to shift it, turn the wheel to zoom. Drag a ring to turn the "
                           "body."));
    scene_ = new DipScene(*view_, this);
    timeline_ = new Timeline;
    staleBanner_ = new QLabel;
    staleBanner_->setObjectName(QStringLiteral("staleBanner"));
    staleBanner_->setAlignment(Qt::AlignCenter);
    staleBanner_->setAutoFillBackground(true);
    staleBanner_->setContentsMargins(8, 4, 8, 4);
    staleBanner_->setWordWrap(true);
    staleBanner_->hide();
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    notice_ = new NoticeBar;
    layout->addWidget(notice_);
    layout->addWidget(staleBanner_);
    layout->addWidget(view_, 1);
    layout->addWidget(timeline_);
    pages_->addWidget(startPage_);
    pages_->addWidget(page);
    setCentralWidget(pages_);
}

void MainWindow::makeDocks() {
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);

    tree_ = new ProjectTree;
    properties_ = new PropertyPanel(workbench_.registry());
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(tree_);
    splitter->addWidget(properties_);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({190, 500});
    projectDock_ = new QDockWidget(tr("Project"));
    projectDock_->setObjectName(QStringLiteral("projectDock"));
    projectDock_->setWidget(splitter);
    addDockWidget(Qt::LeftDockWidgetArea, projectDock_);

    results_ = new ResultsPanel;
    resultsDock_ = new QDockWidget(tr("Results"));
    resultsDock_->setObjectName(QStringLiteral("resultsDock"));
    resultsDock_->setWidget(results_);
    addDockWidget(Qt::RightDockWidgetArea, resultsDock_);

    log_ = new LogPanel;
    logDock_ = new QDockWidget(tr("Log"));
    logDock_->setObjectName(QStringLiteral("logDock"));
    logDock_->setWidget(log_);
    addDockWidget(Qt::BottomDockWidgetArea, logDock_);
    logDock_->hide();
    resizeDocks({logDock_}, {160}, Qt::Vertical);
}

void MainWindow::sizeDocks() {
    resizeDocks({projectDock_, resultsDock_}, {width() / 5, width() * 3 / 10}, Qt::Horizontal);
}

void MainWindow::makeStatusBar() {
    readingLabel_ = new QLabel;
    readingLabel_->setObjectName(QStringLiteral("reading"));
    readingLabel_->setAccessibleName(tr("Value under the cursor"));
    readingLabel_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    jobLabel_ = new QLabel;
    progressBar_ = new QProgressBar;
    progressBar_->setObjectName(QStringLiteral("progress"));
    progressBar_->setAccessibleName(tr("Progress"));
    progressBar_->setRange(0, 1000);
    progressBar_->setFixedWidth(200);
    progressBar_->setTextVisible(false);
    cancelButton_ = new QToolButton;
    cancelButton_->setDefaultAction(actions_->cancel);
    cancelButton_->setAutoRaise(true);
    statusBar()->addWidget(readingLabel_, 1);
    statusBar()->addPermanentWidget(jobLabel_);
    statusBar()->addPermanentWidget(progressBar_);
    statusBar()->addPermanentWidget(cancelButton_);
    for (QWidget* widget : {static_cast<QWidget*>(jobLabel_), static_cast<QWidget*>(progressBar_),
                            static_cast<QWidget*>(cancelButton_)}) {
        widget->hide();
    }
}

QAction* MainWindow::addToggle(const char* name, const QString& iconName, const QString& text,
                               const QString& help, bool on) {
    QAction* action = addAction(name, iconName, text, help, {}, {});
    action->setCheckable(true);
    action->setChecked(on);
    return action;
}

QAction* MainWindow::addAction(const char* name, const QString& iconName, const QString& text,
                               const QString& help, const QKeySequence& shortcut,
                               const std::function<void()>& triggered) {
    auto* action = new QAction(text, this);
    action->setObjectName(QLatin1String(name));
    if (!iconName.isEmpty()) {
        action->setIcon(icon(iconName));
    }
    action->setShortcut(shortcut);
    action->setProperty("defaultShortcut", QVariant::fromValue(shortcut));
    action->setWhatsThis(help);
    if (triggered) {
        connect(action, &QAction::triggered, this, triggered);
    }
    QMainWindow::addAction(action);
    return action;
}

void MainWindow::makeActions() {
    actions_ = std::make_unique<Actions>();
    makeFileActions();
    makeEditActions();
    makeDipActions();
    makeCameraActions();
    makeDisplayActions();
    makeFilmLookActions();
    makeHelpActions();
}

void MainWindow::makeFileActions() {
    Actions& a = *actions_;
    a.newWindow = addAction("newWindow", {}, tr("New &Window"), tr("Open another window"),
                            key("Ctrl+Shift+N"), [this] { workbench_.openWindow(); });
    a.newProject = addAction("new", QStringLiteral("document-new"), tr("&New Project…"),
                             tr("Make a project of a textured model"), QKeySequence::New,
                             [this] { newProject(); });
    a.open = addAction("open", QStringLiteral("document-open"), tr("&Open…"), tr("Open a project"),
                       QKeySequence::Open, [this] { open(); });
    a.save = addAction("save", QStringLiteral("document-save"), tr("&Save"), tr("Save the project"),
                       QKeySequence::Save, [this] { save(); });
    a.saveAs = addAction("saveAs", {}, tr("Save &As…"), tr("Save the project as another file"),
                         key("Ctrl+Shift+S"), [this] { saveAs(); });
    a.exportResults = addAction("exportResults", QStringLiteral("export"), tr("&Export Results…"),
                                tr("Write sheets, stretch maps, proof, films and report to a "
                                   "folder"),
                                key("Ctrl+E"), [this] { exportResults(); });
    a.exportPdf = addAction("exportPdf", QStringLiteral("sheet"), tr("Sheet as P&DF…"),
                            tr("Save this immersion's sheet as PDF at true size"), {},
                            [this] { exportSheet(true); });
    a.exportPng = addAction("exportPng", QStringLiteral("texture"), tr("Sheet as P&NG…"),
                            tr("Save this immersion's film image as PNG"), {},
                            [this] { exportSheet(false); });
    a.print =
        addAction("print", QStringLiteral("print"), tr("&Print…"), tr("Print sheets at true size"),
                  QKeySequence::Print, [this] { printSheets(); });
    a.calibrate =
        addAction("calibratePrinter", QStringLiteral("measure"), tr("Calibrate P&rinter…"),
                  tr("Print a page of rulers and put the printer's scale into its "
                     "profile"),
                  {}, [this] { calibratePrinter(); });
    a.profiles =
        addAction("profiles", {}, tr("Pro&files…"),
                  tr("What is known of printers, films and tanks"), {}, [this] { showProfiles(); });
    a.close = addAction("close", {}, tr("&Close Window"), tr("Close this window"),
                        QKeySequence::Close, [this] { close(); });
    a.quit = addAction("quit", {}, tr("&Quit"), tr("Close all windows"), key("Ctrl+Q"),
                       [] { QApplication::closeAllWindows(); });
    a.quit->setMenuRole(QAction::QuitRole);
}

void MainWindow::makeEditActions() {
    Actions& a = *actions_;
    a.undo = addAction("undo", QStringLiteral("undo"), tr("&Undo"), tr("Take back the last change"),
                       QKeySequence::Undo, [this] { document_->undoStack().undo(); });
    a.redo = addAction("redo", QStringLiteral("redo"), tr("&Redo"), tr("Make the change again"),
                       key("Ctrl+Shift+Z"), [this] { document_->undoStack().redo(); });
    a.addImmersion = addAction("addImmersion", QStringLiteral("add"), tr("Add &Second Immersion"),
                               tr("Dip the body a second time, from another side"), {},
                               [this] { addImmersion(); });
    a.removeImmersion =
        addAction("removeImmersion", QStringLiteral("remove"), tr("Remove &Immersion"),
                  tr("Remove the immersion shown"), {}, [this] { removeImmersion(immersion_); });
    a.reloadModel = addAction("reloadModel", QStringLiteral("reload"), tr("Re&load Model"),
                              tr("Read the model's file again and keep all settings"),
                              QKeySequence::Refresh, [this] { reloadModel(); });
    a.replaceModel = addAction("replaceModel", QStringLiteral("replace"), tr("Replace &Model…"),
                               tr("Take another model"), {}, [this] { replaceModel({}); });
    a.replaceTexture =
        addAction("replaceTexture", QStringLiteral("texture"), tr("Replace &Texture…"),
                  tr("Put another picture on the model"), {}, [this] { replaceTexture({}); });
    a.preferences = addAction("preferences", QStringLiteral("preferences"), tr("&Preferences…"),
                              tr("Units, language, look, shortcuts and solvers"), key("Ctrl+,"),
                              [this] { showPreferences(); });
    a.preferences->setMenuRole(QAction::PreferencesRole);
}

void MainWindow::makeDipActions() {
    Actions& a = *actions_;
    a.run = addAction("run", QStringLiteral("run"), tr("&Run"),
                      tr("Simulate the dip and make the sheets"), key("Ctrl+R"),
                      [this] { startDip(); });
    a.cancel = addAction("cancel", QStringLiteral("cancel"), tr("&Cancel"),
                         tr("Stop what is running"), key("Ctrl+."), [this] { cancelJobs(); });
    a.live = addToggle("live", QStringLiteral("live"), tr("Run &Live"),
                       tr("Once there is a result, run again after each change"), false);
    a.certainty = addAction("certainty", {}, tr("C&heck Certainty…"),
                            tr("Compute the sheets more finely and see how far they move, and "
                               "where"),
                            {}, [this] { checkCertainty(); });
    a.play = addAction("play", QStringLiteral("play"), tr("&Play or Pause"), tr("Play the dip"),
                       key("Ctrl+Space"), [this] { timeline_->togglePlaying(); });
}

void MainWindow::makeCameraActions() {
    Actions& a = *actions_;
    const auto look = [this](ViewDirection direction) {
        return [this, direction] { view_->look(direction); };
    };
    a.fit = addAction("fit", QStringLiteral("fit"), tr("&Fit"), tr("Show body and film whole"),
                      key("Ctrl+0"), [this] { view_->fit(); });
    a.oblique =
        addAction("oblique", QStringLiteral("view-oblique"), tr("&Oblique"),
                  tr("Look from above at an angle"), key("Ctrl+1"), look(ViewDirection::Oblique));
    a.front = addAction("front", QStringLiteral("view-front"), tr("F&ront"),
                        tr("Look from the front"), key("Ctrl+2"), look(ViewDirection::Front));
    a.right = addAction("right", QStringLiteral("view-right"), tr("Ri&ght"),
                        tr("Look from the right"), key("Ctrl+3"), look(ViewDirection::Right));
    a.top = addAction("top", QStringLiteral("view-top"), tr("&Top"), tr("Look from above"),
                      key("Ctrl+4"), look(ViewDirection::Top));
    a.back = addAction("back", {}, tr("Bac&k"), tr("Look from behind"), key("Ctrl+5"),
                       look(ViewDirection::Back));
    a.left = addAction("left", {}, tr("&Left"), tr("Look from the left"), key("Ctrl+6"),
                       look(ViewDirection::Left));
    a.bottom = addAction("bottom", {}, tr("&Bottom"), tr("Look from below"), key("Ctrl+7"),
                         look(ViewDirection::Bottom));
    a.resetLayout = addAction("resetLayout", {}, tr("&Standard Layout"),
                              tr("Put all panels back where they were at first"), {},
                              [this] { resetLayout(); });
    a.saveLayout =
        addAction("saveLayout", {}, tr("&Save Layout…"),
                  tr("Keep where the panels are under a name"), {}, [this] { askLayoutName(); });
    a.parallel = addToggle("parallel", QStringLiteral("parallel"), tr("&Parallel Projection"),
                           tr("Show equal lengths equally long, near or far"), false);
    connect(a.parallel, &QAction::toggled, view_, &DipView::setParallelProjection);
}

void MainWindow::makeDisplayActions() {
    Actions& a = *actions_;
    a.rings = addToggle("rings", QStringLiteral("rotate"), tr("R&otation Rings"),
                        tr("Show the rings that turn the body"), true);
    connect(a.rings, &QAction::toggled, scene_, &DipScene::setShowRings);
    a.water = addToggle("water", QStringLiteral("water"), tr("&Water and Tank"),
                        tr("Show the water and the edges of the tank"), true);
    connect(a.water, &QAction::toggled, view_, &DipView::setWaterVisible);
    a.body = addToggle("body", QStringLiteral("body"), tr("Bo&dy"), tr("Show the body"), true);
    connect(a.body, &QAction::toggled, view_, &DipView::setBodyVisible);
    a.coverage = addToggle("coverage", QStringLiteral("proof"), tr("&Coverage on the Body"),
                           tr("Show how much of the body this immersion paints"), false);
    connect(a.coverage, &QAction::toggled, scene_, &DipScene::setShowCoverage);
    a.filmOnBody =
        addToggle("filmOnBody", QStringLiteral("film-on-body"), tr("Film on the Body &Only"),
                  tr("At the end of the dip, hide the film that paints nothing"), false);
    connect(a.filmOnBody, &QAction::toggled, this, [this](bool only) {
        scene_->setFilmExtent(only ? FilmExtent::OnBody : FilmExtent::Whole);
    });
    a.measure =
        addToggle("measure", QStringLiteral("measure"), tr("&Measure"),
                  tr("Click two places on the body to measure the distance between them"), false);
    a.measure->setProperty("defaultShortcut", key("Ctrl+M"));
    connect(a.measure, &QAction::toggled, this, [this](bool on) {
        measuring_ = on;
        measured_.clear();
        view_->setMeasure({}, {});
    });
}

void MainWindow::makeFilmLookActions() {
    actions_->filmLook = new QActionGroup(this);
    const auto addLook = [this](const char* name, const QString& text, FilmLook look) {
        QAction* action = addToggle(name, {}, text, tr("What the film wears in the view"), false);
        actions_->filmLook->addAction(action);
        connect(action, &QAction::triggered, this, [this, look] { setFilmLook(look); });
        return action;
    };
    addLook("filmLines", tr("&Lines every 10 mm"), FilmLook::Lines)->setChecked(true);
    addLook("filmSheet", tr("The &Sheet's Image"), FilmLook::Sheet);
    addLook("filmStretch", tr("S&tretch"), FilmLook::Stretch);
    addLook("filmChessboard", tr("&Chessboard of 17 mm"), FilmLook::Chessboard);
    addLook("filmPicture", tr("A &Picture…"), FilmLook::Picture);
}

void MainWindow::makeHelpActions() {
    Actions& a = *actions_;
    a.tour = addAction("tour", QStringLiteral("help"), tr("Quick &Tour"),
                       tr("What is where, in six steps"), {}, [this] { showTour(); });
    a.guide =
        addAction("guide", QStringLiteral("report"), tr("User &Guide"), tr("How everything works"),
                  QKeySequence::HelpContents, [this] { showGuide(); });
    a.whatsThis = addAction("whatsThis", {}, tr("&What Is This?"),
                            tr("Click something afterwards to be told what it is for"),
                            QKeySequence::WhatsThis, [] { QWhatsThis::enterWhatsThisMode(); });
    a.about = addAction("about", {}, tr("&About Dipwright"), {}, {}, [this] { showAbout(); });
    a.about->setMenuRole(QAction::AboutRole);
}

void MainWindow::makeMenus() {
    const Actions& a = *actions_;
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->addActions({a.newProject, a.newWindow, a.open});
    recentMenu_ = file->addMenu(tr("Open &Recent"));
    connect(recentMenu_, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
    file->addSeparator();
    file->addActions({a.save, a.saveAs});
    file->addSeparator();
    file->addActions({a.print, a.calibrate, a.exportResults, a.exportPdf, a.exportPng});
    file->addSeparator();
    file->addActions({a.close, a.quit});

    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    edit->addActions({a.undo, a.redo});
    edit->addSeparator();
    edit->addActions({a.addImmersion, a.removeImmersion});
    edit->addSeparator();
    edit->addActions({a.reloadModel, a.replaceModel, a.replaceTexture});
    edit->addSeparator();
    edit->addActions({a.profiles, a.preferences});

    QMenu* view = menuBar()->addMenu(tr("&View"));
    view->addActions({a.fit, a.oblique, a.front, a.right, a.top, a.back, a.left, a.bottom});
    view->addSeparator();
    view->addAction(a.parallel);
    view->addSeparator();
    filmMenu_ = view->addMenu(icon(QStringLiteral("film")), tr("Film &Wears"));
    filmMenu_->addActions(a.filmLook->actions());
    view->addActions({a.filmOnBody, a.body, a.coverage, a.water, a.rings, a.measure});

    QMenu* dip = menuBar()->addMenu(tr("&Dip"));
    dip->addActions({a.run, a.cancel, a.live});
    dip->addSeparator();
    dip->addActions({a.play, a.certainty});

    QMenu* window = menuBar()->addMenu(tr("&Window"));
    window->addActions({projectDock_->toggleViewAction(), resultsDock_->toggleViewAction(),
                        logDock_->toggleViewAction()});
    window->addSeparator();
    layoutMenu_ = window->addMenu(tr("&Layouts"));
    layoutMenu_->setObjectName(QStringLiteral("layouts"));
    connect(layoutMenu_, &QMenu::aboutToShow, this, &MainWindow::fillLayoutMenu);
    window->addActions({a.saveLayout, a.resetLayout});

    QMenu* help = menuBar()->addMenu(tr("&Help"));
    help->addActions({a.tour, a.guide, a.whatsThis});
    help->addSeparator();
    help->addAction(a.about);
}

void MainWindow::fillLayoutMenu() {
    layoutMenu_->clear();
    const QStringList names = savedLayouts();
    if (names.isEmpty()) {
        layoutMenu_->addAction(tr("None saved yet"))->setEnabled(false);
        return;
    }
    for (const QString& name : names) {
        QAction* action = layoutMenu_->addAction(name);
        connect(action, &QAction::triggered, this, [this, name] {
            restoreState(savedLayout(name));
            statusBar()->showMessage(tr("Layout “%1”").arg(name), 4000);
        });
    }
    layoutMenu_->addSeparator();
    QMenu* removal = layoutMenu_->addMenu(tr("&Remove"));
    for (const QString& name : names) {
        connect(removal->addAction(name), &QAction::triggered, this,
                [name] { removeLayout(name); });
    }
}

void MainWindow::makeToolBars() {
    const Actions& a = *actions_;
    QToolBar* main = addToolBar(tr("Main"));
    main->setObjectName(QStringLiteral("mainToolBar"));
    main->setIconSize({22, 22});
    main->addActions({a.newProject, a.open, a.save});
    main->addSeparator();
    main->addActions({a.undo, a.redo});
    main->addSeparator();
    main->addAction(a.run);
    auto* run = qobject_cast<QToolButton*>(main->widgetForAction(a.run));
    run->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    main->addActions({a.cancel, a.live});
    main->addSeparator();
    main->addAction(a.print);

    QToolBar* view = addToolBar(tr("View"));
    view->setObjectName(QStringLiteral("viewToolBar"));
    view->setIconSize({22, 22});
    view->addActions({a.fit, a.oblique, a.front, a.right, a.top, a.parallel});
    view->addSeparator();
    auto* film = new QToolButton;
    film->setIcon(icon(QStringLiteral("film")));
    film->setToolTip(tr("What the film wears in the view"));
    film->setAccessibleName(tr("Film Wears"));
    film->setPopupMode(QToolButton::InstantPopup);
    film->setMenu(filmMenu_);
    view->addWidget(film);
    view->addActions({a.filmOnBody, a.coverage, a.water, a.rings, a.measure});
}

} // namespace dipwright
