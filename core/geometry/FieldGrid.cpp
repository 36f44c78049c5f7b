#include "geometry/FieldGrid.h"

#include "base/Error.h"
#include "geometry/SurfaceSamples.h"
#include "parallel/ParallelFor.h"

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
constexpr double opposite = -0.8;   // cosine between the normals of a plate's faces
constexpr float leastTaper = 0.01F; // sine of half the angle of an edge; below, faces are parallel
constexpr double wantedSamples = 4'000;
constexpr float infinity = std::numeric_limits<float>::infinity();

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

// A place of the surface, and how thick the body is there.
struct Thickness {
    Eigen::Vector3f place, outward;
    float plate; // distance to the opposite face, mm; infinite if no face lies opposite
    Eigen::Vector3f farOutward = Eigen::Vector3f::Zero(); // normal of the opposite face
};

// Tells whether the body tapers to a sharp edge: halfway to the line in which the planes of its two
// faces meet, a point is inside, and as far behind this line, it is outside.
bool tapersToEdge(const Thickness& at, const SurfaceQuery& query) {
    const Eigen::Vector3f towardsEdge = at.outward + at.farOutward; // 2·sin(half the angle) long
    const float sine = towardsEdge.norm() / 2;
    if (std::isinf(at.plate) || sine <= leastTaper) {
        return false;
    }
    const Eigen::Vector3f middle = at.place - at.plate / 2 * at.outward;
    const float toEdge = at.plate / 2 * std::sqrt(1 - sine * sine) / sine;
    const Eigen::Vector3f half = toEdge / 2 * towardsEdge.normalized();
    return query.isInside(middle + half) && !query.isInside(middle + 3 * half);
}

// Measures the thickness at `count` places that are spread evenly.
std::vector<Thickness> thicknessSamples(const TriangleMesh& body, const SurfaceQuery& query,
                                        double count) {
    // distance from the face at which the ray starts, so that it misses the face
    const float clear = 1e-5F * boundingBox(body).diagonal().norm();
    const std::vector<SurfacePoint> samples = evenSamples(body, surfaceArea(body) / count);
    std::vector<Thickness> found(samples.size());
    parallelFor(std::size_t(0), samples.size(), [&](std::size_t i) {
        const Eigen::Vector3f outward = triangleNormal(body, samples[i].triangle);
        const Eigen::Vector3f place = position(body, samples[i]);
        const RayHit through = query.hit(place - clear * outward, -outward);
        found[i] = {place, outward, infinity};
        if (!through.point.isValid()) {
            return;
        }
        const Eigen::Vector3f farNormal = triangleNormal(body, through.point.triangle);
        const float distance = through.distance + clear;
        if (farNormal.dot(outward) < opposite) {
            found[i] = {place, outward, distance, farNormal};
        }
    });
    return found;
}

// Returns the thickness that 1 % of the places do not reach.
double lowPercentile(std::vector<float> thicknesses) {
    const auto rank = std::size_t(thinShare * double(thicknesses.size()));
    if (rank >= thicknesses.size()) {
        return double(infinity);
    }
    const auto nth = thicknesses.begin() + std::ptrdiff_t(rank);
    std::nth_element(thicknesses.begin(), nth, thicknesses.end());
    return double(*nth);
}

// Tells whether a ball of this diameter, mm, fits into the body where it touches the surface at
// `at`. It does not fit beside the edges of a fin, even though these lie far apart.
bool isThick(const Thickness& at, const SurfaceQuery& query, double diameter) {
    constexpr double touching = 0.9; // less than 1 because of rounding, and of coarse triangles
    const auto radius = float(diameter / 2);
    return double(at.plate) >= diameter &&
           double(query.closest(at.place - radius * at.outward).distance) >=
               touching * double(radius);
}

} // namespace

Eigen::Vector3d bodyOrigin(const TriangleMesh& model) {
    const BoundingBox box = boundingBox(model);
    if (box.isEmpty()) {
        return Eigen::Vector3d::Zero();
    }
    const Eigen::Vector3d middle = (box.min().cast<double>() + box.max().cast<double>()) / 2;
    const double edge = double(box.sizes().maxCoeff());
    return middle.cwiseAbs().maxCoeff() > farFromOrigin * edge ? middle : Eigen::Vector3d::Zero();
}

TriangleMesh inBodyCoordinates(const TriangleMesh& model) {
    const Eigen::Vector3d origin = bodyOrigin(model);
    TriangleMesh body = model;
    if (!origin.isZero(0)) {
        for (Eigen::Vector3f& place : body.positions) {
            place = (place.cast<double>() - origin).cast<float>();
        }
    }
    return body;
}

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

ThinParts thinParts(const TriangleMesh& body, const SurfaceQuery& query) {
    const std::vector<Thickness> samples = thicknessSamples(body, query, wantedSamples);
    std::vector<float> all(samples.size()), plates(samples.size());
    parallelFor(std::size_t(0), samples.size(), [&](std::size_t i) {
        all[i] = samples[i].plate;
        plates[i] = tapersToEdge(samples[i], query) ? infinity : samples[i].plate;
    });
    return {lowPercentile(std::move(all)), lowPercentile(std::move(plates))};
}

MissedParts missedParts(const TriangleMesh& body, const SurfaceQuery& query, double spacing) {
    constexpr double manySamples = 20'000, leastShare = 0.001;
    constexpr double reachInCells = 4, reachInSamples = 2; // distances between neighbours
    const std::vector<Thickness> samples = thicknessSamples(body, query, manySamples);
    std::vector<std::uint8_t> areThick(samples.size());
    parallelFor(std::size_t(0), samples.size(),
                [&](std::size_t i) { areThick[i] = isThick(samples[i], query, spacing); });
    std::vector<Thickness> thin, thick;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        (areThick[i] ? thick : thin).push_back(samples[i]);
    }
    const double sampleDistance = std::sqrt(surfaceArea(body) / manySamples);
    const auto reach = float(std::max(reachInCells * spacing, reachInSamples * sampleDistance));
    std::vector<std::uint8_t> stickOut(thin.size());
    parallelFor(std::size_t(0), thin.size(), [&](std::size_t i) {
        stickOut[i] = std::none_of(thick.begin(), thick.end(), [&](const Thickness& other) {
            return (other.place - thin[i].place).squaredNorm() < reach * reach;
        });
    });
    double thickest = 0;
    for (std::size_t i = 0; i < thin.size(); ++i) {
        if (stickOut[i] && double(thin[i].plate) < spacing) { // not beside the edge of a fin
            thickest = std::max(thickest, double(thin[i].plate));
        }
    }
    const double share = double(std::count(stickOut.begin(), stickOut.end(), std::uint8_t(1))) /
                         double(std::max<std::size_t>(samples.size(), 1));
    return share < leastShare ? MissedParts{} : MissedParts{share * surfaceArea(body), thickest};
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
