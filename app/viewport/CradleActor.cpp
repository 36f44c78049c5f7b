#include "CradleActor.h"

#include "VtkConversions.h"
#include "reduction/VtkSurface.h"

#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace dipwright {

CradleActor::CradleActor(vtkRenderer* renderer) : actor_(vtkSmartPointer<vtkActor>::New()) {
    actor_->SetMapper(vtkSmartPointer<vtkPolyDataMapper>::New());
    actor_->GetProperty()->SetColor(0.85, 0.55, 0.2);
    actor_->GetProperty()->SetOpacity(0.4);
    actor_->GetProperty()->BackfaceCullingOn(); // its far sides would cover the part
    actor_->VisibilityOff();
    actor_->PickableOff();
    renderer->AddActor(actor_);
}

void CradleActor::setMesh(std::shared_ptr<const TriangleMesh> mesh) {
    actor_->SetVisibility(mesh != nullptr);
    if (mesh) {
        auto* mapper = vtkPolyDataMapper::SafeDownCast(actor_->GetMapper());
        mapper->SetInputData(polyDataOf(*mesh));
    }
}

void CradleActor::setTransform(const Eigen::Isometry3d& meshToWorld) {
    actor_->SetUserMatrix(vtkMatrix(meshToWorld));
}

} // namespace dipwright
