// Chooses the print that the view shows on the body: after which dip, and with which displacement
// of the second film.
#pragma once

#include "results/Results.h"
#include "workbench/widgets/Units.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace dipwright {

// The print after the first `dips` dips, with the second film displaced by `slip`.
struct ShownPrint {
    std::size_t dips = 2;
    FilmPlacementError slip = {};
    bool operator==(const ShownPrint&) const = default;
};

class PrintFields : public QWidget {
    Q_OBJECT

public:
    // `mostDeeper`: largest extra depth that can be shown.
    PrintFields(LengthUnit unit, Millimetres mostDeeper, QWidget* parent = nullptr);

    ShownPrint print() const;
    void setDips(const QString& first, const QString& second); // names of the two dips

signals:
    void changed();

private:
    // One number, shown as a slider and a field with its unit.
    struct Row {
        QString name, label, help;
        double least = 0, most = 0; // in the shown unit
        double step = 0;
        QString suffix;
        int decimals = 1;
    };
    QDoubleSpinBox* add(QFormLayout& form, const Row& row);

    LengthUnit unit_;
    QComboBox* dips_;
    QDoubleSpinBox* across_;
    QDoubleSpinBox* down_;
    QDoubleSpinBox* turn_;
    QDoubleSpinBox* swell_;
    QDoubleSpinBox* deeper_;
};

} // namespace dipwright
