#include "reduction/MeshDistance.h"

#include "geometry/SurfaceSamples.h"
#include "parallel/ParallelFor.h"

#include <algorithm>

namespace dipwright {

double largestDistance(const TriangleMesh& from, const SurfaceQuery& to, double likely,
                       double spacing) {
    std::vector<Eigen::Vector3f> places = from.positions;
    for (std::uint32_t t = 0; t < from.triangles.size(); ++t) {
        places.push_back(position(from, middleOf(t)));
    }
    for (const SurfacePoint& sample : evenSamples(from, spacing * spacing)) {
        places.push_back(position(from, sample));
    }
    std::vector<float> distances(places.size());
    parallelFor(std::size_t(0), places.size(), [&](std::size_t i) {
        distances[i] = to.closestNear(places[i], float(likely)).distance;
    });
    return distances.empty() ? 0 : *std::max_element(distances.begin(), distances.end());
}

} // namespace dipwright
