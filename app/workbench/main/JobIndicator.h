// The running job in a status bar: its text, progress, time left, and a button that cancels it.
// Hidden while no job runs.
#pragma once

#include <QList>
#include <QObject>

class QAction;
class QLabel;
class QStatusBar;
class QWidget;

namespace dipwright {

class JobRunner;

class JobIndicator : public QObject {
    Q_OBJECT

public:
    // Becomes the bar's child. `name`: object name of the progress bar. `width`: of the progress
    // bar, in pixels.
    JobIndicator(QStatusBar& bar, const JobRunner& jobs, QAction& cancel, const QString& name,
                 int width);

    void setText(const QString& text);

private:
    QLabel* text_;
    QList<QWidget*> widgets_; // in the bar
};

} // namespace dipwright
