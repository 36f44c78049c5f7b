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
                                                  const std::vector<FilmTriangle>& triangles,
                                                  const FilmContact& contact) {
    const auto columns = std::uint32_t(film.grid.columns);
    const auto rows = std::uint32_t(film.grid.rows);
    const std::vector<float> stretches = constraintStretches(film);
    const std::size_t firstVertical = std::size_t(rows) * (columns - 1);
    std::vector<std::uint8_t> isPainted(stretches.size(), 0);
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

std::vector<float> meanOfConstraints(const std::vector<PaintedConstraint>& constraints,
                                     std::size_t points) {
    std::vector<float> sums(points, 0);
    std::vector<int> counts(points, 0);
    for (const PaintedConstraint& constraint : constraints) {
        for (const std::uint32_t point : {constraint.from, constraint.to}) {
            sums[point] += constraint.stretch;
            ++counts[point];
        }
    }
    for (std::size_t point = 0; point < points; ++point) {
        sums[point] = counts[point] > 0 ? sums[point] / float(counts[point]) : 1.f;
    }
    return sums;
}

// For each film point the mean of `value` over the painted triangles round it; 1 where none is.
template <typename Value>
std::vector<float> meanOfTriangles(const std::vector<FilmTriangle>& triangles,
                                   const FilmContact& contact, const Value& value) {
    std::vector<float> sums(contact.surface.size(), 0);
    std::vector<int> counts(contact.surface.size(), 0);
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle) {
        if (contact.painted[triangle]) {
            for (const std::uint32_t point : triangles[triangle]) {
                sums[point] += value(triangle);
                ++counts[point];
            }
        }
    }
    for (std::size_t point = 0; point < sums.size(); ++point) {
        sums[point] = counts[point] > 0 ? sums[point] / float(counts[point]) : 1.f;
    }
    return sums;
}

std::vector<std::uint8_t> paintedPoints(const std::vector<FilmTriangle>& triangles,
                                        const FilmContact& contact) {
    std::vector<std::uint8_t> painted(contact.surface.size(), 0);
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle) {
        if (contact.painted[triangle]) {
            for (const std::uint32_t point : triangles[triangle]) {
                painted[point] = 1;
            }
        }
    }
    return painted;
}

// Just past the limit of contact film would be stretched as it is before it.
void continueToLimit(std::vector<float>& stretches, const std::vector<std::uint8_t>& isPainted,
                     const std::vector<FilmTriangle>& triangles, const FilmContact& contact) {
    for (const auto& [triangle, limit] : contact.limits) {
        float sum = 0;
        int known = 0;
        for (const std::uint32_t point : triangles[triangle]) {
            sum += isPainted[point] ? stretches[point] : 0;
            known += isPainted[point] ? 1 : 0;
        }
        for (const std::uint32_t point : triangles[triangle]) {
            stretches[point] =
                isPainted[point] || known == 0 ? stretches[point] : sum / float(known);
        }
    }
}

Wrinkling wrinkling(const DippedFilm& film, const std::vector<FilmTriangle>& triangles,
                    const std::vector<PrincipalStretch>& stretches, const FilmContact& contact) {
    const auto compressionOf = [&](std::size_t triangle) {
        return compression(film, triangles[triangle], stretches[triangle]);
    };
    Wrinkling result;
    result.pointStretches = meanOfTriangles(triangles, contact, compressionOf);
    // In triangles of the first one's size, which makes whole numbers of an even film's.
    const double unit = restArea(film.grid, 0);
    double painted = 0, wrinkled = 0;
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle) {
        if (contact.painted[triangle]) {
            const float smaller = compressionOf(triangle);
            const double size = restArea(film.grid, triangle) / unit;
            painted += size;
            wrinkled += smaller < wrinkledBelow ? size : 0;
            result.least = std::min(result.least, double(smaller));
        }
    }
    result.area = wrinkled * unit;
    result.share = painted > 0 ? wrinkled / painted : 0;
    return result;
}

} // namespace

PaintedStretch paintedStretch(const DippedFilm& film, const std::vector<FilmTriangle>& triangles,
                              const std::vector<PrincipalStretch>& stretches,
                              const FilmContact& contact) {
    PaintedStretch result;
    result.points = paintedPoints(triangles, contact);
    const std::vector<PaintedConstraint> constraints = paintedConstraints(film, triangles, contact);
    for (const PaintedConstraint& constraint : constraints) {
        result.constraints.push_back(constraint.stretch);
    }
    result.pointMeans = meanOfConstraints(constraints, film.grid.pointCount());
    for (std::size_t triangle = 0; triangle < triangles.size(); ++triangle) {
        if (contact.painted[triangle]) {
            result.areas.push_back(stretches[triangle].area());
        }
    }
    result.pointAreas = meanOfTriangles(
        triangles, contact, [&](std::size_t triangle) { return stretches[triangle].area(); });
    continueToLimit(result.pointAreas, result.points, triangles, contact);
    result.wrinkling = wrinkling(film, triangles, stretches, contact);
    return result;
}

} // namespace dipwright
