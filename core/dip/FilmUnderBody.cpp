#include "dip/FilmUnderBody.h"

#include "base/Error.h"
#include "film/FilmGrid.h"
#include "film/FilmLines.h"
#include "geometry/SurfaceSamples.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <vector>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Dip)
};

// Number of cells that a film needs across the body's narrow parts.
constexpr double cellsAcross = 8;
// The narrowest parts may have fewer cells across if they are at most this share of the surface
// that meets the film.
constexpr double narrowestShare = 0.1;
// Least number of cells along the longest side of the body's shadow, whatever the body's thickness.
constexpr double leastCellsAlong = 60;
constexpr double mostCellsAlong = 150;
// The fine cells are so large that an even film of cells `largerThanFinest` times as large has at
// most `mostPoints` points.
constexpr double mostPoints = 500'000, largerThanFinest = 2.5;
constexpr int fewestLines = 8;
constexpr double wantedSamples = 4'000;
// Faces whose normals point down by less than this count as upright.
constexpr float steepest = 0.01f;
// Number of fine cells outside the strip that drawIn() returns.
constexpr double cellsOfMargin = 4;

double narrowest(std::vector<float> thickness) {
    if (thickness.empty()) {
        return 0;
    }
    const auto nth = thickness.begin() + std::ptrdiff_t(narrowestShare * double(thickness.size()));
    std::nth_element(thickness.begin(), nth, thickness.end());
    return double(*nth);
}

// Returns the height of the part of the body that goes under water, from the body's lowest point,
// mm.
double wetHeight(const TriangleMesh& mesh, const Eigen::Isometry3f& toPose,
                 const ProcessSettings& process) {
    if (process.depth) {
        return process.depth->value();
    }
    float highest = 0;
    for (const Eigen::Vector3f& place : mesh.positions) {
        highest = std::max(highest, (toPose * place).y());
    }
    return double(highest);
}

// `toPose` maps coordinates of `mesh` to the pose frame.
Underside undersideInPose(const TriangleMesh& mesh, const SurfaceQuery& query,
                          const Eigen::Isometry3d& toPose, const ProcessSettings& process) {
    const Eigen::Isometry3f pose = toPose.cast<float>();
    const Eigen::Vector3f down = pose.linear().transpose() * -Eigen::Vector3f::UnitY();
    const auto deepest = float(wetHeight(mesh, pose, process));
    const double perSample = surfaceArea(mesh) / wantedSamples;
    // Distance that keeps rays off their own face.
    const float clear = 1e-4f * boundingBox(mesh).diagonal().norm();
    Underside underside;
    for (const Eigen::Vector3f& position : mesh.positions) {
        const Eigen::Vector3f place = pose * position;
        if (place.y() <= deepest) {
            underside.shadow.extend(Eigen::Vector2d(place.x(), place.z()));
        }
    }
    std::vector<float> thickness;
    for (const SurfacePoint& sample : evenSamples(mesh, perSample)) {
        const Eigen::Vector3f place = position(mesh, sample);
        const Eigen::Vector3f outward = triangleNormal(mesh, sample.triangle);
        if ((pose * place).y() > deepest || !(outward.dot(down) > steepest) ||
            query.isHit(place + clear * outward, down)) {
            continue;
        }
        underside.area += perSample;
        underside.shadowArea += perSample * double(outward.dot(down));
        const RayHit through = query.hit(place - clear * outward, -outward);
        if (through.point.isValid()) {
            thickness.push_back(through.distance);
        }
    }
    underside.thickness = narrowest(std::move(thickness));
    underside.longest = underside.shadow.isEmpty() ? 0 : underside.shadow.sizes().maxCoeff();
    return underside;
}

} // namespace

Underside undersideOf(const TriangleMesh& mesh, const SurfaceQuery& query,
                      const Immersion& immersion, const ProcessSettings& process) {
    const Eigen::Isometry3d toPose = poseTransform(mesh, immersion);
    Underside underside = undersideInPose(mesh, query, toPose, process);
    if (!immersion.path.isStraightDown()) {
        const TriangleMesh posed = transformed(mesh, toPose);
        underside.shadow =
            shadowOnPath(bodyPath(posed, immersion, process), posed, ShadowOf::UnderWater);
    }
    return underside;
}

Underside undersideOf(const PosedBody& body, const ProcessSettings& process) {
    Underside underside =
        undersideInPose(body.mesh, body.query, Eigen::Isometry3d::Identity(), process);
    if (!body.path.isStraightDown()) {
        underside.shadow = shadowOnPath(body.path, body.mesh, ShadowOf::UnderWater);
    }
    return underside;
}

// The extra film is the difference between the faces' area and their shadow's area. The estimate
// assumes that it comes evenly from all sides of a disc as large as the shadow.
double drawIn(const Underside& underside) {
    const double round = 2 * std::sqrt(pi * underside.shadowArea);
    return round > 0 ? (underside.area - underside.shadowArea) / round : 0;
}

Millimetres automaticCell(const Underside& underside, const FilmSettings& film) {
    const double longest = underside.longest;
    const double coarsest = longest / leastCellsAlong;
    const double wanted = underside.thickness > 0 ? underside.thickness / cellsAcross : coarsest;
    const solver::FilmGrid whole = filmGrid(film);
    const double affordable = std::sqrt(whole.width * whole.depth / mostPoints) / largerThanFinest;
    return Millimetres(
        std::max(std::clamp(wanted, longest / mostCellsAlong, coarsest), affordable));
}

bool isGraded(const FilmSettings& film) {
    return film.resolution != FilmResolution::Points &&
           solver::isProductionFilm(film.lattice, film.support);
}

bool isRefinable(const FilmSettings& film) {
    return isGraded(film) && film.resolution == FilmResolution::Automatic && film.work > 0;
}

solver::FilmGrid gradedFilm(const FilmSettings& film, const Eigen::AlignedBox2d& shadow,
                            double drawIn, Millimetres cell,
                            const std::array<Millimetres, 2>& offset) {
    solver::FilmGrid grid = filmGrid(film);
    const double margin = drawIn + cellsOfMargin * cell.value();
    const auto lines = [&](int axis, double length) {
        const double middle = offset[std::size_t(axis)].value();
        return gradedLines(length, shadow.min()[axis] + middle - margin,
                           shadow.max()[axis] + middle + margin, cell.value(), film.refinement,
                           fewestLines);
    };
    grid.columnPlaces = lines(0, grid.width);
    grid.rowPlaces = lines(1, grid.depth);
    grid.columns = int(grid.columnPlaces.size());
    grid.rows = int(grid.rowPlaces.size());
    if (grid.pointCount() > maximumFilmGrid) {
        throw Error(Text::tr("With these cells the film would have %1 million points, but at most "
                             "%2 million are allowed; choose larger cells")
                        .arg(double(grid.pointCount()) / 1e6, 0, 'f', 1)
                        .arg(maximumFilmGrid / 1'000'000),
                    QStringLiteral("film.cell_mm"));
    }
    return grid;
}

solver::FilmGrid filmUnderBody(const FilmSettings& film, const Underside& underside,
                               const std::array<Millimetres, 2>& offset) {
    if (!isGraded(film)) {
        return filmGrid(film);
    }
    const Millimetres cell =
        film.resolution == FilmResolution::Cell ? film.cell : automaticCell(underside, film);
    return gradedFilm(film, underside.shadow, drawIn(underside), cell, offset);
}

} // namespace dipwright
