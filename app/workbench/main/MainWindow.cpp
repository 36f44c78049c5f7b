#include "workbench/main/MainWindow.h"

#include "pipeline/JobTraveller.h"
#include "workbench/document/RecentProjects.h"
#include "workbench/preferences/PreferencesDialog.h"
#include "workbench/widgets/DroppedFiles.h"
#include "workbench/widgets/Theme.h"
#ifdef DIPWRIGHT_INSPECTION
#include "workbench/inspection/InspectionController.h"
#endif
#include "workbench/actions/WindowMenus.h"
#include "workbench/appearance/ViewTheme.h"
#include "workbench/main/StatusLine.h"
#include "workbench/main/WindowPages.h"
#include "workbench/main/Workbench.h"
#include "workbench/project/ProjectTree.h"
#include "workbench/project/PropertyPanel.h"
#include "workbench/project/PropertySpecs.h"
#include "workbench/project/StartPage.h"
#include "workbench/results/ReportPanel.h"
#include "workbench/results/ResultsPanel.h"
#include "workbench/results/StretchPanel.h"
#include "workbench/results/Timeline.h"
#include "workbench/results/WarningTexts.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDialog>
#include <QDockWidget>
#include <QMenu>
#include <QMimeData>
#include <QStatusBar>
#include <QWhatsThis>

