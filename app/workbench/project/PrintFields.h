// What the view shows of the print on the body: after which dip, and how far the second film is to
// lie off, to see what that does.
#pragma once

#include "results/Results.h"
#include "workbench/widgets/Units.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace dipwright {

// The print after so many of the dips, of which the second lies off by a slip.
struct ShownPrint {
    std::size_t dips = 2;
    FilmSlip slip = {};
    bool operator==(const ShownPrint&) const = default;
};

class PrintFields : public QWidget {
    Q_OBJECT

public:
    // `mostDeeper`: how much deeper it can be shown as dipped.
    PrintFields(LengthUnit unit, Millimetres mostDeeper, QWidget* parent = nullptr);

    ShownPrint print() const;
    void setDips(const QString& first, const QString& second); // their names

signals:
    void changed();

private:
    // One number, as a slider and a field of its unit.
    struct Row {
        QString name, label, help;
        double least = 0, most = 0; // as shown
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
