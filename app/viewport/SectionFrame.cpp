#include "SectionFrame.h"

#include "VtkConversions.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace dipwright {

SectionFrame::SectionFrame(vtkRenderer* renderer)
    : data_(vtkSmartPointer<vtkPolyData>::New()), actor_(vtkSmartPointer<vtkActor>::New()) {
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(data_);
    actor_->SetMapper(mapper);
    actor_->GetProperty()->LightingOff();
    actor_->PickableOff();
    actor_->VisibilityOff();
    renderer->AddActor(actor_);
    highlight(false);
}

void SectionFrame::set(const std::optional<SectionPlane>& plane) {
    actor_->SetVisibility(plane.has_value());
    if (!plane) {
        return;
    }
    auto points = vtkSmartPointer<vtkPoints>::New();
    for (const Eigen::Vector3f& corner : plane->corners()) {
        points->InsertNextPoint(corner.x(), corner.y(), corner.z());
    }
    auto line = vtkSmartPointer<vtkCellArray>::New();
    line->InsertNextCell({0, 1, 2, 3, 0});
    data_->SetPoints(points);
    data_->SetLines(line);
}

void SectionFrame::highlight(bool lit) {
    lit_ = lit;
    actor_->GetProperty()->SetLineWidth(float((lit ? 4.5 : 2) * pixelRatio_));
}

void SectionFrame::setColour(const QColor& colour) {
    actor_->GetProperty()->SetColor(vtkColour(colour).data());
}

void SectionFrame::setPixelRatio(double ratio) {
    pixelRatio_ = ratio;
    highlight(lit_);
}

} // namespace dipwright
