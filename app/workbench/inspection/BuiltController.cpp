#include "workbench/inspection/BuiltController.h"

#include "inspection/BuiltPlaces.h"
#include "project/DipKeys.h"
#include "workbench/inspection/InspectionEdits.h"
#include "workbench/jobs/StartJob.h"

#include <QDate>

namespace dipwright {

BuiltController::BuiltController(const DipSession& session, JobRunner& jobs, Messages& messages)
    : session_(session), jobs_(jobs), messages_(messages), page_(new BuiltPage) {
    connect(&jobs, &JobRunner::busy, page_, [this] { page_->setBusy(true); });
    connect(&jobs, &JobRunner::idle, page_, [this] { page_->setBusy(false); });
    connect(page_, &BuiltPage::keepAsked, this,
            [this](const QString& acceptedBy) { keep(measured_, acceptedBy); });
    connect(page_, &BuiltPage::correctsChosen, this,
            [this](bool corrects) { setCorrects(*session_.document(), corrects); });
    connect(page_, &BuiltPage::strengthChosen, this,
            [this](double strength) { setCorrectionStrength(*session_.document(), strength); });
}

void BuiltController::showDocument() {
    if (const Document* document = session_.document()) {
        connect(document, &Document::projectChanged, this, &BuiltController::showProject);
    }
    places_.clear();
    page_->setErrors(nullptr);
    showProject();
}

void BuiltController::showProject() {
    const Document* document = session_.document();
    if (!document) {
        page_->setBuilt({}, {}, Millimetres(210), Millimetres(297));
        return;
    }
    const Project& project = document->project();
    const bool isKnown = project.model && !project.asBuilt.parts.empty();
    const QStringList dips = isKnown ? dipKeys(project) : QStringList();
    page_->setBuilt(project.asBuilt, dips, project.film.width, project.film.height);
    const AsBuilt built = isKnown ? dippedAlike(project.asBuilt, dips) : project.asBuilt;
    if (built.places != places_) {
        places_ = built.places;
        page_->setErrors(nullptr);
        if (!places_.empty()) {
            computeRepeatingError(built, int(project.immersions.size()));
        }
    }
}

void BuiltController::setMeasured(std::shared_ptr<const MeasuredPart> measured) {
    measured_ = std::move(measured);
    page_->setKeepable(measured_ && !measured_->places.empty() && !measured_->followsPrint);
}

void BuiltController::computeRepeatingError(const AsBuilt& built, int dips) {
    startJob(
        jobs_, messages_, tr("Computing the repeating error"), tr("As built"),
        [built, dips](const Progress&) {
            std::vector<RepeatingError> errors;
            for (int dip = 1; dip <= dips; ++dip) {
                errors.emplace_back(built, dip);
            }
            return std::make_shared<const std::vector<RepeatingError>>(std::move(errors));
        },
        [this,
         places = built.places](const std::shared_ptr<const std::vector<RepeatingError>>& errors) {
            if (places == places_) { // else a later job replaces it
                page_->setErrors(errors);
            }
        });
}

void BuiltController::keep(const std::shared_ptr<const MeasuredPart>& measured,
                           const QString& acceptedBy) {
    const AsBuilt built = session_.document()->project().asBuilt;
    startJob(
        jobs_, messages_, tr("Measuring the error on the sheet"), tr("Keep part"),
        [measured, built, acceptedBy](const Progress&) {
            requireOnBody(clickedPairs(measured->project.inspection),
                          SurfaceQuery(measured->project.model->mesh), measured->project.name);
            QStringList hashes;
            for (const PartPhoto& photo : measured->photos) {
                hashes << photo.sha256;
            }
            const FilmSettings& film = measured->project.film;
            const QSizeF sheet(film.width.value(), film.height.value());
            const std::vector<BuiltPlace> places = builtPlaces(
                printedOnSheet(*measured), measured->view, measured->photos.front().picture.size(),
                measured->dips, sheet, int(built.parts.size()) + 1);
            return withBuiltPart(built, places,
                                 {QDate::currentDate().toString(Qt::ISODate), acceptedBy,
                                  hashes.join(u' '), 0, dipKeys(measured->project).join(u' ')},
                                 sheet, measured->project.name);
        },
        [this, built, measured, acceptedBy](const AsBuilt& more) {
            Document& document = *session_.document();
            if (document.project().asBuilt == built) {
                keepBuilt(document, more);
            } else {
                keep(measured, acceptedBy); // adds the part to what as_built is now
            }
        });
}

} // namespace dipwright
