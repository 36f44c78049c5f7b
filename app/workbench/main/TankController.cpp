#include "workbench/main/TankController.h"

#include "project/ProjectFile.h"
#include "project/ProjectStore.h"
#include "workbench/jobs/StartJob.h"

#include <QScreen>

namespace dipwright {

TankController::TankController(OpenDocument openDocument, QObject* parent)
    : QObject(parent), openDocument_(std::move(openDocument)) {
    connect(&messages_, &Messages::failed, this,
            [this](const QString& title, const QString& sentence) {
                say(tr("%1: %2").arg(title, sentence));
            });
}

TankController::~TankController() {
    delete page_;
}

void TankController::open(std::vector<TankJob> jobs, Document* shown) {
    if (page_) {
        page_->close();
    }
    shown_ = shown;
    page_ = new TankPage(std::move(jobs));
    page_->setAttribute(Qt::WA_DeleteOnClose);
    connect(page_, &TankPage::runFinished, this, &TankController::keep);
    if (shown && !shown->isFresh()) {
        page_->say(tr("The project has changed since these sheets were made."));
    }
    page_->setGeometry(page_->screen()->geometry()); // where no window manager does this
    page_->showFullScreen();
    page_->activateWindow();
}

void TankController::say(const QString& sentence) {
    if (page_) {
        page_->say(sentence);
    }
}

void TankController::keep(const TankJob& job, const std::vector<TankTime>& times) {
    Document* document = job.path.isEmpty() ? shown_.data() : openDocument_(job.path);
    if (document) {
        document->edit(tr("Keep times at the tank"), {}, [&](Project& project) {
            project.asBuilt = withTankRun(std::move(project.asBuilt), times);
        });
        return;
    }
    if (job.path.isEmpty()) {
        say(tr("The times of %1 were not stored: the project is closed and has no file")
                .arg(job.project));
        return;
    }
    keepInFile(job, times);
}

void TankController::keepInFile(const TankJob& job, const std::vector<TankTime>& times) {
    startJob(
        jobs_, messages_, tr("Storing the times"),
        tr("The times of %1 were not stored").arg(job.project),
        [path = job.path, times](const Progress&) {
            ProjectFile file(path);
            Project project = loadProject(path);
            project.asBuilt = withTankRun(std::move(project.asBuilt), times);
            file.save(project);
            return true;
        },
        [](bool) {});
}

} // namespace dipwright
