// What all windows of the program share: the solvers, the preferences, and the windows themselves.
#pragma once

#include "solver/SolverRegistry.h"
#include "workbench/document/Preferences.h"
#include "workbench/queue/JobQueue.h"
#include "workbench/widgets/PlainTexts.h"

#include <QObject>
#include <QPointer>
#include <memory>

namespace dipwright {

class MainWindow;
class QueueDialog;

class Workbench : public QObject {
    Q_OBJECT

public:
    // `recovery`: the folder in which copies of unsaved work are kept.
    explicit Workbench(const QString& recovery, QObject* parent = nullptr);
    ~Workbench() override;

    const SolverRegistry& registry() const { return registry_; }
    const QString& recovery() const { return recovery_; }
    const Preferences& preferences() const { return preferences_; }
    void setPreferences(const Preferences& preferences); // and keeps them

    // A new window that shows the start page. Deletes itself when it is closed.
    MainWindow* openWindow();
    // The window that has this file open; false: none has.
    bool bringForward(const QString& path);
    // Projects run one after the other, and the window on them; `project`: that is open, or none.
    JobQueue& queue() { return queue_; }
    void showQueue(const QString& project);
    // Offers what a crash has left behind, each in a window of its own.
    void offerRecovery();

signals:
    void preferencesChanged();

protected:
    // The guide in windows beside the main ones, which have an action for it.
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    MainWindow* emptyWindow(); // one that shows the start page, or a new one

    PlainTexts plainTexts_; // before there is any label
    SolverRegistry registry_;
    QString recovery_;
    Preferences preferences_;
    JobQueue queue_;
    QPointer<QueueDialog> queueWindow_;
};

} // namespace dipwright
