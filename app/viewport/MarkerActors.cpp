#include "MarkerActors.h"

#include "VtkConversions.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextProperty.h>

namespace dipwright {

namespace {

vtkSmartPointer<vtkActor> ballActor(vtkSphereSource* ball) {
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputConnection(ball->GetOutputPort());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetAmbient(0.5);
    actor->VisibilityOff();
    actor->PickableOff();
    return actor;
}

void place(vtkActor& actor, const Eigen::Vector3f& position) {
    actor.SetPosition(position.x(), position.y(), position.z());
    actor.VisibilityOn();
}

} // namespace

MarkerActors::MarkerActors(vtkRenderer* renderer)
    : ball_(vtkSmartPointer<vtkSphereSource>::New()), marker_(ballActor(ball_)),
      line_(vtkSmartPointer<vtkActor>::New()),
      lineData_(vtkSmartPointer<vtkPolyData>::New()), ends_{ballActor(ball_), ballActor(ball_)},
      label_(vtkSmartPointer<vtkBillboardTextActor3D>::New()) {
    ball_->SetThetaResolution(16);
    ball_->SetPhiResolution(16);
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(lineData_);
    line_->SetMapper(mapper);
    setPixelRatio(1);
    line_->GetProperty()->LightingOff();
    line_->VisibilityOff();
    line_->PickableOff();
    label_->SetDisplayOffset(8, 8);
    label_->VisibilityOff();
    label_->PickableOff();
    renderer->AddActor(marker_);
    renderer->AddActor(line_);
    renderer->AddActor(ends_[0]);
    renderer->AddActor(ends_[1]);
    renderer->AddActor(label_);
}

void MarkerActors::setMarker(const std::optional<Eigen::Vector3f>& position) {
    marker_->VisibilityOff();
    if (position) {
        place(*marker_, *position);
    }
}

void MarkerActors::setMeasure(const std::vector<Eigen::Vector3f>& points, const QString& label) {
    for (std::size_t end = 0; end < ends_.size(); ++end) {
        ends_[end]->VisibilityOff();
        if (end < points.size()) {
            place(*ends_[end], points[end]);
        }
    }
    const bool whole = points.size() == 2;
    line_->SetVisibility(whole);
    label_->SetVisibility(whole);
    if (!whole) {
        return;
    }
    auto corners = vtkSmartPointer<vtkPoints>::New();
    for (const Eigen::Vector3f& point : points) {
        corners->InsertNextPoint(point.x(), point.y(), point.z());
    }
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->InsertNextCell({0, 1});
    lineData_->SetPoints(corners);
    lineData_->SetLines(cells);
    const Eigen::Vector3f middle = (points[0] + points[1]) / 2;
    label_->SetPosition(middle.x(), middle.y(), middle.z());
    label_->SetInput(label.toUtf8().constData());
}

void MarkerActors::setSize(double sceneSize) {
    ball_->SetRadius(sceneSize * 0.006);
}

void MarkerActors::setColours(const QColor& accent, const QColor& ink) {
    for (vtkActor* actor : {marker_.Get(), line_.Get(), ends_[0].Get(), ends_[1].Get()}) {
        actor->GetProperty()->SetColor(vtkColour(accent).data());
    }
    vtkTextProperty* text = label_->GetTextProperty();
    text->SetColor(vtkColour(ink).data());
    text->SetBold(1);
    const QColor paper = ink.lightnessF() > 0.5 ? Qt::black : Qt::white;
    text->SetBackgroundColor(vtkColour(paper).data());
    text->SetBackgroundOpacity(0.75);
}

void MarkerActors::setFontSize(int pixels) {
    label_->GetTextProperty()->SetFontSize(pixels);
}

void MarkerActors::setPixelRatio(double ratio) {
    line_->GetProperty()->SetLineWidth(float(2 * ratio));
}

} // namespace dipwright
