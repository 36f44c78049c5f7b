// A line above the view with a notice about the last run. It stays until the user closes it.
#pragma once

#include <QFrame>

class QLabel;

namespace dipwright {

class NoticeBar : public QFrame {
    Q_OBJECT

public:
    explicit NoticeBar(QWidget* parent = nullptr);

    void say(const QString& text); // empty: hides the bar
    void dismiss() { hide(); }
    QString text() const;

private:
    QLabel* text_;
};

} // namespace dipwright
