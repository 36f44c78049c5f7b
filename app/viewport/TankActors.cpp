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
    water_->GetProperty()->SetOpacity(0.35);
    edge_->GetProperty()->SetOpacity(0.6);
    edge_->GetProperty()->SetLineWidth(1.5f);
    renderer->AddActor(edge_);
    renderer->AddActor(water_);
    setSize({210, 297}, 80);
}

void TankActors::setSize(QSizeF film, double depth) {
    const double margin = 0.12 * std::max(film.width(), film.height());
    const double innerX = film.width() / 2, innerZ = film.height() / 2;
    const double outerX = innerX + margin, outerZ = innerZ + margin;

    // A frame round the film: water under the film would only hide what happens there.
    auto waterPoints = vtkSmartPointer<vtkPoints>::New();
    addRectangle(*waterPoints, outerX, 0, outerZ);
    addRectangle(*waterPoints, innerX, 0, innerZ);
    auto quads = vtkSmartPointer<vtkCellArray>::New();
    for (vtkIdType side = 0; side < 4; ++side) {
        const vtkIdType next = (side + 1) % 4;
        quads->InsertNextCell({side, next, 4 + next, 4 + side});
    }
    waterData_->SetPoints(waterPoints);
    waterData_->SetPolys(quads);

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

} // namespace dipwright
