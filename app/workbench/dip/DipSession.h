// Runs the dips of one document, and keeps their last outcome, their recordings and the number of
// the dip that is shown. UI thread only.
#pragma once

#include "workbench/dip/DipJob.h"
#include "workbench/document/Document.h"
#include "workbench/jobs/JobRunner.h"

namespace dipwright {

class DipSession : public QObject {
    Q_OBJECT

public:
    DipSession(JobRunner& jobs, const SolverRegistry& registry, QObject* parent = nullptr);

    // Drops the results of the previous document. Null: no document.
    void setDocument(Document* document);
    Document* document() const { return document_; }
    // Runs the dips that are out of date. Waits for running jobs first, but cancels a running dip
    // with older values. `mostPoints`: approximate number of film points that are recorded.
    void run(std::size_t mostPoints);
    // Sets the result that the first run can reuse.
    void setKept(std::shared_ptr<const JobResult> kept) { kept_ = std::move(kept); }
    // Cancels all jobs. Emits stopped() at once for a running dip. Its job ends on the worker
    // thread at its next progress report.
    void cancel();
    bool isRunning() const { return running_; }

    // The outcome of the last finished run; empty before the first.
    const DipOutcome& outcome() const { return outcome_; }
    // Readout and recording of the dip that is shown; null if there is none.
    std::shared_ptr<const FilmReadout> reading() const;
    std::shared_ptr<const DipRecording> recording() const;
    // The recording of the dip that is being simulated; null before its first frame.
    std::shared_ptr<const DipRecording> liveRecording() const;

    // The number of the dip that is shown, from 0.
    std::size_t immersion() const { return immersion_; }
    void lookAt(std::size_t immersion); // does nothing if there is no such dip

signals:
    void started();
    void finished();                      // there is a new outcome
    void stopped(std::exception_ptr why); // null: cancelled
    void dropped();                       // the outcome is gone, because the model was replaced
    void immersionChanged(std::size_t immersion); // another dip is shown

private:
    void takeOutcome(const DipOutcome& outcome);
    void stop(std::exception_ptr why);
    void projectChanged();

    JobRunner& jobs_;
    const SolverRegistry& registry_;
    Document* document_ = nullptr;
    std::size_t immersion_ = 0;
    DipRecordings recordings_, live_;
    DipOutcome outcome_;
    std::shared_ptr<const JobResult> kept_;
    CancelToken dip_; // cancels the running dip
    bool running_ = false;
    bool wanted_ = false; // run again when the current jobs have ended
    std::size_t mostPoints_ = 0;
};

} // namespace dipwright
