#include "workbench/inspection/FitController.h"

#include "pipeline/SolverChoice.h"
#include "workbench/inspection/InspectionEdits.h"
#include "workbench/inspection/ProfileName.h"
#include "workbench/jobs/WriteFiles.h"

#include <QDate>
#include <QFileDialog>

namespace dipwright {

namespace {

FittedPart fitted(const MeasuredPart& measured, const SolverRegistry& registry,
                  const Progress& progress) {
    const Project& project = measured.project;
    FittedPart part;
    part.project = project;
    part.pairs.photos = int(measured.photos.size());
    part.pairs.picture = measured.photos.front().picture.size();
    part.pairs.printed = printedOnSheet(measured);
    part.pairs.where = project.name;
    if (project.inspection.keepsCamera) { // else the pairs are places in the image
        part.pairs.body = clickedPairs(project.inspection);
    }
    for (const PartPhoto& photo : measured.photos) {
        part.photos.push_back({photo.where, photo.sha256});
    }
    SolverChoice solver = chooseSolver(project.process.solver, registry, progress.cancelToken);
    const auto field =
        cachedDistanceField(project.model->mesh, project.fieldResolution, progress.part(0, 0.1));
    part.fit = withFallback(solver, registry, [&](const dipwright::solver::SolverModule& module) {
        return fitFilm(project, *field, part.pairs, {}, module, progress.part(0.1, 1));
    });
    return part;
}

WatchNotes notesOfToday() {
    return {QDate::currentDate().toString(Qt::ISODate), {}, {}};
}

} // namespace

FitController::FitController(const DipSession& session, JobRunner& jobs,
                             const SolverRegistry& registry, Messages& messages, QWidget& window)
    : session_(session), jobs_(jobs), registry_(registry), messages_(messages), window_(window),
      page_(new FitPage) {
    connect(&jobs, &JobRunner::busy, page_, [this] { page_->setBusy(true); });
    connect(&jobs, &JobRunner::idle, page_, [this] { page_->setBusy(false); });
    connect(page_, &FitPage::fitAsked, this, &FitController::fit);
    connect(page_, &FitPage::useAsked, this, &FitController::use);
    connect(page_, &FitPage::saveAsked, this,
            [this] { askProfileName(window_, [this](const QString& name) { save(name); }); });
    connect(page_, &FitPage::exportAsked, this, &FitController::exportFit);
}

void FitController::setMeasured(std::shared_ptr<const MeasuredPart> measured) {
    const bool isOther = measured != measured_;
    measured_ = std::move(measured);
    page_->setReady(measured_ && !measured_->places.empty(),
                    measured_ && measured_->project.inspection.keepsCamera);
    if (isOther || used_) { // else keeps the message of a failed fit
        showFitted();
    }
}

void FitController::showFitted() {
    const Document* document = session_.document();
    const bool isUsed = fitted_ && document && used_ && document->project() == *used_;
    if (isUsed || (fitted_ && fittedTo_ == measured_)) {
        page_->setFitted(fitted_, isUsed);
    } else {
        page_->setFitted(nullptr, false);
    }
}

void FitController::fit() {
    using Fitted = std::shared_ptr<const FittedPart>;
    jobs_.start(std::make_unique<ValueJob<Fitted>>(
        tr("Fitting film and dip"),
        [measured = measured_, &registry = registry_](const Progress& progress) {
            return std::make_shared<const FittedPart>(fitted(*measured, registry, progress));
        },
        [this, measured = measured_](const Fitted& found) {
            fitted_ = found;
            fittedTo_ = measured;
            used_.reset();
            showFitted(); // shows it only if the part is still the same
        },
        [this](const std::exception_ptr& failure) {
            fitted_ = nullptr;
            used_.reset();
            page_->setRefusal(sentenceOf(failure));
            messages_.log(sentenceOf(failure));
        }));
}

void FitController::use() {
    Document* document = session_.document();
    if (!document || !fitted_) {
        return;
    }
    try {
        useFit(*document, *fitted_, notesOfToday());
        used_ = document->project();
        showFitted();
    } catch (const Error&) {
        messages_.fail(tr("Use in project"), std::current_exception());
    }
}

void FitController::save(const QString& name) {
    if (fitted_) {
        const FilmProfile fresh = newProfileFor(fitted_->project, name);
        saveToProfile(messages_, name, fresh, [this](const FilmProfile& profile) {
            const QString note = otherFilmNote(profile, fitted_->project, fitted_->fit);
            if (!note.isEmpty()) {
                messages_.log(note);
            }
            return withFit(profile, fitted_->fit, fitted_->photos, notesOfToday());
        });
    }
}

void FitController::exportFit() {
    const QString folder =
        QFileDialog::getExistingDirectory(&window_, tr("Export fit to a folder"));
    if (!folder.isEmpty() && fitted_) {
        writeFiles(jobs_, messages_, tr("Export fit"), tr("Wrote the fit to %1"), folder,
                   [part = fitted_](const QString& target, const Progress&) {
                       writeFilmFit(part->fit, part->pairs, part->photos, notesOfToday(), target);
                   });
    }
}

} // namespace dipwright
