// Draws a cradle around the body, translucent.
#pragma once

#include "geometry/TriangleMesh.h"

#include <memory>
#include <vtkActor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace dipwright {

class CradleActor {
public:
    explicit CradleActor(vtkRenderer* renderer);

    void setMesh(std::shared_ptr<const TriangleMesh> mesh); // null: no cradle
    void setTransform(const Eigen::Isometry3d& meshToWorld);

private:
    vtkSmartPointer<vtkActor> actor_;
};

} // namespace dipwright
