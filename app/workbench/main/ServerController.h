// Runs the dips of a window's document on a job server, when the user asks for it.
#pragma once

#include "workbench/dip/DipSession.h"
#include "workbench/jobs/Messages.h"

class QWidget;

namespace dipwright {

struct ServerAccess;
class WindowActions;

class ServerController : public QObject {
    Q_OBJECT

public:
    ServerController(const WindowActions& actions, DipSession& session, JobRunner& jobs,
                     Messages& messages, QWidget& window);

signals:
    void found(); // the session has dips that its next run can reuse

private:
    void ask();
    void send(const ServerAccess& server);

    DipSession& session_;
    JobRunner& jobs_;
    Messages& messages_;
    QWidget& window_;
};

} // namespace dipwright
