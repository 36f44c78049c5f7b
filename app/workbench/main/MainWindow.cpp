#include "main/MainWindow.h"

#include "base/Error.h"
#include "document/RecentProjects.h"
#include "jobs/FilmTable.h"
#include "look/Theme.h"
#include "main/MainWindowActions.h"
#include "main/Workbench.h"
#include "model/ImportModel.h"
#include "panels/LogPanel.h"
#include "panels/PicturePanel.h"
#include "panels/PropertyPanel.h"
#include "panels/ReportPanel.h"
#include "panels/StartPage.h"
#include "panels/StretchPanel.h"
#include "panels/Timeline.h"
#include "project/ProjectStore.h"

#include <QAction>
#include <QActionGroup>
#include <QCloseEvent>
#include <QDate>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QSaveFile>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTabWidget>
#include <QToolButton>

namespace dipwright {

namespace {

constexpr int liveInterval = 33;           // ms between pictures of a running dip
constexpr int updateDelay = 350;           // ms from the last change to a new run
constexpr std::size_t coarsePoints = 6000; // of the moving film, without a GPU
constexpr std::size_t finePoints = 60000;

QString sentenceOf(std::exception_ptr failure) {
    try {
        std::rethrow_exception(failure);
    } catch (const Error& error) {
        return error.sentence();
    } catch (const std::exception& error) {
        return QString::fromUtf8(error.what());
    }
}

QString modelFilter() {
    return MainWindow::tr("Models (%1)").arg(modelFilePatterns().join(QLatin1Char(' ')));
}

QString pictureFilter() {
    return MainWindow::tr("Pictures (%1)")
        .arg(QStringLiteral("*.png *.jpg *.jpeg *.bmp *.tif *.tiff *.webp"));
}

QString projectFilter() {
    return MainWindow::tr("Dipwright projects (%1)").arg(QStringLiteral("*.dipw"));
}

bool matches(const QString& path, const QStringList& patterns) {
    return patterns.contains(QStringLiteral("*.") + QFileInfo(path).suffix().toLower());
}

} // namespace

MainWindow::MainWindow(Workbench& workbench) : workbench_(workbench) {
    setObjectName(QStringLiteral("mainWindow"));
    setAcceptDrops(true);
    makeDocks();
    makeActions();
    makeMenus();
    makeToolBars();
    makeStatusBar();
    resize(1280, 800);

    connect(startPage_, &StartPage::newAsked, this, &MainWindow::newProject);
    connect(startPage_, &StartPage::openAsked, this, &MainWindow::open);
    connect(startPage_, &StartPage::projectChosen, this, &MainWindow::openProject);
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
    connect(&jobs_, &JobRunner::idle, this, [this] {
        updateActions();
        if (dipWanted_) {
            startDip();
        }
    });
    liveTimer_.setInterval(liveInterval);
    connect(&liveTimer_, &QTimer::timeout, this, &MainWindow::showLiveFrame);
    updateTimer_.setSingleShot(true);
    updateTimer_.setInterval(updateDelay);
    connect(&updateTimer_, &QTimer::timeout, this, &MainWindow::startDip);
    connect(timeline_, &Timeline::positionChanged, this, &MainWindow::showMoment);
    connect(stretch_, &StretchPanel::scaleChanged, this,
            [this] { scene_->setHeat(stretch_->quantity(), stretch_->scale()); });
    connect(stretch_, &StretchPanel::exportPictureAsked, this,
            [this] { exportStretch(QStringLiteral("png")); });
    connect(stretch_, &StretchPanel::exportTableAsked, this,
            [this] { exportStretch(QStringLiteral("csv")); });
    connect(stretch_, &StretchPanel::exportFilmAsked, this,
            [this] { exportStretch(QStringLiteral("vtp")); });

    connect(view_, &DipView::hovered, this, &MainWindow::hoverRay);
    connect(view_, &DipView::clicked, this, &MainWindow::clickRay);
    connect(view_, &DipView::hoverLeft, this, [this] { showReading({}); });
    connect(view_, &DipView::rotationDragged, this, &MainWindow::dragRotation);
    connect(view_, &DipView::rotationFinished, this, &MainWindow::finishRotation);
    connect(stretch_, &StretchPanel::hovered, this, &MainWindow::hoverFilm);
    connect(stretch_, &StretchPanel::hoverLeft, this, [this] { showReading({}); });
    connect(&texture_->view(), &PictureView::hovered, this, [this](QPointF printed) {
        if (const FilmReading* shown = reading()) {
            const solver::FilmGrid& grid = shown->film().grid;
            const FilmSettings& film = outcome_.result->project.film;
            hoverFilm({float((printed.x() / film.width.value() - 0.5) * grid.width),
                       float((printed.y() / film.height.value() - 0.5) * grid.depth)});
        }
    });
    connect(&texture_->view(), &PictureView::hoverLeft, this, [this] { showReading({}); });
    connect(&sheet_->view(), &PictureView::hovered, this, [this](QPointF page) {
        if (const FilmReading* shown = reading()) {
            const solver::FilmGrid& grid = shown->film().grid;
            const QRectF film = outcome_.sheets[immersion_].film;
            hoverFilm({float(((page.x() - film.x()) / film.width() - 0.5) * grid.width),
                       float(((page.y() - film.y()) / film.height() - 0.5) * grid.depth)});
        }
    });
    connect(&sheet_->view(), &PictureView::hoverLeft, this, [this] { showReading({}); });
    connect(&workbench_, &Workbench::preferencesChanged, this, &MainWindow::applyPreferences);
    sheet_->addButton(actions_->exportPdf);
    texture_->addButton(actions_->exportPng);

    const QSettings settings;
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("window/state")).toByteArray());
    applyPreferences();
    setDocument(nullptr);
}

