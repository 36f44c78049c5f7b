#include "workbench/dip/DipSession.h"

#include "pipeline/SameSheets.h"

#include <QTimer>

#include <utility>

namespace dipwright {
namespace {

// Whether dip `number` of both outcomes is the same.
bool isSameDip(const DipOutcome& one, const DipOutcome& other, std::size_t number) {
    const auto dipOf = [number](const DipOutcome& outcome) {
        return outcome.result && number < outcome.result->immersions.size()
                   ? outcome.result->immersions[number].laid
                   : nullptr;
    };
    return dipOf(one) == dipOf(other);
}

} // namespace

DipSession::DipSession(JobRunner& jobs, const SolverRegistry& registry, QObject* parent)
    : QObject(parent), jobs_(jobs), registry_(registry) {
    connect(&jobs, &JobRunner::idle, this, [this] {
        if (wanted_) {
            run(mostPoints_, reach_);
            if (!running_) {
                emit stopped(nullptr);
            }
        } else if (refines_) {
            // Other sessions that wait for the same jobs come first.
            QTimer::singleShot(0, this, &DipSession::refine);
        }
    });
}

void DipSession::setDocument(Document* document) {
    jobs_.cancelAll();
    document_ = document;
    immersion_ = 0;
    clear();
    if (document) {
        connect(document, &Document::projectChanged, this, &DipSession::projectChanged);
    }
}

void DipSession::clear() {
    wanted_ = refines_ = false;
    outcome_ = {};
    shown_ = {};
    results_.clear();
    recordings_.clear();
}

void DipSession::projectChanged() {
    // Drops the result of another model.
    if (shown_.result && shown_.result->project.model != document_->project().model) {
        clear();
        document_->setResult(nullptr);
        emit dropped();
    }
    if (immersion_ >= document_->project().immersions.size()) {
        immersion_ = 0;
        emit immersionChanged(0);
    }
    // After an undo, the last outcome may fit again.
    if (document_->isFresh()) {
        if (std::exchange(wanted_, false) && !running_) {
            emit stopped(nullptr);
        }
        if (running_ && !records_ && !isRefining()) {
            dip_.cancel();
        }
        if (shown_.fineness.isDraft()) {
            shown_ = outcome_;
            emit shownChanged();
        }
    }
}

// Tells whether the shown draft belongs to the current project, so that the next draft can follow.
bool DipSession::mayGoOn() const {
    return shown_.fineness.isDraft() && makeSameSheets(shown_.project, document_->project());
}

void DipSession::run(std::size_t mostPoints, DipReach reach) {
    wanted_ = false;
    mostPoints_ = mostPoints;
    reach_ = reach;
    const bool refines = reach == DipReach::AllDrafts || reach == DipReach::JobOnly;
    if (!document_ || (document_->isFresh() && !(refines && mayRefine())) ||
        (reach == DipReach::FirstDraft && mayGoOn())) {
        return;
    }
    if (running_ && !dip_.isCancelled() && makeSameSheets(started_, document_->project())) {
        return; // the running job is the wanted one; `reach_` decides what follows
    }
    if (jobs_.isBusy()) {
        wanted_ = true;
        if (running_ && stage_ != DipStage::FirstDraft) {
            dip_.cancel(); // leaves other jobs alone
        }
        return;
    }
    started_ = document_->project();
    running_ = true;
    if (canRefine()) {
        refines_ = true;
        start(DipStage::Refinement);
    } else if (reach != DipReach::JobOnly && mayGoOn()) {
        goOn();
    } else {
        start(reach == DipReach::JobOnly ? DipStage::Job : DipStage::FirstDraft);
    }
    emit started();
}

bool DipSession::canRefine() const {
    return document_ && document_->isFresh() && outcome_.result && canBeRefined(*outcome_.result);
}

// Tells whether a refinement can start, now or when the running jobs have ended.
bool DipSession::mayRefine() const {
    return canRefine() && !(running_ && !dip_.isCancelled());
}

bool DipSession::canRecord() const {
    const auto recorded = recording();
    return document_ && document_->isFresh() && !shown_.fineness.isDraft() && reading() &&
           !(recorded && recorded->size() > 0);
}

bool DipSession::record(std::size_t mostPoints) {
    if (!canRecord() || jobs_.isBusy()) {
        return false;
    }
    mostPoints_ = mostPoints;
    started_ = document_->project();
    running_ = records_ = true;
    start(canRefine() ? DipStage::Job : DipStage::Refinement); // the stage of the shown results
    emit started();
    return true;
}

void DipSession::start(DipStage stage) {
    stage_ = stage;
    DipJob::Task task{started_, stage, {}, records_ ? JobDrafts() : results_, mostPoints_};
    if (stage == DipStage::NextDraft) {
        task.before = shown_;
    }
    dip_ = jobs_.start(std::make_unique<DipJob>(
        std::move(task), registry_, [this](const DipOutcome& outcome) { takeOutcome(outcome); },
        [this](const Fineness& fineness, bool cancelled, const std::exception_ptr& failure) {
            fail(fineness, cancelled, failure);
        }));
}

// Starts the stage that follows the shown draft.
void DipSession::goOn() {
    if (wanted_) {
        running_ = false; // the next run starts when the jobs are idle
    } else if (reach_ == DipReach::FirstDraft) {
        stop(nullptr);
    } else {
        start(shown_.fineness.level > 1 ? DipStage::NextDraft : DipStage::Job);
    }
}

void DipSession::cancel() {
    refines_ = false;
    const bool isPending = std::exchange(wanted_, false) && !running_;
    jobs_.cancelAll();
    stop(nullptr);
    if (isPending) {
        emit stopped(nullptr);
    }
}

void DipSession::fail(const Fineness& fineness, bool cancelled, const std::exception_ptr& failure) {
    if (!running_) {
        return; // it was cancelled already
    }
    refines_ = refines_ && !failure;                    // a repeated refinement would fail, too
    const bool isDraft = failure && fineness.isDraft(); // a coarse film may miss the body
    if (wanted_) {
        running_ = records_ = false; // the next run starts when the jobs are idle
    } else if (isDraft && reach_ != DipReach::FirstDraft && document_ &&
               started_.model == document_->project().model) {
        start(DipStage::Job);
    } else {
        stop(cancelled || isDraft ? nullptr : failure);
    }
}

void DipSession::stop(std::exception_ptr why) {
    if (running_) { // else it was cancelled already
        running_ = records_ = false;
        emit stopped(why);
    }
}

void DipSession::takeOutcome(const DipOutcome& outcome) {
    if (!running_) {
        return; // cancelled at the last moment
    }
    if (!document_ || outcome.result->project.model != document_->project().model) {
        stop(nullptr); // the model was replaced during the run
        return;
    }
    results_.add(outcome.fineness.level, outcome.result);
    const bool isRecorded = std::exchange(records_, false);
    if (!isRecorded && !isRefining() && document_->isFresh()) {
        stop(nullptr); // an undo made the last outcome current
        return;
    }
    shown_ = outcome;
    if (outcome.fineness.isDraft()) {
        emit shownChanged();
        goOn();
        return;
    }
    running_ = false;
    recordings_.resize(outcome.recordings.size());
    for (std::size_t number = 0; number < recordings_.size(); ++number) {
        // A dip that was taken over has no new recording; the old one is of the last outcome's dip.
        if (outcome.recordings[number] || !isSameDip(outcome_, outcome, number)) {
            recordings_[number] = outcome.recordings[number];
        }
    }
    outcome_ = outcome;
    document_->setResult(outcome.result);
    emit finished();
    // It begins when the jobs are idle.
    refines_ = !isRecorded && reach_ != DipReach::Unrefined && canRefine();
}

// Starts the refinement that is due, unless something else has begun or the results are old.
void DipSession::refine() {
    if (!refines_ || running_ || wanted_ || jobs_.isBusy() || !canRefine()) {
        return;
    }
    started_ = document_->project();
    running_ = true;
    start(DipStage::Refinement);
    emit shownChanged();
}

void DipSession::lookAt(std::size_t immersion) {
    if (document_ && immersion != immersion_ &&
        immersion < document_->project().immersions.size()) {
        immersion_ = immersion;
        emit immersionChanged(immersion);
    }
}

Freshness DipSession::freshness() const {
    if (!shown_.result || immersion_ >= shown_.project.immersions.size()) {
        return {false, false, false};
    }
    if (!shown_.fineness.isDraft()) {
        return document_->freshness(immersion_);
    }
    const auto inputsOf = [this](const Project& project) {
        return sheetInputs(project, {}, immersion_, project.process.solver);
    };
    return dipwright::freshness(inputsOf(shown_.project), inputsOf(document_->project()));
}

bool DipSession::isFresh() const {
    return shown_.fineness.isDraft() ? mayGoOn() : document_ && document_->isFresh();
}

std::shared_ptr<const FilmReadout> DipSession::reading() const {
    return immersion_ < shown_.readings.size() ? shown_.readings[immersion_] : nullptr;
}

std::shared_ptr<const DipRecording> DipSession::recording() const {
    return !shown_.fineness.isDraft() && immersion_ < recordings_.size() ? recordings_[immersion_]
                                                                         : nullptr;
}

} // namespace dipwright
