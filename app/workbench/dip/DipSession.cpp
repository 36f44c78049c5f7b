#include "workbench/dip/DipSession.h"

namespace dipwright {

DipSession::DipSession(JobRunner& jobs, const SolverRegistry& registry, QObject* parent)
    : QObject(parent), jobs_(jobs), registry_(registry) {
    connect(&jobs, &JobRunner::idle, this, [this] {
        if (wanted_) {
            run(mostPoints_);
        }
    });
}

void DipSession::setDocument(Document* document) {
    wanted_ = false;
    jobs_.cancelAll();
    document_ = document;
    immersion_ = 0;
    outcome_ = {};
    kept_ = nullptr;
    recordings_.clear();
    if (document) {
        connect(document, &Document::projectChanged, this, &DipSession::projectChanged);
    }
}

void DipSession::projectChanged() {
    if (immersion_ >= document_->project().immersions.size()) {
        immersion_ = 0;
    }
    // Drops the result of another model.
    if (outcome_.result && outcome_.result->project.model != document_->project().model) {
        outcome_ = {};
        recordings_.clear();
        document_->setResult(nullptr);
        emit dropped();
    }
}

void DipSession::run(std::size_t mostPoints) {
    wanted_ = false;
    mostPoints_ = mostPoints;
    if (!document_ || document_->isFresh()) {
        return;
    }
    if (jobs_.isBusy()) {
        wanted_ = true;
        if (running_) {
            dip_.cancel(); // leaves other jobs alone
        }
        return;
    }
    running_ = true;
    live_ = makeRecordings(document_->project(), mostPoints);
    dip_ = jobs_.start(std::make_unique<DipJob>(
        document_->project(), registry_, document_->result() ? document_->result() : kept_, live_,
        [this](const DipOutcome& outcome) { takeOutcome(outcome); },
        [this](bool cancelled, std::exception_ptr failure) {
            stop(cancelled ? nullptr : failure);
        }));
    emit started();
}

void DipSession::cancel() {
    wanted_ = false;
    jobs_.cancelAll();
    stop(nullptr);
}

void DipSession::stop(std::exception_ptr why) {
    if (running_) { // else it was cancelled already
        running_ = false;
        live_.clear();
        emit stopped(why);
    }
}

void DipSession::takeOutcome(const DipOutcome& outcome) {
    if (!running_) {
        return; // cancelled at the last moment
    }
    running_ = false;
    // A reused dip has no new recording, so keep the old one.
    for (std::size_t number = 0; number < live_.size(); ++number) {
        if (live_[number]->size() == 0 && number < recordings_.size()) {
            live_[number] = recordings_[number];
        }
    }
    recordings_ = std::move(live_);
    live_.clear();
    if (!document_ || outcome.result->project.model != document_->project().model) {
        recordings_.clear(); // the model was replaced during the run
        emit stopped(nullptr);
        return;
    }
    outcome_ = outcome;
    document_->setResult(outcome.result);
    emit finished();
}

void DipSession::lookAt(std::size_t immersion) {
    if (document_ && immersion != immersion_ &&
        immersion < document_->project().immersions.size()) {
        immersion_ = immersion;
        emit immersionChanged(immersion);
    }
}

std::shared_ptr<const FilmReadout> DipSession::reading() const {
    return immersion_ < outcome_.readings.size() ? outcome_.readings[immersion_] : nullptr;
}

std::shared_ptr<const DipRecording> DipSession::recording() const {
    return immersion_ < recordings_.size() ? recordings_[immersion_] : nullptr;
}

std::shared_ptr<const DipRecording> DipSession::liveRecording() const {
    for (std::size_t number = live_.size(); number-- > 0;) {
        if (live_[number]->size() > 0) {
            return live_[number];
        }
    }
    return nullptr;
}

} // namespace dipwright
