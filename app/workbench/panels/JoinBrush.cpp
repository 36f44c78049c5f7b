#include "panels/JoinBrush.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace dipwright {
namespace {

constexpr int noKind = -1;
constexpr double leastRadius = 0.5, mostRadius = 200, usualRadius = 5; // mm

} // namespace

JoinBrush::JoinBrush(LengthUnit unit, QWidget* parent)
    : QWidget(parent), unit_(unit), kind_(new QComboBox), radius_(new QDoubleSpinBox),
      face_(new QCheckBox(tr("The whole face"))), count_(new QLabel),
      removeLast_(new QPushButton(tr("Remove Last"))),
      removeAll_(new QPushButton(tr("Remove All"))) {
    kind_->setObjectName(QStringLiteral("joinBrush"));
    kind_->setAccessibleName(tr("A click on the body"));
    kind_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    kind_->setMinimumContentsLength(8);
    kind_->addItem(tr("Marks nothing"), noKind);
    kind_->addItem({}, int(ShareMarkKind::First));
    kind_->addItem({}, int(ShareMarkKind::Second));
    kind_->addItem(tr("Keeps the join away"), int(ShareMarkKind::Avoid));
    kind_->addItem(tr("Lets the join run there"), int(ShareMarkKind::Allow));
    kind_->setToolTip(
        tr("What a click or a drag on the body in the view marks there. Give places "
           "to the other dip to move the join. With Run Live the join follows at once."));
    const double shown = shownPerStored(Unit::Length, unit);
    radius_->setObjectName(QStringLiteral("joinBrushRadius"));
    radius_->setAccessibleName(tr("Radius"));
    radius_->setDecimals(unitDecimals(Unit::Length, unit));
    radius_->setRange(leastRadius * shown, mostRadius * shown);
    radius_->setValue(usualRadius * shown);
    radius_->setSuffix(unitSuffix(Unit::Length, unit));
    radius_->setToolTip(tr("How far round the click the mark reaches, along the surface."));
    face_->setToolTip(tr("Marks the flat face that is clicked, up to its edges."));
    count_->setWordWrap(true);

    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->addRow(tr("A click"), kind_);
    form->addRow(tr("Radius"), radius_);
    form->addRow(face_);
    form->addRow(count_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(removeLast_);
    buttons->addWidget(removeAll_);
    form->addRow(buttons);

    connect(kind_, &QComboBox::currentIndexChanged, this, &JoinBrush::changed);
    connect(radius_, &QDoubleSpinBox::valueChanged, this, &JoinBrush::changed);
    connect(face_, &QCheckBox::toggled, this, [this](bool whole) {
        radius_->setEnabled(!whole);
        emit changed();
    });
    connect(removeLast_, &QPushButton::clicked, this, &JoinBrush::removeLastAsked);
    connect(removeAll_, &QPushButton::clicked, this, &JoinBrush::removeAllAsked);
}

std::optional<ShareMark> JoinBrush::mark() const {
    const int kind = kind_->currentData().toInt();
    if (kind == noKind) {
        return std::nullopt;
    }
    const double radius = radius_->value() / shownPerStored(Unit::Length, unit_);
    return ShareMark{ShareMarkKind(kind), {}, Millimetres(face_->isChecked() ? 0 : radius)};
}

void JoinBrush::setDips(const QString& first, const QString& second) {
    const auto name = [&](ShareMarkKind kind, const QString& dip) {
        kind_->setItemText(kind_->findData(int(kind)), tr("Gives the place to %1").arg(dip));
    };
    name(ShareMarkKind::First, first);
    name(ShareMarkKind::Second, second);
}

void JoinBrush::setMarkCount(std::size_t count) {
    count_->setText(tr("Marks on the body: %1").arg(count));
    removeLast_->setEnabled(count > 0);
    removeAll_->setEnabled(count > 0);
}

} // namespace dipwright
