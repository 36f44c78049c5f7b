// The quick tour, which explains the parts of the window one after the other.
#pragma once

#include <QPointer>
#include <QWidget>

class QLabel;
class QPushButton;

namespace dipwright {

struct TourStep {
    QPointer<QWidget> target; // null: no target
    QString title, text;
};

// Covers its parent until the last step or Escape, and then deletes itself.
class Tour : public QWidget {
    Q_OBJECT

public:
    Tour(const std::vector<TourStep>& steps, QWidget* parent);

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent*) override {} // blocks clicks on the parent
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void show(std::size_t step);
    void place();
    QRect targetRect() const;

    std::vector<TourStep> steps_;
    std::size_t step_ = 0;
    QWidget* bubble_;
    QLabel* title_;
    QLabel* text_;
    QLabel* count_;
    QPushButton* back_;
    QPushButton* next_;
};

} // namespace dipwright
