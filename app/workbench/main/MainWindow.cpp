#include "main/MainWindow.h"

#include "base/Error.h"
#include "dialogs/GuideWindow.h"
#include "dialogs/PreferencesDialog.h"
#include "dialogs/Tour.h"
#include "document/SavedLayouts.h"
#include "look/Theme.h"
#include "main/MainWindowActions.h"
#include "main/Workbench.h"
#include "panels/LogPanel.h"
#include "panels/NoticeBar.h"
#include "panels/PropertyPanel.h"
#include "panels/ResultsPanel.h"
#include "panels/ShippedNames.h"
#include "panels/StartPage.h"
#include "panels/StretchPanel.h"
#include "panels/Timeline.h"
#include "view/ViewTheme.h"

#include <QAction>
#include <QActionGroup>
#include <QClipboard>
#include <QDockWidget>
#include <QEvent>
#include <QGuiApplication>
#include <QInputDialog>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QSettings>
#include <QStatusBar>
#include <QSysInfo>
#include <QToolBar>
#include <QToolButton>

namespace dipwright {

namespace {

constexpr int updateDelay = 350; // ms from the last change to a new run

QString sentenceOf(std::exception_ptr failure) {
    try {
        std::rethrow_exception(failure);
    } catch (const Error& error) {
        return error.sentence();
    } catch (const std::exception& error) {
        return QString::fromUtf8(error.what());
    }
}

} // namespace

MainWindow::MainWindow(Workbench& workbench)
    : workbench_(workbench), session_(jobs_, workbench.registry()) {
    setObjectName(QStringLiteral("mainWindow"));
    setAcceptDrops(true);
    makeCentre();
    makeDocks();
    makeActions();
    makeMenus();
    makeToolBars();
    makeStatusBar();
    connectPanels();
    resize(1280, 800);
    standardLayout_ = saveState();
    const QSettings settings;
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("window/state")).toByteArray());
    applyPreferences();
    setDocument(nullptr);
}

MainWindow::~MainWindow() {
    properties_->setDocument(nullptr);
    tree_->setDocument(nullptr);
    session_.setDocument(nullptr);
    if (document_) { // a window half gone is told nothing more
        document_->disconnect(this);
        document_->undoStack().disconnect(this);
    }
}

void MainWindow::connectPanels() {
    connect(startPage_, &StartPage::newAsked, this, [this] { newProject(); });
    connect(startPage_, &StartPage::openAsked, this, &MainWindow::open);
    connect(startPage_, &StartPage::tourAsked, this, &MainWindow::showTour);
    connect(startPage_, &StartPage::projectChosen, this, &MainWindow::openProject);
    connect(startPage_, &StartPage::sampleChosen, this, &MainWindow::openCopy);
    connect(tree_, &ProjectTree::nodeSelected, this, [this](const ProjectNode& node) {
        properties_->showNode(node);
        if (node.part == ProjectPart::Immersion) {
            selectImmersion(node.immersion);
        }
    });
    connect(tree_, &ProjectTree::addImmersionAsked, this, &MainWindow::addImmersion);
    connect(tree_, &ProjectTree::removeImmersionAsked, this, &MainWindow::removeImmersion);
    connect(properties_, &PropertyPanel::failed, this,
            [this](const QString& sentence) { statusBar()->showMessage(sentence, 8000); });
    connect(properties_, &PropertyPanel::reloadModelAsked, this, &MainWindow::reloadModel);
    connect(properties_, &PropertyPanel::replaceModelAsked, this, [this] { replaceModel({}); });
    connect(properties_, &PropertyPanel::replaceTextureAsked, this, [this] { replaceTexture({}); });

    connect(&jobs_, &JobRunner::started, this, [this](const QString& title) {
        jobLabel_->setText(title);
        progressBar_->setValue(0);
        updateActions();
    });
    connect(&jobs_, &JobRunner::progressed, this, [this](double share, const QString& text) {
        progressBar_->setValue(int(share * 1000));
        jobLabel_->setText(text);
    });
    connect(&jobs_, &JobRunner::idle, this, &MainWindow::updateActions);
    connect(&session_, &DipSession::started, this, [this] {
        shownFrame_ = nullptr;
        notice_->dismiss();
        timeline_->pause();
        timeline_->setEnabled(false);
        liveTimer_.start();
        updateFreshness();
        updateActions();
    });
    connect(&session_, &DipSession::finished, this, [this] {
        liveTimer_.stop();
        const JobResult& result = *session_.outcome().result;
        for (const QString& note : result.notes) {
            report(note);
        }
        notice_->say(result.notes.join(QLatin1Char('\n')));
        report(
            tr("Simulated with %1 on %2").arg(shownName(result.solver.name), result.solver.device));
        showResults();
    });
    connect(&session_, &DipSession::stopped, this, [this](std::exception_ptr failure) {
        liveTimer_.stop();
        showResults();
        if (failure) {
            reportFailure(tr("The Dip"), failure);
        }
    });
    liveTimer_.setInterval(liveInterval);
    connect(&liveTimer_, &QTimer::timeout, this, &MainWindow::showLiveFrame);
    updateTimer_.setSingleShot(true);
    updateTimer_.setInterval(updateDelay);
    connect(&updateTimer_, &QTimer::timeout, this, &MainWindow::startDip);
    connect(timeline_, &Timeline::positionChanged, this, &MainWindow::showMoment);

    StretchPanel& stretch = results_->stretch();
    connect(&stretch, &StretchPanel::scaleChanged, this,
            [this, &stretch] { scene_->setHeat(stretch.quantity(), stretch.scale()); });
    connect(&stretch, &StretchPanel::exportAsked, this, &MainWindow::exportStretch);
    connect(results_, &ResultsPanel::hovered, this, [this](const Eigen::Vector2f& rest) {
        showReading(session_.reading(immersion_)->at(rest));
    });
    connect(results_, &ResultsPanel::hoverLeft, this, [this] { showReading({}); });
    connect(view_, &DipView::hovered, this, &MainWindow::hoverRay);
    connect(view_, &DipView::clicked, this, &MainWindow::measureAt);
    connect(view_, &DipView::hoverLeft, this, [this] { showReading({}); });
    connect(view_, &DipView::rotationDragged, this, &MainWindow::dragRotation);
    connect(view_, &DipView::rotationFinished, this, &MainWindow::finishRotation);
    connect(&workbench_, &Workbench::preferencesChanged, this, &MainWindow::applyPreferences);
    connect(log_, &LogPanel::reportAsked, this, [this] {
        QGuiApplication::clipboard()->setText(facts().join(QLatin1Char('\n')) +
                                              QStringLiteral("\n\n") + log_->text());
        statusBar()->showMessage(tr("The report is on the clipboard"), 4000);
    });
    results_->addSheetAction(actions_->exportPdf);
    results_->addTextureAction(actions_->exportPng);
}