MainWindow::~MainWindow() {
    properties_->setDocument(nullptr);
    tree_->setDocument(nullptr);
}

LengthUnit MainWindow::lengthUnit() const {
    return workbench_.preferences().unit;
}

const FilmReading* MainWindow::reading() const {
    return immersion_ < outcome_.readings.size() ? outcome_.readings[immersion_].get() : nullptr;
}

void MainWindow::applyPreferences() {
    const Preferences& preferences = workbench_.preferences();
    view_->setColours(viewColours(isDark()));
    view_->setNavigation(preferences.navigation == NavigationChoice::Trackball
                             ? Navigation::Trackball
                             : Navigation::Turntable);
    properties_->setLengthUnit(preferences.unit);
    stretch_->setLengthUnit(preferences.unit);
    actions_->live->setChecked(preferences.liveUpdate);
    if (autoSaver_) {
        autoSaver_->setInterval(preferences.autosaveSeconds);
    }
    for (QAction* action : QMainWindow::actions()) {
        const auto standard = action->property("defaultShortcut").value<QKeySequence>();
        action->setShortcut(preferences.shortcuts.value(action->objectName(), standard));
        const QString help = action->property("help").toString();
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        if (!help.isEmpty()) {
            action->setToolTip(keys.isEmpty() ? help : tr("%1 (%2)").arg(help, keys));
            action->setStatusTip(help);
        }
    }
    QPalette warning = staleBanner_->palette();
    warning.setColor(QPalette::Window,
                     isDark() ? QColor(0x5a, 0x43, 0x10) : QColor(0xff, 0xf0, 0xc8));
    warning.setColor(QPalette::WindowText,
                     isDark() ? QColor(0xff, 0xe3, 0xa6) : QColor(0x5a, 0x3c, 0x00));
    staleBanner_->setPalette(warning);
    report_->setResult(document_ ? document_->result() : nullptr, preferences.unit);
}

// ── Documents ───────────────────────────────────────────────────────────────────────────────────

void MainWindow::setDocument(std::unique_ptr<Document> document) {
    cancelJobs();
    properties_->setDocument(nullptr);
    tree_->setDocument(nullptr);
    autoSaver_.reset();
    document_ = std::move(document);
    outcome_ = {};
    recordings_.clear();
    immersion_ = 0;
    const bool any = document_ != nullptr;
    if (any) {
        autoSaver_ = std::make_unique<AutoSaver>(*document_, workbench_.recovery());
        autoSaver_->setInterval(workbench_.preferences().autosaveSeconds);
        connect(document_.get(), &Document::projectChanged, this, &MainWindow::projectChanged);
        connect(document_.get(), &Document::fileChanged, this, &MainWindow::updateTitle);
        connect(&document_->undoStack(), &QUndoStack::indexChanged, this,
                &MainWindow::updateActions);
    }
    tree_->setDocument(document_.get());
    properties_->setDocument(document_.get());
    pages_->setCurrentIndex(any ? 1 : 0);
    projectDock_->setEnabled(any);
    resultsDock_->setEnabled(any);
    if (any) {
        scene_->setResult(nullptr, nullptr);
        scene_->setProject(document_->project(), 0);
        scene_->showSetup();
        tree_->select({ProjectPart::Immersion, 0});
    } else {
        startPage_->refresh();
    }
    timeline_->setFrames(0);
    showResults();
    updateTitle();
    updateActions();
    if (any) {
        emit documentOpened();
    }
}

