// Shows two states of a project side by side: both bodies with linked cameras, and their figures.
// Dips without a result run on the window's own worker thread. Until they end, each body shows a
// preview of the area that its pose would paint. Escape closes the window.
#pragma once

#include "workbench/compare/ComparedSide.h"
#include "workbench/document/Preferences.h"
#include "workbench/jobs/JobRunner.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QProgressBar;
class QTableWidget;

namespace dipwright {

class CompareWindow : public QDialog {
    Q_OBJECT

public:
    // `kept` (may be null): a result whose dips are reused if they fit.
    CompareWindow(const std::array<ComparedState, 2>& states,
                  const std::shared_ptr<const JobResult>& kept, const SolverRegistry& registry,
                  const Preferences& preferences, QWidget* parent = nullptr);
    ~CompareWindow() override;

    DipView& view(std::size_t side) { return *views_[side]; }

protected:
    void changeEvent(QEvent* event) override; // follows the palette

private:
    QWidget* makeChoices(std::size_t immersions);
    QWidget* makeSides(const std::array<ComparedState, 2>& states);
    QWidget* makeEnd();
    void colourViews();
    void showSides();
    void showScale(const HeatScale& scale);
    void showFigures();

    JobRunner jobs_;
    LengthUnit unit_;
    std::array<DipView*, 2> views_{};
    std::array<std::unique_ptr<ComparedSide>, 2> sides_;
    QComboBox* look_;
    QComboBox* immersion_;
    QLabel* scale_;
    QTableWidget* figures_;
    QLabel* doing_;
    QProgressBar* progress_;
};

} // namespace dipwright
