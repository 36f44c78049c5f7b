#include "DippedByHand.h"
#include "base/WideGamut.h"

#include "geometry/Shapes.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright::test {

namespace {

constexpr float unset = std::numeric_limits<float>::quiet_NaN();

using Corners = std::array<Eigen::Vector3f, 3>;

std::vector<double> gradedPlaces(double length, int count) {
    std::vector<double> places;
    for (int line = 0; line < count; ++line) {
        const double along = (2.0 * line - (count - 1)) / (count - 1); // −1 … 1
        places.push_back(length / 2 * (along * (1 + along * along / 2) / 1.5));
    }
    return places;
}

TexturedMesh modelWith(const TriangleMesh& mesh, const QImage& picture) {
    TexturedMesh model = plainModel(mesh, QColor(200, 200, 200));
    model.materials[0].texture = 0;
    model.textures.push_back(isWide(picture) ? picture
                                             : picture.convertToFormat(QImage::Format_RGBA8888));
    return model;
}

} // namespace

solver::FilmGrid a4Grid(int columns, int rows) {
    return {columns, rows, 210, 297};
}

solver::FilmGrid gradedA4Grid(int columns, int rows) {
    solver::FilmGrid grid = a4Grid(columns, rows);
    grid.columnPlaces = gradedPlaces(grid.width, columns);
    grid.rowPlaces = gradedPlaces(grid.depth, rows);
    return grid;
}

PosedBody posed(const TriangleMesh& model) {
    return posedBody(model, Immersion{});
}

std::shared_ptr<const LaidFilm> laid(const TriangleMesh& model, const DippedFilm& film,
                                     const ProcessSettings& process) {
    return layFilm(std::make_shared<const PosedBody>(posed(model)), film, process);
}

QImage letterF() {
    QImage image(600, 600, QImage::Format_RGBA8888);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.fillRect(90, 60, 60, 300, Qt::black);
    painter.fillRect(150, 60, 120, 60, Qt::black);
    painter.fillRect(150, 180, 80, 60, Qt::black);
    return image;
}

TexturedMesh plainModel(const TriangleMesh& mesh, const QColor& colour) {
    TexturedMesh model;
    model.mesh = mesh;
    const Eigen::Vector2f none(unset, unset);
    model.textureCoordinates.assign(mesh.triangles.size(), {none, none, none});
    model.material.assign(mesh.triangles.size(), 0);
    Material material;
    material.colour = colour;
    model.materials.push_back(material);
    model.chart = findCharts(model);
    return model;
}

TexturedMesh boxWithPicture(const Eigen::Vector3d& size, const QImage& picture) {
    TexturedMesh model = modelWith(boxMesh(size), picture);
    for (std::size_t triangle = 0; triangle < model.mesh.triangles.size(); ++triangle) {
        if (triangleNormal(model.mesh, triangle).y() > -0.9f) {
            continue;
        }
        const Corners corners = cornersOf(model.mesh, triangle);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            model.textureCoordinates[triangle][corner] = {
                0.5f - corners[corner].x() / float(size.x()),
                0.5f - corners[corner].z() / float(size.z())};
        }
    }
    model.chart = findCharts(model);
    return model;
}

TexturedMesh globe(double radius, int rings, int segments, const QImage& picture) {
    TexturedMesh model = modelWith(sphereMesh(radius, rings, segments), picture);
    for (std::size_t triangle = 0; triangle < model.mesh.triangles.size(); ++triangle) {
        const Corners corners = cornersOf(model.mesh, triangle);
        const Eigen::Vector3f middle = (corners[0] + corners[1] + corners[2]) / 3;
        const double middleTurn = std::atan2(-middle.x(), -middle.z());
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Eigen::Vector3f& p = corners[corner];
            const bool pole = std::hypot(p.x(), p.z()) < 1e-3f * float(radius);
            double turn = pole ? middleTurn : std::atan2(-p.x(), -p.z());
            // On the triangle's side of the meridian where the map closes.
            turn = turn - middleTurn > pi ? turn - 2 * pi : turn;
            turn = middleTurn - turn > pi ? turn + 2 * pi : turn;
            const double latitude = std::asin(std::clamp(double(p.y()) / radius, -1.0, 1.0));
            model.textureCoordinates[triangle][corner] =
                Eigen::Vector2d(0.5 + turn / (2 * pi), 0.5 + latitude / pi).cast<float>();
        }
    }
    model.chart = findCharts(model);
    return model;
}

TexturedMesh halvedBall(double radius, int rings, int segments, const QImage& picture) {
    TexturedMesh model = modelWith(sphereMesh(radius, rings, segments), picture);
    const auto scale = float(0.3 / (2 * radius));
    for (std::size_t triangle = 0; triangle < model.mesh.triangles.size(); ++triangle) {
        const Corners corners = cornersOf(model.mesh, triangle);
        const bool left = corners[0].x() + corners[1].x() + corners[2].x() < 0;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Eigen::Vector3f& p = corners[corner];
            model.textureCoordinates[triangle][corner] = {
                (left ? 0.25f : 0.75f) + scale * (left ? p.z() : -p.z()), 0.5f + scale * p.y()};
        }
    }
    model.chart = findCharts(model);
    return model;
}

DippedFilm flatUnderBox(const solver::FilmGrid& grid, const Eigen::Vector3d& size) {
    DippedFilm film;
    film.grid = grid;
    for (std::size_t point = 0; point < grid.pointCount(); ++point) {
        const Eigen::Vector2f rest = restPosition(grid, point);
        const bool under = std::abs(rest.x()) <= size.x() / 2 && std::abs(rest.y()) <= size.z() / 2;
        film.positions.emplace_back(rest.x(), 0, rest.y());
        film.states.push_back(under ? solver::PointState::Adhered : solver::PointState::Free);
    }
    return film;
}

DippedFilm onSphere(const solver::FilmGrid& grid, double radius, double end,
                    const std::function<double(double)>& polarAngle) {
    DippedFilm film;
    film.grid = grid;
    for (std::size_t point = 0; point < grid.pointCount(); ++point) {
        const Eigen::Vector2d rest = restPosition(grid, point).cast<double>();
        const double distance = rest.norm();
        const double angle = std::min(polarAngle(distance), end);
        const Eigen::Vector2d away =
            distance > 0 ? Eigen::Vector2d(rest / distance) : Eigen::Vector2d::Zero();
        const Eigen::Vector2d flat = radius * std::sin(angle) * away;
        film.positions.push_back(
            Eigen::Vector3d(flat.x(), radius * (1 - std::cos(angle)), flat.y()).cast<float>());
        film.states.push_back(angle < end ? solver::PointState::Adhered : solver::PointState::Free);
    }
    return film;
}

DippedFilm viscousOnSphere(const solver::FilmGrid& grid, double radius, double end) {
    return onSphere(grid, radius, end, [=](double distance) {
        return 2 * std::asin(std::min(1.0, distance / (2 * radius)));
    });
}

std::shared_ptr<const LaidFilm> laidOnTurnedSphere(const TriangleMesh& model, double radius,
                                                   double end, double turn) {
    Immersion immersion;
    immersion.rotation[0] = Degrees(turn);
    return layFilm(std::make_shared<const PosedBody>(posedBody(model, immersion)),
                   viscousOnSphere(a4Grid(), radius, end), {});
}

} // namespace dipwright::test
