#include "workbench/main/WindowPages.h"

#include "workbench/actions/WindowActions.h"
#include "workbench/artwork/ArtworkController.h"
#include "workbench/compare/CompareWindow.h"
#include "workbench/document/DocumentSession.h"
#include "workbench/main/DipController.h"
#include "workbench/main/DocumentController.h"
#include "workbench/main/WindowLayout.h"
#include "workbench/main/Workbench.h"
#include "workbench/poses/SearchController.h"

#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)
};

void openBy(const QAction& action, QDockWidget* dock) {
    QObject::connect(&action, &QAction::triggered, dock, [dock] {
        dock->show();
        dock->raise();
    });
}

} // namespace

void addSearchPage(const PageContext& context, const Workbench& workbench, DipController& dip) {
    auto* search = new SearchController(context.session, workbench.registry(), context.messages,
                                        &context.window);
    QObject::connect(search, &SearchController::comparisonAsked, &context.window,
                     [&workbench, &session = context.session,
                      &window = context.window](const std::array<ComparedState, 2>& states) {
                         (new CompareWindow(states, session.document()->result(),
                                            workbench.registry(), workbench.preferences(), &window))
                             ->open();
                     });
    QObject::connect(search, &SearchController::poseTried, &dip, &DipController::tryPose);
    QObject::connect(search, &SearchController::triedPoseUsed, &dip, [&dip] { dip.run(true); });
    openBy(*context.actions.findPoses,
           context.layout.addPage("searchDock", Text::tr("Pose search"), search->page()));
    QObject::connect(&context.documents, &DocumentSession::documentChanged, search,
                     &SearchController::showDocument);
}

void addArtworkPage(const PageContext& context, DipScene& scene, DipController& dip,
                    DocumentController& files) {
    auto* artwork = new ArtworkController(*context.layout.parts().view, scene, context.session,
                                          context.jobs, context.messages, context.window);
    openBy(*context.actions.artwork,
           context.layout.addPage("artworkDock", Text::tr("Artwork"), artwork->page()));
    QObject::connect(&context.documents, &DocumentSession::documentChanged, artwork,
                     &ArtworkController::showDocument);
    QObject::connect(artwork, &ArtworkController::held, &dip, &DipController::setHeld);
    QObject::connect(artwork, &ArtworkController::filesDropped, &files,
                     &DocumentController::takeFiles);
}

} // namespace dipwright
