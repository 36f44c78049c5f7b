#include "MoveArrows.h"

#include "RotationRings.h"
#include "VtkConversions.h"

#include <algorithm>
#include <cmath>
#include <vtkArrowSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace dipwright {

namespace {

constexpr double reachPixels = 9;
constexpr double leastPixels = 12; // shorter arrows cannot be dragged

// Returns the distance from `position` to the segment, in pixels.
double distanceTo(QPointF position, QPointF from, QPointF to) {
    const QPointF along = to - from, away = position - from;
    const double square = QPointF::dotProduct(along, along);
    const double share =
        square > 0 ? std::clamp(QPointF::dotProduct(away, along) / square, 0.0, 1.0) : 0;
    const QPointF off = away - share * along;
    return std::hypot(off.x(), off.y());
}

} // namespace

ArrowActors::ArrowActors(vtkRenderer* renderer) {
    for (int axis = 0; axis < 3; ++axis) {
        auto arrow = vtkSmartPointer<vtkArrowSource>::New(); // points along X and has length 1
        arrow->SetTipLength(0.45);
        arrow->SetTipRadius(0.16);
        arrow->SetShaftRadius(0.05);
        arrow->SetTipResolution(24);
        auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
        mapper->SetInputConnection(arrow->GetOutputPort());
        auto actor = vtkSmartPointer<vtkActor>::New();
        actor->SetMapper(mapper);
        actor->SetOrientation(0, axis == 2 ? -90 : 0, axis == 1 ? 90 : 0);
        actor->GetProperty()->LightingOff();
        actor->VisibilityOff();
        actor->PickableOff();
        renderer->AddActor(actor);
        arrows_[std::size_t(axis)] = actor;
    }
    highlight(-1);
}

void ArrowActors::set(const MoveArrows& arrows) {
    shown_ = arrows;
    for (int axis = 0; axis < 3; ++axis) {
        vtkActor* actor = arrows_[std::size_t(axis)];
        Eigen::Vector3d place = arrows.centre.cast<double>();
        place[axis] += arrows.begin;
        actor->SetPosition(place.data());
        actor->SetScale(arrows.end - arrows.begin);
        actor->SetVisibility(arrows.visible[std::size_t(axis)]);
    }
}

void ArrowActors::addPlaces(std::vector<Eigen::Vector3d>& places) const {
    for (int axis = 0; axis < 3; ++axis) {
        if (shown_.visible[std::size_t(axis)]) {
            places.push_back(shown_.centre.cast<double>() +
                             shown_.end * Eigen::Vector3d::Unit(axis));
        }
    }
}

void ArrowActors::highlight(int axis) {
    for (int arrow = 0; arrow < 3; ++arrow) {
        const QColor colour = axisColour(arrow);
        arrows_[std::size_t(arrow)]->GetProperty()->SetColor(
            vtkColour(arrow == axis ? colour.lighter(140) : colour).data());
    }
}

std::optional<int> MoveArrows::axisAt(QPointF position, const ViewProjection& shown) const {
    std::optional<int> nearest;
    double least = reachPixels;
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3f along = Eigen::Vector3f::Unit(axis);
        const QPointF from = shown.positionOf(centre + float(begin) * along);
        const QPointF to = shown.positionOf(centre + float(end) * along);
        const double distance = distanceTo(position, from, to);
        if (visible[std::size_t(axis)] && distance < least &&
            std::hypot(to.x() - from.x(), to.y() - from.y()) >= leastPixels) {
            least = distance;
            nearest = axis;
        }
    }
    return nearest;
}

} // namespace dipwright
