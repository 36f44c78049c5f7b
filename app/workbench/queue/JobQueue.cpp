#include "workbench/queue/JobQueue.h"

#include "base/Error.h"
#include "base/NumberText.h"
#include "base/PostToThread.h"
#include "cost/CostText.h"
#include "pipeline/DipCache.h"
#include "pipeline/JobCost.h"
#include "pipeline/JobTraveller.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/WriteResults.h"
#include "project/ProjectStore.h"
#include "workbench/jobs/Messages.h"

#include <QFileInfo>
#include <algorithm>

namespace dipwright {

namespace {

constexpr double leastShare = 0.05; // share done before the run time is extrapolated
constexpr double readShare = 0.02;

// Runs one project on the worker thread.
class QueuedJob : public Job {
public:
    struct Outcome {
        QString text;
        std::optional<TankJob> tank;
    };
    using Run = std::function<Outcome(const Progress&)>;
    using Ended = std::function<void(QueuedState, const Outcome&)>;

    QueuedJob(const QString& title, Run run, Ended ended)
        : title_(title), run_(std::move(run)), ended_(std::move(ended)) {}

    QString title() const override { return title_; }
    void process(const Progress& progress) override { outcome_ = run_(progress); }
    void finalize(bool cancelled, std::exception_ptr failure) override {
        ended_(cancelled ? QueuedState::Cancelled
               : failure ? QueuedState::Failed
                         : QueuedState::Done,
               failure ? Outcome{sentenceOf(failure), {}} : outcome_);
    }

private:
    QString title_;
    Outcome outcome_;
    Run run_;
    Ended ended_;
};

QString outcomeOf(const JobResult& result) {
    const QString painted =
        JobQueue::tr("Coverage %1 %").arg(numberText(100 * result.coverageTotal, 1));
    QStringList sentences{adviceText(adviceOf(result)) + u'.', painted + u'.'};
    for (const JobReason& reason : reasonsOf(result)) {
        if (reason.reason.advice > Advice::Print) {
            sentences << reasonText(reason, result, millimetres);
        }
    }
    if (const auto costs = jobCosts(result, result.project); tellsCost(costs)) {
        sentences << costSentence(costs.back()) + u'.';
    }
    return sentences.join(u'\n');
}

} // namespace

JobQueue::JobQueue(const SolverRegistry& registry, QObject* parent)
    : QObject(parent), registry_(registry) {
    connect(&jobs_, &JobRunner::progressed, this, &JobQueue::report);
    connect(&jobs_, &JobRunner::idle, this, &JobQueue::tellEnd);
}

void JobQueue::add(const QStringList& projects, const QString& folder) {
    QStringList all; // includes the earlier ones, so that no two share a folder
    for (const QueuedProject& earlier : projects_) {
        if (QFileInfo(earlier.folder).path() == folder) {
            all.append(earlier.project);
        }
    }
    const qsizetype before = all.size();
    all += projects;
    const QStringList folders = resultFolders(all, folder);
    for (qsizetype number = before; number < all.size(); ++number) {
        projects_.push_back({all[number], folders[number]});
        entries_.push_back({++lastKey_, {}, {}});
        start(projects_.back(), entries_.back());
    }
    emit changed();
}

void JobQueue::start(const QueuedProject& project, Entry& entry) {
    const auto run = [this, key = entry.key, path = project.project, folder = project.folder,
                      keeps = keepsDips_](const Progress& progress) -> QueuedJob::Outcome {
        postToThread(*this, [this, key] { begin(key); });
        const Project read = loadProject(path);
        const Progress dips = progress.part(readShare, 1);
        const auto kept =
            keeps ? usableDips(read, registry_, path, progress.silent(), [](const Error&) {})
                  : nullptr;
        const JobResult result = runAndWrite(read, registry_, {}, kept.get(), folder, dips);
        if (keeps) {
            try {
                cacheDips(result, path);
            } catch (const Error&) { // the results are written anyway
            }
        }
        return {outcomeOf(result), jobAtTank(result, path)};
    };
    entry.cancelToken = jobs_.start(std::make_unique<QueuedJob>(
        QFileInfo(project.project).completeBaseName(), run,
        [this, key = entry.key](QueuedState state, const QueuedJob::Outcome& outcome) {
            end(key, state, outcome.text, outcome.tank);
        }));
}

std::size_t JobQueue::rowOf(int key) const {
    return std::size_t(std::find_if(entries_.begin(), entries_.end(),
                                    [key](const Entry& entry) { return entry.key == key; }) -
                       entries_.begin());
}

void JobQueue::begin(int key) {
    const std::size_t row = rowOf(key);
    if (row < projects_.size() && projects_[row].state == QueuedState::Waiting) {
        runningKey_ = key;
        entries_[row].begun = std::chrono::steady_clock::now();
        projects_[row].state = QueuedState::Running;
        emit changed();
    }
}

void JobQueue::report(double share, const QString& text) {
    const std::size_t row = rowOf(runningKey_);
    if (row < projects_.size() && projects_[row].state == QueuedState::Running) {
        projects_[row].share = share;
        projects_[row].text = text;
        emit changed();
    }
}

void JobQueue::end(int key, QueuedState state, const QString& text, std::optional<TankJob> tank) {
    const std::size_t row = rowOf(key);
    if (row >= projects_.size()) {
        return;
    }
    QueuedProject& project = projects_[row];
    if (project.state == QueuedState::Running) {
        project.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - entries_[row].begun)
                .count();
    }
    project.state = state;
    project.text = text;
    project.tank = std::move(tank);
    emit changed();
}

