#include "pipeline/SurfaceSamples.h"

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

// The i-th of evenly spread weights over a triangle: the R2 sequence, folded into
// it, which starts at the middle.
Eigen::Vector3f spreadWeights(int i) {
    double u = std::fmod(1.0 / 3 + 0.7548776662466927 * i, 1.0);
    double v = std::fmod(1.0 / 3 + 0.5698402909980532 * i, 1.0);
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    return {float(1 - u - v), float(u), float(v)};
}

} // namespace

std::vector<SurfaceSample> spreadOverSurface(const TriangleMesh& mesh, int count) {
    const double areaOfSample = surfaceArea(mesh) / count;
    std::vector<SurfaceSample> samples;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const double area = triangleArea(mesh, triangle);
        const int here = std::max(1, int(std::lround(area / areaOfSample)));
        for (int i = 0; i < here; ++i) {
            samples.push_back({{std::uint32_t(triangle), spreadWeights(i)}, area / here});
        }
    }
    return samples;
}

} // namespace dipwright
