// Keeps the dips of a document's results beside its file, and finds them there when the document is
// opened again (pipeline/DipCache.h). UI thread only; reads as a job and writes on a thread of its
// own.
#pragma once

#include "workbench/dip/DipSession.h"
#include "workbench/jobs/Messages.h"

#include <QThreadPool>
#include <QTimer>

namespace dipwright {

class DipCacheUpdater : public QObject {
    Q_OBJECT

public:
    DipCacheUpdater(DipSession& session, JobRunner& jobs, const SolverRegistry& registry,
                    Messages& messages, QObject* parent = nullptr);
    ~DipCacheUpdater() override; // writes what is still to be written, and waits for it

    // Whether anything is kept or found; at first nothing is.
    void setWanted(bool wanted) { wanted_ = wanted; }
    // To be called when the session has another document.
    void showDocument();

signals:
    void found(); // the session has what its next run can take over

private:
    void find();
    void keepSoon();
    void keep();
    void tellOnce(const QString& sentence);

    DipSession& session_;
    JobRunner& jobs_;
    const SolverRegistry& registry_;
    Messages& messages_;
    bool wanted_ = false, told_ = false;
    QTimer delay_; // since the last result: dips that run one after the other are kept together
    std::shared_ptr<const JobResult> result_; // that is still to be written …
    QString path_;                            // … beside this project
    QThreadPool writer_;
};

} // namespace dipwright
