#include "workbench/view/ViewController.h"

#include "import/trusted/ReadPictures.h"
#include "workbench/actions/WindowActions.h"
#include "workbench/jobs/StartJob.h"
#include "workbench/project/NewProjectDialog.h"
#include "workbench/results/StretchPanel.h"
#include "workbench/view/LookInsideBar.h"
#include "workbench/widgets/Units.h"

#include <QAction>
#include <QActionGroup>
#include <QFileDialog>
#include <QShortcut>

namespace dipwright {

ViewController::ViewController(const WindowActions& actions, DipView& view, DipScene& scene,
                               LookInsideBar& inside, const StretchPanel& stretch, JobRunner& jobs,
                               Messages& messages, QWidget& window)
    : view_(view), scene_(scene), inside_(inside), stretch_(stretch), jobs_(jobs),
      messages_(messages), window_(window) {
    connectCamera(actions);
    connectDisplay(actions);
    connectInside(actions);
    connect(&stretch, &StretchPanel::scaleChanged, this,
            [this] { scene_.setHeat(stretch_.quantity(), stretch_.scale()); });
}

void ViewController::connectCamera(const WindowActions& actions) {
    connect(actions.fit, &QAction::triggered, &view_, &DipView::fit);
    connect(actions.fitPart, &QAction::triggered, &view_, &DipView::fitBody);
    for (const auto& [action, direction] :
         {std::pair(actions.oblique, ViewDirection::Oblique),
          std::pair(actions.front, ViewDirection::Front),
          std::pair(actions.right, ViewDirection::Right),
          std::pair(actions.top, ViewDirection::Top), std::pair(actions.back, ViewDirection::Back),
          std::pair(actions.left, ViewDirection::Left),
          std::pair(actions.bottom, ViewDirection::Bottom)}) {
        connect(action, &QAction::triggered, &view_,
                [&view = view_, direction = direction] { view.look(direction); });
    }
    connect(actions.parallel, &QAction::toggled, &view_, &DipView::setParallelProjection);
}

void ViewController::connectDisplay(const WindowActions& actions) {
    auto* endMeasure = new QShortcut(Qt::Key_Escape, &window_);
    endMeasure->setEnabled(false); // while nothing is measured, others may use Escape
    connect(actions.measure, &QAction::toggled, endMeasure, &QShortcut::setEnabled);
    connect(endMeasure, &QShortcut::activated, actions.measure,
            [&actions] { actions.measure->setChecked(false); });
    connect(actions.rings, &QAction::toggled, &scene_, &DipScene::setShowHandles);
    connect(actions.wearsFilm, &QAction::toggled, &scene_, &DipScene::setWearsFilm);
    connect(actions.warnings, &QAction::toggled, &scene_, &DipScene::setShowPins);
    connect(actions.body, &QAction::toggled, &view_, &DipView::setBodyVisible);
    // Water is hidden so that it does not change the colours of the body.
    const auto showLooks = [this, &actions] {
        const BodyLook look = actions.coverage->isChecked()    ? BodyLook::Coverage
                              : actions.bodyPrint->isChecked() ? BodyLook::Print
                              : actions.zones->isChecked()     ? BodyLook::Zones
                                                               : BodyLook::Own;
        scene_.setBodyLook(look);
        view_.setWaterVisible(actions.water->isChecked() && look == BodyLook::Own);
        view_.setFilmFitted(look == BodyLook::Own);
    };
    connect(actions.water, &QAction::toggled, this, showLooks);
    const QList<QAction*> looks{actions.coverage, actions.bodyPrint, actions.zones};
    for (QAction* shown : looks) { // at most one is checked
        connect(shown, &QAction::toggled, this, [showLooks, shown, looks](bool on) {
            for (QAction* other : looks) {
                const QSignalBlocker quiet(other);
                other->setChecked(other->isChecked() && (other == shown || !on));
            }
            showLooks();
        });
    }
    connect(actions.filmOnBody, &QAction::toggled, this, [this](bool only) {
        scene_.setFilmExtent(only ? FilmExtent::OnBody : FilmExtent::Whole);
    });
    connect(actions.filmLook, &QActionGroup::triggered, this,
            [this](const QAction* action) { setFilmLook(FilmLook(action->data().toInt())); });
}

void ViewController::connectInside(const WindowActions& actions) {
    connect(actions.section, &QAction::toggled, this, [this](bool on) {
        isCutOpen_ = on;
        inside_.setSectionShown(on);
        showSection();
    });
    connect(&inside_, &LookInsideBar::sectionChanged, this, &ViewController::showSection);
    connect(&scene_, &DipScene::bodyRoomChanged, this, &ViewController::showSection);
    connect(&view_, &DipView::sectionDragged, this, [this](double place) {
        const BoundingBox& room = scene_.bodyRoom();
        const int axis = inside_.axis();
        inside_.setShare((place - double(room.min()[axis])) / double(room.sizes()[axis]));
    });
    const auto showFilm = [this, &actions] {
        view_.setFilmOpacity(actions.seeThrough->isChecked() ? inside_.filmOpacity() : 1);
    };
    connect(actions.seeThrough, &QAction::toggled, &inside_, &LookInsideBar::setOpacityShown);
    connect(actions.seeThrough, &QAction::toggled, this, showFilm);
    connect(&inside_, &LookInsideBar::filmOpacityChanged, this, showFilm);
}

void ViewController::showSection() {
    const BoundingBox& room = scene_.bodyRoom();
    if (!isCutOpen_ || room.isEmpty()) {
        view_.setSection({});
        return;
    }
    SectionPlane plane;
    plane.axis = inside_.axis();
    plane.after = inside_.isFarSideShown();
    plane.place =
        double(room.min()[plane.axis]) + inside_.share() * double(room.sizes()[plane.axis]);
    plane.extent = room;
    inside_.setPlace(shownLength(plane.place, unit_));
    view_.setSection(plane);
}

void ViewController::setPreferences(const Preferences& preferences) {
    view_.setNavigation(preferences.navigation == NavigationChoice::Trackball
                            ? Navigation::Trackball
                            : Navigation::Turntable);
    unit_ = preferences.unit;
    showSection();
}

void ViewController::setFilmLook(FilmLook look) {
    scene_.setHeat(stretch_.quantity(), stretch_.scale());
    if (look != FilmLook::Picture) {
        scene_.setFilmLook(look);
        return;
    }
    const QString path =
        QFileDialog::getOpenFileName(&window_, tr("Picture on the film"), {}, pictureFileFilter());
    if (!path.isEmpty()) {
        showPicture(path);
    }
}

void ViewController::showPicture(const QString& path) {
    startJob(
        jobs_, messages_, tr("Reading the picture"), tr("Picture on the film"),
        [path](const Progress&) { return readPictureFile(path); },
        [this](const QImage& picture) { scene_.setFilmLook(FilmLook::Picture, picture); });
}

} // namespace dipwright
