// Lets the user type the angle or the distance while dragging a ring or an arrow: a number, with a
// unit or without. Backspace removes a sign, Enter ends the drag, Escape takes it back. Shows the
// value beside the pointer.
#pragma once

#include "viewport/DipView.h"
#include "workbench/widgets/Units.h"

namespace dipwright {

class TypedDrag : public QObject {
    Q_OBJECT

public:
    explicit TypedDrag(DipView& view, QObject* parent = nullptr);

    void setLengthUnit(LengthUnit unit) { unit_ = unit; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void press(const QKeyEvent& key);
    void apply();
    void show(const QString& value);
    QString unit() const; // of a number that is typed without a unit

    DipView& view_;
    LengthUnit unit_ = LengthUnit::Millimetre;
    bool turns_ = true; // the last drag was that of a ring
    QString typed_;
};

} // namespace dipwright
