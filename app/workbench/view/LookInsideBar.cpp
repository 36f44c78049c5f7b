#include "workbench/view/LookInsideBar.h"

#include "workbench/widgets/Icons.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSlider>
#include <QToolButton>

namespace dipwright {

namespace {

constexpr int steps = 1000; // of the slider along the axis
constexpr int leastOpacity = 5, usualOpacity = 45, mostOpacity = 100; // per cent

QSlider* slider(int least, int most, int value, const char* name, const QString& text) {
    auto* made = new QSlider(Qt::Horizontal);
    made->setObjectName(QLatin1String(name));
    made->setRange(least, most);
    made->setValue(value);
    made->setPageStep((most - least) / 20);
    made->setAccessibleName(text);
    made->setToolTip(text);
    made->setMinimumWidth(60);
    return made;
}

QHBoxLayout* rowOf(QWidget* half) {
    auto* row = new QHBoxLayout(half);
    row->setContentsMargins(0, 0, 0, 0);
    return row;
}

} // namespace

LookInsideBar::LookInsideBar(QWidget* parent)
    : QWidget(parent), axis_(new QComboBox),
      section_(slider(0, steps, steps / 2, "sectionPlace",
                      tr("Position of the section through part and film. You can also drag its "
                         "frame in the view."))),
      opacity_(slider(leastOpacity, mostOpacity, usualOpacity, "filmOpacity",
                      tr("How opaque the film is. At 100 % it hides everything behind it."))),
      after_(new QToolButton), place_(new QLabel), percent_(new QLabel),
      sectionHalf_(makeSection()), opacityHalf_(makeOpacity()) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 2, 8, 2);
    row->addWidget(sectionHalf_, 5);
    row->addWidget(opacityHalf_, 2);
    setSectionShown(false);
    setOpacityShown(false);
}

QWidget* LookInsideBar::makeSection() {
    axis_->setObjectName(QStringLiteral("sectionAxis"));
    axis_->addItems({tr("Cut across X"), tr("Horizontal cut, across Y"), tr("Cut across Z")});
    axis_->setCurrentIndex(2); // the front is cut away
    axis_->setAccessibleName(tr("Axis perpendicular to the section plane"));
    axis_->setToolTip(tr("Axis perpendicular to the section plane"));
    after_->setObjectName(QStringLiteral("sectionAfter"));
    after_->setIcon(icon(QStringLiteral("replace")));
    after_->setCheckable(true);
    after_->setAutoRaise(true);
    after_->setAccessibleName(tr("Show the other side"));
    after_->setToolTip(tr("Show the other side"));
    place_->setObjectName(QStringLiteral("sectionPlaceText"));
    place_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    place_->setMinimumWidth(place_->fontMetrics().horizontalAdvance(QStringLiteral(" −000.00 mm")));
    auto* half = new QWidget;
    QHBoxLayout* row = rowOf(half);
    row->addWidget(axis_);
    row->addWidget(section_, 1);
    row->addWidget(place_);
    row->addWidget(after_);
    connect(axis_, &QComboBox::currentIndexChanged, this, &LookInsideBar::sectionChanged);
    connect(section_, &QSlider::valueChanged, this, &LookInsideBar::sectionChanged);
    connect(after_, &QToolButton::toggled, this, &LookInsideBar::sectionChanged);
    return half;
}

QWidget* LookInsideBar::makeOpacity() {
    auto* half = new QWidget;
    QHBoxLayout* row = rowOf(half);
    row->addWidget(new QLabel(tr("Film opacity")));
    row->addWidget(opacity_, 1);
    row->addWidget(percent_);
    percent_->setMinimumWidth(percent_->fontMetrics().horizontalAdvance(QStringLiteral("100 %")));
    const auto tell = [this] {
        percent_->setText(tr("%1 %").arg(QLocale().toString(opacity_->value())));
    };
    connect(opacity_, &QSlider::valueChanged, this, tell);
    connect(opacity_, &QSlider::valueChanged, this, &LookInsideBar::filmOpacityChanged);
    tell();
    return half;
}

void LookInsideBar::setSectionShown(bool shown) {
    hasSection_ = shown;
    updateVisibility();
}

void LookInsideBar::setOpacityShown(bool shown) {
    hasOpacity_ = shown;
    updateVisibility();
}

void LookInsideBar::updateVisibility() {
    sectionHalf_->setVisible(hasSection_);
    opacityHalf_->setVisible(hasOpacity_);
    setVisible(hasSection_ || hasOpacity_);
}

int LookInsideBar::axis() const {
    return axis_->currentIndex();
}

double LookInsideBar::share() const {
    return double(section_->value()) / steps;
}

bool LookInsideBar::isFarSideShown() const {
    return after_->isChecked();
}

void LookInsideBar::setShare(double share) {
    section_->setValue(qRound(share * steps));
}

void LookInsideBar::setPlace(const QString& text) {
    place_->setText(text);
}

double LookInsideBar::filmOpacity() const {
    return opacity_->value() / 100.0;
}

} // namespace dipwright
