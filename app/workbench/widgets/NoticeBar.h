// A line over the view that tells something about the last run until it is read and closed.
#pragma once

#include <QFrame>

class QLabel;

namespace dipwright {

class NoticeBar : public QFrame {
    Q_OBJECT

public:
    explicit NoticeBar(QWidget* parent = nullptr);

    void say(const QString& text); // empty: nothing
    void dismiss() { hide(); }
    QString text() const;

private:
    QLabel* text_;
};

} // namespace dipwright
