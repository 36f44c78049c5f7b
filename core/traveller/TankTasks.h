// The steps at the tank, one after the other, for the traveller's pages and for the tank-side page.
#pragma once

#include "settings/AsBuilt.h"

#include <QString>
#include <optional>
#include <vector>

namespace dipwright {

struct Traveller;

struct TankTask {
    int dip = 1; // from 1
    TankStep step = TankStep::Lay;
    QString title;               // a few words, for large letters
    QString text;                // the traveller's sentence
    std::optional<Seconds> time; // planned; none: no time is given
};

// A job at the tank.
struct TankJob {
    QString project;
    QString path; // the project's file; empty: never saved
    QString job;  // number of all sheets together
    std::vector<TankTask> tasks;
};

// Returns the steps of all dips, in order.
std::vector<TankTask> tankTasks(const Traveller& traveller);
// Returns the title of a step.
QString tankStepTitle(TankStep step);

// How long a step took in all runs.
struct TankSummary {
    int dip = 1;
    TankStep step = TankStep::Lay;
    int runs = 0;
    std::optional<Seconds> planned; // in the last run
    Seconds mean, shortest, longest;
};
// Returns a summary for each step, in the order of the first run.
std::vector<TankSummary> tankSummaries(const std::vector<TankTime>& times);

} // namespace dipwright
