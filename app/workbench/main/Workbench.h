// What all windows of the program share: solvers, preferences, the queue and the list of windows.
#pragma once

#include "solver/SolverRegistry.h"
#include "workbench/document/Preferences.h"
#include "workbench/main/TankController.h"
#include "workbench/queue/JobQueue.h"
#include "workbench/widgets/PlainTexts.h"
#include "workbench/widgets/WheelGuard.h"

#include <QObject>
#include <QPointer>
#include <memory>

namespace dipwright {

class MainWindow;
class QueueDialog;

class Workbench : public QObject {
    Q_OBJECT

public:
    // `recovery`: folder for copies of unsaved work.
    explicit Workbench(const QString& recovery, QObject* parent = nullptr);
    ~Workbench() override;

    const SolverRegistry& registry() const { return registry_; }
    const QString& recovery() const { return recovery_; }
    const Preferences& preferences() const { return preferences_; }
    void setPreferences(const Preferences& preferences); // also stores them

    // A new window that shows the start page. Deletes itself when it is closed.
    MainWindow* openWindow();
    // Raises the window that has this file open. Returns false if there is none.
    bool bringForward(const QString& path);
    // The queue that runs projects one after the other.
    JobQueue& queue() { return queue_; }
    // Opens the queue's window. It proposes the folder of `project` (may be empty) for the results.
    void showQueue(const QString& project);
    // Opens the tank-side page for at least one job. `shown` is the document of a job without a
    // file; it may be null.
    void showTank(const std::vector<TankJob>& jobs, Document* shown) { tank_.open(jobs, shown); }
    // Offers to restore unsaved work after a crash, each document in its own window.
    void offerRecovery();

signals:
    void preferencesChanged();

protected:
    // Opens the guide in dialogs, which have no action for it.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    MainWindow* windowOf(const QString& path) const; // that has this file open; may be null
    MainWindow* emptyWindow(); // a window that shows the start page; opens one if there is none

    PlainTexts plainTexts_; // must exist before any label
    WheelGuard wheelGuard_; // must exist before any field
    SolverRegistry registry_;
    QString recovery_;
    Preferences preferences_;
    JobQueue queue_;
    QPointer<QueueDialog> queueWindow_;
    TankController tank_;
};

} // namespace dipwright
