// A window with one document. Creates the window's parts and connects their signals; the parts do
// the work.
#pragma once

#include "workbench/accuracy/ToleranceController.h"
#include "workbench/actions/WindowActions.h"
#include "workbench/dip/DeeperFilm.h"
#include "workbench/jobs/JobRunner.h"
#include "workbench/main/DipController.h"
#include "workbench/main/DocumentController.h"
#include "workbench/main/EditController.h"
#include "workbench/main/ExportController.h"
#include "workbench/main/HelpController.h"
#include "workbench/main/PlaceWarning.h"
#include "workbench/main/ProfileController.h"
#include "workbench/main/ServerController.h"
#include "workbench/main/WindowLayout.h"
#include "workbench/main/WindowMessages.h"
#include "workbench/view/BodyHandles.h"
#include "workbench/view/CradleView.h"
#include "workbench/view/DipPlayback.h"
#include "workbench/view/FilmProbe.h"
#include "workbench/view/MarkTool.h"
#include "workbench/view/MeasureTool.h"
#include "workbench/view/TypedDrag.h"
#include "workbench/view/ViewController.h"

#include <QMainWindow>

namespace dipwright {

class InspectionController;
class StatusLine;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(Workbench& workbench);
    ~MainWindow() override;

    Document* document() const { return documents_.document(); } // null: the start page is shown
    bool isEmpty() const { return !document() && !jobs_.isBusy(); }
    DocumentSession& documents() { return documents_; }
    DipSession& session() { return session_; }
    DipView& view() { return *parts_.view; }

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void addInspection();
    void addPages();
    void connectActions();
    void connectMenus();
    void connectPanels();
    void connectSession();

    void showDocument();
    void applyPreferences();
    void askPreferences();
    void updateTitle();
    void updateActions();
    void keepThumbnail();

    Workbench& workbench_;
    Messages messages_;
    JobRunner jobs_;
    DocumentSession documents_;
    DipSession session_;
    NumericalErrorCheck check_;
    ToleranceCheck toleranceCheck_;
    DeeperFilm deeperFilm_;

    WindowLayout layout_;
    const WindowParts& parts_;
    WindowActions actions_;
    WindowMessages shownMessages_;
    StatusLine* status_;
    QString refusal_; // what the status bar says on a refused value; the next accepted one hides it
    PlaceWarning placeWarning_;

    DipScene scene_;
    DipPlayback playback_;
    FilmProbe reader_;
    MeasureTool measure_;
    MarkTool marks_;
    BodyHandles handles_;
    TypedDrag typedDrag_;
    CradleView cradle_;
    DipController dip_;
    ServerController server_;
    DocumentController documentActions_;
    EditController edits_;
    ExportController exports_;
    ToleranceController tolerances_;
    ProfileController profiles_;
    ViewController viewActions_;
    HelpController help_;
    InspectionController* inspection_ = nullptr; // a child; null in a build without inspection
};

} // namespace dipwright
