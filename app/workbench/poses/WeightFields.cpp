#include "workbench/poses/WeightFields.h"

#include "workbench/widgets/NumberBox.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>

namespace dipwright {

namespace {

// How a measure is shown: the factor on its value, its suffix and its maximum.
struct Scale {
    double factor = 100;
    QString suffix = QStringLiteral(" %");
    double most = 100;
    double proposed = 50; // proposed limit
};

Scale scaleOf(Measure measure) {
    switch (measure) {
    case Measure::Stretch:
        return {1, QStringLiteral(" ×"), 10, 2};
    case Measure::Join:
        return {1, QStringLiteral(" mm"), 100'000, 500};
    case Measure::Wrinkled:
    case Measure::Torn:
    case Measure::Narrow:
    case Measure::TrappedAir:
        return {.proposed = 0};
    default:
        return {};
    }
}

} // namespace

WeightFields::WeightFields(QWidget* parent) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(0, 1);
    grid->addWidget(new QLabel(tr("Weight")), 0, 1);
    grid->addWidget(new QLabel(tr("Limit")), 0, 2, 1, 2);
    int line = 1;
    for (const Measure measure : allMeasures()) {
        const Row row = makeRow(measure);
        rows_[measure] = row;
        auto* name = new QLabel(measureName(measure));
        name->setBuddy(row.weight);
        grid->addWidget(name, line, 0);
        grid->addWidget(row.weight, line, 1);
        grid->addWidget(row.isLimited, line, 2);
        grid->addWidget(row.limit, line, 3);
        ++line;
    }
    for (std::size_t zone = 0; zone < zoneCount; ++zone) {
        auto* weight = new NumberBox;
        weight->setRange(0, mostZoneWeight);
        weight->setDecimals(1);
        const QString name = tr("Quality in zone %1").arg(QChar('A' + int(zone)));
        weight->setAccessibleName(name);
        weight->setToolTip(tr("How much more the quality counts in this zone of the part. Zones "
                              "are marked under Tolerances."));
        watch(weight, zoneKey(zone),
              [this, zone](double value) { aims_.zoneWeights[zone] = value; });
        auto* label = new QLabel(name);
        label->setBuddy(weight);
        grid->addWidget(label, line, 0);
        grid->addWidget(weight, line, 1);
        zones_[zone] = weight;
        ++line;
    }
    aims_.weights = {}; // start from the default weights
    show({});
}

WeightFields::Row WeightFields::makeRow(Measure measure) {
    const Scale scale = scaleOf(measure);
    Row row{new NumberBox, new QCheckBox, new NumberBox};
    row.weight->setRange(0, mostWeight);
    row.weight->setDecimals(2);
    row.weight->setSingleStep(0.1);
    row.weight->setAccessibleName(tr("Weight of %1").arg(measureName(measure)));
    row.weight->setToolTip(
        tr("How much this measure counts, compared with the others. 0: not at all."));
    row.weight->setObjectName(QStringLiteral("weight_") + measureKey(measure));
    row.isLimited->setObjectName(QStringLiteral("limited_") + measureKey(measure));
    row.isLimited->setText(isHigherBetter(measure) ? QStringLiteral("≥") : QStringLiteral("≤"));
    row.isLimited->setAccessibleName(tr("Limit of %1").arg(measureName(measure)));
    row.isLimited->setToolTip(tr("Of poses with the same verdict, those that miss this limit rank "
                                 "below those that keep it."));
    row.limit->setRange(0, scale.most);
    row.limit->setDecimals(scale.factor == 1 ? 2 : 1);
    row.limit->setSuffix(scale.suffix);
    row.limit->setValue(scale.proposed);
    row.limit->setEnabled(false);
    row.limit->setAccessibleName(row.isLimited->accessibleName());
    const QString weightKey = QStringLiteral("weight of ") + measureKey(measure);
    const QString limitKey = QStringLiteral("limit of ") + measureKey(measure);
    watch(row.weight, weightKey, [this, measure](double value) { aims_.weights[measure] = value; });
    watch(row.limit, limitKey, [this, measure](double) { takeLimit(measure); });
    connect(row.isLimited, &QCheckBox::toggled, row.limit, &QWidget::setEnabled);
    connect(row.isLimited, &QCheckBox::toggled, this, [this, measure, limitKey] {
        takeLimit(measure);
        emit changed(limitKey);
        emit left();
    });
    return row;
}

void WeightFields::watch(QDoubleSpinBox* box, const QString& what,
                         const std::function<void(double)>& take) {
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, what, take](double value) {
        take(value);
        emit changed(what);
    });
    connect(box, &QDoubleSpinBox::editingFinished, this, &WeightFields::left);
}

void WeightFields::takeLimit(Measure measure) {
    const Row& row = rows_[measure];
    aims_.limits[measure] = row.isLimited->isChecked()
                                ? std::optional(row.limit->value() / scaleOf(measure).factor)
                                : std::nullopt;
}

// Changes nothing if the values are equal, so that text being typed is kept.
void WeightFields::show(const PoseAims& aims) {
    if (aims == aims_) {
        return;
    }
    const QSignalBlocker quiet(this);
    for (const Measure measure : allMeasures()) {
        const Row& row = rows_[measure];
        row.weight->setValue(aims.weights[measure]);
        row.isLimited->setChecked(aims.limits[measure].has_value());
        const Scale scale = scaleOf(measure);
        const std::optional<double> limit = aims.limits[measure];
        row.limit->setValue(limit ? *limit * scale.factor : scale.proposed);
    }
    for (std::size_t zone = 0; zone < zoneCount; ++zone) {
        zones_[zone]->setValue(aims.zoneWeights[zone]);
    }
    aims_ = aims; // the fields only show rounded values
}

} // namespace dipwright
