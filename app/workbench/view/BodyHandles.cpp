#include "workbench/view/BodyHandles.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

// The limits of the project file (core/project/Schema.cpp).
constexpr double mostOffset = 5000, leastDepth = 0.1, mostDepth = 5000;

Millimetres placed(double millimetres, double least, double most) {
    return Millimetres(std::clamp(std::round(10 * millimetres) / 10, least, most));
}

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
    session_.document()->edit(tr("Turn part"), QStringLiteral("turn"), [&](Project& project) {
        project.immersions[session_.immersion()] = turned(*before_, axis, degrees, shownBefore_);
    });
    emit told(tr("Turned by %1° about %2 (hold Shift for steps of %3°)")
                  .arg(QLocale().toString(degrees, 'f', 1), axisName(axis),
                       QLocale().toString(ringStep)));
}

void BodyHandles::move(int axis, double millimetres) {
    hold();
    if (shownBefore_.key && !(axis == 1 && *shownBefore_.key + 1 == before_->path.keys.size())) {
        moveKey(axis, millimetres);
        return;
    }
    Document& document = *session_.document();
    const QString steps = shownLength(arrowStep, unit_);
    if (axis == 1) {
        if (depthBefore_) {
            const Millimetres depth =
                placed(depthBefore_->value() - millimetres, leastDepth, mostDepth);
            document.edit(tr("Change depth"), QStringLiteral("depth"),
                          [&](Project& project) { project.process.depth = depth; });
            emit told(tr("Depth %1 (hold Shift for steps of %2)")
                          .arg(shownLength(depth.value(), unit_), steps));
        }
        return;
    }
    const std::size_t part = axis == 0 ? 0 : 1;
    const Millimetres offset =
        placed(before_->offset[part].value() + millimetres, -mostOffset, mostOffset);
    document.edit(tr("Move part"), QStringLiteral("move"), [&](Project& project) {
        project.immersions[session_.immersion()].offset[part] = offset;
    });
    emit told(tr("Moved to %1 along %2 (hold Shift for steps of %3)")
                  .arg(shownLength(offset.value(), unit_), axisName(axis), steps));
}

void BodyHandles::moveKey(int axis, double millimetres) {
    const std::size_t number = *shownBefore_.key;
    PathKey key = before_->path.keys[number];
    QString text;
    if (axis == 1) {
        if (number == 0 || !key.depth) {
            return; // the first pose is at the water
        }
        key.depth = placed(key.depth->value() - millimetres, -mostOffset, mostDepth);
        text = tr("Pose %1: depth %2").arg(number + 1).arg(shownLength(key.depth->value(), unit_));
    } else {
        Millimetres& beside = key.beside[axis == 0 ? 0 : 1];
        beside = placed(beside.value() + millimetres, -mostOffset, mostOffset);
        text = tr("Pose %1: moved by %2 along %3")
                   .arg(number + 1)
                   .arg(shownLength(beside.value(), unit_), axisName(axis));
    }
    session_.document()->edit(tr("Move pose of path"), QStringLiteral("move"),
                              [&](Project& project) {
                                  project.immersions[session_.immersion()].path.keys[number] = key;
                              });
    emit told(text);
}

void BodyHandles::finish() {
    before_.reset();
    session_.document()->endMerge();
    emit held(false);
}

} // namespace dipwright
