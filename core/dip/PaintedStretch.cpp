#include "dip/PaintedStretch.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <span>

namespace dipwright {

namespace {

// Number of rings of triangles that the fit uses at the rim of painted film (rimRings) and beyond
// the rim (beyondRings). Beyond the rim the fit needs more triangles, or the error of one triangle
// would tilt it.
constexpr int rimRings = 2, beyondRings = 3;

// A constraint along a side of a painted triangle: its ends and its stretch.
struct PaintedConstraint {
    std::uint32_t from, to;
    float stretch;
};

// Returns the constraints of painted film in the order of constraintStretches().
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

// Returns per film point the mean of `value` over the painted triangles round it; `otherwise` if
// there are none.
template <typename Value>
std::vector<float> meanOfTriangles(const std::vector<FilmTriangle>& triangles,
                                   const FilmContact& contact, const Value& value,
                                   float otherwise = 1) {
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
        sums[point] = counts[point] > 0 ? sums[point] / float(counts[point]) : otherwise;
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

// Fits J of painted film as a linear function of the flat film round a point. A plain mean over the
// triangles round the point has no first-order error if they lie on all sides. If they lie on one
// side only, the mean is the value half a cell away from the point. That is the case at the rim,
// where J grows fastest.
class StretchAtRim {
public:
    StretchAtRim(const DippedFilm& film, const std::vector<FilmTriangle>& triangles,
                 const std::vector<PrincipalStretch>& stretches, const FilmContact& contact)
        : film_(film), triangles_(triangles), stretches_(stretches), contact_(contact),
          first_(film.grid.pointCount() + 1), trianglesAtPoints_(3 * triangles.size()) {
        for (const FilmTriangle& corners : triangles) {
            for (const std::uint32_t point : corners) {
                ++first_[point + 1];
            }
        }
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle) {
            for (const std::uint32_t point : triangles[triangle]) {
                trianglesAtPoints_[next[point]++] = triangle;
            }
        }
    }

    // Whether some triangle round the point is not painted.
    bool isAtRim(std::uint32_t point) const {
        const auto round = trianglesAt(point);
        return std::any_of(round.begin(), round.end(),
                           [&](std::uint32_t triangle) { return contact_.painted[triangle] == 0; });
    }
    // Returns the linear fit at `point` through the painted triangles in `rings` rings round the
    // painted points `known`. `areas` are the means over the triangles round each point.
    float at(std::uint32_t point, const std::set<std::uint32_t>& known, int rings,
             const std::vector<float>& areas) const {
        float mean = 0;
        for (const std::uint32_t near : known) {
            mean += areas[near] / float(known.size());
        }
        std::set<std::uint32_t> patch, points = known;
        for (int ring = 0; ring < rings; ++ring) {
            for (const std::uint32_t near : points) {
                patch.merge(paintedAt(near));
            }
            for (const std::uint32_t triangle : patch) {
                points.insert(triangles_[triangle].begin(), triangles_[triangle].end());
            }
        }
        return linear(patch, point, mean);
    }

private:
    std::span<const std::uint32_t> trianglesAt(std::uint32_t point) const {
        return std::span(trianglesAtPoints_)
            .subspan(first_[point], first_[point + 1] - first_[point]);
    }
    std::set<std::uint32_t> paintedAt(std::uint32_t point) const {
        std::set<std::uint32_t> painted;
        for (const std::uint32_t triangle : trianglesAt(point)) {
            if (contact_.painted[triangle]) {
                painted.insert(triangle);
            }
        }
        return painted;
    }
    // Returns a least-squares fit of the triangles' J at `point`. The fit exceeds the range of
    // their values by at most the width of that range. It is blended with `mean`; the weight of the
    // fit is its correlation coefficient.
    float linear(const std::set<std::uint32_t>& patch, std::uint32_t point, float mean) const {
        const Eigen::Vector2d origin = restPosition(film_.grid, point).cast<double>();
        Eigen::MatrixX3d places(Eigen::Index(patch.size()), 3);
        Eigen::VectorXd areas(Eigen::Index(patch.size()));
        Eigen::Index row = 0;
        for (const std::uint32_t triangle : patch) {
            Eigen::Vector2d middle = Eigen::Vector2d::Zero();
            for (const std::uint32_t corner : triangles_[triangle]) {
                middle += restPosition(film_.grid, corner).cast<double>() / 3;
            }
            places.row(row) << 1, (middle - origin).transpose();
            areas[row++] = double(stretches_[triangle].area());
        }
        const double least = areas.minCoeff(), most = areas.maxCoeff();
        const Eigen::Vector3d fit = places.completeOrthogonalDecomposition().solve(areas);
        const double spread = (areas.array() - areas.mean()).square().sum();
        const double left = (areas - places * fit).squaredNorm();
        const double explained = spread > 0 ? std::sqrt(std::max(0.0, 1 - left / spread)) : 1;
        const double there =
            std::clamp(fit[0], std::max(2 * least - most, least / 2), 2 * most - least);
        return float(mean + explained * (there - double(mean)));
    }

    const DippedFilm& film_;
    const std::vector<FilmTriangle>& triangles_;
    const std::vector<PrincipalStretch>& stretches_;
    const FilmContact& contact_;
    // Per point, plus one entry: start of its triangles in trianglesAtPoints_.
    std::vector<std::uint32_t> first_;
    std::vector<std::uint32_t> trianglesAtPoints_; // the triangles at each point
};

// Refines J at the rim of painted film, and extrapolates it just past the limit of contact.
std::vector<float> continuedToLimit(const std::vector<float>& means,
                                    const std::vector<std::uint8_t>& isPainted,
                                    const std::vector<FilmTriangle>& triangles,
                                    const FilmContact& contact, const StretchAtRim& rim) {
    std::vector<float> areas = means;
    for (std::uint32_t point = 0; point < areas.size(); ++point) {
        if (isPainted[point] && rim.isAtRim(point)) {
            areas[point] = rim.at(point, {point}, rimRings, means);
        }
    }
    // Points past the limit, and the painted points nearest to each.
    std::map<std::uint32_t, std::set<std::uint32_t>> beyond;
    for (bool grows = true; grows;) {
        const auto nearer = beyond;
        for (const auto& [triangle, limit] : contact.limits) {
            for (const std::uint32_t point : triangles[triangle]) {
                for (const std::uint32_t other : triangles[triangle]) {
                    if (isPainted[point] || nearer.contains(point)) {
                        continue;
                    }
                    if (isPainted[other]) {
                        beyond[point].insert(other);
                    } else if (const auto known = nearer.find(other); known != nearer.end()) {
                        beyond[point].insert(known->second.begin(), known->second.end());
                    }
                }
            }
        }
        grows = beyond.size() > nearer.size();
    }
    for (const auto& [point, known] : beyond) {
        areas[point] = rim.at(point, known, beyondRings, means);
    }
    return areas;
}

// Corrects J of the cells for the interpolation between their middles, whose mean over a cell has
// only 9/16 of the cell's own J in it. So narrow stripes that have shrunk or stretched keep their
// J.
std::vector<float> sharpened(const std::vector<float>& cells, int columns, int rows) {
    constexpr float mostChange = 1.25F; // as a factor
    // The mean over a cell of linear interpolation between the middles, along one axis.
    constexpr std::array<float, 3> shares{0.125F, 0.75F, 0.125F};
    std::vector<float> sharp = cells;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const float own = cells[std::size_t(row) * std::size_t(columns) + std::size_t(column)];
            float mean = 0;
            for (int j = -1; j <= 1; ++j) {
                for (int i = -1; i <= 1; ++i) {
                    const int x = std::clamp(column + i, 0, columns - 1);
                    const int y = std::clamp(row + j, 0, rows - 1);
                    const float near =
                        cells[std::size_t(y) * std::size_t(columns) + std::size_t(x)];
                    mean += shares[std::size_t(i + 1)] * shares[std::size_t(j + 1)] *
                            (std::isnan(near) ? own : near);
                }
            }
            sharp[std::size_t(row) * std::size_t(columns) + std::size_t(column)] =
                std::clamp(2 * own - mean, own / mostChange, own * mostChange);
        }
    }
    return sharp;
}

