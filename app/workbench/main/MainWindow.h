// One window, one document: project tree and properties on the left, the view with its timeline in
// the middle, the results on the right.
#pragma once

#include "document/Document.h"
#include "document/Recovery.h"
#include "jobs/JobRunner.h"
#include "model/ImportModel.h"
#include "panels/ProjectTree.h"
#include "panels/Units.h"
#include "session/DipSession.h"
#include "view/DipScene.h"

#include <QMainWindow>
#include <QTimer>
#include <optional>

class QActionGroup;
class QDockWidget;
class QLabel;
class QMenu;
class QProgressBar;
class QStackedWidget;
class QToolButton;

namespace dipwright {

struct ImmersionCertainty;
class LogPanel;
class NoticeBar;
class PropertyPanel;
class ResultsPanel;
class StartPage;
class Timeline;
class Workbench;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(Workbench& workbench);
    ~MainWindow() override;

    Document* document() const { return document_.get(); } // null: the start page is shown
    bool isEmpty() const { return !document_ && !jobs_.isBusy(); }
    DipView& view() { return *view_; }
    const DipSession& session() const { return session_; }

    // Each opens in this window if it is empty, else in a new one; on the worker thread: the window
    // tells when it is there or why it is not.
    void openProject(const QString& path);
    // As an untitled copy: a sample, which stays as it is.
    void openCopy(const QString& path);
    // `complete` may set what the user has chosen beside the model.
    void importModelAsProject(const QString& path, const ImportOptions& options,
                              const std::function<void(Project&)>& complete = {});
    void restore(const RecoveredDocument& recovered);
    void saveAsFile(const QString& path); // throws Error
    void replaceModel(const QString& path);
    void replaceTexture(const QString& path);

    void selectImmersion(std::size_t number);

public slots: // NOLINT: moc reads it
    void newProject(const QString& model = {});
    void open();
    bool save();   // false: not saved
    bool saveAs(); // false: not saved
    void startDip();
    void cancelJobs();
    void addImmersion();
    void printSheets();
    void calibratePrinter();
    void showProfiles();
    void resetLayout();
    void askLayoutName();
    void showPreferences();
    void showTour();
    void showGuide();
    void showAbout();

signals:
    void documentOpened();

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Actions;
    static constexpr int liveInterval = 33; // ms between pictures of a running dip

    // Building the window (MainWindowLayout.cpp).
    void makeCentre();
    void makeDocks();
    void makeStatusBar();
    void makeActions();
    void makeFileActions();
    void makeEditActions();
    void makeDipActions();
    void makeCameraActions();
    void makeDisplayActions();
    void makeFilmLookActions();
    void makeHelpActions();
    void makeMenus();
    void makeToolBars();
    void fillLayoutMenu();
    void sizeDocks(); // as the window's width allows
    QAction* addAction(const char* name, const QString& iconName, const QString& text,
                       const QString& help, const QKeySequence& shortcut,
                       const std::function<void()>& triggered);
    QAction* addToggle(const char* name, const QString& iconName, const QString& text,
                       const QString& help, bool on);

    // State of the whole window (MainWindow.cpp).
    void connectPanels();
    void applyPreferences();
    void applyShortcuts();
    void updateTitle();
    void updateActions();
    void report(const QString& what);
    QStringList facts() const; // about program and machine, for a report of what went wrong
    void reportFailure(const QString& title, std::exception_ptr failure);

    // Documents (MainWindowDocuments.cpp).
    void setDocument(std::unique_ptr<Document> document);
    MainWindow& showProject(const Project& project); // in this window or a new one
    void doubtSize(const TriangleMesh& mesh);
    bool lockOrAsk(Document& document);
    bool mayClose();
    void fillRecentMenu();
    void reloadModel();
    void importInto(const QString& model, const QString& texture, const QString& undoText,
                    bool keepPose);
    void removeImmersion(std::size_t number);

    // The dip and what is shown of it (MainWindowDip.cpp).
    void projectChanged();
    void showLiveFrame();
    void showMoment(int position);
    void showResults();
    void updateFreshness();
    void setFilmLook(FilmLook look);
    void wearPicture(const QString& path);
    void checkCertainty();
    void showCertainty(const std::vector<ImmersionCertainty>& certainty, bool outdated);
    void exportResults();
    void exportSheet(bool pdf);
    void exportStretch(const QString& kind);
    // Has `path` written on the worker thread; `done` is what the user is told then, its %1 the
    // path.
    void
    writeAsJob(const QString& title, const QString& done, const QString& path,
               const std::function<void(const QString& path, const Progress& progress)>& write);
    // Asks for a file and has it written so.
    void exportFile(const QString& title, const QString& name, const QString& suffix,
                    const std::function<void(const QString& path)>& write);
    void hoverRay(const ViewRay& ray);
    void showReading(const std::optional<FilmReadingPoint>& point);
    void measureAt(const ViewRay& ray);
    void showMeasure();
    QString measuredDistance() const; // empty before the second place
    void dragRotation(int axis, double degrees);
    void finishRotation();

    Workbench& workbench_;
    std::unique_ptr<Document> document_;
    std::unique_ptr<AutoSaver> autoSaver_;
    JobRunner jobs_;
    DipSession session_;

    std::unique_ptr<Actions> actions_;
    QStackedWidget* pages_ = nullptr;
    StartPage* startPage_ = nullptr;
    DipView* view_ = nullptr;
    DipScene* scene_ = nullptr;
    Timeline* timeline_ = nullptr;
    QLabel* staleBanner_ = nullptr;
    NoticeBar* notice_ = nullptr;
    ProjectTree* tree_ = nullptr;
    PropertyPanel* properties_ = nullptr;
    ResultsPanel* results_ = nullptr;
    LogPanel* log_ = nullptr;
    QDockWidget* projectDock_ = nullptr;
    QDockWidget* resultsDock_ = nullptr;
    QDockWidget* logDock_ = nullptr;
    QByteArray standardLayout_;
    QMenu* recentMenu_ = nullptr;
    QMenu* layoutMenu_ = nullptr;
    QMenu* filmMenu_ = nullptr;
    QLabel* readingLabel_ = nullptr;
    QLabel* jobLabel_ = nullptr;
    QProgressBar* progressBar_ = nullptr;
    QToolButton* cancelButton_ = nullptr;

    std::size_t immersion_ = 0;   // the one shown
    QTimer liveTimer_;            // pictures of the dip that runs
    QTimer updateTimer_;          // from the last change to a new run
    CancelSwitch certaintyCheck_; // of the last one
    const RecordedFrame* shownFrame_ = nullptr;
    bool measuring_ = false;
    std::vector<Eigen::Vector3f> measured_; // model coordinates
    std::shared_ptr<const TexturedMesh> measuredModel_;
    std::optional<Immersion> dragged_; // as it was before it was turned by its rings
};

} // namespace dipwright
