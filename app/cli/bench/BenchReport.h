// Prints the measurements of `bench` as JSON, as text and as the paper's Figures 6 and 7.
#pragma once

#include "cli/bench/Measurements.h"

#include <QJsonObject>
#include <QTextStream>

namespace dipwright::cli {

struct BenchReport {
    SolverInfo solver;
    QString device;
    int runs = 1;
    std::optional<solver::Ceiling> ceiling; // empty if the solver cannot measure its device
    std::vector<StepRow> tableOne, fieldSweep;
    std::vector<LiveRow> live;
    std::vector<TimedRow> dips, fields, sheets, runParts, wholeRuns;
};

QJsonObject toJson(const BenchReport& report);
void print(const BenchReport& report, QTextStream& out);
// Draws the figures into FILE.png or FILE.svg. Throws Error if the file cannot be written.
void drawPlot(const BenchReport& report, const QString& path);

} // namespace dipwright::cli
