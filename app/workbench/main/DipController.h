// Runs and cancels the dip of a window's document, on request or live, and checks its numerical
// error. Marks results that no longer match the project.
#pragma once

#include "pipeline/InkOptions.h"
#include "workbench/accuracy/NumericalErrorCheck.h"
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
    DipController(const WindowActions& actions, DipSession& session, NumericalErrorCheck& check,
                  JobRunner& jobs, const SolverRegistry& registry, DipPlayback& playback,
                  Messages& messages, ResultsPanel& results, QLabel& staleBanner);

    // Call this when the session has another document.
    void showDocument();
    void setPreferences(const Preferences& preferences);
    // Runs the dip: drafts, then the job. A failed live run does not interrupt the user.
    void run(bool live);
    // Runs the dip of a pose that the user tries. Its film is not refined.
    void tryPose();
    // While the body is dragged, live runs make only first drafts.
    void setHeld(bool held) { live_.setHeld(held); }

signals:
    void cancelled();

private:
    void begin(bool live, DipReach reach);
    void record();
    void cancel();
    void checkNumericalError();
    void takeSmallerFilm();
    void takeInkOption(const InkOption& option);
    void takeResult();
    void showResults();
    void showFreshness();
    void showCosts();
    void showBanner(const QString& text);
    QString draftText(const DipOutcome& draft) const;

    const WindowActions& actions_;
    DipSession& session_;
    NumericalErrorCheck& check_;
    DipPlayback& playback_;
    Messages& messages_;
    ResultsPanel& results_;
    QLabel& staleBanner_;
    LiveRun live_;
    DipCacheUpdater keeper_;
    bool isLive_ = false; // whether the current or last run is a live run
    std::optional<bool> livePreference_;
    LengthUnit unit_ = LengthUnit::Millimetre;
};

} // namespace dipwright
