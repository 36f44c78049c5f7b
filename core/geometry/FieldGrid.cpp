#include "geometry/FieldGrid.h"

#include "base/Error.h"
#include "geometry/SurfaceSamples.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

constexpr int paddingCells = 3;
// A plate is always resolved if at least this many cells lie across its thickness. Then a sample
// lies inside the plate, and each face is determined only by samples on its own side of the middle.
constexpr double leastCellsAcross = 2;
// A plate with fewer cells gets this many, because plates may lie obliquely in the grid.
constexpr double cellsAcross = 4;
constexpr double thinShare = 0.01;
constexpr double opposite = -0.8; // cosine between the normals of a plate's faces
constexpr double wantedSamples = 4'000;

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::DistanceField)
};

BoundingBox extentOf(const TriangleMesh& body) {
    const BoundingBox box = boundingBox(body);
    const double edge = box.isEmpty() ? 0 : double(box.sizes().maxCoeff());
    if (!(edge > 0) || !std::isfinite(edge)) {
        throw Error(Text::tr("The size of the model is zero; choose a model with a surface"),
                    QString());
    }
    return box;
}

FieldGrid centredGrid(const BoundingBox& box, const std::array<int, 3>& size, double spacing) {
    FieldGrid grid{size, {}, spacing};
    for (int axis = 0; axis < 3; ++axis) {
        grid.origin[axis] = (double(box.min()[axis]) + double(box.max()[axis])) / 2 -
                            spacing * (size[std::size_t(axis)] - 1) / 2;
    }
    return grid;
}

FieldGrid boxGrid(const BoundingBox& box, double spacing) {
    std::array<int, 3> size{};
    for (int axis = 0; axis < 3; ++axis) {
        const double cells = std::ceil(double(box.sizes()[axis]) / spacing);
        size[std::size_t(axis)] = int(cells) + 1 + 2 * paddingCells;
    }
    return centredGrid(box, size, spacing);
}

} // namespace

std::size_t FieldGrid::sampleCount() const {
    return std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]);
}

FieldGrid cubeGrid(const TriangleMesh& body, int resolution) {
    if (resolution < 32 || resolution > 512) {
        throw Error(
            Text::tr("The distance field's resolution is %1; choose 32 to 512").arg(resolution),
            QString());
    }
    const BoundingBox box = extentOf(body);
    const double spacing = double(box.sizes().maxCoeff()) / (resolution - 1 - 2 * paddingCells);
    return centredGrid(box, {resolution, resolution, resolution}, spacing);
}

FieldGrid boxGrid(const TriangleMesh& body, double spacing) {
    return boxGrid(extentOf(body), spacing);
}

double thinnestPart(const TriangleMesh& body, const SurfaceQuery& query) {
    // distance from the face at which the ray starts, so that it misses the face
    const float clear = 1e-5F * boundingBox(body).diagonal().norm();
    const std::vector<SurfacePoint> samples = evenSamples(body, surfaceArea(body) / wantedSamples);
    std::vector<float> thicknesses;
    for (const SurfacePoint& sample : samples) {
        const Eigen::Vector3f outward = triangleNormal(body, sample.triangle);
        const RayHit through = query.hit(position(body, sample) - clear * outward, -outward);
        if (through.point.isValid() &&
            triangleNormal(body, through.point.triangle).dot(outward) < opposite) {
            thicknesses.push_back(through.distance + clear);
        }
    }
    const auto rank = std::size_t(thinShare * double(samples.size()));
    if (rank >= thicknesses.size()) {
        return std::numeric_limits<double>::infinity();
    }
    const auto nth = thicknesses.begin() + std::ptrdiff_t(rank);
    std::nth_element(thicknesses.begin(), nth, thicknesses.end());
    return double(*nth);
}

bool isFineEnough(const FieldGrid& grid, double thinnest) {
    return thinnest >= leastCellsAcross * grid.spacing;
}

FieldGrid fieldGrid(const TriangleMesh& body, int resolution, double thinnest) {
    const FieldGrid usual = cubeGrid(body, resolution);
    if (isFineEnough(usual, thinnest)) {
        return usual;
    }
    constexpr double mostCellsAlong = 8'000, coarser = 1.02;
    const BoundingBox box = extentOf(body);
    const double finest = double(box.sizes().maxCoeff()) / mostCellsAlong;
    FieldGrid grid = boxGrid(box, std::max(thinnest / cellsAcross, finest));
    while (grid.sampleCount() > mostFieldSamples) {
        grid = boxGrid(box, grid.spacing * coarser);
    }
    return grid.spacing < usual.spacing ? grid : usual;
}

} // namespace dipwright
