#include "workbench/actions/WindowMenus.h"

#include "workbench/actions/WindowActions.h"
#include "workbench/widgets/Icons.h"

#include <QActionGroup>
#include <QMainWindow>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

namespace dipwright {

namespace {

// Adds groups of actions with a separator between them.
void addGroups(QMenu& menu, const QList<QList<QAction*>>& groups) {
    for (const QList<QAction*>& group : groups) {
        if (&group != &groups.front()) {
            menu.addSeparator();
        }
        menu.addActions(group);
    }
}

} // namespace

WindowMenus::WindowMenus(QMainWindow& window, const WindowActions& actions,
                         const QList<QAction*>& docks)
    : QObject(&window) {
    const WindowActions& a = actions;
    QMenuBar& bar = *window.menuBar();
    makeFileMenu(*bar.addMenu(tr("&File")), actions);
    makeEditMenu(*bar.addMenu(tr("&Edit")), actions);
    makeViewMenu(*bar.addMenu(tr("&View")), actions);
    addGroups(*bar.addMenu(tr("&Dip")), {{a.run, a.cancel, a.live, a.sendToServer},
                                         {a.play, a.findPoses, a.numericalError, a.tolerances}});
    makeWindowMenu(*bar.addMenu(tr("&Window")), actions, docks);
    addGroups(*bar.addMenu(tr("&Help")), {{a.tour, a.guide, a.whatsThis}, {a.about}});
    makeMainToolBar(window, actions);
    makeViewToolBar(window, actions);
}

void WindowMenus::makeFileMenu(QMenu& menu, const WindowActions& a) {
    menu.addActions({a.newProject, a.newWindow, a.open});
    recent_ = menu.addMenu(tr("Open &recent"));
    menu.addSeparator();
    addGroups(menu,
              {{a.save, a.saveAs, a.snapshots},
               {a.print, a.plates, a.printHistory, a.calibrate, a.jobQueue, a.tank, a.packJobs,
                a.exportResults, a.exportPdf, a.exportPng, a.exportCradles, a.makeOutputs},
               {a.close, a.quit}});
}

void WindowMenus::makeEditMenu(QMenu& menu, const WindowActions& a) {
    addGroups(menu, {{a.undo, a.redo}, {a.addImmersion, a.removeImmersion, a.swapImmersions}});
    menu.addSeparator();
    menu.addMenu(tr("Tur&n part"))->addActions(a.bodyTurns->actions());
    menu.addMenu(tr("Mo&ve part"))->addActions(a.bodyMoves->actions());
    menu.addSeparator();
    addGroups(menu, {{a.reloadModel, a.replaceModel, a.replaceTexture, a.artwork},
                     {a.profiles, a.preferences}});
}

void WindowMenus::makeViewMenu(QMenu& menu, const WindowActions& a) {
    addGroups(menu,
              {{a.fit, a.fitPart, a.oblique, a.front, a.right, a.top, a.back, a.left, a.bottom},
               {a.parallel}});
    menu.addSeparator();
    film_ = menu.addMenu(icon(QStringLiteral("film")), tr("Film appearan&ce"));
    film_->addActions(a.filmLook->actions());
    menu.addActions({a.wearsFilm, a.filmOnBody, a.seeThrough, a.section, a.body, a.coverage,
                     a.bodyPrint, a.zones, a.warnings, a.cradle, a.water, a.rings, a.measure});
}

void WindowMenus::makeWindowMenu(QMenu& menu, const WindowActions& a,
                                 const QList<QAction*>& docks) {
    menu.addActions(docks);
    menu.addSeparator();
    layouts_ = menu.addMenu(tr("&Layouts"));
    layouts_->setObjectName(QStringLiteral("layouts"));
    menu.addActions({a.saveLayout, a.resetLayout});
}

void WindowMenus::makeMainToolBar(QMainWindow& window, const WindowActions& a) {
    QToolBar* bar = window.addToolBar(tr("Main"));
    bar->setObjectName(QStringLiteral("mainToolBar"));
    bar->setIconSize({22, 22});
    bar->addActions({a.newProject, a.open, a.save});
    bar->addSeparator();
    bar->addActions({a.undo, a.redo});
    bar->addSeparator();
    bar->addAction(a.run);
    auto* run = qobject_cast<QToolButton*>(bar->widgetForAction(a.run));
    run->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->addActions({a.cancel, a.live});
    bar->addSeparator();
    bar->addAction(a.print);
}

void WindowMenus::makeViewToolBar(QMainWindow& window, const WindowActions& a) {
    QToolBar* bar = window.addToolBar(tr("View"));
    bar->setObjectName(QStringLiteral("viewToolBar"));
    bar->setIconSize({22, 22});
    bar->addActions({a.fit, a.fitPart, a.oblique, a.front, a.right, a.top, a.parallel});
    bar->addSeparator();
    auto* film = new QToolButton;
    film->setIcon(icon(QStringLiteral("film")));
    film->setToolTip(tr("What the film shows in the 3D view"));
    film->setAccessibleName(tr("Film appearance"));
    film->setPopupMode(QToolButton::InstantPopup);
    film->setMenu(film_);
    bar->addWidget(film);
    bar->addActions(
        {a.filmOnBody, a.seeThrough, a.section, a.coverage, a.water, a.rings, a.measure});
}

} // namespace dipwright
