#include "workbench/main/DipController.h"

#include "pipeline/FilmRefinement.h"
#include "pipeline/JobCost.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/SmallerFilm.h"
#include "workbench/accuracy/VerdictPanel.h"
#include "workbench/actions/WindowActions.h"
#include "workbench/results/ReportPanel.h"
#include "workbench/results/ResultsPanel.h"
#include "workbench/view/DipPlayback.h"
#include "workbench/widgets/ShippedNames.h"

#include <QAction>
#include <QLabel>

namespace dipwright {

DipController::DipController(const WindowActions& actions, DipSession& session,
                             NumericalErrorCheck& check, JobRunner& jobs,
                             const SolverRegistry& registry, DipPlayback& playback,
                             Messages& messages, ResultsPanel& results, QLabel& staleBanner)
    : actions_(actions), session_(session), check_(check), playback_(playback), messages_(messages),
      results_(results), staleBanner_(staleBanner), keeper_(session, jobs, registry, messages) {
    connect(&session, &DipSession::started, this, [this] {
        messages_.notice({});
        results_.setDraftEnd(DraftEnd::ResultFollows);
        showFreshness();
    });
    connect(&session, &DipSession::shownChanged, this, &DipController::showResults);
    connect(&session, &DipSession::finished, this, &DipController::takeResult);
    connect(&session, &DipSession::stopped, this, [this](const std::exception_ptr& failure) {
        messages_.notice({});
        // While the part is held, only a draft is computed; the run goes on when it is released.
        results_.setDraftEnd(failure          ? DraftEnd::Failed
                             : live_.isHeld() ? DraftEnd::ResultFollows
                                              : DraftEnd::Cancelled);
        showResults();
        // A failed live run must not interrupt the user.
        if (failure && isLive_) {
            messages_.log(sentenceOf(failure));
            messages_.notice(sentenceOf(failure));
        } else if (failure) {
            messages_.fail(tr("Dip"), failure);
        }
    });
    connect(&session, &DipSession::immersionChanged, this, &DipController::showResults);
    connect(&session, &DipSession::dropped, this, &DipController::showResults);
    connect(&live_, &LiveRun::runAsked, this, [this] { run(true); });
    connect(&playback, &DipPlayback::recordingAsked, this, &DipController::record);
    connect(&keeper_, &DipCacheUpdater::found, this, [this] { run(true); });
    connect(actions.run, &QAction::triggered, this, [this] { run(false); });
    connect(actions.cancel, &QAction::triggered, this, &DipController::cancel);
    connect(actions.live, &QAction::toggled, &live_, &LiveRun::setWanted);
    connect(actions.live, &QAction::toggled, &playback, &DipPlayback::setLive);
    connect(actions.numericalError, &QAction::triggered, this, &DipController::checkNumericalError);
    connect(&results.report(), &ReportPanel::smallerFilmTaken, this,
            &DipController::takeSmallerFilm);
    connect(&results.report(), &ReportPanel::inkOptionTaken, this, &DipController::takeInkOption);
}

void DipController::showDocument() {
    const Document* document = session_.document();
    live_.setDocument(document);
    if (document) {
        connect(document, &Document::projectChanged, this, &DipController::showFreshness);
        connect(document, &Document::projectChanged, this, &DipController::showCosts);
        showResults();
    }
    keeper_.showDocument();
}

void DipController::setPreferences(const Preferences& preferences) {
    // The user's own choice holds until the preference itself is changed.
    if (std::exchange(livePreference_, preferences.liveUpdate) != preferences.liveUpdate) {
        actions_.live->setChecked(preferences.liveUpdate);
    }
    keeper_.setWanted(preferences.keepsResults);
    unit_ = preferences.unit;
}

void DipController::run(bool live) {
    begin(live, live && live_.isHeld() ? DipReach::FirstDraft : DipReach::AllDrafts);
}

void DipController::tryPose() {
    begin(true, DipReach::Unrefined);
}

void DipController::begin(bool live, DipReach reach) {
    isLive_ = live;
    live_.begin();
    check_.cancel();
    session_.run(playback_.mostPoints(), reach);
}

// Dips that were read from the cache have no recordings.
void DipController::record() {
    isLive_ = false;
    if (session_.record(playback_.mostPoints())) {
        playback_.playNext();
        messages_.notice(tr("The saved results contain no recording of the dip. The dip is "
                            "simulated again so that you can play it; the results stay the same."));
    } else {
        messages_.say(tr("The dip can be played when the running job has ended."));
    }
}

void DipController::cancel() {
    live_.cancel();
    session_.cancel();
    results_.setDraftEnd(DraftEnd::Cancelled); // also between a draft and the run that follows it
    emit cancelled();
}

void DipController::checkNumericalError() {
    check_.start(*session_.document());
}

void DipController::takeSmallerFilm() {
    Document& document = *session_.document();
    const auto isDipped = [&] {
        for (std::size_t number = 0; number < document.project().immersions.size(); ++number) {
            if (!document.isFresh(JobStep::Dip, number)) {
                return false;
            }
        }
        return true;
    };
    const auto smaller = isDipped() ? smallerFilm(*document.result()) : std::nullopt;
    if (!smaller) {
        messages_.say(tr("The results are out of date; run the dip again first."));
        return;
    }
    document.edit(tr("Use film %1").arg(smaller->format), {},
                  [&](Project& project) { take(project, *smaller); });
}

void DipController::takeInkOption(const InkOption& option) {
    Document& document = *session_.document();
    if (!document.isFresh()) {
        messages_.say(tr("The results are out of date; run the dip again first."));
        return;
    }
    document.edit(remedyText(option), {}, [&](Project& project) { take(project, option); });
    if (option.remedy == InkRemedy::OtherPose) {
        actions_.findPoses->trigger();
    }
}

void DipController::takeResult() {
    const JobResult& result = *session_.outcome().result;
    for (const QString& note : result.notes) {
        messages_.log(note);
    }
    const QString notes = result.notes.join(QLatin1Char('\n'));
    if (result.notes == refinementRemarks(result)) {
        messages_.inform(notes);
    } else {
        messages_.notice(notes);
    }
    messages_.log(adviceText(adviceOf(result)));
    for (const JobReason& reason : reasonsOf(result)) {
        messages_.log(reasonText(reason, result, millimetres));
    }
    messages_.log(
        tr("Simulated with %1 on %2").arg(shownName(result.solver.name), result.solver.device));
    showResults();
}

void DipController::showResults() {
    results_.setOutcome(session_.shown(), session_.immersion());
    showCosts();
    showFreshness();
}

// Prices and the number of parts may be newer than the result.
void DipController::showCosts() {
    const DipOutcome& shown = session_.shown();
    const bool hasCosts = session_.document() && shown.result && !shown.fineness.isDraft();
    results_.report().setCosts(hasCosts ? jobCosts(*shown.result, session_.document()->project())
                                        : std::vector<OrderCost>());
    results_.report().setTankTimes(session_.document()
                                       ? session_.document()->project().asBuilt.times
                                       : std::vector<TankTime>());
}

void DipController::showFreshness() {
    const DipOutcome& shown = session_.shown();
    if (!shown.result) {
        staleBanner_.hide();
        return;
    }
    const Freshness fresh = session_.freshness();
    results_.setFreshness(fresh, session_.isFresh());
    const bool isDraft = shown.fineness.isDraft();
    const bool isCoarse = session_.canRefine(); // also while it is being refined
    staleBanner_.setVisible(isDraft || isCoarse || !fresh.sheet);
    if (!fresh.sheet) {
        showBanner(session_.isRunning() ? tr("Out of date: new results are being computed.")
                   : fresh.dip          ? tr("Sheet out of date: made before the last changes.")
                                        : tr("Results out of date: made before the last changes."));
    } else if (isDraft) {
        showBanner(draftText(shown));
    } else if (isCoarse) {
        showBanner(session_.isRefining()
                       ? tr("Refining to reduce the numerical error. Cancel keeps this result.")
                       : tr("The numerical error is larger than wanted. Run the dip again to "
                            "refine the film."));
    }
}

// The banner has one line, so that the view keeps its size. In a narrow window the tooltip has the
// whole text.
void DipController::showBanner(const QString& text) {
    staleBanner_.setText(text);
    staleBanner_.setToolTip(text);
}

// Returns how fine the draft is and how far it may be off.
QString DipController::draftText(const DipOutcome& draft) const {
    const solver::FilmGrid& grid = session_.reading()->film().grid;
    QStringList parts{tr("Draft with %1 × %2 film points").arg(grid.columns).arg(grid.rows)};
    if (draft.fineness.moves) {
        parts +=
            tr("95 % of the sheet within about %1").arg(shownLength(*draft.fineness.moves, unit_));
    }
    parts += session_.isRunning() ? tr("being refined") : tr("run the dip before printing");
    return parts.join(QStringLiteral(" · "));
}

} // namespace dipwright
