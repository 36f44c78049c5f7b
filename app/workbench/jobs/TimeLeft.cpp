#include "workbench/jobs/TimeLeft.h"

#include "workbench/jobs/JobRunner.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace dipwright {

std::optional<double> secondsLeft(const std::vector<JobProgress>& reports, double now) {
    constexpr double soonest = 4; // s
    if (now < soonest || reports.size() < 2) {
        return std::nullopt;
    }
    const auto isLate = [now](const JobProgress& report) { return report.seconds >= now / 2; };
    auto first = std::find_if(reports.begin(), reports.end() - 1, isLate);
    if (first != reports.begin()) {
        --first; // so that a job with few reports has two of them
    }
    const JobProgress &from = *first, &last = reports.back();
    const double meanStep = (last.seconds - from.seconds) / double(reports.end() - first - 1);
    const double since = now - last.seconds;
    const double seconds = last.seconds - from.seconds + std::max(0.0, since - meanStep);
    if (seconds <= 0) {
        return std::nullopt;
    }
    const double rest = (1 - last.share) * seconds / (last.share - from.share);
    return std::max(0.0, rest - std::min(since, meanStep));
}

double steadySeconds(double left, std::optional<double> shown) {
    constexpr double grownLittle = 1.25;
    const double step = left < 60 ? 5 : left < 600 ? 30 : left < 3600 ? 60 : 600;
    const double rounded = std::max(1.0, std::ceil(left / step)) * step;
    const bool isKept = shown && rounded > *shown && left < *shown * grownLittle + step;
    return isKept ? *shown : rounded;
}

QString timeLeftText(double seconds) {
    constexpr double minute = 60, hour = 3600;
    const QLocale locale;
    if (seconds < hour) {
        return seconds < 2 * minute
                   ? TimeLeft::tr("about %1 s left").arg(locale.toString(int(std::ceil(seconds))))
                   : TimeLeft::tr("about %1 min left")
                         .arg(locale.toString(int(std::ceil(seconds / minute))));
    }
    const int minutes = int(std::ceil(seconds / minute));
    return TimeLeft::tr("about %1 h %2 min left").arg(minutes / 60).arg(minutes % 60);
}

TimeLeft::TimeLeft(const JobRunner& jobs, QObject* parent) : QObject(parent) {
    constexpr int everySecond = 1000; // ms
    tick_.setInterval(everySecond);
    connect(&tick_, &QTimer::timeout, this, &TimeLeft::tell);
    connect(&jobs, &JobRunner::started, this, &TimeLeft::begin);
    connect(&jobs, &JobRunner::progressed, this,
            [this](double share, const QString&) { add(share); });
    connect(&jobs, &JobRunner::idle, this, [this] {
        tick_.stop();
        emit told({});
    });
}

void TimeLeft::begin() {
    reports_.clear();
    shown_.reset();
    clock_.start();
    tick_.start();
    emit told({});
}

void TimeLeft::add(double share) {
    constexpr double shortest = 0.5; // s; closer reports say nothing more
    const double now = double(clock_.elapsed()) / 1000;
    if (!reports_.empty() && share < reports_.back().share) {
        reports_.clear(); // the job has begun another part
    }
    if (reports_.empty() ||
        (share > reports_.back().share && now - reports_.back().seconds >= shortest)) {
        reports_.push_back({now, share});
    }
}

void TimeLeft::tell() {
    const std::optional<double> left = secondsLeft(reports_, double(clock_.elapsed()) / 1000);
    if (!left) {
        return;
    }
    shown_ = steadySeconds(*left, shown_);
    emit told(timeLeftText(*shown_));
}

} // namespace dipwright
