// The line at the bottom of a window: the value under the cursor, the progress of the job, and the
// time it will still take.
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
    StatusLine(QStatusBar& bar, const JobRunner& jobs, QAction& cancel); // becomes the bar's child

    void setReading(const QString& text);
    // Shows a warning about the body's place until the next call. Empty: shows none.
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
    QLabel* timeLeft_;
    QToolButton* cancel_;
    QTimer unanswered_; // starts when a job is cancelled
};

} // namespace dipwright
