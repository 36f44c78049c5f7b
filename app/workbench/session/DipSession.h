// The dips of one document: starts them, starts them again when the project changes on the way,
// and keeps the recordings and the outcome of the last one. No widgets. UI thread only.
#pragma once

#include "document/Document.h"
#include "jobs/DipJob.h"
#include "jobs/JobRunner.h"

namespace dipwright {

class DipSession : public QObject {
    Q_OBJECT

public:
    DipSession(JobRunner& jobs, const SolverRegistry& registry, QObject* parent = nullptr);

    // Lets go of what belonged to another document; null: none.
    void setDocument(Document* document);
    // Runs what is out of date; nothing where nothing is. While jobs run, it is done after them,
    // and a dip that runs on older values is cancelled. `mostPoints`: of the recorded film.
    void run(std::size_t mostPoints);
    // The dip is over at once, whenever the solver comes to its next step and notices.
    void cancel();
    bool isRunning() const { return running_; }

    // Of the last dip that was done; empty before.
    const DipOutcome& outcome() const { return outcome_; }
    std::shared_ptr<const FilmReading> reading(std::size_t immersion) const;    // may be null
    std::shared_ptr<const DipRecording> recording(std::size_t immersion) const; // may be null
    // Of the dip that runs: the immersion that is being dipped; null before its first frame.
    std::shared_ptr<const DipRecording> liveRecording() const;

signals:
    void started();
    void finished();                      // the outcome is new
    void stopped(std::exception_ptr why); // null: cancelled

private:
    void takeOutcome(const DipOutcome& outcome);
    void stop(std::exception_ptr why);
    void projectChanged();

    JobRunner& jobs_;
    const SolverRegistry& registry_;
    Document* document_ = nullptr;
    DipRecordings recordings_, live_;
    DipOutcome outcome_;
    CancelSwitch dip_; // the one that runs
    bool running_ = false;
    bool wanted_ = false; // again, once the jobs that run now have ended
    std::size_t mostPoints_ = 0;
};

} // namespace dipwright
