// Keeps the mouse wheel from changing fields that the user only scrolls past.
#pragma once

#include <QObject>

class QApplication;

namespace dipwright {

// While this object exists, the wheel changes a number field or a drop-down list only if the field
// has the keyboard's focus, and does not give it the focus. Otherwise what is around the field
// scrolls.
class WheelGuard : public QObject {
public:
    explicit WheelGuard(QApplication& application);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace dipwright
