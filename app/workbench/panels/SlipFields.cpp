#include "panels/SlipFields.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSignalBlocker>

namespace dipwright {
namespace {

constexpr double mostShift = 20; // mm
constexpr double mostTurn = 15;  // degrees
constexpr double mostSwell = 20; // per cent

} // namespace

SlipFields::SlipFields(LengthUnit unit, QWidget* parent) : QWidget(parent), unit_(unit) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    const double shown = shownPerStored(Unit::Length, unit);
    const QString length = unitSuffix(Unit::Length, unit);
    const int decimals = unitDecimals(Unit::Length, unit);
    across_ = add(*form, tr("Shift X"), tr("How far the second film lies off along X."),
                  mostShift * shown, 0.1 * shown, length, decimals);
    down_ = add(*form, tr("Shift Z"), tr("How far it lies off along Z."), mostShift * shown,
                0.1 * shown, length, decimals);
    turn_ = add(*form, tr("Turn"), tr("How far it is turned, from X to Z."), mostTurn, 0.5,
                QStringLiteral("°"), 1);
    swell_ = add(*form, tr("Swell"), tr("How much more it has grown than the sheet reckons with."),
                 mostSwell, 0.5, QStringLiteral(" %"), 1);
    auto* reset = new QPushButton(tr("In its Place"));
    reset->setToolTip(tr("The second film where it belongs."));
    form->addRow(reset);
    connect(reset, &QPushButton::clicked, this, [this] {
        for (QDoubleSpinBox* box : {across_, down_, turn_, swell_}) {
            const QSignalBlocker quiet(box);
            box->setValue(0);
        }
        emit changed();
    });
}

QDoubleSpinBox* SlipFields::add(QFormLayout& form, const QString& label, const QString& help,
                                double most, double step, const QString& suffix, int decimals) {
    auto* box = new QDoubleSpinBox;
    box->setAccessibleName(label);
    box->setToolTip(help);
    box->setDecimals(decimals);
    box->setRange(-most, most);
    box->setSingleStep(step);
    box->setSuffix(suffix);
    box->setKeyboardTracking(false);
    form.addRow(label, box);
    connect(box, &QDoubleSpinBox::valueChanged, this, &SlipFields::changed);
    return box;
}

FilmSlip SlipFields::slip() const {
    const double shown = shownPerStored(Unit::Length, unit_);
    return {{Millimetres(across_->value() / shown), Millimetres(down_->value() / shown)},
            Degrees(turn_->value()),
            1 + swell_->value() / 100};
}

} // namespace dipwright
