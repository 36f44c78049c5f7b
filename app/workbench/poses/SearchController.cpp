#include "workbench/poses/SearchController.h"

#include "base/PostToThread.h"
#include "film/FilmGrid.h"
#include "pipeline/JobSearch.h"
#include "pipeline/SolverChoice.h"
#include "search/PoseCandidates.h"
#include "traveller/PosePicture.h"
#include "workbench/document/ImmersionEdits.h"

#include <condition_variable>
#include <map>
#include <mutex>

namespace dipwright {

namespace {

constexpr QSize pictureSize(112, 112); // twice the shown size, for high-resolution screens
constexpr std::size_t mostPictures = 20;

} // namespace

// The page's contents, made on the worker thread.
struct SearchController::Update {
    SearchResult result;
    std::vector<QImage> pictures;
    int done = 0, wanted = 0;
    std::optional<double> secondsLeft;
    bool isRefiningFilm = false;
    SolverInfo solver; // of a search that ended; its id is empty if another solver took over
};

// Connects the search's thread with the UI thread: passes updates on, and blocks the search while
// it is paused. Used from both threads.
class SearchController::Watcher {
public:
    Watcher(SearchController& owner, std::shared_ptr<const TexturedMesh> model)
        : owner_(&owner), model_(std::move(model)) {}

    // The user pauses the search; the project's own dip makes it wait.
    void setPaused(bool paused) { set(isPaused_, paused); }
    void setWaiting(bool waiting) { set(isWaiting_, waiting); }

    // Worker thread. Returns when the search may continue or is cancelled; tells how long it
    // waited.
    std::chrono::duration<double> watch(const std::shared_ptr<Watcher>& self,
                                        const SearchState& state, const CancelToken& cancelToken) {
        handOverUpdate(self, {state.soFar,
                              picturesOf(state.soFar, cancelToken),
                              state.done,
                              state.wanted,
                              state.secondsLeft,
                              state.isRefiningFilm,
                              {}});
        const auto begin = std::chrono::steady_clock::now();
        std::unique_lock lock(mutex_);
        while ((isPaused_ || isWaiting_) && !cancelToken.isCancelled()) {
            goOn_.wait_for(lock, std::chrono::milliseconds(100));
        }
        return std::chrono::steady_clock::now() - begin;
    }

    Update lastOf(const SearchResult& result, const SolverInfo& solver) {
        return {result, picturesOf(result, {}), 0, 0, std::nullopt, false, solver};
    }

private:
    void set(bool& flag, bool value) {
        {
            const std::lock_guard lock(mutex_);
            flag = value;
        }
        goOn_.notify_all();
    }

    void handOverUpdate(const std::shared_ptr<Watcher>& self, Update update) {
        postToThread(*owner_, [self, owner = owner_, update = std::move(update)] {
            if (owner->watcher_ == self) { // it is still the current search
                owner->take(update);
            }
        });
    }

    // Pictures of the best poses; each is drawn once.
    std::vector<QImage> picturesOf(const SearchResult& result, const CancelToken& cancelToken) {
        std::vector<QImage> pictures;
        for (const RankedPoses& poses : result.ranking) {
            if (pictures.size() >= mostPictures || cancelToken.isCancelled()) {
                break;
            }
            pictures.push_back(pictureOf(poses.immersions.front()));
        }
        return pictures;
    }
    QImage pictureOf(const Immersion& immersion) {
        const std::array<double, 3> key{immersion.rotation[0].value(),
                                        immersion.rotation[1].value(),
                                        immersion.rotation[2].value()};
        auto found = drawn_.find(key);
        if (found == drawn_.end()) {
            if (!fine_) {
                fine_ = fineBody(model_->mesh);
            }
            const PosedBody body = posedBody(model_->mesh, immersion);
            const PaintedBody bare({}, {});
            const PoseView view{body, *fine_, bare};
            found = drawn_.emplace(key, posePicture(view, PoseSide::Front, pictureSize, {}).image)
                        .first;
        }
        return found->second;
    }

