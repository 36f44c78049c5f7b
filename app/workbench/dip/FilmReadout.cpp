#include "workbench/dip/FilmReadout.h"

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

// Returns the mean over the triangles around each point.
std::vector<float> perPoint(std::size_t points, const std::vector<FilmTriangle>& triangles,
                            const std::vector<PrincipalStretch>& stretches,
                            float (*value)(const PrincipalStretch&)) {
    std::vector<float> sums(points, 0), counts(points, 0);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (const std::uint32_t point : triangles[t]) {
            sums[point] += value(stretches[t]);
            counts[point] += 1;
        }
    }
    for (std::size_t point = 0; point < points; ++point) {
        sums[point] /= counts[point];
    }
    return sums;
}

// Returns the chosen values, or all if none is chosen.
std::vector<float> chosen(const std::vector<float>& values,
                          const std::vector<std::uint8_t>& isOne) {
    std::vector<float> kept;
    for (std::size_t entry = 0; entry < values.size(); ++entry) {
        if (isOne[entry]) {
            kept.push_back(values[entry]);
        }
    }
    return kept.empty() ? values : kept;
}

// Returns the barycentric weights of `place` in a plane triangle. Some are negative outside it.
Eigen::Vector3f weightsIn(const std::array<Eigen::Vector2f, 3>& corners,
                          const Eigen::Vector2f& place) {
    const auto cross = [](const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
        return a.x() * b.y() - a.y() * b.x();
    };
    const float whole = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const float second = cross(place - corners[0], corners[2] - corners[0]) / whole;
    const float third = cross(corners[1] - corners[0], place - corners[0]) / whole;
    return {1 - second - third, second, third};
}

} // namespace

FilmReadout::FilmReadout(std::shared_ptr<const LaidFilm> laid)
    : laid_(std::move(laid)), mesh_{film().positions, laid_->triangles()},
      draped_(drapedFilm(*laid_)) {
    query_ = std::make_unique<SurfaceQuery>(mesh_);
    const auto mean = [&](float (*value)(const PrincipalStretch&)) {
        return perPoint(film().positions.size(), mesh_.triangles, laid_->stretches(), value);
    };
    const PaintedStretch& painted = laid_->painted();
    values_[std::size_t(FilmQuantity::Length)] = painted.pointMeans;
    values_[std::size_t(FilmQuantity::Area)] =
        mean([](const PrincipalStretch& stretch) { return stretch.area(); });
    values_[std::size_t(FilmQuantity::Larger)] =
        mean([](const PrincipalStretch& stretch) { return stretch.larger; });
    values_[std::size_t(FilmQuantity::Smaller)] =
        mean([](const PrincipalStretch& stretch) { return stretch.smaller; });
    // Relative to the floating film at the moment of contact, as for wrinkling.
    for (std::size_t point = 0; point < film().grown.size(); ++point) {
        values_[std::size_t(FilmQuantity::Smaller)][point] /= film().grown[point];
    }
    for (std::size_t quantity = 0; quantity < filmQuantityCount; ++quantity) {
        painted_[quantity] = chosen(values_[quantity], painted.points);
    }
    for (const FilmQuantity quantity : {FilmQuantity::Larger, FilmQuantity::Smaller}) {
        spreads_[std::size_t(quantity)] = distribution(paintedValues(quantity));
    }
    spreads_[std::size_t(FilmQuantity::Length)] = distribution(painted.constraints);
    spreads_[std::size_t(FilmQuantity::Area)] = distribution(painted.areas);
}

std::optional<FilmReadoutPoint> FilmReadout::at(const Eigen::Vector2f& rest) const {
    const solver::FilmGrid& grid = film().grid;
    const double across = columnAt(grid, double(rest.x()) / grid.width + 0.5);
    const double down = rowAt(grid, double(rest.y()) / grid.depth + 0.5);
    if (across < 0 || down < 0 || across > grid.columns - 1 || down > grid.rows - 1) {
        return std::nullopt;
    }
    const int column = std::min(int(across), grid.columns - 2);
    const int row = std::min(int(down), grid.rows - 2);
    const auto cell = std::uint32_t(row * (grid.columns - 1) + column);
    SurfacePoint best;
    for (std::uint32_t triangle = cell * 2; triangle < cell * 2 + 2; ++triangle) {
        std::array<Eigen::Vector2f, 3> corners;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            corners[corner] = restPosition(grid, mesh_.triangles[triangle][corner]);
        }
        const Eigen::Vector3f weights = weightsIn(corners, rest);
        if (!best.isValid() || weights.minCoeff() > best.weights.minCoeff()) {
            best = {triangle, weights};
        }
    }
    return at(best);
}

std::optional<FilmReadoutPoint> FilmReadout::at(const Eigen::Vector3f& origin,
                                                const Eigen::Vector3f& direction) const {
    const RayHit hit = query_->hit(origin, direction);
    if (!hit.point.isValid()) {
        return std::nullopt;
    }
    return at(hit.point);
}

FilmReadoutPoint FilmReadout::at(const SurfacePoint& onFilm) const {
    const FilmTriangle& triangle = mesh_.triangles[onFilm.triangle];
    FilmReadoutPoint reading;
    reading.place = position(mesh_, onFilm);
    reading.stretch = laid_->stretches()[onFilm.triangle];
    Eigen::Index nearest = 0;
    onFilm.weights.maxCoeff(&nearest);
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t point = triangle[corner];
        const float weight = onFilm.weights[Eigen::Index(corner)];
        reading.rest += weight * restPosition(film().grid, point);
        for (std::size_t quantity = 0; quantity < filmQuantityCount; ++quantity) {
            reading.values[quantity] += weight * values_[quantity][point];
        }
    }
    reading.onPart = laid_->contact().painted[onFilm.triangle] ||
                     std::all_of(triangle.begin(), triangle.end(),
                                 [&](auto point) { return film().adhered(point); });
    reading.body = laid_->contact().surface[triangle[std::size_t(nearest)]];
    if (reading.body.isValid()) {
        reading.outward = triangleNormal(laid_->body().mesh, reading.body.triangle);
    }
    return reading;
}

} // namespace dipwright
