// Converts between triangle meshes and VTK's surfaces.
#pragma once

#include "geometry/TriangleMesh.h"

#include <vtkSmartPointer.h>

class vtkPolyData;

namespace dipwright {

// Returns the triangles of a surface without other cells, each in the opposite order if `flipped`.
TriangleMesh meshOf(vtkPolyData& surface, bool flipped = false);
vtkSmartPointer<vtkPolyData> polyDataOf(const TriangleMesh& mesh);

} // namespace dipwright
