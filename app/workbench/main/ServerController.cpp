#include "workbench/main/ServerController.h"

#include "workbench/actions/WindowActions.h"
#include "workbench/serving/ServerDialog.h"

#include <QAction>
#include <QPointer>

namespace dipwright {

ServerController::ServerController(const WindowActions& actions, DipSession& session,
                                   JobRunner& jobs, Messages& messages, QWidget& window)
    : session_(session), jobs_(jobs), messages_(messages), window_(window) {
    connect(actions.sendToServer, &QAction::triggered, this, &ServerController::ask);
}

void ServerController::ask() {
    auto* dialog = new ServerDialog(&window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ServerDialog::sent, this, &ServerController::send);
    dialog->open();
}

void ServerController::send(const ServerAccess& server) {
    using Fetched = std::shared_ptr<const JobResult>;
    const Document& document = *session_.document();
    jobs_.start(std::make_unique<ValueJob<Fetched>>(
        tr("Running on the server"),
        [project = document.project(), server](const Progress& progress) {
            return remoteDips(project, server, progress);
        },
        [this, document = QPointer(&document)](const Fetched& fetched) {
            if (!document || document != session_.document()) {
                return;
            }
            if (document->project() != fetched->project) {
                messages_.say(
                    tr("The project was changed while the server ran it. Send it again."));
                return;
            }
            messages_.logAndSay(tr("The server has simulated the dips."));
            session_.setKept(fetched);
            emit found();
        },
        [this](const std::exception_ptr& failure) {
            messages_.fail(tr("Send to server"), failure);
        }));
}

} // namespace dipwright
