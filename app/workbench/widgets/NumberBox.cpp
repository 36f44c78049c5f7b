#include "workbench/widgets/NumberBox.h"

#include <QWheelEvent>

namespace dipwright {
namespace {

// The sign that was typed in the digits of `text` becomes the locale's. Groups of digits are never
// shown, so that a comma or a point can only be the decimal sign.
void useDecimalSign(QString& text, const QDoubleSpinBox& box) {
    const auto first = text.startsWith(box.prefix()) ? box.prefix().size() : 0;
    const auto last = text.endsWith(box.suffix()) ? text.size() - box.suffix().size() : text.size();
    const QString sign = box.locale().decimalPoint();
    for (auto place = first; place < last; ++place) {
        if (text[place] == u',' || text[place] == u'.') {
            text[place] = sign.front();
        }
    }
}

} // namespace

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setFocusPolicy(Qt::StrongFocus);
}

// Two signs are two decimal signs then, which no number has.
QValidator::State NumberBox::validate(QString& text, int& position) const {
    useDecimalSign(text, *this);
    return QDoubleSpinBox::validate(text, position);
}

double NumberBox::valueFromText(const QString& text) const {
    QString own = text;
    useDecimalSign(own, *this);
    return QDoubleSpinBox::valueFromText(own);
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