    SearchController* owner_;
    std::shared_ptr<const TexturedMesh> model_;
    std::shared_ptr<const RefinedMesh> fine_;       // worker thread only
    std::map<std::array<double, 3>, QImage> drawn_; // worker thread only
    std::mutex mutex_;
    std::condition_variable goOn_;
    bool isPaused_ = false, isWaiting_ = false;
};

SearchController::SearchController(DipSession& session, const SolverRegistry& registry,
                                   Messages& messages, QObject* parent)
    : QObject(parent), session_(session), registry_(registry), messages_(messages),
      page_(new SearchPage) {
    connect(page_, &SearchPage::startAsked, this, &SearchController::start);
    connect(page_, &SearchPage::stopAsked, this, [this] { running_.cancel(); });
    connect(page_, &SearchPage::pauseAsked, this, [this](bool paused) {
        if (watcher_) {
            watcher_->setPaused(paused);
        }
    });
    for (const auto changed : {&DipSession::started, &DipSession::finished, &DipSession::dropped}) {
        connect(&session, changed, this, &SearchController::yieldToDip);
    }
    connect(&session, &DipSession::stopped, this, &SearchController::yieldToDip);
    connect(page_, &SearchPage::lookAsked, this, [this](const RankedPoses& poses) {
        if (session_.document()) {
            keepDips(poses);
            tryImmersions(*session_.document(), poses.immersions);
            emit poseTried();
        }
    });
    connect(page_, &SearchPage::applyAsked, this, &SearchController::apply);
    connect(page_, &SearchPage::aimsChanged, this, &SearchController::takeAims);
    connect(page_, &SearchPage::aimsLeft, this, [this] {
        if (session_.document()) {
            session_.document()->endMerge();
        }
    });
    connect(page_, &SearchPage::comparisonAsked, this,
            [this](const std::array<ComparedState, 2>& states) {
                std::array<ComparedState, 2> whole = states;
                for (ComparedState& state : whole) { // uses the project at the time of the search
                    const std::vector<Immersion> immersions = state.project.immersions;
                    state.project = searched_;
                    state.project.immersions = immersions;
                }
                emit comparisonAsked(whole);
            });
    connect(page_, &SearchPage::sideAsked, this, &SearchController::applySide);
    connect(&jobs_, &JobRunner::idle, this, &SearchController::end);
    connect(&jobs_, &JobRunner::progressed, page_,
            [this](double, const QString& doing) { page_->setPreparing(doing); });
}

QWidget* SearchController::page() const {
    return page_;
}

void SearchController::showDocument() {
    running_.cancel();
    watcher_.reset();
    page_->clear();
    searched_ = {};
    searchedSolver_ = {};
    if (const Document* document = session_.document()) {
        page_->setImmersions(int(document->project().immersions.size()));
        connect(document, &Document::projectChanged, this, &SearchController::showProject);
        showProject();
    }
}

void SearchController::start() {
    const Document* document = session_.document();
    if (!document || watcher_) {
        return;
    }
    searched_ = document->project();
    searchedSolver_ = {};
    const SearchSettings settings = page_->settings();
    page_->setState(SearchPage::State::Searching);
    watcher_ = std::make_shared<Watcher>(*this, searched_.model);
    yieldToDip();
    using Found = std::optional<Update>; // none: cancelled before the first result
    running_ = jobs_.start(std::make_unique<ValueJob<Found>>(
        tr("Searching poses"),
        [project = searched_, settings, watcher = watcher_,
         &registry = registry_](const Progress& progress) {
            SolverChoice solver =
                chooseSolver(project.process.solver, registry, progress.cancelToken);
            const SearchWatch watch = [&](const SearchState& state) {
                return watcher->watch(watcher, state, progress.cancelToken);
            };
            const SolverInfo chosen = solver.solver;
            const SearchResult result =
                withFallback(solver, registry, [&](const solver::SolverModule& module) {
                    return searchPoses(searchSubject(project, solver.solver.id), settings, module,
                                       {}, watch, progress);
                });
            return Found(
                watcher->lastOf(result, solver.solver.id == chosen.id ? chosen : SolverInfo()));
        },
        [this, watcher = watcher_](const Found& found) {
            if (watcher_ == watcher && found) {
                end();
                page_->setResult(found->result, found->pictures);
                searchedSolver_ = found->solver;
                messages_.logAndSay(
                    found->result.isComplete
                        ? tr("The search has finished. The best pose is at the top.")
                        : tr("The search was stopped. The best pose so far is at the top."));
                showFreshness();
            }
        },
        [this](const std::exception_ptr& failure) {
            end();
            messages_.fail(tr("Pose search"), failure);
        }));
}

// A search waits while the project's own dip runs, so that the user sees results at once. It does
// not wait while the film of the results is refined.
void SearchController::yieldToDip() {
    if (watcher_) {
        const bool waits = session_.isRunning() && !session_.isRefining();
        watcher_->setWaiting(waits);
        page_->setWaiting(waits);
    }
}

// Called at the end of every search. A search that was cancelled before its first result has no
// other signal.
void SearchController::end() {
    watcher_.reset();
    page_->setState(SearchPage::State::Idle);
}

void SearchController::take(const Update& update) {
    page_->setResult(update.result, update.pictures);
    page_->setProgress(update.done, update.wanted, update.isRefiningFilm, update.secondsLeft);
    showFreshness();
}

void SearchController::apply(const RankedPoses& poses) {
    if (session_.document() && !poses.immersions.empty()) {
        keepDips(poses);
        Document& document = *session_.document();
        const bool wasTried = document.project().immersions == poses.immersions;
        document.endMerge(); // poses tried before keep their own undo step
        setImmersions(document, poses.immersions);
        if (wasTried && (session_.isRunning() || session_.canRefine())) {
            emit triedPoseUsed();
        }
    }
}

// The next run takes over the dips that the search simulated.
void SearchController::keepDips(const RankedPoses& poses) {
    if (!watcher_ && !searchedSolver_.id.isEmpty()) {
        session_.setKept(foundDips(searched_, poses, searchedSolver_));
    }
}

// Turns the shown dip so that the side `down` points down.
void SearchController::applySide(const Eigen::Vector3d& down) {
    if (Document* document = session_.document(); document && document->project().model) {
        std::vector<Immersion> immersions = document->project().immersions;
        Immersion& shown = immersions[session_.immersion()];
        const Project& project = document->project();
        shown.rotation = immersionFor(project.model->mesh, down, filmGrid(project.film)).rotation;
        setImmersions(*document, immersions);
    }
}

void SearchController::takeAims(const QString& what) {
    if (Document* document = session_.document()) {
        document->edit(tr("Change search settings"), QStringLiteral("pose_search ") + what,
                       [this](Project& project) { project.poseAims = page_->settings().aims; });
    }
}

void SearchController::showProject() {
    if (const Document* document = session_.document()) {
        page_->setAims(document->project().poseAims);
        showFreshness();
    }
}

// The project's poses are only some more candidates of a search, so other poses do not outdate its
// result.
void SearchController::showFreshness() {
    if (const Document* document = session_.document(); document && searched_.model) {
        const Project& now = document->project();
        page_->setOutdated(!haveSameSearchSubject(now, searched_) ||
                           now.poseAims != searched_.poseAims);
    }
}

} // namespace dipwright
