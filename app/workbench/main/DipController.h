// The dip of a window's document: run, cancelled, run again live, how certain it is, and what of
// its results is still true.
#pragma once

#include "workbench/accuracy/CertaintyCheck.h"
#include "workbench/dip/DipCacheUpdater.h"
#include "workbench/dip/DipSession.h"
#include "workbench/dip/LiveRun.h"
#include "workbench/document/Preferences.h"
#include "workbench/jobs/Messages.h"

class QLabel;

namespace dipwright {

class DipPlayback;
class ResultsPanel;
class WindowActions;

class DipController : public QObject {
    Q_OBJECT

public:
    DipController(const WindowActions& actions, DipSession& session, CertaintyCheck& check,
                  JobRunner& jobs, const SolverRegistry& registry, const DipPlayback& playback,
                  Messages& messages, ResultsPanel& results, QLabel& staleBanner);

    // To be called when the session has another document.
    void showDocument();
    void setPreferences(const Preferences& preferences);
    // While the body is dragged, nothing is run live.
    void setHeld(bool held) { live_.setHeld(held); }

signals:
    void cancelled();

private:
    void run(bool live);
    void cancel();
    void checkCertainty();
    void takeSmallerFilm();
    void takeResult();
    void showResults();
    void showFreshness();

    const WindowActions& actions_;
    DipSession& session_;
    CertaintyCheck& check_;
    const DipPlayback& playback_;
    Messages& messages_;
    ResultsPanel& results_;
    QLabel& staleBanner_;
    LiveRun live_;
    DipCacheUpdater keeper_;
    bool isLive_ = false; // what runs, or ran last
    std::optional<bool> livePreference_;
};

} // namespace dipwright
