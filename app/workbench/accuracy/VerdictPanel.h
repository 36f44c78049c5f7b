// The panel that shows the verdict on the last run: reasons, places to check, and a map of the
// sheet's numerical error.
#pragma once

#include "workbench/dip/DipJob.h"
#include "workbench/widgets/Units.h"

#include <QWidget>

class QUrl;

namespace dipwright {

class HtmlView;
class PicturePanel;

// Whether a result follows the draft on show, or why not.
enum class DraftEnd { ResultFollows, Cancelled, Failed };

class VerdictPanel : public QWidget {
    Q_OBJECT

public:
    explicit VerdictPanel(QWidget* parent = nullptr);

    // Shows the result of dip number `immersion`. Shows nothing if it has none.
    void setOutcome(const DipOutcome& outcome, std::size_t immersion, LengthUnit unit);
    // Whether the result fits the project. A verdict from before the last changes is marked.
    void setFresh(bool fresh);
    void setDraftEnd(DraftEnd end);

    QSize minimumSizeHint() const override;

signals:
    void placeChosen(Eigen::Vector2f rest); // a place on the floating film, mm
    void fieldChosen(const QString& path);  // the project's field that sets a reason's limit

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void showText();
    void choosePlace(const QUrl& link);
    int wantedMapHeight() const;
    void fitText();

    std::shared_ptr<const JobResult> result_; // null: nothing is shown
    std::size_t immersion_ = 0;
    bool isDraft_ = false, isFresh_ = true;
    DraftEnd draftEnd_ = DraftEnd::ResultFollows;
    LengthUnit unit_ = LengthUnit::Millimetre;
    std::vector<PlaceToCheck> places_;
    HtmlView* text_;
    PicturePanel* map_;
};

} // namespace dipwright
