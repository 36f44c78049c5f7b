// Shows two states of a project side by side: both bodies with linked cameras, and their figures.
// Dips without a result run on the window's own worker thread. Until they end, each body shows a
// preview of the area that its pose would paint. The difference of the sheets is computed when the
// user chooses to see it. Escape closes the window.
#pragma once

#include "workbench/compare/ComparedSide.h"
#include "workbench/compare/StateDifference.h"
#include "workbench/document/Preferences.h"
#include "workbench/jobs/JobRunner.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QProgressBar;
class QStackedWidget;
class QTableWidget;

namespace dipwright {

class PicturePanel;

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
    QWidget* makeTables();
    QWidget* makeEnd();
    void colourViews();
    void showSides();
    void showScale(const HeatScale& scale, const QString& low, const QString& high);
    void showFigures();
    ComparedResults results() const;
    void wantDifference();
    void startDifference();
    void takeDifference(std::vector<DipDifference> difference);
    const DipDifference* shownDifference() const; // null: there is none, or it is not wanted
    void showDifference();
    void showDifferenceTable();
    void showFarthest(int dip);

    JobRunner jobs_;
    LengthUnit unit_;
    std::array<DipView*, 2> views_{};
    std::array<std::unique_ptr<ComparedSide>, 2> sides_;
    QComboBox* look_;
    QComboBox* immersion_;
    QLabel* scale_;
    std::array<QLabel*, 2> titles_{};
    QStackedWidget* secondSide_; // the second view, or the sheet's map
    PicturePanel* map_;
    QTableWidget* figures_;
    QTableWidget* differences_; // one row for each dip
    QLabel* note_;              // explains the difference, or why there is none
    QLabel* doing_;
    QProgressBar* progress_;
    ComparedResults compared_; // of `difference_`, or of the running comparison
    std::optional<std::vector<DipDifference>> difference_;
    CancelToken comparison_;
};

} // namespace dipwright
