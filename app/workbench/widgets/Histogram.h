// Draws how often each value occurs, in the colours of the scale. The histogram also serves as the
// colour key.
#pragma once

#include "workbench/widgets/HeatScale.h"

#include <QWidget>

namespace dipwright {

class Histogram : public QWidget {
    Q_OBJECT

public:
    explicit Histogram(QWidget* parent = nullptr);

    void setValues(const std::vector<float>& values, const HeatScale& scale);
    void setMark(const std::optional<double>& value); // the value under the cursor
    // Draws it with the painter's font; draws nothing without values.
    void paint(QPainter& painter, const QRectF& place, const QColor& ink) const;

    QSize sizeHint() const override { return {320, 96}; }
    QSize minimumSizeHint() const override { return {160, 84}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<int> counts_; // from low to high values
    HeatScale scale_;
    std::optional<double> mark_;
};

} // namespace dipwright
