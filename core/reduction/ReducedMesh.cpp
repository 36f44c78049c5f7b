#include "reduction/ReducedMesh.h"

#include "geometry/SurfaceQuery.h"
#include "reduction/MeshDistance.h"
#include "reduction/VtkSurface.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

TriangleMesh decimated(vtkPolyData& surface, double keptShare) {
    vtkNew<vtkQuadricDecimation> filter;
    filter->SetInputData(&surface);
    filter->SetTargetReduction(1 - keptShare);
    filter->Update();
    return meshOf(*filter->GetOutput());
}

} // namespace

ReducedMesh reducedMesh(const TriangleMesh& mesh, std::size_t triangles, double tolerance,
                        const CancelToken& cancelToken) {
    const SurfaceQuery original(mesh);
    const auto data = polyDataOf(mesh);
    const double spacing =
        std::sqrt(surfaceArea(mesh) / double(std::max<std::size_t>(1, triangles)));
    for (; triangles < mesh.triangles.size(); triangles *= 2) {
        cancelToken.throwIfCancelled();
        ReducedMesh result{decimated(*data, double(triangles) / double(mesh.triangles.size())), 0};
        cancelToken.throwIfCancelled();
        if (result.mesh.triangles.empty()) {
            continue;
        }
        const SurfaceQuery reduced(result.mesh);
        result.distance = std::max(largestDistance(mesh, reduced, tolerance, spacing),
                                   largestDistance(result.mesh, original, tolerance, spacing));
        if (result.distance <= tolerance) {
            return result;
        }
    }
    return {mesh, 0};
}

} // namespace dipwright
