#include "workbench/tank/TankWork.h"

#include <QJsonArray>

#include <algorithm>
#include <utility>

namespace dipwright {

namespace {

const QString taskKey = QStringLiteral("task"), runKey = QStringLiteral("run"),
              spentKey = QStringLiteral("spent_s"), pausedKey = QStringLiteral("paused"),
              savedKey = QStringLiteral("saved_s"), beganKey = QStringLiteral("began"),
              timesKey = QStringLiteral("times"), tookKey = QStringLiteral("took_s");

} // namespace

TankWork::TankWork(std::vector<TankJob> jobs, Clock clock, const QString& now)
    : jobs_(std::move(jobs)), clock_(std::move(clock)) {
    begin(0, now);
}

const TankTask* TankWork::task() const {
    return isDone_ ? nullptr : &job().tasks[task_];
}

const TankTask* TankWork::nextTask() const {
    return isDone_ || task_ + 1 >= job().tasks.size() ? nullptr : &job().tasks[task_ + 1];
}

Seconds TankWork::spent() const {
    return Seconds(isPaused_ ? began_ : clock_() - began_);
}

std::optional<Seconds> TankWork::left() const {
    return task() && task()->time ? std::optional(*task()->time - spent()) : std::nullopt;
}

void TankWork::begin(std::size_t task, const QString& now) {
    task_ = task;
    isPaused_ = false;
    began_ = clock_();
    beganAt_ = now;
}

std::vector<TankTime> TankWork::next(const QString& now) {
    if (isDone_) {
        return {};
    }
    const TankTask& done = *task();
    times_.push_back({run_, done.dip, done.step, beganAt_, done.time, spent()});
    if (task_ + 1 < job().tasks.size()) {
        begin(task_ + 1, now);
        return {};
    }
    if (job_ + 1 < jobs_.size()) {
        ++job_;
        run_ = 1;
    } else {
        isDone_ = true;
    }
    begin(0, now);
    return std::exchange(times_, {});
}

void TankWork::back(const QString& now) {
    if (!isDone_ && task_ > 0) {
        times_.pop_back();
        begin(task_ - 1, now);
    }
}

void TankWork::setPaused(bool paused) {
    if (paused != isPaused_ && !isDone_) {
        const Seconds soFar = spent();
        began_ = paused ? soFar.value() : clock_() - soFar.value();
        isPaused_ = paused;
    }
}

void TankWork::again(const QString& now) {
    if (isDone_) {
        isDone_ = false;
        ++run_;
        begin(0, now);
    }
}

QJsonObject TankWork::progress(double wall) const {
    QJsonArray times;
    for (const TankTime& time : times_) {
        times.append(QJsonObject{{beganKey, time.began}, {tookKey, time.took.value()}});
    }
    return {{taskKey, qint64(task_)}, {runKey, run_},   {spentKey, spent().value()},
            {pausedKey, isPaused_},   {savedKey, wall}, {beganKey, beganAt_},
            {timesKey, times}};
}

void TankWork::restore(const QJsonObject& progress, double wall) {
    const auto task = std::size_t(std::max(0, progress.value(taskKey).toInt()));
    const QJsonArray times = progress.value(timesKey).toArray();
    if (progress.isEmpty() || isDone_ || task >= job().tasks.size() ||
        std::size_t(times.size()) != task) {
        return;
    }
    run_ = std::max(1, progress.value(runKey).toInt());
    times_.clear();
    for (std::size_t i = 0; i < task; ++i) {
        const TankTask& done = job().tasks[i];
        const QJsonObject time = times[qsizetype(i)].toObject();
        times_.push_back({run_, done.dip, done.step, time.value(beganKey).toString(), done.time,
                          Seconds(std::max(0.0, time.value(tookKey).toDouble()))});
    }
    begin(task, progress.value(beganKey).toString());
    const bool wasPaused = progress.value(pausedKey).toBool();
    const double meanwhile =
        wasPaused ? 0 : std::max(0.0, wall - progress.value(savedKey).toDouble());
    began_ = clock_() - std::max(0.0, progress.value(spentKey).toDouble()) - meanwhile;
    setPaused(wasPaused);
}

} // namespace dipwright
