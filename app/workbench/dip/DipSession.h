// Runs the dips of one document: drafts that become finer, then the job itself. Keeps their
// outcomes, their recordings and the number of the dip that is shown. UI thread only.
#pragma once

#include "workbench/dip/DipJob.h"
#include "workbench/document/Document.h"
#include "workbench/jobs/JobRunner.h"

namespace dipwright {

// How far a run goes.
enum class DipReach {
    FirstDraft, // only the coarsest draft: the user is still changing the project
    Unrefined,  // all drafts, then the job, but no refined films: the user only looks
    AllDrafts,  // all drafts, then the job, then refined films
    JobOnly     // the job and refined films, without drafts
};

class DipSession : public QObject {
    Q_OBJECT

public:
    DipSession(JobRunner& jobs, const SolverRegistry& registry, QObject* parent = nullptr);

    // Drops the results of the previous document. Null: no document.
    void setDocument(Document* document);
    Document* document() const { return document_; }
    // Runs the dips that are out of date. Waits for other jobs first. Cancels a run with older
    // values, but lets a first draft finish, so that new drafts appear while the user drags.
    // `mostPoints`: approximate number of film points that are recorded.
    void run(std::size_t mostPoints, DipReach reach = DipReach::AllDrafts);
    // Whether the results on show are current but have no recording, because they were read from a
    // cache.
    bool canRecord() const;
    // Runs the dips of the results on show again, to record them. The results stay the same.
    // Returns false if jobs are running.
    bool record(std::size_t mostPoints);
    // Sets the result that the first run can reuse.
    void setKept(std::shared_ptr<const JobResult> kept) { results_.add(0, std::move(kept)); }
    // Cancels all jobs. Emits stopped() at once for a running dip. Its job ends on the worker
    // thread at its next progress report.
    void cancel();
    bool isRunning() const { return running_; }
    // Whether the film of a finished result is being refined. The result can be used meanwhile, and
    // stays if this is cancelled.
    bool isRefining() const { return running_ && stage_ == DipStage::Refinement; }
    // Whether the results on show are current, but their film can still be refined. run() then
    // continues the refinement.
    bool canRefine() const;

    // The outcome of the last finished job; empty before the first. Sheets are printed from it.
    const DipOutcome& outcome() const { return outcome_; }
    // The outcome on show: a draft, or outcome().
    const DipOutcome& shown() const { return shown_; }
    // Which results on show fit the current project. A draft fits if it was computed from the
    // current project with coarser settings.
    Freshness freshness() const;
    bool isFresh() const; // all results on show, of all dips
    // Readout of the outcome on show, and recording of the last finished job, for the dip that is
    // shown; null if there is none.
    std::shared_ptr<const FilmReadout> reading() const;
    std::shared_ptr<const DipRecording> recording() const;

    // The number of the dip that is shown, from 0.
    std::size_t immersion() const { return immersion_; }
    void lookAt(std::size_t immersion); // does nothing if there is no such dip

signals:
    void started();
    void shownChanged();                  // another draft or outcome is on show
    void finished();                      // there is a new outcome, and it is on show
    void stopped(std::exception_ptr why); // null: cancelled, or only a first draft was requested
    void dropped();                       // the outcome is gone, because the model was replaced
    void immersionChanged(std::size_t immersion); // another dip is shown

private:
    bool mayGoOn() const;
    bool mayRefine() const;
    void start(DipStage stage);
    void takeOutcome(const DipOutcome& outcome);
    void refine();
    void goOn();
    void fail(const Fineness& fineness, bool cancelled, const std::exception_ptr& failure);
    void stop(std::exception_ptr why);
    void clear();
    void projectChanged();

    JobRunner& jobs_;
    const SolverRegistry& registry_;
    Document* document_ = nullptr;
    std::size_t immersion_ = 0;
    DipRecordings recordings_;
    DipOutcome outcome_, shown_;
    JobDrafts results_;
    Project started_; // the project of the current run
    DipStage stage_ = DipStage::Job;
    DipReach reach_ = DipReach::AllDrafts;
    CancelToken dip_; // cancels the running dip
    bool running_ = false;
    bool records_ = false; // runs only to record
    // A refinement is due or running. A change that stops it leaves this set, so that it continues
    // after an undo.
    bool refines_ = false;
    bool wanted_ = false; // run again when the current jobs have ended
    std::size_t mostPoints_ = 0;
};

} // namespace dipwright
