#include "cradle/ReducedSurface.h"

#include "cradle/CradleCheck.h"
#include "parallel/ParallelFor.h"
#include "reduction/MeshDistance.h"
#include "reduction/VtkSurface.h"

#include <QCoreApplication>
#include <vtkCallbackCommand.h>
#include <vtkDecimatePro.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <atomic>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Cradle)
};

// Shares of the triangles to keep, one try after the other; in the first not more than
// mostTriangles, which are 3 MB as STL.
constexpr std::array<double, 3> keptShares{0.1, 0.15, 0.3};
constexpr double mostTriangles = 59'500;
// Degrees between two triangles that make an edge. So small that the filter treats each bend of
// the form as an edge and does not round it.
constexpr double featureAngle = 1;
constexpr float leastDepth = 1e-3F; // mm; triangles that cross less than this only touch

void stopIfCancelled(vtkObject* filter, unsigned long, void* token, void*) {
    if (static_cast<const CancelToken*>(token)->isCancelled()) {
        static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1);
    }
}

TriangleMesh decimated(vtkPolyData& surface, double keptShare, CancelToken cancelToken) {
    vtkNew<vtkDecimatePro> filter;
    filter->SetInputData(&surface);
    filter->PreserveTopologyOn();
    filter->SetTargetReduction(1 - keptShare);
    filter->SetFeatureAngle(featureAngle);
    vtkNew<vtkCallbackCommand> cancel;
    cancel->SetCallback(stopIfCancelled);
    cancel->SetClientData(&cancelToken);
    filter->AddObserver(vtkCommand::ProgressEvent, cancel);
    filter->Update();
    cancelToken.throwIfCancelled();
    return meshOf(*filter->GetOutput());
}

// Whether the line from `start` to `end` passes through the triangle, deeper than leastDepth. `hit`
// is where it meets the triangle.
bool passesThrough(const std::array<Eigen::Vector3f, 3>& corners, const SurfacePoint& hit,
                   const Eigen::Vector3f& start, const Eigen::Vector3f& end) {
    const Eigen::Vector3f across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const float twiceArea = across.norm();
    if (std::min(std::abs(across.dot(start - corners[0])), std::abs(across.dot(end - corners[0]))) <
        leastDepth * twiceArea) {
        return false;
    }
    for (int i = 0; i < 3; ++i) {
        const float side = (corners[(i + 2) % 3] - corners[(i + 1) % 3]).norm();
        if (hit.weights[i] * twiceArea < leastDepth * side) {
            return false;
        }
    }
    return true;
}

bool isCrossed(const TriangleMesh& mesh, const SurfaceQuery& query, const Eigen::Vector3f& start,
               const Eigen::Vector3f& end) {
    const Eigen::Vector3f along = end - start;
    const float step = leastDepth / std::max(along.norm(), leastDepth);
    float passed = 0;
    while (passed < 1) {
        const RayHit hit = query.hit(start + passed * along, along, 1 - passed);
        if (!hit.point.isValid()) {
            return false;
        }
        if (passesThrough(cornersOf(mesh, hit.point.triangle), hit.point, start, end)) {
            return true;
        }
        passed += std::max(hit.distance, 0.0F) + step;
    }
    return false;
}

} // namespace

bool crossesItself(const TriangleMesh& mesh, const SurfaceQuery& query) {
    std::atomic<bool> crosses = false;
    parallelFor(std::size_t(0), 3 * mesh.triangles.size(), [&](std::size_t edge) {
        const auto& corners = mesh.triangles[edge / 3];
        const std::uint32_t from = corners[edge % 3], to = corners[(edge + 1) % 3];
        if (from < to && !crosses &&
            isCrossed(mesh, query, mesh.positions[from], mesh.positions[to])) {
            crosses = true;
        }
    });
    return crosses;
}

ReducedSurface reducedSurface(const TriangleMesh& surface, double tolerance, double spacing,
                              const Progress& progress) {
    if (surface.triangles.empty()) {
        return {surface, 0};
    }
    const QString text = Text::tr("Reducing the triangles of the cradle");
    progress(0, text);
    const SurfaceQuery original(surface);
    const auto data = polyDataOf(surface);
    for (std::size_t attempt = 0; attempt < keptShares.size(); ++attempt) {
        const double most = attempt == 0 ? mostTriangles / double(surface.triangles.size()) : 1;
        const double share = std::min(keptShares[attempt], most);
        ReducedSurface result{decimated(*data, share, progress.cancelToken), 0};
        progress(double(attempt + 1) / double(keptShares.size() + 1), text);
        if (!isClosedSurface(result.mesh)) {
            continue;
        }
        const SurfaceQuery reduced(result.mesh);
        result.distance = std::max(largestDistance(surface, reduced, tolerance, spacing),
                                   largestDistance(result.mesh, original, tolerance, spacing));
        if (result.distance <= tolerance && !crossesItself(result.mesh, reduced)) {
            return result;
        }
    }
    return {surface, 0};
}

} // namespace dipwright
