// What counts in a search, and what must be kept.
#pragma once

#include "search/SearchSettings.h"

#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;

namespace dipwright {

class WeightFields : public QWidget {
    Q_OBJECT

public:
    explicit WeightFields(QWidget* parent = nullptr);

    void fill(SearchSettings& settings) const; // weights, zones and limits
    void show(const SearchSettings& settings);

signals:
    void changed();

private:
    struct Row {
        QDoubleSpinBox* weight;
        QCheckBox* isLimited;
        QDoubleSpinBox* limit;
    };
    Row makeRow(Measure measure);

    PerMeasure<Row> rows_;
    std::array<QDoubleSpinBox*, zoneCount> zones_{};
};

} // namespace dipwright
