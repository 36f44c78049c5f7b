#include "geometry/SurfaceQuery.h"

#include "base/Error.h"
#include "geometry/TriangleDistance.h"

#include <QCoreApplication>

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

// State of a point query while it descends the hierarchy.
struct ClosestSearch {
    const TriangleMesh& mesh;
    Eigen::Vector3d position;
    double slack; // largest error of Embree's float distances to boxes, mm
    double limit; // largest squared distance that counts, mm²
    double squaredDistance = std::numeric_limits<double>::infinity();
    std::uint32_t triangle = SurfacePoint::noTriangle;
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();
    bool any = false;                          // ends at the first triangle within the limit
    std::vector<std::uint32_t>* all = nullptr; // not null: collects all triangles instead
};

bool visitTriangle(RTCPointQueryFunctionArguments* arguments) {
    auto& search = *static_cast<ClosestSearch*>(arguments->userPtr);
    if (search.any && search.triangle != SurfacePoint::noTriangle) {
        return false;
    }
    if (search.all) {
        search.all->push_back(arguments->primID);
        return false;
    }
    const auto& index = search.mesh.triangles[arguments->primID];
    const Eigen::Vector3d a = search.mesh.positions[index[0]].cast<double>();
    const Eigen::Vector3d b = search.mesh.positions[index[1]].cast<double>();
    const Eigen::Vector3d c = search.mesh.positions[index[2]].cast<double>();
    const Eigen::Vector3d weights = closestWeights(search.position, a, b, c);
    const double squaredDistance =
        (weights[0] * a + weights[1] * b + weights[2] * c - search.position).squaredNorm();
    // If triangles are equally near, the first one counts, so that the order of visits does not
    // matter.
    const bool nearer =
        squaredDistance < search.squaredDistance ||
        (squaredDistance == search.squaredDistance && arguments->primID < search.triangle);
    if (!nearer || !(squaredDistance <= search.limit)) {
        return false;
    }
    search.squaredDistance = squaredDistance;
    search.triangle = arguments->primID;
    search.weights = weights;
    const float radius = search.any ? 0.f : float(std::sqrt(squaredDistance) + search.slack);
    if (radius >= arguments->query->radius) {
        return false;
    }
    arguments->query->radius = radius;
    return true;
}

RTCRay makeRay(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float reach) {
    RTCRay ray{};
    ray.org_x = origin.x(), ray.org_y = origin.y(), ray.org_z = origin.z();
    ray.dir_x = direction.x(), ray.dir_y = direction.y(), ray.dir_z = direction.z();
    ray.tnear = 0;
    ray.tfar = reach;
    ray.mask = ~0u;
    return ray;
}

// Embree's context is the first member, so that a filter can reach the other members.
struct FirstHit {
    RTCIntersectContext context;
    float distance = std::numeric_limits<float>::infinity();
    std::uint32_t triangle = RTC_INVALID_GEOMETRY_ID;
};

// If triangles are hit at the same distance (on a shared edge), the first one counts. Then the
// order of traversal does not matter.
void keepFirstTriangle(const RTCFilterFunctionNArguments* arguments) {
    auto& best = *reinterpret_cast<FirstHit*>(arguments->context);
    const float distance = RTCRayN_tfar(arguments->ray, arguments->N, 0);
    const std::uint32_t triangle = RTCHitN_primID(arguments->hit, arguments->N, 0);
    if (distance < best.distance || (distance == best.distance && triangle < best.triangle)) {
        best.distance = distance;
        best.triangle = triangle;
    } else {
        arguments->valid[0] = 0;
    }
}

struct HitDistances {
    RTCIntersectContext context;
    std::vector<float> all;
};

// Notes the distance of the hit, and lets the ray continue.
void noteDistance(const RTCFilterFunctionNArguments* arguments) {
    reinterpret_cast<HitDistances*>(arguments->context)
        ->all.push_back(RTCRayN_tfar(arguments->ray, arguments->N, 0));
    arguments->valid[0] = 0;
}

struct CrossingCount {
    RTCIntersectContext context;
    int winding = 0;
};

// Counts exits minus entries of the ray, and lets it continue.
void countCrossing(const RTCFilterFunctionNArguments* arguments) {
    auto* ray = arguments->ray;
    auto* hit = arguments->hit;
    const unsigned n = arguments->N;
    const float along = RTCRayN_dir_x(ray, n, 0) * RTCHitN_Ng_x(hit, n, 0) +
                        RTCRayN_dir_y(ray, n, 0) * RTCHitN_Ng_y(hit, n, 0) +
                        RTCRayN_dir_z(ray, n, 0) * RTCHitN_Ng_z(hit, n, 0);
    reinterpret_cast<CrossingCount*>(arguments->context)->winding += along > 0 ? 1 : -1;
    arguments->valid[0] = 0;
}

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::SurfaceQuery)
};

[[noreturn]] void throwNoMemory() {
    throw Error(Text::tr("The mesh is too large for this computer's memory; reduce its number of "
                         "triangles"),
                QString());
}

} // namespace

struct SurfaceQuery::Data {
    TriangleMesh mesh;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    double slack = 0;

    Data() = default;
    Data(const Data&) = delete;
    Data& operator=(const Data&) = delete;
    ~Data() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
    void build();
    // `any`: ends at the first triangle that is near enough.
    ClosestSearch find(const Eigen::Vector3f& position, float within, bool any) const {
        const double reach = slack + 4e-7 * position.cwiseAbs().maxCoeff();
        ClosestSearch search{mesh, position.cast<double>(), reach, double(within) * within};
        search.any = any;
        RTCPointQuery query{position.x(), position.y(), position.z(), 0, float(within + reach)};
        RTCPointQueryContext context;
        rtcInitPointQueryContext(&context);
        rtcPointQuery(scene, &query, &context, nullptr, &search);
        return search;
    }
};

