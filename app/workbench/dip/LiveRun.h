// Requests a new run shortly after each change, once there is a result.
#pragma once

#include "workbench/document/Document.h"

#include <QTimer>
#include <optional>

namespace dipwright {

class LiveRun : public QObject {
    Q_OBJECT

public:
    explicit LiveRun(QObject* parent = nullptr);

    void setDocument(const Document* document); // may be null
    // Switches live runs on or off, from the next change on.
    void setWanted(bool wanted) { wanted_ = wanted; }
    // Suspends runs during a drag, and requests one afterwards if something has changed.
    void setHeld(bool held);
    void stop(); // drops a pending request
    // The user cancelled. Requests no run until a change affects the sheets.
    void cancel();

signals:
    void runAsked();

private:
    void consider();

    const Document* document_ = nullptr;
    bool wanted_ = false;
    bool held_ = false;
    // The project at the last cancel. Projects with the same sheets do not run.
    std::optional<Project> cancelled_;
    QTimer delay_;
};

} // namespace dipwright
