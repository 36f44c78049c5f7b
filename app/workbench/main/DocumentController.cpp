#include "workbench/main/DocumentController.h"

#include "base/Error.h"
#include "model/ModelFormats.h"
#include "project/ProjectFile.h"
#include "workbench/actions/WindowActions.h"
#include "workbench/compare/CompareWindow.h"
#include "workbench/compare/SnapshotsDialog.h"
#include "workbench/document/RecentProjects.h"
#include "workbench/main/Workbench.h"
#include "workbench/printing/PackDialog.h"
#include "workbench/printing/PrintHistoryDialog.h"
#include "workbench/project/NewProjectDialog.h"

#include <QDir>
#include <QEventLoop>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>
#include <algorithm>
#include <chrono>
#include <utility>

namespace dipwright {

namespace {

bool matches(const QString& path, const QStringList& patterns) {
    return patterns.contains(QStringLiteral("*.") + QFileInfo(path).suffix().toLower());
}

} // namespace

DocumentController::DocumentController(const WindowActions& actions, DocumentSession& session,
                                       Messages& messages, Workbench& workbench, QWidget& window)
    : session_(session), messages_(messages), workbench_(workbench), window_(window) {
    const auto on = [this](const QAction* action, auto what) {
        connect(action, &QAction::triggered, this, what);
    };
    on(actions.newProject, [this] { askNew(); });
    on(actions.open, &DocumentController::askOpen);
    connect(&session, &DocumentSession::runAsked, actions.run, &QAction::trigger);
    connect(&session, &DocumentSession::fileWasChanged, this,
            &DocumentController::askToReplaceChanged);
    on(actions.save, &DocumentController::save);
    on(actions.saveAs, &DocumentController::saveAs);
    connect(&session, &DocumentSession::saved, this, [this] {
        if (std::exchange(saysFileIsMissing_, false)) {
            messages_.notice({});
        }
    });
    on(actions.snapshots, &DocumentController::showSnapshots);
    on(actions.printHistory, &DocumentController::showPrintHistory);
    on(actions.jobQueue, [this] {
        workbench_.showQueue(session_.document() ? session_.document()->path() : QString());
    });
    on(actions.packJobs, &DocumentController::packJobs);
    connect(&workbench.queue(), &JobQueue::ended, this, [this](const QString& sentence) {
        messages_.log(sentence);
        const auto& projects = workbench_.queue().projects();
        const bool areAllDone =
            std::all_of(projects.begin(), projects.end(), [](const QueuedProject& project) {
                return project.state == QueuedState::Done;
            });
        if (areAllDone) {
            messages_.inform(sentence);
        } else {
            messages_.notice(sentence);
        }
    });
}

void DocumentController::askNew(const QString& model) {
    auto* dialog = new NewProjectDialog(model, workbench_.preferences(), &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        session_.importModel(dialog->model(), dialog->importOptions(), dialog->completion(),
                             dialog->runsAtOnce());
    });
    dialog->open();
}

void DocumentController::askOpen() {
    const QString path =
        QFileDialog::getOpenFileName(&window_, tr("Open project"), {}, projectFileFilter());
    if (!path.isEmpty()) {
        session_.openProject(path);
    }
}

bool DocumentController::askToOpenLocked(const Document& document, const LockState& holder) {
    QMessageBox question(
        QMessageBox::Warning, tr("Project in use"),
        tr("“%1” is already open on %2 (process %3).")
            .arg(document.title(), holder.host.isEmpty() ? tr("an unknown machine") : holder.host)
            .arg(holder.process),
        QMessageBox::Cancel, &window_);
    question.setInformativeText(tr("If both programs save the project, the one that saves second "
                                   "asks which version to keep."));
    question.setObjectName(QStringLiteral("lockQuestion"));
    QPushButton* anyway = question.addButton(tr("Open anyway"), QMessageBox::AcceptRole);
    question.setDefaultButton(QMessageBox::Cancel);
    question.exec();
    return question.clickedButton() == anyway;
}

void DocumentController::save() {
    if (session_.document()->path().isEmpty()) {
        saveAs();
    } else {
        session_.save();
    }
}

void DocumentController::askToReplaceChanged(const QString& path) {
    QMessageBox question(
        QMessageBox::Warning, tr("Project changed by another program"),
        tr("Another program has saved “%1” since you opened it.").arg(session_.document()->title()),
        QMessageBox::Cancel, &window_);
    question.setInformativeText(
        tr("Save under another name to keep both versions. If you overwrite the file, the changes "
           "of the other program are lost."));
    question.setObjectName(QStringLiteral("changedQuestion"));
    QPushButton* another = question.addButton(tr("Save &as…"), QMessageBox::AcceptRole);
    QPushButton* overwrite = question.addButton(tr("&Overwrite"), QMessageBox::DestructiveRole);
    question.setDefaultButton(another);
    question.exec();
    if (question.clickedButton() == another) {
        saveAs();
    } else if (question.clickedButton() == overwrite) {
        session_.saveAs(path);
    }
}

