#include "PhotographedPart.h"

#include "DippedByHand.h"
#include "base/Units.h"
#include "dip/LaidFilm.h"
#include "geometry/Shapes.h"
#include "pipeline/Pipeline.h"
#include "tolerance/Contributors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace dipwright::test {
namespace {

constexpr double k1 = -0.06;
constexpr double square = 8; // mm, of the sheet's chessboard

std::shared_ptr<const LaidFilm> laidOf(const Project& project, const SolverRegistry& registry) {
    JobOptions options;
    options.estimatesCertainty = false;
    return runJob(project, registry, options, nullptr, {}).immersions.front().laid;
}

std::optional<Eigen::Vector3d> lies(const LaidFilm& laid, const Eigen::Vector2d& sheet,
                                    const FilmSettings& film) {
    const Eigen::Vector2d rest(sheet.x() * film.swellX, sheet.y() * film.swellY);
    const auto place = laid.flat(rest.cast<float>());
    const auto found = place ? laid.onBody(*place) : std::nullopt;
    return found ? std::optional<Eigen::Vector3d>(laid.body().modelToPose.inverse() *
                                                  found->cast<double>())
                 : std::nullopt;
}

} // namespace

TrueCamera::TrueCamera(const std::vector<Standpoint>& from, const Eigen::Vector3d& middle,
                       double distance, double focalLength, int pixels)
    : focalLength_(focalLength), pixels_(pixels) {
    for (const Standpoint& at : from) {
        const double round = at.round * pi / 180, above = at.above * pi / 180;
        const Eigen::Vector3d out(std::cos(above) * std::sin(round), std::sin(above),
                                  std::cos(above) * std::cos(round));
        const Eigen::Vector3d right = Eigen::Vector3d::UnitY().cross(out).normalized();
        Eigen::Matrix3d turn;
        turn << right.transpose(), (-out.cross(right)).transpose(), (-out).transpose();
        const Eigen::Vector3d aside(1.5, -2, 0); // nobody looks at the very middle
        photos_.push_back({turn, -turn * (middle + distance * out) + aside});
    }
}

Eigen::Vector2d TrueCamera::seen(int photo, const Eigen::Vector3d& model) const {
    const Photo& at = photos_[std::size_t(photo)];
    const Eigen::Vector3d from = at.turn * model + at.shift;
    const Eigen::Vector2d q = focalLength_ * from.head<2>() / from.z();
    const double half = std::sqrt(0.5) * pixels_;
    return Eigen::Vector2d::Constant(pixels_ / 2.0) + half * (1 + k1 * q.squaredNorm()) * q;
}

bool TrueCamera::faces(int photo, const Eigen::Vector3d& model,
                       const Eigen::Vector3d& outward) const {
    constexpr double leastCosine = 0.35;
    const Photo& at = photos_[std::size_t(photo)];
    const Eigen::Vector3d sight = (at.turn * model + at.shift).normalized();
    return (at.turn * outward).dot(sight) < -leastCosine;
}

PhotographedPart::PhotographedPart(Project believed, const Hidden& hidden, double cell,
                                   const SolverRegistry& registry)
    : believed_(std::move(believed)) {
    Project real = believed_;
    real.film.swellX = hidden.swellX;
    real.film.swellY = hidden.swellY;
    real.film.relaxationTime = Seconds(hidden.relaxation);
    real.film.cell = Millimetres(cell);
    real.process.contactTravel = 0.3;
    Immersion& immersion = real.immersions.front();
    immersion.offset[0] = immersion.offset[0] + Millimetres(hidden.shiftX);
    immersion.offset[1] = immersion.offset[1] + Millimetres(hidden.shiftZ);
    immersion.rotation[1] = immersion.rotation[1] + Degrees(hidden.turn);
    const auto truly = laidOf(real, registry);
    meant_ = laidOf(believed_, registry);
    const TriangleMesh& mesh = believed_.model->mesh;
    field_ = cachedDistanceField(mesh, believed_.fieldResolution, {});
    const SurfaceQuery query(mesh);
    for (double x = -9 * square; x <= 9 * square; x += square) {
        for (double y = -9 * square; y <= 9 * square; y += square) {
            const Eigen::Vector2d sheet(x, y);
            const auto at = lies(*truly, sheet, real.film);
            const auto wanted = lies(*meant_, sheet, believed_.film);
            if (at && wanted) {
                const Eigen::Vector3f outward =
                    triangleNormal(mesh, query.closest(at->cast<float>()).point.triangle);
                corners_.push_back({sheet, *at, outward.cast<double>(), *wanted});
            }
        }
    }
    const auto count = int(mesh.triangles.size());
    for (int i = 0; i < 400; ++i) {
        const auto triangle = std::uint32_t((std::int64_t(i) * 7919 + 13) % count);
        const Eigen::Vector3d at =
            position(mesh, {triangle, {1.0f / 3, 1.0f / 3, 1.0f / 3}}).cast<double>();
        body_.push_back({{0, 0}, at, triangleNormal(mesh, triangle).cast<double>(), at});
    }
}

FitPairs PhotographedPart::pairs(const TrueCamera& camera, int photos, int printed, int body,
                                 double noise, int seed) const {
    std::mt19937 random{std::uint32_t(seed)};
    std::normal_distribution<double> off(0, 1);
    const auto seen = [&](int photo, const Eigen::Vector3d& at) {
        const double x = off(random), y = off(random);
        return Eigen::Vector2d(camera.seen(photo, at) + noise * Eigen::Vector2d(x, y));
    };
    // As many of those that face the camera, every so many of them.
    const auto facing = [&](const std::vector<Corner>& all, int photo, int count) {
        std::vector<Corner> found;
        for (const Corner& corner : all) {
            if (camera.faces(photo, corner.lies, corner.outward)) {
                found.push_back(corner);
            }
        }
        std::vector<Corner> some;
        for (int i = 0; i < count; ++i) {
            some.push_back(found[std::size_t(i) * found.size() / std::size_t(count)]);
        }
        return some;
    };
    FitPairs pairs;
    pairs.photos = photos;
    pairs.picture = camera.picture();
    pairs.where = QStringLiteral("pairs.csv");
    for (int photo = 0; photo < photos; ++photo) {
        for (const Corner& corner : facing(corners_, photo, printed)) {
            pairs.printed.push_back(
                {photo, seen(photo, corner.lies), 0, corner.sheet, corner.meant});
        }
        for (const Corner& place : facing(body_, photo, body)) {
            pairs.body.push_back({photo, seen(photo, place.lies), place.lies});
        }
    }
    return pairs;
}

Project eggToFit(double height, double cell) {
    TriangleMesh egg = sphereMesh(28, 60, 120);
    for (Eigen::Vector3f& place : egg.positions) {
        place.y() *= float(height);
    }
    Project project;
    project.model = std::make_shared<const TexturedMesh>(plainModel(egg, QColor(200, 200, 200)));
    project.film.width = project.film.height = Millimetres(210);
    project.film.resolution = FilmResolution::Cell;
    project.film.cell = Millimetres(cell);
    project.film.swellX = project.film.swellY = 1.03;
    project.fieldResolution = 96;
    project.sheet.resolution = DotsPerInch(40);
    return project;
}

} // namespace dipwright::test
