// Shows the stretch of the film as a map over the flat film, with scale, histogram and export.
#pragma once

#include "workbench/dip/FilmReadout.h"
#include "workbench/widgets/HeatScale.h"
#include "workbench/widgets/Histogram.h"
#include "workbench/widgets/PictureView.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace dipwright {

class StretchPanel : public QWidget {
    Q_OBJECT

public:
    explicit StretchPanel(QWidget* parent = nullptr);

    // Null: nothing has been simulated yet. A draft is not exported.
    void setReading(std::shared_ptr<const FilmReadout> reading, bool isDraft = false);
    FilmQuantity quantity() const;
    const HeatScale& scale() const { return scale_; }
    // The map as shown, with isolines and key, large enough to print.
    QImage picture() const;
    // Shows the linked cursor; nullopt hides it.
    void showReading(const std::optional<FilmReadoutPoint>& point);

signals:
    void scaleChanged(); // quantity, colour map, range or limit
    void hovered(Eigen::Vector2f rest);
    void hoverLeft();
    void exportAsked(const QString& suffix); // "png", "csv" or "vtp"

private:
    void fillFields();
    void makeExportButton();
    void connectFields();
    void makeScaleRow(QVBoxLayout& layout);
    void redraw();
    QSizeF filmSize() const;
    QImage heatMap(double longestEdge) const; // in pixels
    QList<QLineF> shownIsolines() const;

    std::shared_ptr<const FilmReadout> reading_;
    bool isDraft_ = false;
    HeatScale scale_;
    QComboBox* quantityBox_;
    QComboBox* mapBox_;
    QCheckBox* automaticBox_;
    QDoubleSpinBox* lowBox_;
    QDoubleSpinBox* highBox_;
    QCheckBox* limitTick_;
    QDoubleSpinBox* limitBox_;
    QCheckBox* isolineTick_;
    QToolButton* exportButton_;
    PictureView* view_;
    Histogram* histogram_;
    QLabel* summary_;
};

} // namespace dipwright