void DocumentController::saveAs() {
    const Document& document = *session_.document();
    QFileDialog dialog(&window_, tr("Save project"), {}, projectFileFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("dipw"));
    dialog.selectFile(document.path().isEmpty() ? document.project().name + QStringLiteral(".dipw")
                                                : document.path());
    if (dialog.exec() == QDialog::Accepted) {
        session_.saveAs(dialog.selectedFiles().first());
    }
}

void DocumentController::checkFile() {
    Document* document = session_.document();
    if (!document) {
        return;
    }
    const bool wasMissing = document->isFileMissing();
    document->checkFile();
    if (document->isFileMissing() && !wasMissing) {
        saysFileIsMissing_ = true;
        messages_.notice(tr("The file of this project no longer exists: %1. Save the project to "
                            "write it again.")
                             .arg(QDir::toNativeSeparators(document->path())));
    }
}

void DocumentController::waitBrieflyForSave() {
    constexpr std::chrono::milliseconds brief{300}; // a message shown for less only flashes
    QEventLoop loop;
    connect(&session_.saves(), &JobRunner::idle, &loop, &QEventLoop::quit);
    QTimer::singleShot(brief, &loop, &QEventLoop::quit);
    loop.exec(QEventLoop::ExcludeUserInputEvents);
}

bool DocumentController::waitForSave() {
    if (!session_.isSaving()) {
        return true;
    }
    waitBrieflyForSave();
    QMessageBox waiting(QMessageBox::Information, tr("Saving"),
                        tr("“%1” is being saved. The window closes when the project is saved.")
                            .arg(session_.document()->title()),
                        QMessageBox::Cancel, &window_);
    waiting.setInformativeText(
        tr("If you cancel, the window stays open. The project is saved in any case."));
    waiting.setObjectName(QStringLiteral("savingMessage"));
    connect(&session_.saves(), &JobRunner::idle, &waiting, &QDialog::accept);
    while (session_.isSaving() && !waiting.clickedButton()) {
        waiting.exec();
    }
    return !waiting.clickedButton();
}

bool DocumentController::mayClose() {
    if (!waitForSave()) {
        return false;
    }
    checkFile();
    const Document* document = session_.document();
    if (!document || !document->isModified()) {
        return true;
    }
    const QString words =
        document->isFileMissing()
            ? tr("The file of “%1” no longer exists. Save the project before closing it?")
            : tr("Save the changes to “%1” before closing it?");
    QMessageBox question(QMessageBox::Question, tr("Unsaved changes"), words.arg(document->title()),
                         QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window_);
    question.setObjectName(QStringLiteral("closeQuestion"));
    question.setDefaultButton(QMessageBox::Save);
    switch (question.exec()) {
    case QMessageBox::Save:
        save();
        return waitForSave() && !document->isModified();
    case QMessageBox::Discard:
        session_.discardChanges();
        return true;
    default:
        return false;
    }
}

void DocumentController::fillRecentMenu(QMenu& menu) {
    menu.clear();
    for (const QString& path : recentProjects()) {
        QAction* action = menu.addAction(QFileInfo(path).completeBaseName());
        action->setToolTip(QDir::toNativeSeparators(path));
        action->setEnabled(QFileInfo::exists(path));
        connect(action, &QAction::triggered, this, [this, path] { session_.openProject(path); });
    }
    if (menu.isEmpty()) {
        menu.addAction(tr("No recent projects"))->setEnabled(false);
    }
}

void DocumentController::showSnapshots() {
    auto* dialog =
        new SnapshotsDialog(*session_.document(), workbench_.preferences().unit, &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &SnapshotsDialog::comparisonAsked, this,
            [this](const std::array<ComparedState, 2>& states) {
                (new CompareWindow(states, session_.document()->result(), workbench_.registry(),
                                   workbench_.preferences(), &window_))
                    ->open();
            });
    dialog->open();
}

void DocumentController::showPrintHistory() {
    auto* dialog = new PrintHistoryDialog(PrintHistory(), workbench_.preferences().unit, &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &PrintHistoryDialog::projectAsked, &session_, &DocumentSession::openProject);
    dialog->show();
}

void DocumentController::packJobs() {
    auto* dialog = new PackDialog(workbench_.registry(), &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &PackDialog::printed, &messages_, &Messages::logAndSay);
    if (session_.document() && !session_.document()->path().isEmpty()) {
        dialog->add({session_.document()->path()});
    }
    dialog->show(); // modeless: the user can continue to work
}

void DocumentController::takeFiles(const QStringList& files) {
    for (const QString& file : files) {
        takeFile(file);
    }
}

void DocumentController::takeFile(const QString& path) {
    const QString name = QFileInfo(path).fileName();
    if (matches(path, {QStringLiteral("*.dipw")})) {
        session_.openProject(path);
    } else if (matches(path, pictureFilePatterns()) && session_.document()) {
        emit textureDropped(path);
    } else if (matches(path, pictureFilePatterns())) {
        messages_.say(tr("%1 is a picture. Open a project first, then drop the picture to use it "
                         "as the texture.")
                          .arg(name));
    } else if (matches(path, modelFilePatterns())) {
        askNew(path);
    } else {
        messages_.say(tr("%1 is not a project, model or picture").arg(name));
    }
}

} // namespace dipwright
