#include "workbench/view/TypedDrag.h"

#include "base/NumberText.h"
#include "base/TypedNumber.h"

#include <QKeyEvent>

namespace dipwright {

TypedDrag::TypedDrag(DipView& view, QObject* parent) : QObject(parent), view_(view) {
    view.installEventFilter(this);
    connect(&view, &DipView::handleHeld, this, [this](bool turns) {
        turns_ = turns;
        typed_.clear();
    });
    connect(&view, &DipView::rotationDragged, this,
            [this](int, double degrees) { show(numberText(degrees, 1) + QStringLiteral("°")); });
    connect(&view, &DipView::moveDragged, this,
            [this](int, double millimetres) { show(shownLength(millimetres, unit_)); });
}

QString TypedDrag::unit() const {
    return turns_ ? QStringLiteral("°") : unitSuffix(Unit::Length, unit_);
}

// While something is typed, its text is shown instead of the value.
void TypedDrag::show(const QString& value) {
    const bool hasUnit = !typed_.isEmpty() && typed_.back().isLetter();
    view_.setDragText(
        typed_.isEmpty() ? value : typed_ + QStringLiteral("│") + (hasUnit ? QString() : unit()));
}

bool TypedDrag::eventFilter(QObject* watched, QEvent* event) {
    if (watched != &view_ || !view_.isHandleHeld()) {
        return false;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept(); // the key is typed and calls no action
        return true;
    }
    if (event->type() == QEvent::KeyPress) {
        press(static_cast<const QKeyEvent&>(*event));
        return true;
    }
    return false;
}

void TypedDrag::press(const QKeyEvent& key) {
    const QString text = key.text();
    if (key.key() == Qt::Key_Escape) {
        view_.setDragValue(0);
        view_.releaseHandle();
    } else if (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter) {
        view_.releaseHandle();
    } else if (key.key() == Qt::Key_Backspace) {
        typed_.chop(1);
        apply();
    } else if (!text.isEmpty() && text.front().isPrint()) {
        typed_ += text;
        apply();
    }
}

// A text that is not a number yet, such as "-", leaves the part where it is.
void TypedDrag::apply() {
    const std::vector<double> values = typedNumber(typed_, unit().trimmed(), QLocale()).values;
    show({});
    if (typed_.isEmpty()) {
        view_.setDragValue({});
    } else if (!values.empty()) {
        view_.setDragValue(turns_ ? values.front()
                                  : values.front() / shownPerStored(Unit::Length, unit_));
    }
}

} // namespace dipwright
