// Controls the pages that measure films and dipped parts by photos: runs their requests as jobs and
// shows the results.
#pragma once

#include "solver/SolverRegistry.h"
#include "workbench/dip/DipSession.h"
#include "workbench/inspection/BuiltController.h"
#include "workbench/inspection/FilmWatchController.h"
#include "workbench/inspection/FitController.h"
#include "workbench/inspection/PartPage.h"
#include "workbench/jobs/Messages.h"
#include "workbench/view/DipScene.h"

#include <QTabWidget>
#include <map>

namespace dipwright {

class InspectionController : public QObject {
    Q_OBJECT

public:
    InspectionController(DipView& view, const DipScene& scene, const DipSession& session,
                         JobRunner& jobs, const SolverRegistry& registry, Messages& messages,
                         QWidget& window);

    // The tabs of all inspection pages. Their window owns them.
    QTabWidget* pages() const { return pages_; }
    // Call this when the session has another document.
    void showDocument();

private:
    void connectPart();
    void showProject();
    void readPhotos(const QStringList& files);
    void lookAt(int photo);
    void readAgain(const InspectedPhoto& photo);
    void click(const ViewRay& ray);
    void measurePart(bool findsCorners);
    void exportPart();

    DipView& view_;
    const DipScene& scene_;
    const DipSession& session_;
    JobRunner& jobs_;
    const SolverRegistry& registry_;
    Messages& messages_;
    QWidget& window_;
    QTabWidget* pages_;
    PartPage* part_;
    FilmWatchController* film_;
    FitController* fit_;
    BuiltController* built_;
    std::map<QString, PartPhoto> photos_; // the photos read so far, by file
    std::shared_ptr<const MeasuredPart> measured_;
};

} // namespace dipwright
