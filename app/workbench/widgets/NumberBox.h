// A field for a number, as all windows have it.
#pragma once

#include <QDoubleSpinBox>

namespace dipwright {

// Takes a comma and a point for the decimal sign in any language, and refuses a number with both;
// shows no more decimals than there are. Takes the wheel only while it has the focus, so that
// scrolling what it stands in changes no value.
class NumberBox : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit NumberBox(QWidget* parent = nullptr);

    QValidator::State validate(QString& text, int& position) const override;
    double valueFromText(const QString& text) const override;

protected:
    QString textFromValue(double value) const override;
    void wheelEvent(QWheelEvent* event) override;
};

} // namespace dipwright
