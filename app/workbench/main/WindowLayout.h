// What a window is made of and where it stands: the start page or the view with its timeline in the
// middle, project and properties on the left, results on the right, the log below. Remembers where
// the user has put it all.
#pragma once

#include <QByteArray>
#include <QObject>

class QAction;
class QDockWidget;
class QLabel;
class QMainWindow;
class QMenu;
class QStackedWidget;

namespace dipwright {

class DipView;
class LogPanel;
class LookInsideBar;
class NoticeBar;
class ProjectTree;
class PropertyPanel;
class ResultsPanel;
class SolverRegistry;
class StartPage;
class Timeline;

// All belong to the window.
struct WindowParts {
    StartPage* startPage;
    DipView* view;
    LookInsideBar* inside;
    Timeline* timeline;
    QLabel* staleBanner;
    NoticeBar* notice;
    ProjectTree* tree;
    PropertyPanel* properties;
    ResultsPanel* results;
    LogPanel* log;
    QDockWidget *projectDock, *resultsDock, *logDock;
    QList<QDockWidget*> pageDocks; // beside the results, hidden at first
};

class WindowLayout : public QObject {
    Q_OBJECT

public:
    // Makes the parts.
    WindowLayout(QMainWindow& window, const SolverRegistry& registry);

    const WindowParts& parts() const { return parts_; }
    // Behind the results, hidden at first. Before restore().
    // A page beside the results; `name` is what saved layouts know it by. Before restore().
    QDockWidget* addPage(const char* name, const QString& title, QWidget* page);
    QList<QAction*> dockToggles() const;

    // Once the window is complete: how it was when the last one was closed.
    void restore();
    void keep() const;
    // The start page, or all that belongs to a project.
    void showProject(bool shown);
    // Back to how it is at first.
    void reset();
    // Under a name of the user's.
    void askName();
    void fillMenu(QMenu& menu);

    // For dark or light.
    void colourBanners();

signals:
    void layoutChosen(const QString& name);

private:
    void makeCentre();
    void makeDocks(const SolverRegistry& registry);
    QDockWidget* addDock(Qt::DockWidgetArea area, const char* name, const QString& title,
                         QWidget* widget);
    void sizeDocks(); // as the window's width allows

    QMainWindow& window_;
    WindowParts parts_{};
    QStackedWidget* pages_ = nullptr;
    QByteArray standard_;
};

} // namespace dipwright
