// The parts of a window and their layout. The start page, or the view with its timeline, is in the
// middle. Project and properties are on the left, results on the right, the log is below. Remembers
// the user's arrangement.
#pragma once

#include <QByteArray>
#include <QObject>
#include <optional>

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

// The window owns all parts.
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
    // Creates the parts.
    WindowLayout(QMainWindow& window, const SolverRegistry& registry);

    const WindowParts& parts() const { return parts_; }
    // Adds a page beside the results, hidden at first. `name` identifies it in saved layouts. Call
    // this before restore().
    QDockWidget* addPage(const char* name, const QString& title, QWidget* page);
    QList<QAction*> dockToggles() const;

    // Restores the layout of the last window that was closed. Call it once the window is complete.
    void restore();
    void keep() const;
    // Shows everything that belongs to a project, or else the start page.
    void showProject(bool shown);
    // Restores the original layout.
    void reset();
    // Saves the layout under a name that the user types.
    void askName();
    void fillMenu(QMenu& menu);

    // Call this after the theme has changed.
    void colourBanners();

signals:
    void layoutChosen(const QString& name);

private:
    void makeCentre();
    void makeDocks(const SolverRegistry& registry);
    QDockWidget* addDock(Qt::DockWidgetArea area, const char* name, const QString& title,
                         QWidget* widget);
    void sizeDocks(); // fits the docks to the window's width
    void keepProjectWidth(int least);

    QMainWindow& window_;
    WindowParts parts_{};
    QStackedWidget* pages_ = nullptr;
    QByteArray standard_;
    // Widths of the project dock while a wide page of properties widens it.
    struct Widened {
        int before, after;
    };
    std::optional<Widened> widened_;
};

} // namespace dipwright
