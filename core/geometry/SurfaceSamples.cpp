#include "geometry/SurfaceSamples.h"

#include <cmath>

namespace dipwright {

std::vector<SurfacePoint> evenSamples(const TriangleMesh& mesh, double area) {
    std::vector<SurfacePoint> samples;
    if (!(area > 0)) { // a body without surface, where nothing can be measured
        return samples;
    }
    double left = area / 2;
    // Spread the points within a triangle by a low-discrepancy sequence, the additive recurrence of
    // the plastic number.
    double u = 0.5;
    double v = 0.5;
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        left += triangleArea(mesh, triangle);
        while (left >= area) {
            left -= area;
            u = std::fmod(u + 0.7548776662466927, 1.0);
            v = std::fmod(v + 0.5698402909980532, 1.0);
            const double root = std::sqrt(u);
            samples.push_back(
                {triangle, Eigen::Vector3d(1 - root, root * (1 - v), root * v).cast<float>()});
        }
    }
    return samples;
}

} // namespace dipwright
