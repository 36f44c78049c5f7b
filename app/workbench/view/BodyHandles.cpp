#include "workbench/view/BodyHandles.h"

#include "base/NumberText.h"

#include <QLocale>
#include <algorithm>

namespace dipwright {

namespace {

// The limits of the project file (core/project/Schema.cpp).
constexpr double leastDepth = 0.1, mostDepth = 5000;

QString axisName(int axis) {
    return QString(QLatin1Char("XYZ"[axis]));
}

} // namespace

BodyHandles::BodyHandles(const DipSession& session, const DipView& view, const DipScene& scene,
                         QObject* parent)
    : QObject(parent), session_(session), scene_(scene) {
    connect(&view, &DipView::rotationDragged, this, &BodyHandles::turn);
    connect(&view, &DipView::rotationFinished, this, &BodyHandles::finish);
    connect(&view, &DipView::moveDragged, this, &BodyHandles::move);
    connect(&view, &DipView::moveFinished, this, &BodyHandles::finish);
}

void BodyHandles::hold() {
    if (!before_) {
        const Project& project = session_.document()->project();
        before_ = project.immersions[session_.immersion()];
        depthBefore_ = project.process.depth;
        shownBefore_ = scene_.shownPose();
        emit held(true);
    }
}

void BodyHandles::turn(int axis, double degrees) {
    hold();
    session_.document()->drag(tr("Turn part"), [&](Project& project) {
        project.immersions[session_.immersion()] = turned(*before_, axis, degrees, shownBefore_);
    });
    emit told(tr("Turned by %1° about %2 (type an angle, or hold Shift for steps of %3°)")
                  .arg(numberText(degrees, 1), axisName(axis), QLocale().toString(ringStep)));
}

void BodyHandles::move(int axis, double millimetres) {
    hold();
    Document& document = *session_.document();
    const std::size_t dip = session_.immersion();
    const QString steps = shownLength(arrowStep, unit_);
    if (axis == 1) {
        moveDown(millimetres);
        return;
    }
    const Immersion after = moved(*before_, axis, millimetres, shownBefore_);
    document.drag(tr("Move part"), [&](Project& project) { project.immersions[dip] = after; });
    const std::size_t part = axis == 0 ? 0 : 1;
    const Millimetres now =
        shownBefore_.key ? after.path.keys[*shownBefore_.key].beside[part] : after.offset[part];
    emit told(tr("Moved to %1 along %2 (type a distance, or hold Shift for steps of %3)")
                  .arg(shownLength(now.value(), unit_), axisName(axis), steps));
}

void BodyHandles::moveDown(double millimetres) {
    const bool isInnerKey = shownBefore_.key && *shownBefore_.key + 1 < before_->path.keys.size();
    const std::optional<Millimetres> from =
        isInnerKey ? before_->path.keys[*shownBefore_.key].depth : depthBefore_;
    if (!from) {
        return;
    }
    const Millimetres depth(std::clamp(moved(from->value(), -millimetres), leastDepth, mostDepth));
    session_.document()->drag(tr("Change depth"), [&](Project& project) {
        if (isInnerKey) {
            project.immersions[session_.immersion()].path.keys[*shownBefore_.key].depth = depth;
        } else {
            project.process.depth = depth;
        }
    });
    emit told(tr("Depth %1 (type a distance, or hold Shift for steps of %2)")
                  .arg(shownLength(depth.value(), unit_), shownLength(arrowStep, unit_)));
}

void BodyHandles::finish() {
    before_.reset();
    session_.document()->endDrag();
    emit held(false);
}

} // namespace dipwright