Wrinkling wrinkling(const DippedFilm& film, const std::vector<FilmTriangle>& triangles,
                    const std::vector<PrincipalStretch>& stretches, const FilmContact& contact) {
    const auto compressionOf = [&](std::size_t triangle) {
        return compression(film, triangles[triangle], stretches[triangle]);
    };
    Wrinkling result;
    result.pointStretches = meanOfTriangles(triangles, contact, compressionOf);
    // Areas are in units of the first triangle's area, so that sums over a film of equal cells are
    // exact.
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
    result.wrinkling = wrinkling(film, triangles, stretches, contact);
    return result;
}

std::vector<float> paintedCellAreas(const DippedFilm& film,
                                    const std::vector<FilmTriangle>& triangles,
                                    const std::vector<PrincipalStretch>& stretches,
                                    const FilmContact& contact) {
    constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> means = meanOfTriangles(
        triangles, contact, [&](std::size_t triangle) { return stretches[triangle].area(); },
        unknown);
    const std::vector<float> points =
        continuedToLimit(means, paintedPoints(triangles, contact), triangles, contact,
                         StretchAtRim(film, triangles, stretches, contact));
    std::vector<float> cells(triangles.size() / 2, unknown);
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
        float sum = 0, painted = 0, pointSum = 0, known = 0;
        for (const std::size_t triangle : {2 * cell, 2 * cell + 1}) {
            if (contact.painted[triangle]) {
                sum += stretches[triangle].area();
                ++painted;
            }
            for (const std::uint32_t point : triangles[triangle]) {
                if (!std::isnan(points[point])) {
                    pointSum += points[point];
                    ++known;
                }
            }
        }
        // If one triangle of the cell is painted, the mean of the points is nearer to J in the
        // cell's middle than this triangle's J.
        cells[cell] = painted == 2 ? sum / painted : known > 0 ? pointSum / known : unknown;
    }
    cells = sharpened(cells, film.grid.columns - 1, film.grid.rows - 1);
    std::replace_if(
        cells.begin(), cells.end(), [](float area) { return std::isnan(area); }, 1.0F);
    return cells;
}

} // namespace dipwright
