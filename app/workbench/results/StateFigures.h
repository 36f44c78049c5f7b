// Figures for comparing two states of a project, or two poses.
#pragma once

#include "project/Project.h"
#include "workbench/widgets/Units.h"

#include <functional>

namespace dipwright {

struct StateFigure {
    QString name;
    std::optional<double> value; // none: no result yet
    std::function<QString(double)> words;
    bool isMoreBetter = true;

    QString text() const;
};

// A state and its known figures. Two compared states have the same list of figures.
struct ComparedState {
    QString title;
    Project project;
    std::vector<StateFigure> figures;
};

// The difference of the second value to the first, and whether it is better: "−3.0 %, worse". Empty
// if there is nothing to compare.
QString differenceText(const StateFigure& first, const StateFigure& second);

// Lists the figures that workbench/document/SnapshotEdits.h measures. They have no values where
// `measures` is empty.
std::vector<StateFigure> stateFigures(const QJsonObject& measures, LengthUnit unit);

} // namespace dipwright