namespace dipwright {

MainWindow::MainWindow(Workbench& workbench)
    : workbench_(workbench),
      documents_(jobs_, messages_, workbench.recovery(),
                 {[this](const Document& document, const LockState& holder) {
                      return documentActions_.askToOpenLocked(document, holder);
                  },
                  [this](const QString& path) { return workbench_.bringForward(path); },
                  [this]() -> DocumentSession& { return workbench_.openWindow()->documents(); },
                  [this] { close(); }}),
      session_(jobs_, workbench.registry()), check_(jobs_, workbench.registry(), messages_),
      toleranceCheck_(jobs_, workbench.registry(), messages_),
      deeperFilm_(jobs_, workbench.registry(), messages_), layout_(*this, workbench.registry()),
      parts_(layout_.parts()), actions_(*this), shownMessages_(messages_, parts_, *this),
      status_(new StatusLine(*statusBar(), jobs_, *actions_.cancel, documents_.saves())),
      placeWarning_(session_, *status_), scene_(*parts_.view),
      playback_(session_, *parts_.view, scene_, *parts_.timeline),
      reader_(session_, *parts_.view, scene_, *parts_.results),
      measure_(*parts_.view, scene_, messages_), marks_(*parts_.view, scene_, session_),
      handles_(session_, *parts_.view, scene_), typedDrag_(*parts_.view),
      cradle_(*actions_.cradle, scene_, session_, jobs_, messages_),
      dip_(actions_, session_, check_, jobs_, workbench.registry(), playback_, messages_,
           *parts_.results, *parts_.staleBanner),
      server_(actions_, session_, jobs_, messages_, *this),
      documentActions_(actions_, documents_, messages_, workbench, *this),
      edits_(actions_, *parts_.tree, *parts_.properties, *parts_.view, scene_, session_, jobs_,
             messages_, *this),
      exports_(actions_, parts_.results->stretch(), session_, jobs_, messages_, *this),
      tolerances_(actions_, session_, toleranceCheck_, messages_, *this),
      profiles_(actions_, documents_, messages_, workbench, *parts_.properties, *this),
      viewActions_(actions_, *parts_.view, scene_, *parts_.inside, parts_.results->stretch(), jobs_,
                   messages_, *this),
      help_(actions_, *this, parts_, workbench.registry(), messages_) {
    setObjectName(QStringLiteral("mainWindow"));
    setAcceptDrops(true);
    connectActions();
    connectPanels();
    connectSession();
    // Call this after connectSession(), so that the session handles a new document before the
    // inspection does.
    addInspection();
    addPages();
    connectMenus();
    layout_.restore();
    applyPreferences();
    showDocument();
}

MainWindow::~MainWindow() {
    // A dialog reads a number that is being typed when it is hidden, and its destructor is too late
    // for that.
    for (QDialog* dialog : findChildren<QDialog*>()) {
        dialog->hide();
    }
    parts_.properties->setDocument(nullptr);
    parts_.tree->setDocument(nullptr);
    session_.setDocument(nullptr);
    if (document()) { // a half-destroyed window receives no signals
        document()->disconnect(this);
        document()->undoStack().disconnect(this);
    }
}

#ifdef DIPWRIGHT_INSPECTION
void MainWindow::addInspection() {
    inspection_ = new InspectionController(*parts_.view, scene_, session_, jobs_,
                                           workbench_.registry(), messages_, *this);
    inspection_->setParent(this);
    layout_.addPage("inspectionDock", tr("Inspection"), inspection_->pages());
    connect(&documents_, &DocumentSession::documentChanged, inspection_,
            &InspectionController::showDocument);
}
#else
void MainWindow::addInspection() {}
#endif

void MainWindow::addPages() {
    const PageContext context{*this, layout_, actions_, documents_, session_, jobs_, messages_};
    addSearchPage(context, workbench_, dip_);
    addArtworkPage(context, scene_, dip_, documentActions_);
}

void MainWindow::connectActions() {
    const auto on = [this](const QAction* action, auto what) {
        connect(action, &QAction::triggered, this, what);
    };
    on(actions_.newWindow, [this] { workbench_.openWindow(); });
    on(actions_.close, &QWidget::close);
    on(actions_.quit, [] { QApplication::closeAllWindows(); });
    on(actions_.preferences, &MainWindow::askPreferences);
    connect(actions_.run, &QAction::triggered, &deeperFilm_, &DeeperFilm::cancel);
    on(actions_.play, [this] { parts_.timeline->togglePlaying(); });
    on(actions_.resetLayout, [this] { layout_.reset(); });
    on(actions_.saveLayout, [this] { layout_.askName(); });
    connect(actions_.measure, &QAction::toggled, &measure_, &MeasureTool::setActive);
    connect(actions_.tank, &QAction::triggered, this, [this] {
        workbench_.showTank({jobAtTank(*session_.outcome().result, document()->path())},
                            document());
    });
    parts_.results->addSheetAction(actions_.exportPdf);
    parts_.results->addTextureAction(actions_.exportPng);
}

void MainWindow::connectMenus() {
    auto* menus = new WindowMenus(*this, actions_, layout_.dockToggles());
    connect(&menus->recent(), &QMenu::aboutToShow, this,
            [this, menus] { documentActions_.fillRecentMenu(menus->recent()); });
    connect(&menus->layouts(), &QMenu::aboutToShow, this,
            [this, menus] { layout_.fillMenu(menus->layouts()); });
    connect(&layout_, &WindowLayout::layoutChosen, this,
            [this](const QString& name) { messages_.say(tr("Layout “%1”").arg(name), 4000); });
}

void MainWindow::connectPanels() {
    StartPage* start = parts_.startPage;
    connect(start, &StartPage::newAsked, this, [this] { documentActions_.askNew(); });
    connect(start, &StartPage::openAsked, &documentActions_, &DocumentController::askOpen);
    connect(start, &StartPage::tourAsked, &help_, &HelpController::showTour);
    connect(start, &StartPage::projectChosen, &documents_, &DocumentSession::openProject);
    connect(start, &StartPage::sampleChosen, &documents_, &DocumentSession::openCopy);
    connect(&documentActions_, &DocumentController::textureDropped, &edits_,
            &EditController::replaceTexture);
    connect(parts_.tree, &ProjectTree::nodeSelected, this, [this](const ProjectNode& node) {
        parts_.properties->showNode(node);
        if (node.part == ProjectPart::Immersion) {
            session_.lookAt(node.immersion);
        }
    });
    connect(parts_.properties, &PropertyPanel::shownPrintChanged, &scene_,
            &DipScene::setShownPrint);
    connect(parts_.properties, &PropertyPanel::pathKeyChosen, &playback_, &DipPlayback::setPathKey);
    connect(&scene_, &DipScene::deeperFilmWanted, &deeperFilm_, &DeeperFilm::start);
    connect(&deeperFilm_, &DeeperFilm::done, &scene_, &DipScene::setDeeperFilm);
    connect(parts_.properties, &PropertyPanel::tolerancesAsked, actions_.tolerances,
            &QAction::trigger);
    connect(&tolerances_, &ToleranceController::changed, this,
            [this](const auto& tolerances, const QStringList& verdicts) {
                scene_.setTolerances(tolerances);
                parts_.results->report().setTolerances(verdicts);
            });
    connect(&parts_.results->report(), &ReportPanel::costTableAsked, &exports_,
            &ExportController::exportCosts);
    connect(&parts_.results->report(), &ReportPanel::pricesAsked, actions_.profiles,
            &QAction::trigger);
    connect(parts_.properties, &PropertyPanel::brushChanged, &tolerances_,
            &ToleranceController::setBrush);
    connect(parts_.properties, &PropertyPanel::brushChanged, this, [this](const MarkBrush& brush) {
        marks_.setBrush(brush);
        scene_.setMarking(std::holds_alternative<ShareMark>(brush));
        scene_.setBrushed(!std::holds_alternative<std::monostate>(brush));
    });
    connect(&marks_, &MarkTool::begun, this, [this] { dip_.setHeld(true); });
    connect(&marks_, &MarkTool::refused, &messages_,
            [this](const QString& sentence) { messages_.say(sentence); });
    connect(&marks_, &MarkTool::ended, this, [this] { dip_.setHeld(false); });
    connect(parts_.properties, &PropertyPanel::failed, &messages_, [this](const QString& sentence) {
        messages_.say(sentence);
        refusal_ = sentence;
    });
    connect(parts_.properties, &PropertyPanel::edited, this, [this] {
        if (statusBar()->currentMessage() == refusal_) {
            statusBar()->clearMessage();
        }
    });
}

void MainWindow::connectSession() {
    connect(&documents_, &DocumentSession::documentChanged, this, &MainWindow::showDocument);
    connect(&documents_, &DocumentSession::saved, this, &MainWindow::keepThumbnail);
    connect(&documents_, &DocumentSession::implausibleLengthFound, this,
            [this](double millimetres) {
                messages_.notice(tr("The largest dimension of the part is %1. If the file uses "
                                    "another unit, change this dimension under Model.")
                                     .arg(shownLength(millimetres, workbench_.preferences().unit)));
            });
    connect(&jobs_, &JobRunner::busy, this, &MainWindow::updateActions);
    connect(&jobs_, &JobRunner::idle, this, &MainWindow::updateActions);
    for (const auto changed : {&DipSession::started, &DipSession::shownChanged,
                               &DipSession::finished, &DipSession::dropped}) {
        connect(&session_, changed, this, &MainWindow::updateActions);
    }
    connect(&session_, &DipSession::stopped, this, &MainWindow::updateActions);
    connect(&session_, &DipSession::immersionChanged, this, [this](std::size_t immersion) {
        parts_.tree->select({ProjectPart::Immersion, immersion});
        updateActions();
    });
    connect(status_, &StatusLine::saveCancelled, &documents_, &DocumentSession::cancelSave);
    connect(status_, &StatusLine::warningClicked, this, [this] {
        parts_.tree->select({ProjectPart::Immersion, session_.immersion()});
    });
    connect(&playback_, &DipPlayback::momentShown, &measure_, &MeasureTool::show);
    connect(parts_.results, &ResultsPanel::placeChosen, this, [this](const Eigen::Vector2f& rest) {
        parts_.timeline->pause();
        parts_.timeline->setPosition(parts_.timeline->frames());
        reader_.lookAtFilmPlace(rest);
    });
    connect(parts_.results, &ResultsPanel::modelPlaceChosen, this,
            [this](const Eigen::Vector3f& place) {
                parts_.timeline->pause();
                parts_.timeline->setPosition(parts_.timeline->frames());
                scene_.lookAt(place);
            });
    connect(parts_.results, &ResultsPanel::fieldChosen, this, [this](const QString& path) {
        if (const std::optional<ProjectNode> node = nodeOfField(path)) {
            parts_.projectDock->show();
            parts_.tree->select(*node);
            parts_.properties->showField(path);
        }
    });
    connect(&scene_, &DipScene::pinClicked, this, [this](std::size_t pin) {
        parts_.resultsDock->show();
        parts_.resultsDock->raise();
        parts_.results->showWarning(pin);
        messages_.say(warningText(session_.shown().warnings[pin], *session_.shown().result,
                                  workbench_.preferences().unit));
    });
    connect(&reader_, &FilmProbe::read, status_, &StatusLine::setReading);
    connect(&handles_, &BodyHandles::held, &dip_, &DipController::setHeld);
    connect(&handles_, &BodyHandles::held, &scene_, &DipScene::setPreviewed);
    connect(&handles_, &BodyHandles::told, status_, &StatusLine::setReading);
    connect(&server_, &ServerController::found, this, [this] { dip_.run(false); });
    connect(&dip_, &DipController::cancelled, this,
            [this] { status_->setJob(tr("Cancelling …")); });
    connect(&check_, &NumericalErrorCheck::done, this,
            [this](const auto& numericalError, bool outdated) {
                exports_.showNumericalError(numericalError, outdated,
                                            workbench_.preferences().unit);
            });
    connect(&workbench_, &Workbench::preferencesChanged, this, &MainWindow::applyPreferences);
}

void MainWindow::showDocument() {
    Document* shown = document();
    parts_.properties->setDocument(nullptr);
    parts_.tree->setDocument(nullptr);
    session_.setDocument(shown);
    parts_.tree->setDocument(shown);
    parts_.properties->setDocument(shown);
    layout_.showProject(shown); // as wide as the properties need
    playback_.showDocument();
    dip_.showDocument();
    tolerances_.showDocument();
    placeWarning_.showDocument();
    if (shown) {
        connect(shown, &Document::projectChanged, this, &MainWindow::updateActions);
        connect(shown, &Document::fileChanged, this, &MainWindow::updateTitle);
        connect(&shown->undoStack(), &QUndoStack::indexChanged, this, &MainWindow::updateActions);
        parts_.tree->select({ProjectPart::Immersion, 0});
    } else {
        parts_.startPage->refresh();
    }
    updateTitle();
}

void MainWindow::applyPreferences() {
    const Preferences& preferences = workbench_.preferences();
    parts_.view->setColours(viewColours(isDark()));
    parts_.properties->setLengthUnit(preferences.unit);
    parts_.results->setLengthUnit(preferences.unit);
    playback_.setLengthUnit(preferences.unit);
    reader_.setLengthUnit(preferences.unit);
    measure_.setLengthUnit(preferences.unit);
    handles_.setLengthUnit(preferences.unit);
    typedDrag_.setLengthUnit(preferences.unit);
    tolerances_.setLengthUnit(preferences.unit);
    viewActions_.setPreferences(preferences);
    dip_.setPreferences(preferences);
    exports_.setPreferences(preferences);
    actions_.setShortcuts(preferences.shortcuts);
    documents_.setAutosaveInterval(preferences.autosaveSeconds);
    layout_.colourBanners();
    parts_.startPage->refresh();
}

void MainWindow::askPreferences() {
    PreferencesDialog dialog(workbench_.preferences(), workbench_.registry(), actions(), this);
    if (dialog.exec() == QDialog::Accepted) {
        workbench_.setPreferences(dialog.preferences());
    }
}

void MainWindow::updateTitle() {
    const Document* shown = document();
    setWindowTitle(shown ? shown->title() + QStringLiteral("[*]") : QStringLiteral("Dipwright"));
    setWindowModified(shown && shown->isModified());
    if (shown) {
        setWindowFilePath(shown->path());
    }
    updateActions();
}

void MainWindow::updateActions() {
    const JobResult* result = session_.outcome().result.get();
    actions_.enable({document(), jobs_.isBusy(), session_.isRunning(),
                     parts_.timeline->frames() > 1 || session_.canRecord(),
                     result && session_.immersion() < result->immersions.size(),
                     session_.shown().fineness.isDraft()});
}

void MainWindow::keepThumbnail() {
    const QImage& portrait = session_.outcome().portrait;
    keepProjectThumbnail(document()->path(),
                         portrait.isNull() ? parts_.view->shownPicture() : portrait);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!documentActions_.mayClose()) {
        event->ignore();
        return;
    }
    if (document() && !document()->path().isEmpty()) {
        keepThumbnail();
    }
    layout_.keep();
    jobs_.cancelAll();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!droppedFiles(*event->mimeData()).isEmpty()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    documentActions_.takeFiles(droppedFiles(*event->mimeData()));
    event->acceptProposedAction();
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        applyPreferences();
    } else if (event->type() == QEvent::ActivationChange) {
        documentActions_.checkFile();
    }
}

} // namespace dipwright
