#include "workbench/widgets/WheelGuard.h"

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
    auto* list = qobject_cast<QComboBox*>(watched);
    if (!list) {
        return false;
    }
    if (!isWheel) {
        list->setFocusPolicy(Qt::StrongFocus);
        return false;
    }
    if (list->hasFocus()) {
        return false;
    }
    event->ignore(); // so that it goes to the widget around the list
    return true;
}

} // namespace dipwright
