// Requests a new run after each change, once there is a result or a run has begun.
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
    // While the body is held, requests only first drafts. Requests a whole run afterwards if
    // something has changed.
    void setHeld(bool held);
    bool isHeld() const { return held_; }
    void begin(); // a run begins: drops a pending request
    // The user cancelled. Requests no run until a change affects the sheets.
    void cancel();

signals:
    void runAsked();

private:
    void consider();

    const Document* document_ = nullptr;
    bool wanted_ = false;
    bool held_ = false;
    bool begun_ = false; // a run of the document has begun
    // The project at the last cancel. Projects with the same sheets do not run.
    std::optional<Project> cancelled_;
    QTimer soon_; // joins changes that come at once
};

} // namespace dipwright
