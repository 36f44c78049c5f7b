// One window, one document: project tree and properties on the left, the view with its timeline in
// the middle, the results on the right.
#pragma once

#include "document/Document.h"
#include "document/Recovery.h"
#include "jobs/DipJob.h"
#include "jobs/JobRunner.h"
#include "main/DipScene.h"
#include "panels/ProjectTree.h"
#include "panels/Units.h"

#include <QMainWindow>
#include <QTimer>
#include <optional>

class QActionGroup;
class QDockWidget;
class QLabel;
class QMenu;
class QProgressBar;
class QStackedWidget;
class QTabWidget;
class QToolButton;

namespace dipwright {

class LogPanel;
class PicturePanel;
class PropertyPanel;
class ReportPanel;
class StartPage;
class StretchPanel;
class Timeline;
class Workbench;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(Workbench& workbench);
    ~MainWindow() override;

    Document* document() const { return document_.get(); }
    DipView& view() { return *view_; }
    JobRunner& jobs() { return jobs_; }

    // Opens a project in this window if it is empty, else in a new one. On the worker thread: the
    // window tells when it is there or why it is not.
    void openProject(const QString& path);
    // Takes an untitled project, or one made from a model.
    void showProject(const Project& project);
    void importModelAsProject(const QString& path, double longestEdge,
                              const std::function<void(Project&)>& complete);
    void restore(const RecoveredDocument& recovered);

    void startDip();
    void cancelJobs();
    void selectImmersion(std::size_t number);

public slots:
    void newProject();
    void open();
    bool save();   // false: not saved
    bool saveAs(); // false: not saved

signals:
    void documentOpened();
    void dipFinished(bool done);

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Actions;

    // Building the window (MainWindowLayout.cpp).
    void makeDocks();
    void makeResults();
    void makeStatusBar();
    void makeActions();
    void makeMenus();
    void makeToolBars();
    QAction* addAction(const char* name, const QString& iconName, const QString& text,
                       const QString& help, const QKeySequence& shortcut,
                       const std::function<void()>& triggered);
    void applyPreferences();
    void fillRecentMenu();
    void fillFilmMenu();

    // Documents.
    void setDocument(std::unique_ptr<Document> document);
    bool lockOrAsk(Document& document);
    bool mayClose();
    void updateTitle();
    void updateActions();
    void reloadModel();
    void replaceModel(const QString& path);
    void replaceTexture(const QString& path);
    void importInto(const QString& model, const QString& texture, const QString& undoText,
                    bool keepPose);
    void addImmersion();
    void removeImmersion(std::size_t number);
    void report(const QString& what);
    void reportFailure(const QString& title, std::exception_ptr failure);

    // The dip.
    void projectChanged();
    void takeOutcome(const DipOutcome& outcome);
    void showLiveFrame();
    void showMoment(int position);
    void showResults();
    void updateFreshness();
    void setFilmLook(FilmLook look);
    void exportResults();
    void exportSheet(bool pdf);
    void exportStretch(const QString& kind);

    // The cursor and the tools in the view.
    void hoverRay(const ViewRay& ray);
    void hoverFilm(const Eigen::Vector2f& rest);
    void showReading(const std::optional<FilmReadingPoint>& point);
    void clickRay(const ViewRay& ray);
    void dragRotation(int axis, double degrees);
    void finishRotation();

    LengthUnit lengthUnit() const;
    const FilmReading* reading() const; // of the immersion shown; null: none

    Workbench& workbench_;
    std::unique_ptr<Document> document_;
    std::unique_ptr<AutoSaver> autoSaver_;
    JobRunner jobs_;

    std::unique_ptr<Actions> actions_;
    QStackedWidget* pages_ = nullptr;
    StartPage* startPage_ = nullptr;
    DipView* view_ = nullptr;
    DipScene* scene_ = nullptr;
    Timeline* timeline_ = nullptr;
    QLabel* staleBanner_ = nullptr;
    ProjectTree* tree_ = nullptr;
    PropertyPanel* properties_ = nullptr;
    QTabWidget* results_ = nullptr;
    StretchPanel* stretch_ = nullptr;
    PicturePanel* texture_ = nullptr;
    PicturePanel* proof_ = nullptr;
    PicturePanel* sheet_ = nullptr;
    ReportPanel* report_ = nullptr;
    LogPanel* log_ = nullptr;
    QDockWidget* projectDock_ = nullptr;
    QDockWidget* resultsDock_ = nullptr;
    QDockWidget* logDock_ = nullptr;
    QMenu* recentMenu_ = nullptr;
    QLabel* readingLabel_ = nullptr;
    QLabel* jobLabel_ = nullptr;
    QProgressBar* progressBar_ = nullptr;
    QToolButton* cancelButton_ = nullptr;

    std::size_t immersion_ = 0;
    DipRecordings recordings_, running_;
    DipOutcome outcome_;
    bool dipRunning_ = false;
    bool dipWanted_ = false; // again, once the jobs that run now have ended
    QTimer liveTimer_, updateTimer_;
    const RecordedFrame* shownFrame_ = nullptr;
    bool measuring_ = false;
    std::vector<Eigen::Vector3f> measured_; // model coordinates
    std::optional<Immersion> dragged_;      // as it was before the drag
    QImage filmPicture_;
};

} // namespace dipwright