void MainWindow::updateTitle() {
    if (!document_) {
        setWindowTitle(QStringLiteral("Dipwright"));
        setWindowModified(false);
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
    a.run->setEnabled(any && !dipRunning_);
    a.cancel->setEnabled(busy);
    for (QAction* action : {a.exportResults, a.exportPdf, a.exportPng, a.coverage, a.filmOnBody}) {
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

void MainWindow::reportFailure(const QString& title, std::exception_ptr failure) {
    const QString sentence = sentenceOf(failure);
    report(sentence);
    auto* box = new QMessageBox(QMessageBox::Critical, title, sentence, QMessageBox::Ok, this);
    box->setObjectName(QStringLiteral("failure"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

void MainWindow::newProject() {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("New Project from a Model"), {}, modelFilter());
    if (!path.isEmpty()) {
        importModelAsProject(path, 0, {});
    }
}

void MainWindow::importModelAsProject(const QString& path, double longestEdge,
                                      const std::function<void(Project&)>& complete) {
    ImportOptions options;
    if (longestEdge > 0) {
        options.longestEdge = Millimetres(longestEdge);
    }
    jobs_.start(std::make_unique<ValueJob<ImportedModel>>(
        tr("Reading the model"),
        [path, options](const Progress& progress) { return importModel(path, options, progress); },
        [this, path, complete](const ImportedModel& imported) {
            for (const QString& line : imported.report.repairs + imported.report.warnings) {
                report(line);
            }
            Project project;
            project.name = QFileInfo(path).completeBaseName();
            project.date = QDate::currentDate().toString(Qt::ISODate);
            project.immersions.front().name = tr("Immersion %1").arg(1);
            project.model = std::make_shared<const TexturedMesh>(imported.model);
            project.modelSource.source = path;
            if (complete) {
                complete(project);
            }
            showProject(project);
        },
        [this](std::exception_ptr failure) { reportFailure(tr("New Project"), failure); }));
    updateActions();
}

void MainWindow::showProject(const Project& project) {
    MainWindow* window = document_ ? workbench_.openWindow() : this;
    window->setDocument(std::make_unique<Document>(project));
}

void MainWindow::open() {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open Project"), {}, projectFilter());
    if (!path.isEmpty()) {
        openProject(path);
    }
}

void MainWindow::openProject(const QString& path) {
    if (document_) {
        workbench_.openWindow()->openProject(path);
        return;
    }
    const QString absolute = QFileInfo(path).absoluteFilePath();
    jobs_.start(std::make_unique<ValueJob<Project>>(
        tr("Opening the project"), [absolute](const Progress&) { return loadProject(absolute); },
        [this, absolute](const Project& project) {
            auto document = std::make_unique<Document>(project, absolute);
            if (!lockOrAsk(*document)) {
                return;
            }
            addRecentProject(absolute);
            report(tr("Opened %1").arg(QDir::toNativeSeparators(absolute)));
            setDocument(std::move(document));
        },
        [this](std::exception_ptr failure) { reportFailure(tr("Open Project"), failure); }));
    updateActions();
}

bool MainWindow::lockOrAsk(Document& document) {
    const LockState state = document.lock();
    if (state.acquired) {
        return true;
    }
    QMessageBox question(
        QMessageBox::Warning, tr("Project in Use"),
        tr("“%1” is open already, on %2 (process %3).")
            .arg(document.title(), state.host.isEmpty() ? tr("an unknown machine") : state.host)
            .arg(state.process),
        QMessageBox::Cancel, this);
    question.setInformativeText(tr("Whoever saves last overwrites what the other has done."));
    question.setObjectName(QStringLiteral("lockQuestion"));
    QPushButton* anyway = question.addButton(tr("Open Anyway"), QMessageBox::AcceptRole);
    question.exec();
    if (question.clickedButton() != anyway) {
        return false;
    }
    document.lockAnyway();
    return true;
}

void MainWindow::restore(const RecoveredDocument& recovered) {
    jobs_.start(std::make_unique<ValueJob<Project>>(
        tr("Restoring the project"),
        [copy = recovered.copy](const Progress&) { return loadProject(copy); },
        [this, recovered](const Project& project) {
            auto document = std::make_unique<Document>(project, recovered.original);
            if (!lockOrAsk(*document)) {
                return;
            }
            document->setRecovered();
            setDocument(std::move(document));
            autoSaver_->keepNow();
            discardRecovered(recovered);
            report(tr("Restored unsaved changes of %1").arg(recovered.name));
        },
        [this](std::exception_ptr failure) { reportFailure(tr("Restore Project"), failure); }));
}

bool MainWindow::save() {
    if (document_->path().isEmpty()) {
        return saveAs();
    }
    try {
        document_->save();
    } catch (const Error&) {
        reportFailure(tr("Save"), std::current_exception());
        return false;
    }
    addRecentProject(document_->path());
    keepProjectThumbnail(document_->path(), view_->picture());
    report(tr("Saved %1").arg(QDir::toNativeSeparators(document_->path())));
    return true;
}

bool MainWindow::saveAs() {
    QFileDialog dialog(this, tr("Save Project"), {}, projectFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("dipw"));
    dialog.selectFile(document_->path().isEmpty()
                          ? document_->project().name + QStringLiteral(".dipw")
                          : document_->path());
    if (dialog.exec() != QDialog::Accepted) {
        return false;
    }
    try {
        document_->saveAs(dialog.selectedFiles().first());
    } catch (const Error&) {
        reportFailure(tr("Save"), std::current_exception());
        return false;
    }
    return save();
}

bool MainWindow::mayClose() {
    if (!document_ || !document_->isModified()) {
        return true;
    }
    QMessageBox question(
        QMessageBox::Question, tr("Unsaved Changes"),
        tr("Save the changes to “%1” before it is closed?").arg(document_->title()),
        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    question.setObjectName(QStringLiteral("closeQuestion"));
    question.setDefaultButton(QMessageBox::Save);
    switch (question.exec()) {
    case QMessageBox::Save:
        return save();
    case QMessageBox::Discard:
        autoSaver_->discard();
        return true;
    default:
        return false;
    }
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!mayClose()) {
        event->ignore();
        return;
    }
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/state"), saveState());
    jobs_.cancelAll();
    event->accept();
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && actions_) {
        applyPreferences();
    }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QStringList pictures{QStringLiteral("*.png"),  QStringLiteral("*.jpg"),
                               QStringLiteral("*.jpeg"), QStringLiteral("*.bmp"),
                               QStringLiteral("*.tif"),  QStringLiteral("*.tiff"),
                               QStringLiteral("*.webp")};
    for (const QUrl& url : event->mimeData()->urls()) {
        const QString path = url.toLocalFile();
        if (matches(path, {QStringLiteral("*.dipw")})) {
            openProject(path);
        } else if (matches(path, pictures)) {
            if (document_) {
                replaceTexture(path);
            }
        } else if (matches(path, modelFilePatterns())) {
            importModelAsProject(path, 0, {});
        } else {
            statusBar()->showMessage(
                tr("%1 is neither a project, a model nor a picture").arg(url.fileName()), 8000);
        }
    }
    event->acceptProposedAction();
}

void MainWindow::fillRecentMenu() {
    recentMenu_->clear();
    for (const QString& path : recentProjects()) {
        QAction* action = recentMenu_->addAction(QFileInfo(path).completeBaseName());
        action->setToolTip(QDir::toNativeSeparators(path));
        action->setEnabled(QFileInfo::exists(path));
        connect(action, &QAction::triggered, this, [this, path] { openProject(path); });
    }
    if (recentMenu_->isEmpty()) {
        recentMenu_->addAction(tr("None yet"))->setEnabled(false);
    }
}

void MainWindow::reloadModel() {
    const ModelSource& source = document_->project().modelSource;
    importInto(source.source, source.texture, tr("Reload Model"), true);
}

void MainWindow::replaceModel(const QString& path) {
    const QString chosen =
        path.isEmpty() ? QFileDialog::getOpenFileName(this, tr("Replace Model"), {}, modelFilter())
                       : path;
    if (!chosen.isEmpty()) {
        importInto(chosen, {}, tr("Replace Model"), false);
    }
}

void MainWindow::replaceTexture(const QString& path) {
    const QString chosen =
        path.isEmpty()
            ? QFileDialog::getOpenFileName(this, tr("Replace Texture"), {}, pictureFilter())
            : path;
    if (!chosen.isEmpty()) {
        importInto(document_->project().modelSource.source, chosen, tr("Replace Texture"), true);
    }
}

// The size of the model that is there is kept: its settings were made for it.
void MainWindow::importInto(const QString& model, const QString& texture, const QString& undoText,
                            bool keepPose) {
    ImportOptions options;
    options.texture = texture;
    options.unitMillimetres = document_->project().modelSource.unitMillimetres;
    if (keepPose) {
        options.longestEdge =
            Millimetres(double(boundingBox(document_->project().model->mesh).sizes().maxCoeff()));
    }
    jobs_.start(std::make_unique<ValueJob<ImportedModel>>(
        tr("Reading the model"),
        [model, options](const Progress& progress) {
            return importModel(model, options, progress);
        },
        [this, model, texture, undoText, keepPose](const ImportedModel& imported) {
            for (const QString& line : imported.report.repairs + imported.report.warnings) {
                report(line);
            }
            document_->edit(undoText, {}, [&](Project& project) {
                project.model = std::make_shared<const TexturedMesh>(imported.model);
                project.modelSource.source = model;
                project.modelSource.texture = texture;
                project.modelSource.sha256.clear();
                if (!keepPose) {
                    for (Immersion& immersion : project.immersions) {
                        immersion = Immersion{.name = immersion.name};
                    }
                }
            });
        },
        [this, undoText](std::exception_ptr failure) { reportFailure(undoText, failure); }));
    updateActions();
}

void MainWindow::addImmersion() {
    document_->edit(tr("Add Immersion"), {}, [](Project& project) {
        Immersion second = project.immersions.front();
        second.name = tr("Immersion %1").arg(2);
        // From the other side: the first one's pose turned upside down.
        second.rotation[0] = Degrees(std::remainder(second.rotation[0].value() + 180, 360));
        project.immersions.push_back(second);
    });
    tree_->select({ProjectPart::Immersion, 1});
}

void MainWindow::removeImmersion(std::size_t number) {
    document_->edit(tr("Remove Immersion"), {}, [number](Project& project) {
        project.immersions.erase(project.immersions.begin() + std::ptrdiff_t(number));
    });
}

void MainWindow::selectImmersion(std::size_t number) {
    if (number == immersion_ || number >= document_->project().immersions.size()) {
        return;
    }
    immersion_ = number;
    tree_->select({ProjectPart::Immersion, number});
    scene_->setProject(document_->project(), immersion_);
    showResults();
}

// ── The dip ─────────────────────────────────────────────────────────────────────────────────────

void MainWindow::projectChanged() {
    const Project& project = document_->project();
    if (immersion_ >= project.immersions.size()) {
        immersion_ = 0;
    }
    const bool otherModel = outcome_.result && outcome_.result->project.model != project.model;
    if (otherModel) {
        outcome_ = {};
        recordings_.clear();
        document_->setResult(nullptr);
        showResults();
    }
    scene_->setProject(project, immersion_);
    if (document_->result() && !document_->isFresh(Stage::Dip, immersion_) &&
        timeline_->position() > 0 && !dipRunning_) {
        timeline_->setPosition(0);
        scene_->showSetup();
    }
    updateFreshness();
    updateActions();
    const bool again = actions_->live->isChecked() && document_->result() && !document_->isFresh();
    if (again && !dragged_) {
        updateTimer_.start();
    }
}

void MainWindow::startDip() {
    updateTimer_.stop();
    dipWanted_ = false;
    if (!document_ || document_->isFresh()) {
        updateActions();
        return;
    }
    if (jobs_.isBusy()) {
        dipWanted_ = true;
        if (dipRunning_) {
            jobs_.cancelAll();
        }
        return;
    }
    dipRunning_ = true;
    shownFrame_ = nullptr;
    timeline_->pause();
    timeline_->setEnabled(false);
    running_ = makeRecordings(document_->project(),
                              view_->isUsable() && !view_->isSoftwareRendered() ? finePoints
                                                                                : coarsePoints);
    jobs_.start(std::make_unique<DipJob>(
        document_->project(), workbench_.registry(), document_->result(), running_,
        [this](const DipOutcome& outcome) { takeOutcome(outcome); },
        [this](bool cancelled, std::exception_ptr failure) {
            dipRunning_ = false;
            liveTimer_.stop();
            running_.clear();
            showResults();
            if (!cancelled) {
                reportFailure(tr("The Dip"), failure);
            } else if (!dipWanted_) {
                statusBar()->showMessage(tr("Cancelled"), 4000);
            }
            emit dipFinished(false);
        }));
    liveTimer_.start();
    updateFreshness();
    updateActions();
}

void MainWindow::cancelJobs() {
    dipWanted_ = false;
    updateTimer_.stop();
    jobs_.cancelAll();
    jobLabel_->setText(tr("Cancelling …"));
}

void MainWindow::showLiveFrame() {
    for (std::size_t number = running_.size(); number-- > 0;) {
        const auto frame = running_[number]->latest();
        if (!frame) {
            continue;
        }
        if (frame.get() != shownFrame_) {
            shownFrame_ = frame.get();
            scene_->showFrame(*running_[number], *frame);
            timeline_->setDepth(std::max(0.0, scene_->depth()), lengthUnit());
        }
        return;
    }
}

void MainWindow::takeOutcome(const DipOutcome& outcome) {
    dipRunning_ = false;
    liveTimer_.stop();
    // A dip that did not have to be computed again was not recorded again either.
    for (std::size_t number = 0; number < running_.size(); ++number) {
        if (running_[number]->size() == 0 && number < recordings_.size()) {
            running_[number] = recordings_[number];
        }
    }
    recordings_ = std::move(running_);
    running_.clear();
    outcome_ = outcome;
    document_->setResult(outcome.result);
    for (const QString& note : outcome.result->notes) {
        report(note);
        statusBar()->showMessage(note, 15000);
    }
    report(tr("Simulated with %1 on %2").arg(outcome.result->solver.name, outcome.result->device));
    showResults();
    emit dipFinished(true);
}

void MainWindow::showResults() {
    const bool any = reading() != nullptr;
    const auto shown = any ? outcome_.readings[immersion_] : nullptr;
    scene_->setResult(any ? outcome_.result : nullptr, shown);
    stretch_->setReading(shown);
    report_->setResult(outcome_.result, lengthUnit());
    if (any) {
        const ImmersionResult& result = outcome_.result->immersions[immersion_];
        const FilmSettings& film = outcome_.result->project.film;
        texture_->setPicture(result.texture->image, {film.width.value(), film.height.value()});
        const QImage& proof = outcome_.result->proof;
        proof_->setPicture(proof, QSizeF(proof.size()) / 8);
        const SheetPreview& sheet = outcome_.sheets[immersion_];
        sheet_->setPicture(sheet.page, sheet.size);
    } else {
        texture_->clear();
        proof_->clear();
        sheet_->clear();
    }
    const bool recorded = any && immersion_ < recordings_.size();
    const QSignalBlocker quiet(timeline_);
    timeline_->setFrames(recorded ? int(recordings_[immersion_]->size()) : 0);
    const bool fresh = any && document_->isFresh(Stage::Dip, immersion_);
    timeline_->setPosition(fresh ? timeline_->frames() : 0);
    if (document_) {
        showMoment(timeline_->position());
    }
    updateFreshness();
    updateActions();
}

void MainWindow::showMoment(int position) {
    if (position > 0 && position < timeline_->frames()) {
        const auto frame = recordings_[immersion_]->frame(std::size_t(position) - 1);
        scene_->showFrame(*recordings_[immersion_], *frame);
    } else if (position > 0 && reading()) {
        scene_->showEnd();
    } else {
        scene_->showSetup();
    }
    timeline_->setDepth(std::max(0.0, scene_->depth()), lengthUnit());
    updateFreshness();
}

void MainWindow::updateFreshness() {
    if (!document_ || !document_->result() || dipRunning_) {
        staleBanner_->hide();
        return;
    }
    const bool dip = document_->isFresh(Stage::Dip, immersion_);
    const bool sheet = document_->isFresh(Stage::Sheet, immersion_);
    staleBanner_->setText(dip ? tr("The sheet is out of date: it was made before the last changes.")
                              : tr("The results are out of date: they were made before the last "
                                   "changes."));
    staleBanner_->setVisible(!sheet);
    const QString mark = QStringLiteral(" •");
    const std::array<bool, 4> fresh{dip, document_->isFresh(Stage::Texture, immersion_),
                                    document_->isFresh(Stage::Texture, immersion_), sheet};
    for (int tab = 0; tab < int(fresh.size()); ++tab) {
        QString text = results_->tabText(tab);
        text.remove(mark);
        results_->setTabText(tab, fresh[std::size_t(tab)] ? text : text + mark);
    }
}

void MainWindow::setFilmLook(FilmLook look) {
    if (look == FilmLook::Picture) {
        const QString path =
            QFileDialog::getOpenFileName(this, tr("Picture on the Film"), {}, pictureFilter());
        filmPicture_ = QImage(path);
    }
    scene_->setHeat(stretch_->quantity(), stretch_->scale());
    scene_->setFilmLook(look, filmPicture_);
}

void MainWindow::exportResults() {
    const QString folder =
        QFileDialog::getExistingDirectory(this, tr("Export Results to a Folder"));
    if (folder.isEmpty()) {
        return;
    }
    jobs_.start(std::make_unique<ValueJob<bool>>(
        tr("Writing the results"),
        [result = document_->result(), folder](const Progress& progress) {
            writeResults(result->project, *result, folder, progress);
            return true;
        },
        [this, folder](bool) {
            report(tr("Wrote the results to %1").arg(QDir::toNativeSeparators(folder)));
            statusBar()->showMessage(
                tr("Wrote the results to %1").arg(QDir::toNativeSeparators(folder)), 8000);
        },
        [this](std::exception_ptr failure) { reportFailure(tr("Export Results"), failure); }));
    updateActions();
}

void MainWindow::exportSheet(bool pdf) {
    const QString suffix = pdf ? QStringLiteral("pdf") : QStringLiteral("png");
    const ImmersionResult& result = document_->result()->immersions[immersion_];
    const QString name =
        QStringLiteral("%1 %2.%3").arg(document_->title(), result.immersion.name, suffix);
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save Sheet"), name, QStringLiteral("*.") + suffix);
    if (path.isEmpty()) {
        return;
    }
    try {
        QSaveFile file(path);
        if (!file.open(QIODevice::WriteOnly)) {
            throw Error(tr("The file cannot be written: %1").arg(file.errorString()), path);
        }
        pdf ? writeSheetPdf(result.sheet, file) : writeSheetPng(result.sheet, file);
        if (!file.commit()) {
            throw Error(tr("The file cannot be written: %1").arg(file.errorString()), path);
        }
        report(tr("Wrote %1").arg(QDir::toNativeSeparators(path)));
    } catch (const Error&) {
        reportFailure(tr("Save Sheet"), std::current_exception());
    }
}

void MainWindow::exportStretch(const QString& kind) {
    const QString path = QFileDialog::getSaveFileName(this, tr("Export Stretch"),
                                                      tr("stretch") + QLatin1Char('.') + kind,
                                                      QStringLiteral("*.") + kind);
    if (path.isEmpty()) {
        return;
    }
    const ImmersionResult& result = outcome_.result->immersions[immersion_];
    try {
        if (kind == QLatin1String("vtp")) {
            writeFilmVtp(*result.film, *result.contact, *result.body, path);
        } else if (kind == QLatin1String("csv")) {
            writeFilmTable(*reading(), path);
        } else if (!stretchMap(*result.film, *result.contact, 2400).save(path)) {
            throw Error(tr("The picture cannot be written"), path);
        }
        report(tr("Wrote %1").arg(QDir::toNativeSeparators(path)));
    } catch (const Error&) {
        reportFailure(tr("Export Stretch"), std::current_exception());
    }
}

// ── The cursor and the tools in the view ────────────────────────────────────────────────────────

void MainWindow::hoverRay(const ViewRay& ray) {
    const auto worldToEnd = scene_->worldToEnd();
    if (worldToEnd && reading()) {
        const Eigen::Isometry3f toPose = worldToEnd->cast<float>();
        showReading(reading()->at(toPose * ray.origin, toPose.linear() * ray.direction));
        return;
    }
    const auto point = document_ ? scene_->modelPoint(ray) : std::nullopt;
    readingLabel_->setText(point ? tr("Body at %1, %2, %3")
                                       .arg(shownLength(double(point->x()), lengthUnit()),
                                            shownLength(double(point->y()), lengthUnit()),
                                            shownLength(double(point->z()), lengthUnit()))
                                 : QString());
}

void MainWindow::hoverFilm(const Eigen::Vector2f& rest) {
    showReading(reading() ? reading()->at(rest) : std::nullopt);
}

void MainWindow::showReading(const std::optional<FilmReadingPoint>& point) {
    stretch_->showReading(point);
    if (!point) {
        readingLabel_->clear();
        view_->setMarker({});
        texture_->view().setCursorAt({});
        sheet_->view().setCursorAt({});
        return;
    }
    const solver::FilmGrid& grid = reading()->film().grid;
    const FilmSettings& film = outcome_.result->project.film;
    const QPointF share(double(point->rest.x()) / grid.width + 0.5,
                        double(point->rest.y()) / grid.depth + 0.5);
    const QPointF printed(share.x() * film.width.value(), share.y() * film.height.value());
    texture_->view().setCursorAt(printed);
    const QRectF onPage = outcome_.sheets[immersion_].film;
    sheet_->view().setCursorAt(onPage.topLeft() +
                               QPointF(share.x() * onPage.width(), share.y() * onPage.height()));
    if (const auto worldToEnd = scene_->worldToEnd()) {
        view_->setMarker(Eigen::Vector3f(worldToEnd->inverse().cast<float>() * point->place));
    }
    const auto number = [this](float value) { return locale().toString(double(value), 'f', 3); };
    const QString where = point->adhered ? tr("on the body") : tr("on the water");
    readingLabel_->setText(tr("Sheet %1, %2 · %3 · stretch %4 · area %5 · %6 to %7")
                               .arg(shownLength(printed.x(), lengthUnit()),
                                    shownLength(printed.y(), lengthUnit()), where,
                                    number(point->values[std::size_t(FilmQuantity::Length)]),
                                    number(point->values[std::size_t(FilmQuantity::Area)]),
                                    number(point->values[std::size_t(FilmQuantity::Smaller)]),
                                    number(point->values[std::size_t(FilmQuantity::Larger)])));
}

void MainWindow::clickRay(const ViewRay& ray) {
    if (!measuring_) {
        return;
    }
    const auto point = scene_->modelPoint(ray);
    if (!point) {
        return;
    }
    if (measured_.size() == 2) {
        measured_.clear();
    }
    measured_.push_back(*point);
    std::vector<Eigen::Vector3f> shown;
    for (const Eigen::Vector3f& place : measured_) {
        shown.push_back(scene_->toWorld(place));
    }
    const QString label =
        measured_.size() == 2
            ? shownLength(double((measured_[1] - measured_[0]).norm()), lengthUnit())
            : QString();
    view_->setMeasure(shown, label);
    statusBar()->showMessage(label.isEmpty() ? tr("Click the second place on the body")
                                             : tr("Distance %1").arg(label));
}

void MainWindow::dragRotation(int axis, double degrees) {
    if (!dragged_) {
        dragged_ = document_->project().immersions[immersion_];
    }
    const auto angle = [this](int part) { return radians(dragged_->rotation[std::size_t(part)]); };
    using Eigen::AngleAxisd, Eigen::Vector3d;
    const Eigen::Matrix3d before =
        (AngleAxisd(angle(2), Vector3d::UnitZ()) * AngleAxisd(angle(1), Vector3d::UnitY()) *
         AngleAxisd(angle(0), Vector3d::UnitX()))
            .toRotationMatrix();
    const Eigen::Matrix3d after =
        AngleAxisd(radians(Degrees(degrees)), Vector3d::Unit(axis)).toRotationMatrix() * before;
    const Vector3d angles = after.eulerAngles(2, 1, 0) * 180 / pi; // about Z, Y, X
    document_->edit(tr("Turn Body"), QStringLiteral("turn"), [&](Project& project) {
        auto& rotation = project.immersions[immersion_].rotation;
        for (int part = 0; part < 3; ++part) {
            rotation[std::size_t(part)] = Degrees(std::round(angles[2 - part] * 10) / 10);
        }
    });
}

void MainWindow::finishRotation() {
    dragged_.reset();
    document_->endMerge();
    projectChanged();
}

} // namespace dipwright
