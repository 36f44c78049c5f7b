// Has the dip run again a moment after a change, once there is a result.
#pragma once

#include "workbench/document/Document.h"

#include <QTimer>

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
    void stop() { delay_.stop(); } // it has been run, or is not to be

signals:
    void runAsked();

private:
    void consider();

    const Document* document_ = nullptr;
    bool wanted_ = false;
    bool held_ = false;
    QTimer delay_;
};

} // namespace dipwright
