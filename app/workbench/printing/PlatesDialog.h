// Shows the plates of a job's sheets before they are printed: each plate alone or several together,
// the ink under the cursor, and where the total ink exceeds a limit. Print files get
// the same plates.
#pragma once

#include "pipeline/JobResult.h"
#include "sheet/prepress/PlateProof.h"
#include "sheet/prepress/PrinterColour.h"
#include "workbench/jobs/JobRunner.h"
#include "workbench/widgets/Units.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace dipwright {

class NumberBox;
class PicturePanel;

class PlatesDialog : public QDialog {
    Q_OBJECT

public:
    // `immersion`: the dip whose sheet is shown first.
    PlatesDialog(std::shared_ptr<const JobResult> result, std::size_t immersion, LengthUnit unit,
                 QWidget* parent = nullptr);
    // Shows a sentence about the sheets at the top, such as that they are out of date.
    void warn(const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override; // moves the cursor by keys

private:
    // The plates of one sheet. `shown` has at most as many pixels as the view can handle.
    struct Separation {
        std::shared_ptr<const PrinterColour> colour;
        std::shared_ptr<const Plates> plates, shown;
        InkFigures figures;
    };
    enum class View { Print, Grey, TotalInk };

    QWidget* makeSide();
    void makeTable();
    void separateSheet();
    void takeSeparation(const Separation& separation);
    void measure(); // figures for another limit
    void draw();
    void fillTable();
    void showFigures();
    void showInkAt(const std::optional<QPoint>& pixel);
    void moveCursor(QPoint by);
    void fail(std::exception_ptr failure);
    const Sheet& sheet() const { return result_->immersions[shown_].sheet; }
    QSizeF film() const;
    View view() const;
    std::vector<bool> shownChannels() const;
    std::optional<double> limit() const;

    std::shared_ptr<const JobResult> result_;
    std::size_t shown_; // the dip
    LengthUnit unit_;
    std::optional<Separation> separation_;
    std::optional<CancelToken> separating_; // the job that makes the plates, until it has ended
    std::optional<QPoint> cursor_;          // pixel of the plates, moved by keys
    QLabel* notice_;
    PicturePanel* picture_;
    QComboBox *dip_, *view_, *ground_;
    QTableWidget* table_;
    NumberBox* limit_;
    QLabel* figures_;
    QProgressBar* progress_;
    QPushButton *allPlates_, *onlyThis_, *stop_;
    int drawing_ = 0; // number of the latest picture that was asked for
    CancelToken drawn_;
    JobRunner jobs_; // destroyed first: jobs report to the members above
};

} // namespace dipwright
