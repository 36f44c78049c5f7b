#include "workbench/view/BodyMenu.h"

#include "base/Error.h"
#include "workbench/document/MarkEdits.h"
#include "workbench/view/BodyHandles.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

namespace dipwright {

BodyMenu::BodyMenu(DipView& view, const DipScene& scene, const DipSession& session,
                   QActionGroup& turns, QActionGroup& moves, QObject* parent)
    : QObject(parent), view_(view), scene_(scene), session_(session), turns_(turns), moves_(moves) {
    connect(&view, &DipView::menuRequested, this, &BodyMenu::show);
    connect(&turns, &QActionGroup::triggered, this, [this](QAction* action) { turn(*action); });
    connect(&moves, &QActionGroup::triggered, this, [this](QAction* action) { move(*action); });
}

void BodyMenu::show(const ViewRay& ray, const QPoint& place) {
    if (!session_.document()) {
        return;
    }
    auto* menu = new QMenu(&view_);
    menu->setObjectName(QStringLiteral("bodyMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const std::optional<SurfacePoint> spot = scene_.modelSurface(ray);
    const auto add = [&](const char* name, const QString& text, auto what) {
        QAction* action = menu->addAction(text, this, [spot, what] { what(*spot); });
        action->setObjectName(QLatin1String(name));
        action->setEnabled(spot.has_value());
    };
    add("layFaceDown", tr("Turn this face &down"),
        [this](const SurfacePoint& point) { layDown(point.triangle); });
    add("faceMustBeGood", tr("Mark this face as &zone A"), [this](const SurfacePoint& point) {
        ZoneMark mark;
        mark.extent = MarkExtent::Face;
        markFace(point, mark);
    });
    add("maskFace", tr("Mask this face, so that it &stays free of film"),
        [this](const SurfacePoint& point) {
            MaskMark mark;
            mark.extent = MarkExtent::Face;
            markFace(point, mark);
        });
    menu->addSeparator();
    menu->addMenu(tr("&Turn"))->addActions(turns_.actions());
    menu->addMenu(tr("&Move"))->addActions(moves_.actions());
    menu->popup(place);
}

void BodyMenu::edit(const QString& text, const std::function<void(Immersion&)>& change) {
    if (Document* document = session_.document()) {
        document->edit(text, {},
                       [&](Project& project) { change(project.immersions[session_.immersion()]); });
    }
}

void BodyMenu::turn(const QAction& action) {
    const auto step = action.data().value<BodyStep>();
    edit(tr("Turn part"), [&](Immersion& immersion) {
        immersion = turned(immersion, step.axis, step.way * ringStep, scene_.shownPose());
    });
}

void BodyMenu::move(const QAction& action) {
    const auto step = action.data().value<BodyStep>();
    edit(tr("Move part"), [&](Immersion& immersion) {
        if (step.way == 0) {
            immersion.offset = {};
        } else {
            immersion = moved(immersion, step.axis, step.way * arrowStep, scene_.shownPose());
        }
    });
}

void BodyMenu::layDown(std::uint32_t triangle) {
    const Eigen::Vector3d outward = triangleNormal(scene_.model()->mesh, triangle).cast<double>();
    if (!outward.isZero()) {
        edit(tr("Turn a face down"),
             [&](Immersion& immersion) { immersion = withFaceDown(immersion, outward); });
    }
}

void BodyMenu::markFace(const SurfacePoint& place, const MarkBrush& brush) {
    const Eigen::Vector3f point = position(scene_.model()->mesh, place);
    std::array<Millimetres, 3> at;
    for (int axis = 0; axis < 3; ++axis) {
        at[std::size_t(axis)] = Millimetres(double(point[axis]));
    }
    try {
        addMark(*session_.document(), brush, at);
    } catch (const Error& error) {
        emit refused(error.sentence());
    }
}

} // namespace dipwright
