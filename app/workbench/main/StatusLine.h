// The line at the bottom of a window: the value under the cursor, and the progress of the running
// job and of a save.
#pragma once

#include <QObject>
#include <QTimer>

class QAction;
class QLabel;
class QStatusBar;
class QToolButton;

namespace dipwright {

class JobIndicator;
class JobRunner;

class StatusLine : public QObject {
    Q_OBJECT

public:
    // Becomes the bar's child. `cancel`: cancels the jobs.
    StatusLine(QStatusBar& bar, const JobRunner& jobs, QAction& cancel, const JobRunner& saves);

    void setReading(const QString& text);
    // Shows a warning about the body's place until the next call. Empty: shows none.
    void setWarning(const QString& text);
    void setJob(const QString& text);

signals:
    void warningClicked();
    void saveCancelled();

private:
    void addReading(QStatusBar& bar);
    void addSaves(QStatusBar& bar, const JobRunner& saves);

    QLabel* reading_;
    QToolButton* warning_;
    JobIndicator* job_ = nullptr;
    QTimer unanswered_; // starts when a job is cancelled
};

} // namespace dipwright
