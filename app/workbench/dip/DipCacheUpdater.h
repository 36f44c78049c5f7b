// Caches the dips of a document's results beside its file, and reads them when the document is
// opened again (pipeline/DipCache.h). UI thread only. Reads as a job; writes on its own thread.
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
    ~DipCacheUpdater() override; // writes a pending result, and waits for the write

    // Switches the cache on or off. It starts off.
    void setWanted(bool wanted) { wanted_ = wanted; }
    // Call this when the session has another document.
    void showDocument();

signals:
    void found(); // the session has dips that its next run can reuse

private:
    void find();
    void keepSoon();
    void keep();
    void reportOnce(const QString& sentence);

    DipSession& session_;
    JobRunner& jobs_;
    const SolverRegistry& registry_;
    Messages& messages_;
    bool wanted_ = false, told_ = false;
    QTimer delay_; // starts after each result, so that several results in a row are written once
    std::shared_ptr<const JobResult> result_; // pending; null: nothing to write
    QString path_;                            // the project file of result_
    QThreadPool writer_;
};

} // namespace dipwright
