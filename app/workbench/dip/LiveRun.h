// Has the dip run again a moment after a change, once there is a result.
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
    // What the user wants; counts from the next change on.
    void setWanted(bool wanted) { wanted_ = wanted; }
    // While something is dragged, nothing is run; afterwards what has changed is.
    void setHeld(bool held);
    void stop(); // it has been run, or is not to be
    // The user does not want what is about to run, or runs: nothing is run before the project's
    // sheets come out otherwise than they would now.
    void cancel();

signals:
    void runAsked();

private:
    void consider();

    const Document* document_ = nullptr;
    bool wanted_ = false;
    bool held_ = false;
    std::optional<Project> cancelled_; // what is not to be run
    QTimer delay_;
};

} // namespace dipwright
