// Edits the weights and limits of a project's pose searches.
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
    void changed(const QString& what); // by the user; `what` is a key for the changed value
    void left();                       // the focus went elsewhere

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
