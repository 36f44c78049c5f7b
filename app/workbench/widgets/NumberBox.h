// A field for a number, as all windows have it.
#pragma once

#include <QDoubleSpinBox>
#include <vector>

namespace dipwright {

// Reads what is typed when it is left or Enter is pressed, in any unit of what its suffix measures
// (TypedNumber.h): "2in" in a field in mm is 50.8. A comma and a point are the decimal sign in any
// language, and may stand between groups of digits. What cannot be read, has two meanings within
// the limits or lies beyond them is red while it is typed and is refused then, with a sentence; the
// value stays. No digit is cut off. Shows no more decimals than there are. Takes the wheel only
// while it has the focus, so that scrolling what it stands in changes no value.
class NumberBox : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit NumberBox(QWidget* parent = nullptr);

    QValidator::State validate(QString& text, int& position) const override;
    double valueFromText(const QString& text) const override;
    void fixup(QString& text) const override;

signals:
    // What was typed was not accepted: why, and what would be. The field shows it, too.
    void refused(const QString& sentence) const;

protected:
    QString textFromValue(double value) const override;
    void wheelEvent(QWheelEvent* event) override;

private:
    struct Reading;
    Reading read(const QString& text) const;
    Reading readingOf(const QString& own, const std::vector<double>& values) const;
    void colourText();
};

} // namespace dipwright
