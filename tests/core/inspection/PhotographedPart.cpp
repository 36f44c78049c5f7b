#include "PhotographedPart.h"

#include "DippedByHand.h"
#include "base/Units.h"
#include "dip/Dip.h"
#include "geometry/Shapes.h"
#include "geometry/SurfaceQuery.h"
#include "production/reference/ReferenceFilm.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace dipwright::test {
namespace {

constexpr double square = 8; // mm, the side of the sheet's chess squares

class ReferenceTank : public solver::SolverModule {
public:
    const char* unavailableReason() const override { return nullptr; }
    const char* device() const override { return "reference"; }
    std::unique_ptr<solver::FilmSolver> create() const override {
        return reference::makeReferenceFilm();
    }
    bool runBatch(std::span<solver::BatchItem>, solver::CancelFunction, void*) const override {
        return false; // no test runs a batch
    }
};

} // namespace

std::vector<PhotoCamera> camerasAround(const std::vector<Standpoint>& from, double distance,
                                       double focalLength, int pixels) {
    const Eigen::Vector3d aside(1.5, -2, 0); // because a user does not aim exactly at the middle
    std::vector<PhotoCamera> cameras;
    for (const Standpoint& at : from) {
        const double round = at.round * pi / 180, above = at.above * pi / 180;
        const Eigen::Vector3d out(std::cos(above) * std::sin(round), std::sin(above),
                                  std::cos(above) * std::cos(round));
        PhotoCamera camera = cameraFrom(distance * out, {0, 0, 0}, {0, 1, 0});
        camera.pose.translation() += aside;
        camera.size = {pixels, pixels};
        camera.focalLength = focalLength;
        camera.k1 = -0.06;
        cameras.push_back(camera);
    }
    return cameras;
}

std::optional<Eigen::Vector3d> onModel(const LaidFilm& laid, const Eigen::Vector2d& sheet,
                                       const FilmSettings& film) {
    const Eigen::Vector2d rest(sheet.x() * film.swellX, sheet.y() * film.swellY);
    const auto place = laid.flat(rest.cast<float>());
    const auto found = place ? laid.onBody(*place) : std::nullopt;
    return found ? std::optional<Eigen::Vector3d>(laid.body().modelToPose.inverse() *
                                                  found->cast<double>())
                 : std::nullopt;
}

const solver::SolverModule& referenceTank() {
    static const ReferenceTank tank;
    return tank;
}

PhotographedPart::PhotographedPart(Project believed, const Hidden& hidden, double cell,
                                   const solver::SolverModule& program,
                                   const solver::SolverModule& tank)
    : believed_(std::move(believed)),
      field_(cachedDistanceField(believed_.model->mesh, believed_.fieldResolution, {})) {
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
    if (hidden.deeper != 0) {
        real.process.depth = *believed_.process.depth + Millimetres(hidden.deeper);
    }
    truly_ = dipped(real, tank);
    meant_ = dipped(believed_, program);
    real_ = real.film;
    gatherCorners();
}

std::shared_ptr<const LaidFilm> PhotographedPart::dipped(const Project& project,
                                                         const solver::SolverModule& module) const {
    const Immersion& immersion = project.immersions.front();
    auto body = std::make_shared<const PosedBody>(
        posedBody(project.model->mesh, immersion, project.process));
    DippedFilm film =
        simulateDip(*body, *field_, immersion, project.film, project.process, module, {}, {});
    return layFilm(std::move(body), std::move(film), project.process);
}

void PhotographedPart::gatherCorners() {
    const TriangleMesh& mesh = believed_.model->mesh;
    const SurfaceQuery query(mesh);
    for (double x = -9 * square; x <= 9 * square; x += square) {
        for (double y = -9 * square; y <= 9 * square; y += square) {
            const Eigen::Vector2d sheet(x, y);
            const auto at = onModel(*truly_, sheet, real_);
            const auto wanted = onModel(*meant_, sheet, believed_.film);
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

FitPairs PhotographedPart::pairs(const std::vector<PhotoCamera>& cameras, int printed, int body,
                                 double noise, int seed) const {
    std::mt19937 random{std::uint32_t(seed)};
    std::normal_distribution<double> off(0, 1);
    const auto seen = [&](const PhotoCamera& camera, const Eigen::Vector3d& at) {
        const double x = off(random), y = off(random);
        return Eigen::Vector2d(camera.seen(at) + noise * Eigen::Vector2d(x, y));
    };
    // Returns `count` corners that face the camera, evenly picked from all such corners.
    const auto facing = [](const std::vector<Corner>& all, const PhotoCamera& camera, int count) {
        std::vector<Corner> found;
        for (const Corner& corner : all) {
            if (camera.faces(corner.lies, corner.outward)) {
                found.push_back(corner);
            }
        }
        count = std::min(count, int(found.size()));
        std::vector<Corner> some;
        for (int i = 0; i < count; ++i) {
            some.push_back(found[std::size_t(i) * found.size() / std::size_t(count)]);
        }
        return some;
    };
    FitPairs pairs;
    pairs.photos = int(cameras.size());
    pairs.picture = cameras.front().size;
    pairs.where = QStringLiteral("pairs.csv");
    for (int photo = 0; photo < pairs.photos; ++photo) {
        const PhotoCamera& camera = cameras[std::size_t(photo)];
        for (const Corner& corner : facing(corners_, camera, printed)) {
            pairs.printed.push_back(
                {photo, seen(camera, corner.lies), 0, corner.sheet, corner.meant});
        }
        for (const Corner& place : facing(body_, camera, body)) {
            pairs.body.push_back({photo, seen(camera, place.lies), place.lies});
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
