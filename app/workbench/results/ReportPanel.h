// Shows the figures of the last run as tables.
#pragma once

#include "cost/OrderCost.h"
#include "marks/SurfaceMask.h"
#include "pipeline/InkOptions.h"
#include "pipeline/JobWarnings.h"
#include "settings/AsBuilt.h"
#include "workbench/widgets/Units.h"

#include <Eigen/Core>
#include <QWidget>
#include <vector>

class QLabel;
class QUrl;

namespace dipwright {

class HtmlView;

class ReportPanel : public QWidget {
    Q_OBJECT

public:
    explicit ReportPanel(QWidget* parent = nullptr);

    // Shows a result; null if there is none yet. `warnings` is the result of jobWarnings(), or
    // empty for a draft; `inkOptions` that of inkOptions(), or none for a draft.
    void setResult(std::shared_ptr<const JobResult> result, std::vector<JobWarning> warnings,
                   std::optional<InkOptions> inkOptions, LengthUnit unit);
    void showWarning(std::size_t number); // scrolls to a warning and selects it
    // Sets one sentence for each zone on how far handling may move the colours. Empty: not
    // computed.
    void setTolerances(const QStringList& sentences);
    // Sets the cost of one part and, if several are ordered, of the order. Empty: not known.
    void setCosts(const std::vector<OrderCost>& costs);
    // Sets how long the steps at the tank took. Empty: nothing is stored.
    void setTankTimes(const std::vector<TankTime>& times);

signals:
    // The user accepts the film that smallerFilm() finds for the shown result.
    void smallerFilmTaken();
    void inkOptionTaken(dipwright::InkOption option);
    void costTableAsked();                   // the user wants the costs in a file
    void pricesAsked();                      // the user wants to enter prices
    void placeChosen(Eigen::Vector3f place); // a place of the model that has a link, mm

private:
    void show();
    void follow(const QUrl& link);

    std::shared_ptr<const JobResult> result_;
    LengthUnit unit_ = LengthUnit::Millimetre;
    std::shared_ptr<const SurfaceMask> mask_; // `masked_` was computed for it
    MaskedAreas masked_;
    std::vector<JobWarning> warnings_;
    std::optional<InkOptions> inkOptions_;
    QStringList tolerances_;
    std::vector<OrderCost> costs_;
    std::vector<TankTime> tankTimes_;
    std::vector<Eigen::Vector3f> places_; // the places that have links
    HtmlView* text_;
    QLabel* hint_; // shown instead of the text before the first run
};

} // namespace dipwright
