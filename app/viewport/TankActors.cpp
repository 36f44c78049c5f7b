#include "TankActors.h"

#include "VtkConversions.h"

#include <algorithm>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace dipwright {

namespace {

vtkSmartPointer<vtkActor> actorOf(vtkPolyData* data) {
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(data);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
    return actor;
}

void addRectangle(vtkPoints& points, double halfWidth, double y, double halfDepth) {
    points.InsertNextPoint(-halfWidth, y, -halfDepth);
    points.InsertNextPoint(halfWidth, y, -halfDepth);
    points.InsertNextPoint(halfWidth, y, halfDepth);
    points.InsertNextPoint(-halfWidth, y, halfDepth);
}

} // namespace

TankActors::TankActors(vtkRenderer* renderer)
    : waterData_(vtkSmartPointer<vtkPolyData>::New()),
      edgeData_(vtkSmartPointer<vtkPolyData>::New()), water_(actorOf(waterData_)),
      edge_(actorOf(edgeData_)) {
    water_->GetProperty()->SetOpacity(0.3);
    edge_->GetProperty()->SetOpacity(0.6);
    setPixelRatio(1);
    renderer->AddActor(edge_);
    renderer->AddActor(water_);
    setSize({210, 297}, 80);
}

double TankActors::margin(QSizeF film) {
    return 0.12 * std::max(film.width(), film.height());
}

void TankActors::setSize(QSizeF film, double depth) {
    const double outerX = film.width() / 2 + margin(film);
    const double outerZ = film.height() / 2 + margin(film);

    // The water lies just below the film, so that the film is visible.
    auto waterPoints = vtkSmartPointer<vtkPoints>::New();
    addRectangle(*waterPoints, outerX, -0.1, outerZ);
    auto quad = vtkSmartPointer<vtkCellArray>::New();
    quad->InsertNextCell({0, 1, 2, 3});
    waterData_->SetPoints(waterPoints);
    waterData_->SetPolys(quad);

    auto edgePoints = vtkSmartPointer<vtkPoints>::New();
    addRectangle(*edgePoints, outerX, 0, outerZ);
    addRectangle(*edgePoints, outerX, -depth, outerZ);
    auto lines = vtkSmartPointer<vtkCellArray>::New();
    for (vtkIdType corner = 0; corner < 4; ++corner) {
        const vtkIdType next = (corner + 1) % 4;
        lines->InsertNextCell({corner, next});
        lines->InsertNextCell({4 + corner, 4 + next});
        lines->InsertNextCell({corner, 4 + corner});
    }
    edgeData_->SetPoints(edgePoints);
    edgeData_->SetLines(lines);
}

void TankActors::setVisible(bool visible) {
    water_->SetVisibility(visible);
    edge_->SetVisibility(visible);
}

void TankActors::setColours(const QColor& water, const QColor& edge) {
    water_->GetProperty()->SetColor(vtkColour(water).data());
    edge_->GetProperty()->SetColor(vtkColour(edge).data());
}

void TankActors::setPixelRatio(double ratio) {
    edge_->GetProperty()->SetLineWidth(float(1.5 * ratio));
}

} // namespace dipwright
