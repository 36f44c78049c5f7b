// Keeps the mouse wheel from changing drop-down lists that the user only scrolls past.
#pragma once

#include <QObject>

class QApplication;

namespace dipwright {

// While this object exists, the wheel changes a drop-down list only if the list has the keyboard's
// focus, and does not give it the focus. Otherwise what is around the list scrolls. NumberBox does
// the same.
class WheelGuard : public QObject {
public:
    explicit WheelGuard(QApplication& application);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace dipwright