void JobQueue::cancel(std::size_t number) {
    QueuedProject& project = projects_[number];
    entries_[number].cancelToken.cancel();
    if (project.state == QueuedState::Waiting) { // cancelled at once, without waiting for its turn
        project.state = QueuedState::Cancelled;
    } else if (project.state == QueuedState::Running) {
        project.text = tr("Cancelling …");
    }
    emit changed();
}

void JobQueue::cancelAll() {
    for (std::size_t number = 0; number < projects_.size(); ++number) {
        cancel(number);
    }
}

void JobQueue::removeEnded() {
    for (std::size_t number = projects_.size(); number-- > 0;) {
        const QueuedState state = projects_[number].state;
        if (state != QueuedState::Waiting && state != QueuedState::Running) {
            projects_.erase(projects_.begin() + std::ptrdiff_t(number));
            entries_.erase(entries_.begin() + std::ptrdiff_t(number));
        }
    }
    emit changed();
}

std::optional<double> JobQueue::secondsLeft() const {
    double seconds = 0;
    int known = 0, waiting = 0;
    double running = 0; // remaining share of the running project
    for (std::size_t number = 0; number < projects_.size(); ++number) {
        const QueuedProject& project = projects_[number];
        if (project.state == QueuedState::Done) {
            seconds += project.seconds;
            ++known;
        } else if (project.state == QueuedState::Running) {
            running = 1 - project.share;
            if (project.share > leastShare) {
                const std::chrono::duration<double> sofar =
                    std::chrono::steady_clock::now() - entries_[number].begun;
                seconds += sofar.count() / project.share;
                ++known;
            }
        }
        waiting += project.state == QueuedState::Waiting;
    }
    return known > 0 ? std::optional(seconds / known * (waiting + running)) : std::nullopt;
}

void JobQueue::tellEnd() {
    const auto count = [this](QueuedState state) {
        return std::count_if(projects_.begin(), projects_.end(),
                             [state](const auto& project) { return project.state == state; });
    };
    const auto failed = count(QueuedState::Failed), cancelled = count(QueuedState::Cancelled);
    QString sentence =
        tr("The queue has finished. Projects done: %1").arg(count(QueuedState::Done));
    if (failed > 0) {
        sentence += tr(", failed: %1").arg(failed);
    }
    if (cancelled > 0) {
        sentence += tr(", cancelled: %1").arg(cancelled);
    }
    emit ended(sentence);
}

} // namespace dipwright
