#include "RotationRings.h"

#include "VtkConversions.h"
#include "base/Units.h"

#include <cmath>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRegularPolygonSource.h>

namespace dipwright {

namespace {

constexpr int segments = 180;
constexpr double reachPixels = 9;

double lengthOf(QPointF vector) {
    return std::hypot(vector.x(), vector.y());
}

} // namespace

QColor axisColour(int axis) {
    static const std::array<QColor, 3> colours{QColor(200, 40, 40), QColor(110, 200, 70),
                                               QColor(50, 100, 220)};
    return colours[std::size_t(axis)];
}

RingActors::RingActors(vtkRenderer* renderer) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto circle = vtkSmartPointer<vtkRegularPolygonSource>::New();
        circle->SetNumberOfSides(segments);
        circle->SetRadius(1);
        circle->GeneratePolygonOff();
        circle->SetNormal(axis == 0, axis == 1, axis == 2);
        auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
        mapper->SetInputConnection(circle->GetOutputPort());
        rings_[axis] = vtkSmartPointer<vtkActor>::New();
        rings_[axis]->SetMapper(mapper);
        rings_[axis]->GetProperty()->LightingOff();
        rings_[axis]->VisibilityOff();
        rings_[axis]->PickableOff();
        renderer->AddActor(rings_[axis]);
    }
    highlight(-1);
}

void RingActors::set(const RotationRings& rings) {
    shown_ = rings;
    for (const auto& ring : rings_) {
        ring->SetPosition(rings.centre.x(), rings.centre.y(), rings.centre.z());
        ring->SetScale(rings.radius);
        ring->SetVisibility(rings.visible);
    }
}

void RingActors::addPlaces(std::vector<Eigen::Vector3d>& places) const {
    constexpr double apart = 15; // degrees
    for (int axis = 0; axis < 3 && shown_.visible; ++axis) {
        for (double angle = 0; angle < 360; angle += apart) {
            places.push_back(shown_.ringPoint(axis, angle).cast<double>());
        }
    }
}

void RingActors::setPixelRatio(double ratio) {
    pixelRatio_ = ratio;
    highlight(lit_);
}

void RingActors::highlight(int axis) {
    lit_ = axis;
    for (int ring = 0; ring < 3; ++ring) {
        vtkProperty* look = rings_[std::size_t(ring)]->GetProperty();
        const bool lit = ring == axis;
        look->SetLineWidth(float((lit ? 4.5 : 2.5) * pixelRatio_));
        const QColor colour = axisColour(ring);
        look->SetColor(vtkColour(lit ? colour.lighter(130) : colour).data());
    }
}

Eigen::Vector3f RotationRings::ringPoint(int axis, double degrees) const {
    const double angle = degrees * pi / 180;
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    offset[(axis + 1) % 3] = std::cos(angle);
    offset[(axis + 2) % 3] = std::sin(angle);
    return centre + (radius * offset).cast<float>();
}

std::optional<int> RotationRings::axisAt(QPointF position, const ViewProjection& shown) const {
    if (!visible) {
        return std::nullopt;
    }
    std::optional<int> nearest;
    double least = reachPixels;
    for (int axis = 0; axis < 3; ++axis) {
        const double angle = angleAt(axis, position, shown);
        const double distance = lengthOf(shown.positionOf(ringPoint(axis, angle)) - position);
        if (distance < least) {
            least = distance;
            nearest = axis;
        }
    }
    return nearest;
}

double RotationRings::angleAt(int axis, QPointF position, const ViewProjection& shown) const {
    double best = 0, least = INFINITY;
    for (int step = 0; step < 720; ++step) {
        const double angle = step * 0.5;
        const double distance = lengthOf(shown.positionOf(ringPoint(axis, angle)) - position);
        if (distance < least) {
            least = distance;
            best = angle;
        }
    }
    return best;
}

} // namespace dipwright
