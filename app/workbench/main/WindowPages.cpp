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

void addSearchPage(const PageContext& makings, const Workbench& workbench) {
    auto* search = new SearchController(makings.session, makings.jobs, workbench.registry(),
                                        makings.messages, &makings.window);
    QObject::connect(search, &SearchController::comparisonAsked, &makings.window,
                     [&workbench, &session = makings.session,
                      &window = makings.window](const std::array<ComparedState, 2>& states) {
                         (new CompareWindow(states, session.document()->result(),
                                            workbench.registry(), workbench.preferences(), &window))
                             ->open();
                     });
    openBy(*makings.actions.findPoses,
           makings.layout.addPage("searchDock", Text::tr("Pose search"), search->page()));
    QObject::connect(&makings.documents, &DocumentSession::documentChanged, search,
                     &SearchController::showDocument);
}

void addArtworkPage(const PageContext& makings, DipScene& scene, DipController& dip,
                    DocumentController& files) {
    auto* artwork = new ArtworkController(*makings.layout.parts().view, scene, makings.session,
                                          makings.jobs, makings.messages, makings.window);
    openBy(*makings.actions.artwork,
           makings.layout.addPage("artworkDock", Text::tr("Artwork"), artwork->page()));
    QObject::connect(&makings.documents, &DocumentSession::documentChanged, artwork,
                     &ArtworkController::showDocument);
    QObject::connect(artwork, &ArtworkController::held, &dip, &DipController::setHeld);
    QObject::connect(artwork, &ArtworkController::filesDropped, &files,
                     &DocumentController::takeFiles);
}

} // namespace dipwright
