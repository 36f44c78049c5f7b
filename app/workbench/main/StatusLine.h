// The line at the bottom of a window: what is under the cursor, and how far the job is that runs.
#pragma once

#include <QObject>
#include <QTimer>

class QAction;
class QLabel;
class QProgressBar;
class QStatusBar;
class QToolButton;

namespace dipwright {

class JobRunner;

class StatusLine : public QObject {
    Q_OBJECT

public:
    StatusLine(QStatusBar& bar, const JobRunner& jobs, QAction& cancel); // the bar's child

    void setReading(const QString& text);
    // What is wrong with the body's place; stays until it is set anew; empty: nothing.
    void setWarning(const QString& text);
    void setJob(const QString& text);

signals:
    void warningClicked();

private:
    void showJob(bool shown);

    QLabel* reading_;
    QToolButton* warning_;
    QLabel* job_;
    QProgressBar* progress_;
    QToolButton* cancel_;
    QTimer unanswered_; // since a job was to stop
};

} // namespace dipwright
