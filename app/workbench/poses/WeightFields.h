// What counts in a search, and what must be kept: the aims of a project's searches.
#pragma once

#include "settings/SearchSettings.h"

#include <QWidget>

#include <functional>

class QCheckBox;
class QDoubleSpinBox;

namespace dipwright {

class WeightFields : public QWidget {
    Q_OBJECT

public:
    explicit WeightFields(QWidget* parent = nullptr);

    const PoseAims& aims() const { return aims_; }
    void show(const PoseAims& aims); // emits nothing

signals:
    void changed(const QString& what); // by the user; what was, as a key
    void left();                       // the user has turned to something else

private:
    struct Row {
        QDoubleSpinBox* weight;
        QCheckBox* isLimited;
        QDoubleSpinBox* limit;
    };
    Row makeRow(Measure measure);
    void watch(QDoubleSpinBox* box, const QString& what, const std::function<void(double)>& take);
    void takeLimit(Measure measure);

    PoseAims aims_;
    PerMeasure<Row> rows_;
    std::array<QDoubleSpinBox*, zoneCount> zones_{};
};

} // namespace dipwright
