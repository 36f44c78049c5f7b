#include "workbench/widgets/WheelGuard.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>

namespace dipwright {

WheelGuard::WheelGuard(QApplication& application) {
    application.installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
    const bool isWheel = event->type() == QEvent::Wheel;
    if (!isWheel && event->type() != QEvent::Polish) {
        return false;
    }
    if (!qobject_cast<QComboBox*>(watched) && !qobject_cast<QAbstractSpinBox*>(watched)) {
        return false;
    }
    auto* field = static_cast<QWidget*>(watched);
    if (!isWheel) {
        field->setFocusPolicy(Qt::StrongFocus);
        return false;
    }
    if (field->hasFocus()) {
        return false;
    }
    event->ignore(); // so that it goes to the widget around the field
    return true;
}

} // namespace dipwright
