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
    bool isHigherBetter = true;

    QString text() const;
};

// A state of a project and its known figures. Two compared states have the same list of figures.
struct ComparedState {
    QString title;
    Project project;
    std::vector<StateFigure> figures;
};

// Returns how the second value differs from the first, and whether it is better: "−3.0 % (worse)".
// Empty if one of the values is missing.
QString differenceText(const StateFigure& first, const StateFigure& second);

// Lists the figures that workbench/document/SnapshotEdits.h measures. A figure that is not in
// `measures` has no value.
std::vector<StateFigure> stateFigures(const QJsonObject& measures, LengthUnit unit);

} // namespace dipwright
