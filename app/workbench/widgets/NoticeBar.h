// A line above the view with a notice about the last run. It stays until the user closes it.
#pragma once

#include <QFrame>

class QLabel;
class QScrollArea;

namespace dipwright {

// The sign before a notice.
enum class NoticeKind { Warning, Done };

class NoticeBar : public QFrame {
    Q_OBJECT

public:
    explicit NoticeBar(QWidget* parent = nullptr);

    // An empty text hides the bar.
    void say(const QString& text, NoticeKind kind = NoticeKind::Warning);
    void dismiss() { hide(); }
    QString text() const;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fitText();

    QLabel* sign_;
    QLabel* text_;
    QScrollArea* scroll_;
};

} // namespace dipwright
