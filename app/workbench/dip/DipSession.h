// The dips of one document: starts them, starts them again when the project changes on the way,
// keeps the recordings and the outcome of the last one, and which immersion of it is looked at. UI
// thread only.
#pragma once

#include "workbench/dip/DipJob.h"
#include "workbench/document/Document.h"
#include "workbench/jobs/JobRunner.h"

namespace dipwright {

class DipSession : public QObject {
    Q_OBJECT

public:
    DipSession(JobRunner& jobs, const SolverRegistry& registry, QObject* parent = nullptr);

    // Lets go of what belonged to another document; null: none.
    void setDocument(Document* document);
    Document* document() const { return document_; }
    // Runs what is out of date; nothing where nothing is. While jobs run, it is done after them,
    // and a dip that runs on older values is cancelled. `mostPoints`: of the recorded film.
    void run(std::size_t mostPoints);
    // What the first run of the document can take over, in the place of an earlier result.
    void setKept(std::shared_ptr<const JobResult> kept) { kept_ = std::move(kept); }
    // Cancels all jobs. A dip that runs is over for the session at once, with stopped(); its job
    // ends on the worker thread when it next reports its progress.
    void cancel();
    bool isRunning() const { return running_; }

    // Of the last dip that was done; empty before.
    const DipOutcome& outcome() const { return outcome_; }
    // Of the immersion that is looked at; null where it has none.
    std::shared_ptr<const FilmReadout> reading() const;
    std::shared_ptr<const DipRecording> recording() const;
    // Of the dip that runs: the immersion that is being dipped; null before its first frame.
    std::shared_ptr<const DipRecording> liveRecording() const;

    // The immersion that is looked at; the first one of a new document.
    std::size_t immersion() const { return immersion_; }
    void lookAt(std::size_t immersion); // nothing where the project has none of that number

signals:
    void started();
    void finished();                      // the outcome is new
    void stopped(std::exception_ptr why); // null: cancelled
    void dropped();                       // there is no outcome any more: the model is another
    void immersionChanged(std::size_t immersion); // another one is looked at

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
    CancelToken dip_; // the one that runs
    bool running_ = false;
    bool wanted_ = false; // again, once the jobs that run now have ended
    std::size_t mostPoints_ = 0;
};

} // namespace dipwright
