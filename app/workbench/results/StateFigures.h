// Figures by which two states of a project, or two poses, are compared.
#pragma once

#include "project/Project.h"
#include "workbench/widgets/Units.h"

#include <functional>

namespace dipwright {

struct StateFigure {
    QString name;
    std::optional<double> value; // none: there is no result yet
    std::function<QString(double)> words;
    bool isMoreBetter = true;

    QString text() const;
};

// A state with what is known of it before it is dipped. Two that are compared have the same
// figures.
struct ComparedState {
    QString title;
    Project project;
    std::vector<StateFigure> figures;
};

// By how much the second is more, and whether that is better: "−3.0 %, worse"; empty where there is
// nothing to compare.
QString differenceText(const StateFigure& first, const StateFigure& second);

// Lists the figures that workbench/document/SnapshotEdits.h measures. They have no values where
// `measures` is empty.
std::vector<StateFigure> stateFigures(const QJsonObject& measures, LengthUnit unit);

} // namespace dipwright