void MainWindow::applyPreferences() {
    const Preferences& preferences = workbench_.preferences();
    view_->setColours(viewColours(isDark()));
    view_->setNavigation(preferences.navigation == NavigationChoice::Trackball
                             ? Navigation::Trackball
                             : Navigation::Turntable);
    properties_->setLengthUnit(preferences.unit);
    results_->setLengthUnit(preferences.unit);
    actions_->live->setChecked(preferences.liveUpdate);
    if (autoSaver_) {
        autoSaver_->setInterval(preferences.autosaveSeconds);
    }
    applyShortcuts();
    QPalette warning = palette();
    warning.setColor(QPalette::Window,
                     isDark() ? QColor(0x5a, 0x43, 0x10) : QColor(0xff, 0xf0, 0xc8));
    warning.setColor(QPalette::WindowText,
                     isDark() ? QColor(0xff, 0xe3, 0xa6) : QColor(0x5a, 0x3c, 0x00));
    staleBanner_->setPalette(warning);
    notice_->setPalette(warning);
    showMeasure();
    startPage_->refresh();
}

void MainWindow::applyShortcuts() {
    const auto& chosen = workbench_.preferences().shortcuts;
    for (QAction* action : actions()) {
        const auto standard = action->property("defaultShortcut").value<QKeySequence>();
        action->setShortcut(chosen.value(action->objectName(), standard));
        const QString help = action->whatsThis();
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        if (!help.isEmpty()) {
            action->setToolTip(keys.isEmpty() ? help : tr("%1 (%2)").arg(help, keys));
        }
    }
}

void MainWindow::updateTitle() {
    if (!document_) {
        setWindowTitle(QStringLiteral("Dipwright"));
        setWindowModified(false);
        updateActions();
        return;
    }
    setWindowTitle(document_->title() + QStringLiteral("[*]"));
    setWindowFilePath(document_->path());
    setWindowModified(document_->isModified());
    updateActions();
}