void SurfaceQuery::Data::build() {
    device = rtcNewDevice(nullptr);
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene,
                     RTCSceneFlags(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    // Embree's own buffers have the padding that its vector loads need; a mesh's vectors do not.
    auto* positions = static_cast<Eigen::Vector3f*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(Eigen::Vector3f), mesh.positions.size()));
    auto* triangles = static_cast<std::array<std::uint32_t, 3>*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                sizeof(mesh.triangles[0]), mesh.triangles.size()));
    if (!mesh.triangles.empty() && positions && triangles) {
        std::copy(mesh.positions.begin(), mesh.positions.end(), positions);
        std::copy(mesh.triangles.begin(), mesh.triangles.end(), triangles);
        rtcSetGeometryPointQueryFunction(geometry, visitTriangle);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
    }
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) {
        throwNoMemory();
    }
    const BoundingBox box = boundingBox(mesh);
    if (!box.isEmpty()) {
        slack = 4e-7 * (box.min().cwiseAbs().maxCoeff() + box.max().cwiseAbs().maxCoeff());
    }
}

SurfaceQuery::SurfaceQuery(const TriangleMesh& mesh) : data_(std::make_unique<Data>()) {
    data_->mesh = mesh;
    data_->build();
}

SurfaceQuery::~SurfaceQuery() = default;
SurfaceQuery::SurfaceQuery(SurfaceQuery&&) noexcept = default;
SurfaceQuery& SurfaceQuery::operator=(SurfaceQuery&&) noexcept = default;

ClosestPoint SurfaceQuery::closest(const Eigen::Vector3f& position, float within) const {
    const ClosestSearch search = data_->find(position, within, false);
    ClosestPoint result;
    if (search.triangle != SurfacePoint::noTriangle) {
        result.point = {search.triangle, search.weights.cast<float>()};
        result.distance = float(std::sqrt(search.squaredDistance));
    }
    return result;
}

ClosestPoint SurfaceQuery::closestNear(const Eigen::Vector3f& position, float likely,
                                       float within) const {
    const ClosestPoint nearby = closest(position, std::min(likely, within));
    return nearby.point.isValid() || likely >= within ? nearby : closest(position, within);
}

bool SurfaceQuery::isNear(const Eigen::Vector3f& position, float within) const {
    return data_->find(position, within, true).triangle != SurfacePoint::noTriangle;
}

std::vector<std::uint32_t> SurfaceQuery::trianglesNear(const Eigen::Vector3f& position,
                                                       float distance) const {
    std::vector<std::uint32_t> found;
    const double slack = data_->slack + 4e-7 * position.cwiseAbs().maxCoeff();
    ClosestSearch search{data_->mesh, position.cast<double>(), slack, 0};
    search.all = &found;
    RTCPointQuery query{position.x(), position.y(), position.z(), 0, float(distance + slack)};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(data_->scene, &query, &context, nullptr, &search);
    std::sort(found.begin(), found.end());
    return found;
}

RayHit SurfaceQuery::hit(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                         float reach) const {
    FirstHit first;
    rtcInitIntersectContext(&first.context);
    first.context.filter = keepFirstTriangle;
    RTCRayHit query{makeRay(origin, direction, reach), {}};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(data_->scene, &first.context, &query);
    RayHit result;
    if (query.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
        const float u = query.hit.u, v = query.hit.v;
        result.point = {query.hit.primID, Eigen::Vector3f(1 - u - v, u, v)};
        result.distance = query.ray.tfar;
    }
    return result;
}

bool SurfaceQuery::isHit(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction,
                         float reach) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay ray = makeRay(origin, direction, reach);
    rtcOccluded1(data_->scene, &context, &ray);
    return ray.tfar < 0;
}

std::vector<float> SurfaceQuery::allHits(const Eigen::Vector3f& origin,
                                         const Eigen::Vector3f& direction, float reach) const {
    HitDistances distances;
    rtcInitIntersectContext(&distances.context);
    distances.context.filter = noteDistance;
    RTCRay ray = makeRay(origin, direction, reach);
    rtcOccluded1(data_->scene, &distances.context, &ray);
    std::sort(distances.all.begin(), distances.all.end());
    return std::move(distances.all);
}

bool SurfaceQuery::isInside(const Eigen::Vector3f& position) const {
    return holdsForMost(position, [](int winding) { return winding != 0; });
}

bool SurfaceQuery::isBehind(const Eigen::Vector3f& position) const {
    return holdsForMost(position, [](int winding) { return winding > 0; });
}

bool SurfaceQuery::holdsForMost(const Eigen::Vector3f& position,
                                bool (*counts)(int winding)) const {
    // Oblique directions, so that rays do not run along the axis-parallel faces and edges of
    // bodies.
    static const std::array<Eigen::Vector3f, 5> directions = {{{0.911f, 0.217f, 0.351f},
                                                               {-0.823f, 0.419f, -0.383f},
                                                               {0.137f, -0.941f, 0.309f},
                                                               {0.271f, 0.523f, -0.808f},
                                                               {-0.319f, -0.457f, 0.830f}}};
    constexpr int most = int(directions.size()) / 2 + 1;
    int yes = 0, no = 0;
    for (const auto& direction : directions) {
        CrossingCount crossings;
        rtcInitIntersectContext(&crossings.context);
        crossings.context.filter = countCrossing;
        RTCRayHit query{makeRay(position, direction, std::numeric_limits<float>::infinity()), {}};
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(data_->scene, &crossings.context, &query);
        ++(counts(crossings.winding) ? yes : no);
        if (yes == most || no == most) {
            break;
        }
    }
    return yes == most;
}

} // namespace dipwright
