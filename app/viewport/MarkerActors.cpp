#include "MarkerActors.h"

#include "SurfaceCut.h"
#include "VtkConversions.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextProperty.h>
#include <vtkTrivialProducer.h>

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
    auto lines = vtkSmartPointer<vtkTrivialProducer>::New();
    lines->SetOutput(lineData_);
    showLines(*line_, lines->GetOutputPort());
    setPixelRatio(1);
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

void MarkerActors::setMeasure(const std::vector<Eigen::Vector3f>& places,
                              const std::vector<std::vector<Eigen::Vector3f>>& lines,
                              const QString& label) {
    for (std::size_t end = 0; end < ends_.size(); ++end) {
        ends_[end]->VisibilityOff();
        if (end < places.size()) {
            place(*ends_[end], places[end]);
        }
    }
    line_->SetVisibility(!lines.empty());
    label_->SetVisibility(!lines.empty());
    if (lines.empty()) {
        return;
    }
    auto corners = vtkSmartPointer<vtkPoints>::New();
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (const std::vector<Eigen::Vector3f>& line : lines) {
        cells->InsertNextCell(int(line.size()));
        for (const Eigen::Vector3f& point : line) {
            cells->InsertCellPoint(corners->InsertNextPoint(point.x(), point.y(), point.z()));
        }
    }
    lineData_->SetPoints(corners);
    lineData_->SetLines(cells);
    const std::vector<Eigen::Vector3f>& first = lines.front();
    const Eigen::Vector3f middle = (first[(first.size() - 1) / 2] + first[first.size() / 2]) / 2;
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