void MainWindow::updateActions() {
    const Actions& a = *actions_;
    const bool any = document_ != nullptr;
    const bool result = any && document_->result() != nullptr;
    const bool busy = jobs_.isBusy();
    QUndoStack* undo = any ? &document_->undoStack() : nullptr;
    a.undo->setEnabled(undo && undo->canUndo());
    a.redo->setEnabled(undo && undo->canRedo());
    a.undo->setText(undo && undo->canUndo() ? tr("&Undo “%1”").arg(undo->undoText()) : tr("&Undo"));
    a.redo->setText(undo && undo->canRedo() ? tr("&Redo “%1”").arg(undo->redoText()) : tr("&Redo"));
    for (QAction* action :
         {a.saveAs, a.replaceModel, a.replaceTexture, a.fit, a.oblique, a.front, a.right, a.top,
          a.back, a.left, a.bottom, a.parallel, a.rings, a.water, a.body, a.measure, a.live}) {
        action->setEnabled(any);
    }
    a.filmLook->setEnabled(any);
    a.save->setEnabled(any && document_->isModified());
    a.reloadModel->setEnabled(any && !document_->project().modelSource.source.isEmpty());
    a.addImmersion->setEnabled(any && document_->project().immersions.size() < 2);
    a.removeImmersion->setEnabled(any && document_->project().immersions.size() > 1);
    a.run->setEnabled(any && !session_.isRunning());
    a.certainty->setEnabled(any && !busy);
    a.cancel->setEnabled(busy);
    for (QAction* action :
         {a.print, a.exportResults, a.exportPdf, a.exportPng, a.coverage, a.filmOnBody}) {
        action->setEnabled(result);
    }
    a.play->setEnabled(timeline_->frames() > 0);
    jobLabel_->setVisible(busy);
    progressBar_->setVisible(busy);
    cancelButton_->setVisible(busy);
}

void MainWindow::report(const QString& what) {
    log_->add(what);
}

QStringList MainWindow::facts() const {
    QStringList lines{
        QStringLiteral("Dipwright %1").arg(QStringLiteral(DIPWRIGHT_VERSION)),
        QStringLiteral("Qt %1").arg(QLatin1String(qVersion())),
        QStringLiteral("%1, %2").arg(QSysInfo::prettyProductName(),
                                     QSysInfo::currentCpuArchitecture()),
        QStringLiteral("OpenGL: %1").arg(view_->graphicsDevice()),
    };
    for (const SolverInfo& solver : workbench_.registry().solvers()) {
        lines.append(
            QStringLiteral("%1 %2: %3")
                .arg(solver.id, solver.version, solver.available ? solver.device : solver.reason));
    }
    return lines;
}

void MainWindow::reportFailure(const QString& title, std::exception_ptr failure) {
    const QString sentence = sentenceOf(failure);
    report(sentence);
    auto* box = new QMessageBox(QMessageBox::Critical, title, sentence, QMessageBox::Ok, this);
    box->setObjectName(QStringLiteral("failure"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && actions_) {
        applyPreferences();
    }
}

void MainWindow::resetLayout() {
    restoreState(standardLayout_);
    for (QDockWidget* dock : {projectDock_, resultsDock_}) {
        dock->setVisible(document_ != nullptr);
    }
    sizeDocks();
}

void MainWindow::askLayoutName() {
    auto* dialog = new QInputDialog(this);
    dialog->setObjectName(QStringLiteral("layoutName"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save Layout"));
    dialog->setLabelText(tr("Name of the layout"));
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& name) {
        if (!name.trimmed().isEmpty()) {
            saveLayout(name.trimmed(), saveState());
        }
    });
    dialog->open();
}

void MainWindow::showPreferences() {
    PreferencesDialog dialog(workbench_.preferences(), workbench_.registry(), actions(), this);
    if (dialog.exec() == QDialog::Accepted) {
        workbench_.setPreferences(dialog.preferences());
    }
}

void MainWindow::showTour() {
    new Tour({{nullptr, tr("Welcome"),
               tr("Dipwright computes the picture to print on a film so that, when the body is "
                  "dipped through it, every colour lands where it belongs.")},
              {document_ ? static_cast<QWidget*>(projectDock_) : startPage_, tr("The project"),
               tr("Model, film, one or two immersions, sheet and ink. Choose a part in the tree "
                  "and change its values below. Begin by dropping a model on the window.")},
              {document_ ? view_ : nullptr, tr("The view"),
               tr("The body above the film. Drag to look round it, turn it by its rings, then "
                  "press Run.")},
              {findChild<QToolBar*>(QStringLiteral("mainToolBar")), tr("Run"),
               tr("Simulates the dip while you watch and can be cancelled at any time. With Run "
                  "Live, each change runs what depends on it again.")},
              {document_ ? timeline_ : nullptr, tr("The timeline"),
               tr("Plays the dip again, or shows any moment of it.")},
              {document_ ? resultsDock_ : nullptr, tr("The results"),
               tr("How the film stretches, the picture that goes on it, the body as it will come "
                  "out, and the sheet to print. Move the cursor over one and see the same place "
                  "in all the others.")}},
             this);
}

void MainWindow::showGuide() {
    auto* guide = new GuideWindow(this);
    guide->setAttribute(Qt::WA_DeleteOnClose);
    guide->show();
}

void MainWindow::showAbout() {
    QMessageBox::about(
        this, tr("About Dipwright"),
        QStringLiteral("<h3>Dipwright %1</h3><p>%2</p><p>Qt %3 · %4</p>")
            .arg(QStringLiteral(DIPWRIGHT_VERSION), tr("Computational hydrographic printing."),
                 QLatin1String(qVersion()), view_->graphicsDevice().toHtmlEscaped()));
}

} // namespace dipwright
