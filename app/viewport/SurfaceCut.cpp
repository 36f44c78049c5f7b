#include "SurfaceCut.h"

#include "VtkConversions.h"

#include <vtkContourTriangulator.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace dipwright {

SurfaceCut::SurfaceCut()
    : plane_(vtkSmartPointer<vtkPlane>::New()), cutter_(vtkSmartPointer<vtkCutter>::New()),
      line_(vtkSmartPointer<vtkActor>::New()), area_(vtkSmartPointer<vtkActor>::New()) {
    cutter_->SetCutFunction(plane_);
    showLines(*line_, cutter_->GetOutputPort());
    line_->GetMapper()->ScalarVisibilityOff();
    auto filled = vtkSmartPointer<vtkContourTriangulator>::New();
    filled->SetInputConnection(cutter_->GetOutputPort());
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputConnection(filled->GetOutputPort());
    mapper->ScalarVisibilityOff();
    area_->SetMapper(mapper);
    area_->GetProperty()->LightingOff();
    area_->PickableOff();
    area_->VisibilityOff();
    placePlane();
}

void SurfaceCut::setSurface(vtkPolyData* surface) {
    cutter_->SetInputData(surface);
}

void SurfaceCut::setTransform(const Eigen::Isometry3d& surfaceToWorld) {
    surfaceToWorld_ = surfaceToWorld;
    for (vtkActor* actor : {line_.Get(), area_.Get()}) {
        actor->SetUserMatrix(vtkMatrix(surfaceToWorld));
    }
    placePlane();
}

void SurfaceCut::setPlane(const Eigen::Vector3d& origin, const Eigen::Vector3d& normal) {
    origin_ = origin;
    normal_ = normal;
    placePlane();
}

void SurfaceCut::placePlane() {
    const Eigen::Isometry3d inverse = surfaceToWorld_.inverse();
    const Eigen::Vector3d origin = inverse * origin_, normal = inverse.linear() * normal_;
    plane_->SetOrigin(origin.x(), origin.y(), origin.z());
    plane_->SetNormal(normal.x(), normal.y(), normal.z());
}

void showLines(vtkActor& actor, vtkAlgorithmOutput* lines) {
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputConnection(lines);
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, -8);
    actor.SetMapper(mapper);
    actor.GetProperty()->LightingOff();
    actor.PickableOff();
}

void cutOpen(vtkActor& actor, vtkPlane* plane) {
    actor.GetMapper()->RemoveAllClippingPlanes();
    if (plane) {
        actor.GetMapper()->AddClippingPlane(plane);
    }
}

} // namespace dipwright
