// Shows the results of the last dip in tabs: verdict, stretch, reverse texture, proof, sheet and
// report. One linked cursor is shown in all tabs.
#pragma once

#include "workbench/dip/DipJob.h"
#include "workbench/document/Document.h"
#include "workbench/widgets/Units.h"

#include <QTabWidget>

class QAction;

namespace dipwright {

class VerdictPanel;
class PicturePanel;
class ReportPanel;
class ResultTabs;
class StretchPanel;
enum class DraftEnd;

class ResultsPanel : public QTabWidget {
    Q_OBJECT

public:
    explicit ResultsPanel(QWidget* parent = nullptr);

    void setOutcome(const DipOutcome& outcome, std::size_t immersion); // may be empty
    void setLengthUnit(LengthUnit unit);
    void showWarning(std::size_t number); // in the report
    // Marks the outdated tabs. `freshness`: of the dip on show. `isJobFresh`: whether all results
    // of all dips fit the project; verdict and report are about all dips.
    void setFreshness(const Freshness& freshness, bool isJobFresh);
    void setDraftEnd(DraftEnd end); // for the verdict
    void showReading(const std::optional<FilmReadoutPoint>& point);
    // Adds a button over the picture of the reverse texture.
    void addTextureAction(QAction* action);
    // Adds a button over the picture of the sheet.
    void addSheetAction(QAction* action);
    StretchPanel& stretch() { return *stretch_; }
    ReportPanel& report() { return *report_; }

signals:
    void hovered(Eigen::Vector2f rest); // a place on the floating film (rest position)
    void hoverLeft();
    void placeChosen(Eigen::Vector2f rest);       // show this place in the view
    void modelPlaceChosen(Eigen::Vector3f place); // show this place of the model in the view
    void fieldChosen(const QString& path);        // show this field of the project

private:
    void hoverShare(double across, double down);
    QAction* offer(PicturePanel& panel, const QString& text, const QString& name,
                   const QString& help);
    void showProof();
    void showSheet();

    DipOutcome outcome_;
    std::size_t immersion_ = 0;
    ResultTabs* tabs_;
    LengthUnit unit_ = LengthUnit::Millimetre;
    VerdictPanel* numericalError_;
    StretchPanel* stretch_;
    PicturePanel* texture_;
    PicturePanel* proof_;
    QAction* proofWithoutWhite_;
    QAction* proofShares_; // shows the shares of the dips in place of the proof
    PicturePanel* sheet_;
    QAction* sheetShares_; // shows the shares of the dips over the sheet
    ReportPanel* report_;
};

} // namespace dipwright
