#include "poses/WeightFields.h"

#include "panels/NumberBox.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>

namespace dipwright {

namespace {

// How a measure is shown: the factor on its value, what follows it, and the most that it may be.
struct Scale {
    double factor = 100;
    QString suffix = QStringLiteral(" %");
    double most = 100;
    double proposed = 50; // as a limit
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
    grid->addWidget(new QLabel(tr("Counts")), 0, 1);
    grid->addWidget(new QLabel(tr("Must be kept")), 0, 2, 1, 2);
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
        weight->setToolTip(tr("How much more the quality counts where the body is marked as this "
                              "zone, under Tolerances."));
        connect(weight, &QDoubleSpinBox::valueChanged, this, &WeightFields::changed);
        auto* label = new QLabel(name);
        label->setBuddy(weight);
        grid->addWidget(label, line, 0);
        grid->addWidget(weight, line, 1);
        zones_[zone] = weight;
        ++line;
    }
    show({});
}

WeightFields::Row WeightFields::makeRow(Measure measure) {
    const Scale scale = scaleOf(measure);
    Row row{new NumberBox, new QCheckBox, new NumberBox};
    row.weight->setRange(0, mostWeight);
    row.weight->setDecimals(2);
    row.weight->setSingleStep(0.1);
    row.weight->setAccessibleName(tr("Weight of %1").arg(measureName(measure)));
    row.weight->setToolTip(tr("How much it counts against the others; 0: not at all."));
    row.isLimited->setText(isMoreBetter(measure) ? QStringLiteral("≥") : QStringLiteral("≤"));
    row.isLimited->setAccessibleName(tr("Limit of %1").arg(measureName(measure)));
    row.isLimited->setToolTip(tr("Poses that miss it come after all that keep it."));
    row.limit->setRange(0, scale.most);
    row.limit->setDecimals(scale.factor == 1 ? 2 : 1);
    row.limit->setSuffix(scale.suffix);
    row.limit->setValue(scale.proposed);
    row.limit->setEnabled(false);
    row.limit->setAccessibleName(row.isLimited->accessibleName());
    connect(row.weight, &QDoubleSpinBox::valueChanged, this, &WeightFields::changed);
    connect(row.limit, &QDoubleSpinBox::valueChanged, this, &WeightFields::changed);
    connect(row.isLimited, &QCheckBox::toggled, row.limit, &QWidget::setEnabled);
    connect(row.isLimited, &QCheckBox::toggled, this, &WeightFields::changed);
    return row;
}

void WeightFields::fill(SearchSettings& settings) const {
    for (const Measure measure : allMeasures()) {
        const Row& row = rows_[measure];
        settings.weights[measure] = row.weight->value();
        settings.limits[measure] = row.isLimited->isChecked()
                                       ? std::optional(row.limit->value() / scaleOf(measure).factor)
                                       : std::nullopt;
    }
    for (std::size_t zone = 0; zone < zoneCount; ++zone) {
        settings.zoneWeights[zone] = zones_[zone]->value();
    }
}

void WeightFields::show(const SearchSettings& settings) {
    const QSignalBlocker quiet(this);
    for (const Measure measure : allMeasures()) {
        const Row& row = rows_[measure];
        row.weight->setValue(settings.weights[measure]);
        row.isLimited->setChecked(settings.limits[measure].has_value());
        if (const std::optional<double> limit = settings.limits[measure]) {
            row.limit->setValue(*limit * scaleOf(measure).factor);
        }
    }
    for (std::size_t zone = 0; zone < zoneCount; ++zone) {
        zones_[zone]->setValue(settings.zoneWeights[zone]);
    }
}

} // namespace dipwright
