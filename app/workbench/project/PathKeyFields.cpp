#include "workbench/project/PathKeyFields.h"

#include "base/NumberText.h"
#include "workbench/widgets/Icons.h"
#include "workbench/widgets/NumberBox.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QListWidget>
#include <QPushButton>
#include <algorithm>

namespace dipwright {

namespace {

constexpr double leastWait = leastPathWait.value();
constexpr int shownRows = 6;

} // namespace

PathKeyFields::PathKeyFields(LengthUnit unit, QWidget* parent)
    : QWidget(parent), unit_(unit), list_(new QListWidget),
      add_(new QPushButton(icon(QStringLiteral("add")), tr("Add pose"))),
      remove_(new QPushButton(icon(QStringLiteral("remove")), tr("Remove pose"))) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    list_->setObjectName(QStringLiteral("pathKeys"));
    list_->setAccessibleName(tr("Poses"));
    list_->setToolTip(tr("The poses that the part takes in turn. The view shows the chosen pose; "
                         "its rings and arrows change it."));
    list_->setFixedHeight(shownRows * list_->fontMetrics().height() * 3 / 2);
    form->addRow(list_);
    add_->setObjectName(QStringLiteral("addPathKey"));
    add_->setToolTip(tr("Adds a pose between the chosen one and the next."));
    remove_->setToolTip(tr("Removes the chosen pose. The first and the last one stay."));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(add_);
    buttons->addWidget(remove_);
    form->addRow(buttons);
    const auto addRow = [&](const QString& label, NumberBox* box) { form->addRow(label, box); };
    time_ = addBox(
        Unit::Time, QStringLiteral("keyTime"),
        tr("When the part takes this pose, since the dip began. With a limit of the acceleration "
           "the part may take it later."),
        [](PathKey& key, double value) { key.time = Seconds(value); });
    addRow(tr("Time"), time_);
    depth_ = addBox(Unit::Length, QStringLiteral("keyDepth"),
                    tr("Depth of the part's lowest point. In the first pose it touches the water, "
                       "in the last one it is at the depth of the dip."),
                    [](PathKey& key, double value) { key.depth = Millimetres(value); });
    addRow(tr("Depth"), depth_);
    for (std::size_t part = 0; part < 2; ++part) {
        const QString axis(QLatin1Char("XZ"[part]));
        beside_[part] =
            addBox(Unit::Length, QStringLiteral("keyBeside") + axis,
                   tr("How far the part has moved along %1 from its offset.").arg(axis),
                   [part](PathKey& key, double value) { key.beside[part] = Millimetres(value); });
        addRow(tr("Moved along %1").arg(axis), beside_[part]);
    }
    for (std::size_t part = 0; part < 3; ++part) {
        const QString axis(QLatin1Char("XYZ"[part]));
        turn_[part] =
            addBox(Unit::Angle, QStringLiteral("keyTurn") + axis,
                   tr("How far the part is turned about %1 from its rotation at the end "
                      "of the dip; about X first, then Y, then Z.")
                       .arg(axis),
                   [part](PathKey& key, double value) { key.turn[part] = Degrees(value); });
        addRow(tr("Turned about %1").arg(axis), turn_[part]);
    }
    connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
        showChosen();
        emit chosen(row);
    });
    connect(add_, &QPushButton::clicked, this,
            [this] { emit addAsked(std::clamp(list_->currentRow(), 0, int(keys_.size()) - 2)); });
    connect(remove_, &QPushButton::clicked, this,
            [this] { emit removeAsked(list_->currentRow()); });
}

NumberBox* PathKeyFields::addBox(Unit unit, const QString& name, const QString& text,
                                 const std::function<void(PathKey&, double)>& set) {
    auto* box = new NumberBox;
    box->setObjectName(name);
    box->setAccessibleName(text);
    box->setToolTip(text);
    box->setDecimals(unitDecimals(unit, unit_));
    box->setSuffix(unitSuffix(unit, unit_));
    box->setKeyboardTracking(false);
    const double most = unit == Unit::Angle  ? mostPathTurn.value()
                        : unit == Unit::Time ? latestPathKey.value()
                                             : farthestPathKey.value();
    const double factor = shownPerStored(unit, unit_);
    box->setRange(-most * factor, most * factor);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, set, factor](double value) {
        change([&](PathKey& key) { set(key, value / factor); });
    });
    connect(box, &QDoubleSpinBox::editingFinished, this, &PathKeyFields::left);
    connect(box, &NumberBox::refused, this, &PathKeyFields::refused);
    return box;
}

QString PathKeyFields::textOf(std::size_t key) const {
    const PathKey& pose = keys_[key];
    const QString depth = pose.depth ? shownLength(pose.depth->value(), unit_) : tr("end");
    return tr("%1: %2 s, depth %3").arg(key + 1).arg(roundedText(pose.time.value(), 6), depth);
}

void PathKeyFields::show(const std::vector<PathKey>& keys, Millimetres depth) {
    const int before = list_->currentRow();
    keys_ = keys;
    dipDepth_ = depth;
    {
        const QSignalBlocker quiet(list_);
        while (list_->count() > int(keys.size())) {
            delete list_->takeItem(list_->count() - 1);
        }
        for (std::size_t key = 0; key < keys.size(); ++key) {
            if (int(key) == list_->count()) {
                list_->addItem(QString());
            }
            list_->item(int(key))->setText(textOf(key));
        }
        list_->setCurrentRow(std::min(before, int(keys.size()) - 1));
    }
    showChosen();
    if (list_->currentRow() != before) {
        emit chosen(list_->currentRow());
    }
}

void PathKeyFields::choose(int key) {
    list_->setCurrentRow(key);
}

void PathKeyFields::showChosen() {
    const int row = list_->currentRow();
    const int last = int(keys_.size()) - 1;
    const bool isChosen = row >= 0, isInner = row > 0 && row < last;
    const auto before = std::size_t(std::clamp(row, 0, std::max(last - 1, 0)));
    const bool hasRoom =
        last > 0 && (keys_[before + 1].time - keys_[before].time).value() > 2 * leastWait;
    add_->setEnabled(hasRoom && keys_.size() < mostPathKeys);
    remove_->setEnabled(isInner);
    const double factor = shownPerStored(Unit::Length, unit_);
    const PathKey key = isChosen ? keys_[std::size_t(row)] : PathKey();
    const auto set = [](NumberBox& box, double value, bool enabled) {
        const QSignalBlocker quiet(box);
        box.setValue(value);
        box.setEnabled(enabled);
    };
    {
        const QSignalBlocker quiet(time_);
        time_->setRange(row > 0 ? keys_[std::size_t(row - 1)].time.value() + leastWait : 0,
                        isInner ? keys_[std::size_t(row + 1)].time.value() - leastWait
                                : latestPathKey.value());
    }
    set(*time_, key.time.value(), row > 0);
    set(*depth_, key.depth.value_or(dipDepth_).value() * factor, isInner);
    for (std::size_t part = 0; part < 2; ++part) {
        set(*beside_[part], key.beside[part].value() * factor, isChosen);
    }
    for (std::size_t part = 0; part < 3; ++part) {
        set(*turn_[part], key.turn[part].value(), isChosen && row < last);
    }
}

void PathKeyFields::change(const std::function<void(PathKey&)>& set) {
    if (const int row = list_->currentRow(); row >= 0) {
        std::vector<PathKey> keys = keys_;
        set(keys[std::size_t(row)]);
        emit changed(keys);
    }
}

} // namespace dipwright
