#include "dip/PaintedStretch.h"

#include <algorithm>

namespace dipwright {

namespace {

// A constraint that is a side of painted film: its ends and its stretch.
struct PaintedConstraint {
    std::uint32_t from, to;
    float stretch;
};

// In the order of constraintStretches().
std::vector<PaintedConstraint> paintedConstraints(const DippedFilm& film,
                                                  const FilmContact& contact) {
    const auto columns = std::uint32_t(film.grid.columns);
    const auto rows = std::uint32_t(film.grid.rows);
    const std::vector<float> stretches = constraintStretches(film);
    const std::size_t firstVertical = std::size_t(rows) * (columns - 1);
    std::vector<std::uint8_t> isPainted(stretches.size(), 0);
    const std::vector<FilmTriangle> triangles = filmTriangles(film.grid);
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle) {
        for (int side = 0; contact.painted[triangle] && side < 3; ++side) {
            const std::uint32_t a = triangles[triangle][std::size_t(side)];
            const std::uint32_t b = triangles[triangle][std::size_t((side + 1) % 3)];
            const std::uint32_t first = std::min(a, b), way = std::max(a, b) - first;
            if (way == 1) {
                isPainted[std::size_t(first / columns) * (columns - 1) + first % columns] = 1;
            } else if (way == columns) {
                isPainted[firstVertical + first] = 1;
            }
        }
    }
    std::vector<PaintedConstraint> constraints;
    for (std::size_t constraint = 0; constraint < stretches.size(); ++constraint) {
        if (!isPainted[constraint]) {
            continue;
        }
        if (constraint < firstVertical) {
            const auto row = std::uint32_t(constraint / (columns - 1));
            const auto from = row * columns + std::uint32_t(constraint % (columns - 1));
            constraints.push_back({from, from + 1, stretches[constraint]});
        } else {
            const auto from = std::uint32_t(constraint - firstVertical);
            constraints.push_back({from, from + columns, stretches[constraint]});
        }
    }
    return constraints;
}

} // namespace

std::vector<float> paintedConstraintStretches(const DippedFilm& film, const FilmContact& contact) {
    std::vector<float> stretches;
    for (const PaintedConstraint& constraint : paintedConstraints(film, contact)) {
        stretches.push_back(constraint.stretch);
    }
    return stretches;
}

std::vector<float> paintedPointStretches(const DippedFilm& film, const FilmContact& contact) {
    std::vector<float> sums(film.grid.pointCount(), 0);
    std::vector<int> counts(film.grid.pointCount(), 0);
    for (const PaintedConstraint& constraint : paintedConstraints(film, contact)) {
        for (const std::uint32_t point : {constraint.from, constraint.to}) {
            sums[point] += constraint.stretch;
            ++counts[point];
        }
    }
    for (std::size_t point = 0; point < sums.size(); ++point) {
        sums[point] = counts[point] > 0 ? sums[point] / float(counts[point]) : 1.f;
    }
    return sums;
}

std::vector<float> paintedAreaStretches(const DippedFilm& film, const FilmContact& contact) {
    const std::vector<PrincipalStretch> stretches = principalStretches(film);
    std::vector<float> kept;
    for (std::size_t triangle = 0; triangle < stretches.size(); ++triangle) {
        if (contact.painted[triangle]) {
            kept.push_back(stretches[triangle].area());
        }
    }
    return kept;
}

Wrinkling paintedWrinkling(const DippedFilm& film, const FilmContact& contact) {
    const std::vector<PrincipalStretch> stretches = principalStretches(film);
    const std::vector<FilmTriangle> triangles = filmTriangles(film.grid);
    Wrinkling result;
    result.pointStretches.assign(film.grid.pointCount(), 0);
    std::vector<int> counts(film.grid.pointCount(), 0);
    std::size_t painted = 0, wrinkled = 0;
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle) {
        if (!contact.painted[triangle]) {
            continue;
        }
        const float smaller = stretches[triangle].smaller;
        ++painted;
        wrinkled += smaller < wrinkledBelow ? 1 : 0;
        result.least = std::min(result.least, double(smaller));
        for (const std::uint32_t point : triangles[triangle]) {
            result.pointStretches[point] += smaller;
            ++counts[point];
        }
    }
    for (std::size_t point = 0; point < counts.size(); ++point) {
        float& value = result.pointStretches[point];
        value = counts[point] > 0 ? value / float(counts[point]) : 1.f;
    }
    const double triangleArea = film.grid.spacingX() * film.grid.spacingZ() / 2;
    result.area = double(wrinkled) * triangleArea;
    result.share = painted > 0 ? double(wrinkled) / double(painted) : 0;
    return result;
}

std::vector<std::uint8_t> paintedPoints(const DippedFilm& film, const FilmContact& contact) {
    std::vector<std::uint8_t> painted(film.grid.pointCount(), 0);
    const std::vector<FilmTriangle> triangles = filmTriangles(film.grid);
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle) {
        if (contact.painted[triangle]) {
            for (const std::uint32_t point : triangles[triangle]) {
                painted[point] = 1;
            }
        }
    }
    return painted;
}

} // namespace dipwright
