#include "import/trusted/OverlappingFaces.h"

#include "geometry/SurfaceQuery.h"
#include "geometry/SurfaceSamples.h"
#include "geometry/TriangleDistance.h"

#include <algorithm>

namespace dipwright {
namespace {

constexpr double wantedSamples = 20'000;
constexpr float sameDirection = 0.9999F; // cosine of the angle between the faces
constexpr double rounding = 1e-5;        // of places, in longest edges
constexpr double leastWeight = 1e-3;     // neighbours only touch at their edges

bool looksOtherwise(const TexturedMesh& model, std::size_t one, std::size_t other) {
    return model.material[one] != model.material[other] ||
           (model.hasTextureCoordinates(one) && model.chart[one] != model.chart[other]);
}

bool contains(const TriangleMesh& mesh, std::size_t triangle, const Eigen::Vector3d& place,
              double within) {
    const auto corners = cornersOf(mesh, triangle);
    const Eigen::Vector3d a = corners[0].cast<double>(), b = corners[1].cast<double>(),
                          c = corners[2].cast<double>();
    const Eigen::Vector3d weights = closestWeights(place, a, b, c);
    return weights.minCoeff() > leastWeight &&
           (weights[0] * a + weights[1] * b + weights[2] * c - place).norm() <= within;
}

} // namespace

double overlappingArea(const TexturedMesh& model) {
    if (model.materials.size() < 2 && model.textures.empty()) {
        return 0;
    }
    const TriangleMesh& mesh = model.mesh;
    const SurfaceQuery query(mesh);
    const double within = rounding * longestEdgeOf(mesh),
                 perSample = surfaceArea(mesh) / wantedSamples;
    double area = 0;
    for (const SurfacePoint& sample : evenSamples(mesh, perSample)) {
        const Eigen::Vector3f place = position(mesh, sample);
        const Eigen::Vector3f normal = triangleNormal(mesh, sample.triangle);
        const auto near = query.trianglesNear(place, float(within));
        area += std::ranges::any_of(near,
                                    [&](std::uint32_t other) {
                                        return looksOtherwise(model, sample.triangle, other) &&
                                               triangleNormal(mesh, other).dot(normal) >
                                                   sameDirection &&
                                               contains(mesh, other, place.cast<double>(), within);
                                    })
                    ? perSample
                    : 0;
    }
    return area / 2; // both faces have been counted
}

} // namespace dipwright
