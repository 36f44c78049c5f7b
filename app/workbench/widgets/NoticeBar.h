// A line above the view with a notice about the last run. It stays until the user closes it.
#pragma once

#include <QFrame>

class QLabel;
class QScrollArea;

namespace dipwright {

class NoticeBar : public QFrame {
    Q_OBJECT

public:
    explicit NoticeBar(QWidget* parent = nullptr);

    void say(const QString& text); // empty: hides the bar
    void dismiss() { hide(); }
    QString text() const;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fitText();

    QLabel* text_;
    QScrollArea* scroll_;
};

} // namespace dipwright
