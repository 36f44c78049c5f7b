// How far the second film is to lie off in the view, to see what that does to the print.
#pragma once

#include "panels/Units.h"
#include "results/Results.h"

#include <QWidget>

class QDoubleSpinBox;
class QFormLayout;

namespace dipwright {

class SlipFields : public QWidget {
    Q_OBJECT

public:
    explicit SlipFields(LengthUnit unit, QWidget* parent = nullptr);

    FilmSlip slip() const;

signals:
    void changed();

private:
    QDoubleSpinBox* add(QFormLayout& form, const QString& label, const QString& help, double most,
                        double step, const QString& suffix, int decimals);

    LengthUnit unit_;
    QDoubleSpinBox* across_;
    QDoubleSpinBox* down_;
    QDoubleSpinBox* turn_;
    QDoubleSpinBox* swell_;
};

} // namespace dipwright
