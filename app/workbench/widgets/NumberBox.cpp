#include "workbench/widgets/NumberBox.h"

#include "workbench/widgets/PlainTexts.h"
#include "workbench/widgets/Theme.h"
#include "workbench/widgets/TypedNumber.h"

#include <QLineEdit>
#include <QTimer>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace dipwright {

// A value, or the reason why there is no value.
struct NumberBox::Reading {
    std::optional<double> value;
    QString refusal;
};

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setFocusPolicy(Qt::StrongFocus);
    connect(lineEdit(), &QLineEdit::textChanged, this, &NumberBox::colourText);
}

NumberBox::Reading NumberBox::read(const QString& text) const {
    if (!specialValueText().isEmpty() && text == specialValueText()) {
        return {minimum(), {}};
    }
    const auto first = text.startsWith(prefix()) ? prefix().size() : 0;
    const auto last = text.endsWith(suffix()) ? text.size() - suffix().size() : text.size();
    const QString own = text.mid(first, std::max<qsizetype>(0, last - first)).trimmed();
    const QString unit = suffix().trimmed();
    const TypedNumber typed = typedNumber(own, unit, locale());
    if (!typed.unknownUnit.isEmpty()) {
        return {{},
                unit.isEmpty()
                    ? tr("“%1” has a unit, but this field has none; type only the number").arg(own)
                    : tr("“%1” has a unit that does not fit this field; type a number in %2")
                          .arg(own, unit)};
    }
    if (typed.values.empty()) {
        return {{},
                own.isEmpty() ? tr("The field is empty; type a number")
                              : tr("“%1” is not a number").arg(own)};
    }
    return readingOf(own, typed.values);
}

// Chooses among `values`, the possible meanings of the typed text `own`, the one that the field
// accepts.
NumberBox::Reading NumberBox::readingOf(const QString& own,
                                        const std::vector<double>& values) const {
    constexpr double rounding = 1e-9; // for limits converted to the shown unit
    QLocale plain = locale();
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    const auto shown = [&plain](double value) { return plain.toString(value, 'g', 12); };
    std::vector<double> within;
    for (const double value : values) {
        const double bound = qBound(minimum(), value, maximum());
        if (std::abs(value - bound) <= rounding * std::abs(bound)) {
            within.push_back(bound);
        }
    }
    if (within.empty()) {
        return {{},
                tr("“%1” is outside the range %2 to %3%4")
                    .arg(own, shown(minimum()), shown(maximum()), suffix())};
    }
    if (within.size() > 1) {
        return {{},
                tr("“%1” can mean %2 or %3; type one of them")
                    .arg(own, shown(within[0]), shown(within[1]))};
    }
    if (decimals() == 0 && within[0] != std::round(within[0])) {
        return {{}, tr("“%1” is not a whole number").arg(own)};
    }
    return {within[0], {}};
}

// Any text stays until it is read as a whole.
QValidator::State NumberBox::validate(QString& text, int&) const {
    constexpr int longest = 60;
    if (text.size() > longest + prefix().size() + suffix().size()) {
        return QValidator::Invalid;
    }
    return read(text).value ? QValidator::Acceptable : QValidator::Intermediate;
}

double NumberBox::valueFromText(const QString& text) const {
    return read(text).value.value_or(value());
}

// Called when the field loses the focus with invalid text; the value then stays.
void NumberBox::fixup(QString& text) const {
    const QString refusal = read(text).refusal;
    if (refusal.isEmpty()) {
        return;
    }
    emit refused(refusal);
    // Shown later, because a tooltip closes when the focus moves, and the focus has not moved yet.
    QTimer::singleShot(0, this, [this, refusal] {
        if (isVisible()) {
            constexpr int shownFor = 10'000; // ms
            QToolTip::showText(mapToGlobal(rect().bottomLeft()), inLines(refusal),
                               const_cast<NumberBox*>(this), {}, shownFor);
        }
    });
}

void NumberBox::colourText() {
    QPalette colours = palette();
    if (!read(lineEdit()->text()).value) {
        colours.setColor(QPalette::Text, isDark() ? QColor(255, 130, 120) : QColor(190, 20, 20));
    }
    lineEdit()->setPalette(colours);
}

QString NumberBox::textFromValue(double value) const {
    QString text = QDoubleSpinBox::textFromValue(value);
    const QString point = locale().decimalPoint();
    if (text.contains(point)) {
        while (text.endsWith(locale().zeroDigit())) {
            text.chop(1);
        }
        if (text.endsWith(point)) {
            text.chop(point.size());
        }
    }
    return text;
}

void NumberBox::wheelEvent(QWheelEvent* event) {
    if (hasFocus()) {
        QDoubleSpinBox::wheelEvent(event);
    } else {
        event->ignore();
    }
}

} // namespace dipwright
