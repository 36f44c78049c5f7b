// The documents of a window: new, open, save, restore, close, and what replaces their model.
#include "base/Error.h"
#include "dialogs/NewProjectDialog.h"
#include "document/RecentProjects.h"
#include "main/MainWindow.h"
#include "main/Workbench.h"
#include "panels/LogPanel.h"
#include "panels/NoticeBar.h"
#include "panels/PropertyPanel.h"
#include "panels/StartPage.h"
#include "panels/Timeline.h"
#include "project/ProjectStore.h"

#include <QAction>
#include <QCloseEvent>
#include <QDate>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>

namespace dipwright {

namespace {

// Nothing is shown of one that was cancelled while it was read.
Project projectFrom(const QString& path, const Progress& progress) {
    Project project = loadProject(path);
    progress.cancelSwitch.throwIfCancelled();
    return project;
}

bool matches(const QString& path, const QStringList& patterns) {
    return patterns.contains(QStringLiteral("*.") + QFileInfo(path).suffix().toLower());
}

} // namespace

void MainWindow::setDocument(std::unique_ptr<Document> document) {
    updateTimer_.stop();
    properties_->setDocument(nullptr);
    tree_->setDocument(nullptr);
    session_.setDocument(nullptr);
    autoSaver_.reset();
    document_ = std::move(document);
    immersion_ = 0;
    const bool any = document_ != nullptr;
    if (any) {
        autoSaver_ = std::make_unique<AutoSaver>(*document_, workbench_.recovery());
        autoSaver_->setInterval(workbench_.preferences().autosaveSeconds);
        session_.setDocument(document_.get());
        connect(document_.get(), &Document::projectChanged, this, &MainWindow::projectChanged);
        connect(document_.get(), &Document::fileChanged, this, &MainWindow::updateTitle);
        connect(&document_->undoStack(), &QUndoStack::indexChanged, this,
                &MainWindow::updateActions);
    }
    tree_->setDocument(document_.get());
    properties_->setDocument(document_.get());
    pages_->setCurrentIndex(any ? 1 : 0);
    for (QDockWidget* dock : {projectDock_, resultsDock_}) {
        dock->setVisible(any);
        dock->toggleViewAction()->setEnabled(any);
    }
    if (any) {
        if (!QSettings().contains(QStringLiteral("window/state"))) {
            sizeDocks();
        }
        scene_->setProject(document_->project(), 0);
        tree_->select({ProjectPart::Immersion, 0});
        showResults();
    } else {
        startPage_->refresh();
    }
    updateTitle();
    if (any) {
        emit documentOpened();
    }
}

void MainWindow::newProject(const QString& model) {
    auto* dialog = new NewProjectDialog(model, workbench_.preferences(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        importModelAsProject(dialog->model(), dialog->importOptions(), dialog->completion());
    });
    dialog->open();
}

void MainWindow::importModelAsProject(const QString& path, const ImportOptions& options,
                                      const std::function<void(Project&)>& complete) {
    jobs_.start(std::make_unique<ValueJob<ImportedModel>>(
        tr("Reading the model"),
        [path, options](const Progress& progress) { return importModel(path, options, progress); },
        [this, path, options, complete](const ImportedModel& imported) {
            for (const QString& line : imported.report.repairs + imported.report.warnings) {
                report(line);
            }
            Project project;
            project.name = QFileInfo(path).completeBaseName();
            project.date = QDate::currentDate().toString(Qt::ISODate);
            project.immersions.front().name = tr("Immersion %1").arg(1);
            project.model = std::make_shared<const TexturedMesh>(imported.model);
            project.modelSource.source = path;
            project.modelSource.texture = options.texture;
            project.modelSource.unitMillimetres = options.unitMillimetres;
            if (complete) {
                complete(project);
            }
            showProject(project).doubtSize(project.model->mesh);
        },
        [this](std::exception_ptr failure) { reportFailure(tr("New Project"), failure); }));
    updateActions();
}

MainWindow& MainWindow::showProject(const Project& project) {
    MainWindow* window = document_ ? workbench_.openWindow() : this;
    window->setDocument(std::make_unique<Document>(project));
    return *window;
}

// Files often do not say in which unit they are.
void MainWindow::doubtSize(const TriangleMesh& mesh) {
    constexpr double smallest = 5, largest = 3000; // mm, of what is dipped
    const double longest = double(boundingBox(mesh).sizes().maxCoeff());
    if (longest < smallest || longest > largest) {
        notice_->say(tr("The body is %1 long. If its file is in another unit, make the project "
                        "again and say there how long the longest edge is.")
                         .arg(shownLength(longest, workbench_.preferences().unit)));
    }
}

void MainWindow::open() {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open Project"), {}, projectFileFilter());
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
        tr("Opening the project"),
        [absolute](const Progress& progress) { return projectFrom(absolute, progress); },
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

void MainWindow::openCopy(const QString& path) {
    jobs_.start(std::make_unique<ValueJob<Project>>(
        tr("Opening the project"),
        [path](const Progress& progress) { return projectFrom(path, progress); },
        [this](const Project& project) { showProject(project); },
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
        [copy = recovered.copy](const Progress& progress) { return projectFrom(copy, progress); },
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
        saveAsFile(document_->path());
    } catch (const Error&) {
        reportFailure(tr("Save"), std::current_exception());
        return false;
    }
    return true;
}

void MainWindow::saveAsFile(const QString& path) {
    document_->saveAs(path);
    addRecentProject(path);
    keepProjectThumbnail(path, view_->shownPicture());
    report(tr("Saved %1").arg(QDir::toNativeSeparators(path)));
}

bool MainWindow::saveAs() {
    QFileDialog dialog(this, tr("Save Project"), {}, projectFileFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("dipw"));
    dialog.selectFile(document_->path().isEmpty()
                          ? document_->project().name + QStringLiteral(".dipw")
                          : document_->path());
    if (dialog.exec() != QDialog::Accepted) {
        return false;
    }
    try {
        saveAsFile(dialog.selectedFiles().first());
    } catch (const Error&) {
        reportFailure(tr("Save"), std::current_exception());
        return false;
    }
    return true;
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
    if (document_ && !document_->path().isEmpty()) {
        keepProjectThumbnail(document_->path(), view_->shownPicture());
    }
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/state"), saveState());
    jobs_.cancelAll();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    for (const QUrl& url : event->mimeData()->urls()) {
        const QString path = url.toLocalFile();
        if (matches(path, {QStringLiteral("*.dipw")})) {
            openProject(path);
        } else if (matches(path, pictureFilePatterns())) {
            if (document_) {
                replaceTexture(path);
            } else {
                statusBar()->showMessage(
                    tr("%1 is a picture: open the project first that is to wear it")
                        .arg(url.fileName()),
                    8000);
            }
        } else if (matches(path, modelFilePatterns())) {
            newProject(path);
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
    const QString chosen = path.isEmpty() ? QFileDialog::getOpenFileName(this, tr("Replace Model"),
                                                                         {}, modelFileFilter())
                                          : path;
    if (!chosen.isEmpty()) {
        importInto(chosen, {}, tr("Replace Model"), false);
    }
}

void MainWindow::replaceTexture(const QString& path) {
    const QString chosen =
        path.isEmpty()
            ? QFileDialog::getOpenFileName(this, tr("Replace Texture"), {}, pictureFileFilter())
            : path;
    if (chosen.isEmpty()) {
        return;
    }
    jobs_.start(std::make_unique<ValueJob<TexturedMesh>>(
        tr("Reading the texture"),
        [model = document_->project().model, chosen](const Progress&) {
            return withTexture(*model, chosen);
        },
        [this, chosen](const TexturedMesh& model) {
            document_->edit(tr("Replace Texture"), {}, [&](Project& project) {
                project.model = std::make_shared<const TexturedMesh>(model);
                project.modelSource.texture = chosen;
                project.modelSource.sha256.clear();
            });
        },
        [this](std::exception_ptr failure) { reportFailure(tr("Replace Texture"), failure); }));
    updateActions();
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

} // namespace dipwright
