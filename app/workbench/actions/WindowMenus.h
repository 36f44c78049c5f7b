// Builds the menus and tool bars of a window from its actions.
#pragma once

#include <QObject>

class QAction;
class QMainWindow;
class QMenu;

namespace dipwright {

class WindowActions;

class WindowMenus : public QObject {
    Q_OBJECT

public:
    // `docks`: the actions that show and hide the panels.
    WindowMenus(QMainWindow& window, const WindowActions& actions, const QList<QAction*>& docks);

    // The menu of recent projects. Its entries change, so fill it when it is about to show.
    QMenu& recent() { return *recent_; }
    // The menu of saved layouts. Its entries change, so fill it when it is about to show.
    QMenu& layouts() { return *layouts_; }

private:
    void makeFileMenu(QMenu& menu, const WindowActions& actions);
    void makeEditMenu(QMenu& menu, const WindowActions& actions);
    void makeViewMenu(QMenu& menu, const WindowActions& actions);
    void makeWindowMenu(QMenu& menu, const WindowActions& actions, const QList<QAction*>& docks);
    void makeMainToolBar(QMainWindow& window, const WindowActions& actions);
    void makeViewToolBar(QMainWindow& window, const WindowActions& actions);

    QMenu* recent_ = nullptr;
    QMenu* layouts_ = nullptr;
    QMenu* film_ = nullptr;
};

} // namespace dipwright
