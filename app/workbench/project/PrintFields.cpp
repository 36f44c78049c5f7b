#include "workbench/project/PrintFields.h"

#include "workbench/widgets/NumberBox.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

namespace dipwright {
namespace {

constexpr double mostShift = 20; // mm
constexpr double mostTurn = 15;  // degrees
constexpr double mostSwell = 20; // per cent
constexpr double mostDepth = 40; // mm

} // namespace

PrintFields::PrintFields(LengthUnit unit, Millimetres mostDeeper, QWidget* parent)
    : QWidget(parent), unit_(unit), dips_(new QComboBox) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    dips_->setObjectName(QStringLiteral("printDips"));
    dips_->setAccessibleName(tr("Show part"));
    dips_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    dips_->setMinimumContentsLength(8);
    dips_->addItem({}, 2);
    dips_->addItem({}, 1);
    form->addRow(tr("Show part"), dips_);
    connect(dips_, &QComboBox::currentIndexChanged, this, &PrintFields::changed);
    const double shown = shownPerStored(Unit::Length, unit);
    const QString length = unitSuffix(Unit::Length, unit);
    const int decimals = unitDecimals(Unit::Length, unit);
    const double shift = mostShift * shown;
    across_ = add(*form, {QStringLiteral("slipX"), tr("Shift X"),
                          tr("How far the second film is displaced along X."), -shift, shift,
                          0.1 * shown, length, decimals});
    down_ = add(*form, {QStringLiteral("slipZ"), tr("Shift Z"),
                        tr("How far the second film is displaced along Z."), -shift, shift,
                        0.1 * shown, length, decimals});
    turn_ = add(*form, {QStringLiteral("slipTurn"), tr("Rotation"),
                        tr("Angle by which the second film is turned, from X towards Z."),
                        -mostTurn, mostTurn, 0.5, QStringLiteral("°"), 1});
    swell_ = add(*form, {QStringLiteral("slipSwell"), tr("Extra swell"),
                         tr("How much more the second film has swollen than the sheet assumes."),
                         -mostSwell, mostSwell, 0.5, QStringLiteral(" %"), 1});
    deeper_ =
        add(*form,
            {QStringLiteral("slipDepth"), tr("Extra depth"),
             tr("How much deeper the part is dipped. A negative value dips it less deep; surface "
                "that then stays above the water gets no ink. If the dip covers the whole part, "
                "it cannot go deeper."),
             -mostDepth * shown, mostDeeper.value() * shown, 0.5 * shown, length, decimals});
    auto* reset = new QPushButton(tr("Reset"));
    reset->setToolTip(tr("Puts the second film back in its intended place."));
    form->addRow(reset);
    connect(reset, &QPushButton::clicked, this, [this] {
        for (QDoubleSpinBox* box : {across_, down_, turn_, swell_, deeper_}) {
            box->setValue(0);
        }
    });
}

QDoubleSpinBox* PrintFields::add(QFormLayout& form, const Row& row) {
    auto* box = new NumberBox;
    box->setObjectName(row.name);
    box->setAccessibleName(row.label);
    box->setToolTip(row.help);
    box->setDecimals(row.decimals);
    box->setRange(row.least, row.most);
    box->setSingleStep(row.step);
    box->setSuffix(row.suffix);
    box->setKeyboardTracking(false);
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setAccessibleName(row.label);
    slider->setToolTip(row.help);
    slider->setRange(int(std::lround(row.least / row.step)), int(std::lround(row.most / row.step)));
    slider->setMinimumWidth(48);
    auto* line = new QWidget;
    auto* layout = new QHBoxLayout(line);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(slider, 1);
    layout->addWidget(box);
    form.addRow(row.label, line);
    connect(slider, &QSlider::valueChanged, box,
            [box, step = row.step](int value) { box->setValue(value * step); });
    connect(box, &QDoubleSpinBox::valueChanged, this,
            [this, slider, step = row.step](double value) {
                const QSignalBlocker quiet(slider);
                slider->setValue(int(std::lround(value / step)));
                emit changed();
            });
    return box;
}

void PrintFields::setDips(const QString& first, const QString& second) {
    dips_->setItemText(0, tr("After %1 and %2").arg(first, second));
    dips_->setItemText(1, tr("After %1").arg(first));
}

ShownPrint PrintFields::print() const {
    const auto millimetres = [this](const QDoubleSpinBox& box) {
        return Millimetres(box.value() / shownPerStored(Unit::Length, unit_));
    };
    return {std::size_t(dips_->currentData().toInt()),
            {{millimetres(*across_), millimetres(*down_)},
             Degrees(turn_->value()),
             1 + swell_->value() / 100,
             millimetres(*deeper_)}};
}

} // namespace dipwright
