// The number field that all windows use.
#pragma once

#include <QDoubleSpinBox>
#include <vector>

namespace dipwright {

struct TypedNumber;

// The field reads its text when it loses the focus or Enter is pressed. It also reads it before a
// click elsewhere, a shortcut or closing the window takes effect, so that "Save" saves what the
// field shows. Accepts calculations and any unit of the suffix's quantity (base/TypedNumber.h):
// "2in" in a field in mm is 50.8, "3*12" is 36. While such a text is typed, a tooltip shows its
// value. Comma and point are accepted as decimal signs in any language, and as separators between
// groups of digits. Text that cannot be read, is ambiguous, or lies outside the limits is red while
// it is typed. When it is entered, it is refused with a message, and the value stays. Keeps all
// typed digits; shows no more decimals than needed.
class NumberBox : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit NumberBox(QWidget* parent = nullptr);

    // The value of a field of whole numbers (0 decimals).
    int wholeValue() const;

    QValidator::State validate(QString& text, int& position) const override;
    double valueFromText(const QString& text) const override;
    void fixup(QString& text) const override;

signals:
    // The typed text was not accepted. The sentence says why and what would be accepted; the field
    // shows it too.
    void refused(const QString& sentence) const;

protected:
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    QString textFromValue(double value) const override;

private:
    struct Reading;
    QString ownText(const QString& text) const;
    Reading read(const QString& text) const;
    QString refusalOf(const QString& own, const TypedNumber& typed) const;
    QString shown(double value) const;
    QString outsideRange(const QString& own) const; // the refusal
    Reading readingOf(const QString& own, const std::vector<double>& values) const;
    void showReading();
    bool isShortcut(const QKeyEvent& key);
};

} // namespace dipwright
