#include "dip/TornFilm.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {
namespace {

constexpr int mostSquares = 2000;   // along a side
constexpr float offSurface = 1e-3F; // mm, where the ray to the next face below begins

// Returns the height of the water. Film that floats under trapped air lies lower.
float waterIn(const DippedFilm& film) {
    float height = -std::numeric_limits<float>::infinity();
    for (std::size_t point = 0; point < film.positions.size(); ++point) {
        if (!film.adhered(point)) {
            height = std::max(height, film.positions[point].y());
        }
    }
    return height;
}

} // namespace

TornFilm::TornFilm(const LaidFilm& laid, Degrees overhang)
    : laid_(laid), steepest_(float(std::sin(radians(overhang)))) {
    const DippedFilm& film = laid.film();
    std::vector<std::uint32_t> torn;
    for (std::uint32_t triangle = 0; !film.marks.empty() && triangle < laid.triangles().size();
         ++triangle) {
        const FilmTriangle& corners = laid.triangles()[triangle];
        if (std::any_of(corners.begin(), corners.end(), [&](std::uint32_t point) {
                return has(film.marks[point], solver::PointMark::Torn);
            })) {
            torn.push_back(triangle);
        }
    }
    if (torn.empty()) {
        return;
    }
    water_ = waterIn(film);
    const auto place = [&](std::uint32_t point) {
        return Eigen::Vector2f(film.positions[point].x(), film.positions[point].z());
    };
    for (const std::uint32_t triangle : torn) {
        for (const std::uint32_t point : laid.triangles()[triangle]) {
            area_.extend(place(point));
        }
    }
    square_ = std::max(float(film.grid.leastSpacing()), area_.sizes().maxCoeff() / mostSquares);
    area_ = {area_.min().array() - 2 * square_, area_.max().array() + 2 * square_};
    columns_ = int(std::ceil(area_.sizes().x() / square_));
    const int rows = int(std::ceil(area_.sizes().y() / square_));
    squares_.assign(std::size_t(columns_) * std::size_t(rows), 0);
    const auto mark = [&](const Eigen::Vector2f& at) { // the square and those next to it
        const Eigen::Vector2i middle = ((at - area_.min()) / square_).cast<int>();
        for (int row = middle.y() - 1; row <= middle.y() + 1; ++row) {
            for (int column = middle.x() - 1; column <= middle.x() + 1; ++column) {
                squares_[std::size_t(row) * std::size_t(columns_) + std::size_t(column)] = 1;
            }
        }
    };
    for (const std::uint32_t triangle : torn) {
        const FilmTriangle& corners = laid.triangles()[triangle];
        const Eigen::Vector2f a = place(corners[0]);
        const Eigen::Vector2f ab = place(corners[1]) - a, ac = place(corners[2]) - a;
        const int parts = 1 + int(std::max({ab.norm(), ac.norm(), (ac - ab).norm()}) / square_);
        for (int i = 0; i <= parts; ++i) {
            for (int j = 0; i + j <= parts; ++j) {
                mark(a + ab * (float(i) / float(parts)) + ac * (float(j) / float(parts)));
            }
        }
    }
}

bool TornFilm::isAt(const SurfacePoint& place) const {
    const Eigen::Vector3f position = dipwright::position(laid_.body().mesh, place);
    const Eigen::Vector2f at(position.x(), position.z());
    if (isNone() || !area_.contains(at)) {
        return false;
    }
    const Eigen::Vector2i square = ((at - area_.min()) / square_).cast<int>();
    const std::size_t index =
        std::size_t(square.y()) * std::size_t(columns_) + std::size_t(square.x());
    return square.x() < columns_ && index < squares_.size() && squares_[index] != 0;
}

bool TornFilm::isInReach(const SurfacePoint& place) const {
    const PosedBody& body = laid_.body();
    const Eigen::Vector3f at = position(body.mesh, place);
    const Eigen::Vector3f normal = triangleNormal(body.mesh, place.triangle);
    if (normal.y() > steepest_ || at.y() > water_ || body.isDry(place)) {
        return false;
    }
    return normal.y() > 0 ||
           !std::isfinite(
               body.query.hit(at + offSurface * normal, -Eigen::Vector3f::UnitY()).distance);
}

} // namespace dipwright
