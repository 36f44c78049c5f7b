#include "artwork/Unwrap.h"

#include "base/Budgets.h"
#include "base/Units.h"
#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dipwright {
namespace {

// Cos 50°: largest angle between the normals of a chart and its triangles.
constexpr double leastCosine = 0.64;
constexpr double leastFirstCosine = 0.77; // cos 40°, while the chart's mean normal is unknown
constexpr int margin = 2;                 // texels round a chart
constexpr int directions = 12; // number of rotations tried for a chart, within a quarter turn
// Factor by which the texel size grows if there are too many texels.
constexpr double texelGrowth = 1.15;
constexpr double sameEdge = 1e-4; // a place with a smaller weight counts as on a triangle's edge

using Place = Eigen::Vector2d;

// Part of the surface, laid flat.
struct Chart {
    std::vector<std::uint32_t> triangles;
    Eigen::Vector3d right, up;
    Place least, most;                            // mm
    int left = 0, top = 0, width = 0, height = 0; // texels, in the picture

    Place flat(const Eigen::Vector3f& position) const {
        return {right.dot(position.cast<double>()), -up.dot(position.cast<double>())};
    }
};

Eigen::Vector3d meanNormal(const TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& normals,
                           const std::vector<std::uint32_t>& triangles) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const std::uint32_t triangle : triangles) {
        sum += triangleArea(mesh, triangle) * normals[triangle];
    }
    return sum.norm() > 0 ? Eigen::Vector3d(sum.normalized()) : Eigen::Vector3d::Zero();
}

// Returns the barycentric weights of a place; not finite if the triangle has no area.
Eigen::Vector3d weightsAt(const std::array<Place, 3>& corners, const Place& place) {
    const Place b = corners[1] - corners[0], c = corners[2] - corners[0];
    const Place p = place - corners[0];
    const double area = b.x() * c.y() - b.y() * c.x();
    const double second = (p.x() * c.y() - p.y() * c.x()) / area;
    const double third = (b.x() * p.y() - b.y() * p.x()) / area;
    return {1 - second - third, second, third};
}

// Calls body(column, row, weights) for the texels whose middles are in a triangle.
template <typename Body>
void forTexels(const std::array<Place, 3>& corners, int width, int height, const Body& body) {
    Eigen::AlignedBox2d box;
    for (const Place& corner : corners) {
        box.extend(corner);
    }
    const int left = std::max(0, int(std::ceil(box.min().x() - 0.5)));
    const int top = std::max(0, int(std::ceil(box.min().y() - 0.5)));
    const int right = std::min(width - 1, int(std::floor(box.max().x() - 0.5)));
    const int bottom = std::min(height - 1, int(std::floor(box.max().y() - 0.5)));
    for (int row = top; row <= bottom; ++row) {
        for (int column = left; column <= right; ++column) {
            const Eigen::Vector3d weights = weightsAt(corners, {column + 0.5, row + 0.5});
            if (weights.allFinite() && weights.minCoeff() >= -1e-9) {
                body(column, row, weights);
            }
        }
    }
}

class Unwrapper {
public:
    Unwrapper(const TriangleMesh& mesh, const Progress& progress)
        : mesh_(mesh), progress_(progress), opposite_(oppositeEdges(mesh)) {
        normals_.reserve(mesh.triangles.size());
        for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
            normals_.push_back(triangleNormal(mesh, triangle).cast<double>());
        }
    }

    Unwrapping unwrap(const std::vector<std::uint32_t>& begins, double texel) {
        texel_ = texel;
        std::vector<std::uint8_t> taken(mesh_.triangles.size());
        const auto begin = [&](std::uint32_t seed) {
            while (!taken[seed]) { // until a chart contains the seed
                progress_.cancelToken.throwIfCancelled();
                charts_.push_back(grown(seed, taken));
            }
        };
        std::for_each(begins.begin(), begins.end(), begin);
        for (std::uint32_t seed = 0; seed < taken.size(); ++seed) {
            begin(seed);
        }
        pack();
        return painted();
    }

private:
    Chart grown(std::uint32_t seed, std::vector<std::uint8_t>& taken) {
        const auto grow = [&](const Eigen::Vector3d& chartNormal, double leastLikeness) {
            return connected(seed, taken, [&](std::uint32_t triangle) {
                return normals_[triangle].isZero() ||
                       normals_[triangle].dot(chartNormal) > leastLikeness;
            });
        };
        Chart chart;
        Eigen::Vector3d chartNormal = normals_[seed];
        if (chartNormal.isZero()) {
            chartNormal = Eigen::Vector3d::UnitZ();
            chart.triangles = {seed};
        } else {
            const Eigen::Vector3d mean =
                meanNormal(mesh_, normals_, grow(chartNormal, leastFirstCosine));
            if (mean.dot(normals_[seed]) > leastCosine) {
                chartNormal = mean;
            }
            chart.triangles = grow(chartNormal, leastCosine);
        }
        layFlat(chart, chartNormal);
        keepApart(chart);
        for (const std::uint32_t triangle : chart.triangles) {
            taken[triangle] = 1;
        }
        return chart;
    }

    // Returns the free triangles for which `belongs` is true and that are connected with `first`;
    // `first` comes first.
    template <typename Belongs>
    std::vector<std::uint32_t>
    connected(std::uint32_t first, const std::vector<std::uint8_t>& taken, const Belongs& belongs) {
        std::vector<std::uint32_t> found{first};
        ++round_;
        visited_.resize(mesh_.triangles.size());
        visited_[first] = round_;
        for (std::size_t k = 0; k < found.size(); ++k) {
            for (std::uint32_t edge = 3 * found[k]; edge < 3 * found[k] + 3; ++edge) {
                if (opposite_[edge] == noEdge) {
                    continue;
                }
                const std::uint32_t other = opposite_[edge] / 3;
                if (visited_[other] != round_ && !taken[other] && belongs(other)) {
                    visited_[other] = round_;
                    found.push_back(other);
                }
            }
        }
        return found;
    }

    // Lays a chart flat, rotated so that its bounding box is smallest.
    void layFlat(Chart& chart, const Eigen::Vector3d& chartNormal) const {
        const Eigen::Vector3d aside = chartNormal.unitOrthogonal();
        double smallest = std::numeric_limits<double>::infinity();
        const Chart flat = chart;
        for (int k = 0; k < directions; ++k) {
            Chart tried;
            const double angle = pi / 2 * k / directions;
            tried.right = Eigen::AngleAxisd(angle, chartNormal) * aside;
            tried.up = chartNormal.cross(tried.right);
            Eigen::AlignedBox2d box;
            for (const std::uint32_t triangle : flat.triangles) {
                for (const std::uint32_t corner : mesh_.triangles[triangle]) {
                    box.extend(tried.flat(mesh_.positions[corner]));
                }
            }
            if (box.volume() < smallest || k == 0) {
                smallest = box.volume();
                chart.right = tried.right;
                chart.up = tried.up;
                chart.least = box.min();
                chart.most = box.max();
            }
        }
        const Place size = (chart.most - chart.least) / texel_;
        chart.width = std::max(1, int(std::ceil(size.x()))) + 2 * margin;
        chart.height = std::max(1, int(std::ceil(size.y()))) + 2 * margin;
    }

    // Returns the corners of a triangle, in texels from the upper left corner of its chart.
    std::array<Place, 3> cornersIn(const Chart& chart, std::uint32_t triangle) const {
        std::array<Place, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] =
                (chart.flat(mesh_.positions[mesh_.triangles[triangle][k]]) - chart.least) / texel_ +
                Place::Constant(margin);
        }
        return corners;
    }

    // Removes a triangle if it contains the middle of a texel that another triangle already
    // contains.
    void keepApart(Chart& chart) const {
        if (chart.triangles.size() == 1) {
            return;
        }
        std::vector<std::uint8_t> filled(std::size_t(chart.width) * std::size_t(chart.height));
        std::erase_if(chart.triangles, [&](std::uint32_t triangle) {
            const auto corners = cornersIn(chart, triangle);
            bool isOver = false;
            const auto texelAt = [&](int column, int row) -> std::uint8_t& {
                return filled[std::size_t(row) * std::size_t(chart.width) + std::size_t(column)];
            };
            forTexels(corners, chart.width, chart.height,
                      [&](int column, int row, const Eigen::Vector3d& weights) {
                          isOver = isOver ||
                                   (weights.minCoeff() > sameEdge && texelAt(column, row) == 2);
                      });
            if (!isOver) {
                forTexels(corners, chart.width, chart.height,
                          [&](int column, int row, const Eigen::Vector3d& weights) {
                              std::uint8_t& texel = texelAt(column, row);
                              texel = std::max(texel,
                                               std::uint8_t(weights.minCoeff() > sameEdge ? 2 : 1));
                          });
            }
            return isOver;
        });
    }

    // Packs the charts in rows, tallest first.
    void pack() {
        std::vector<std::size_t> order(charts_.size());
        std::iota(order.begin(), order.end(), std::size_t(0));
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return charts_[a].height > charts_[b].height;
        });
        double area = 0;
        for (const Chart& chart : charts_) {
            area += double(chart.width) * chart.height;
            width_ = std::max(width_, chart.width);
        }
        width_ = std::max(width_, int(std::ceil(std::sqrt(1.05 * area))));
        int left = 0, top = 0;
        for (const std::size_t number : order) {
            Chart& chart = charts_[number];
            if (left + chart.width > width_) {
                top = height_;
                left = 0;
            }
            chart.left = left;
            chart.top = top;
            left += chart.width;
            height_ = std::max(height_, top + chart.height);
        }
    }

    Unwrapping painted() const {
        Unwrapping result;
        result.texel = texel_;
        result.width = width_;
        result.height = height_;
        result.corners.resize(mesh_.triangles.size());
        result.chart.resize(mesh_.triangles.size());
        result.owner.assign(std::size_t(width_) * std::size_t(height_), Unwrapping::nobody);
        parallelFor(std::size_t(0), charts_.size(), [&](std::size_t number) {
            const Chart& chart = charts_[number];
            std::vector<std::uint32_t> owner(std::size_t(chart.width) * std::size_t(chart.height),
                                             Unwrapping::nobody);
            const auto at = [&](int column, int row) -> std::uint32_t& {
                return owner[std::size_t(row) * std::size_t(chart.width) + std::size_t(column)];
            };
            for (const std::uint32_t triangle : chart.triangles) {
                const auto corners = cornersIn(chart, triangle);
                result.chart[triangle] = std::uint32_t(number);
                for (std::size_t k = 0; k < 3; ++k) {
                    result.corners[triangle][k] =
                        (corners[k] + Place(chart.left, chart.top)).cast<float>();
                }
                forTexels(corners, chart.width, chart.height,
                          [&](int column, int row, const Eigen::Vector3d&) {
                              at(column, row) = std::min(at(column, row), triangle);
                          });
            }
            const auto middle = cornersIn(chart, chart.triangles.front());
            const Place inside = (middle[0] + middle[1] + middle[2]) / 3;
            std::uint32_t& one = at(int(inside.x()), int(inside.y()));
            one = one == Unwrapping::nobody ? chart.triangles.front() : one;
            widen(owner, chart.width, chart.height);
            for (int row = 0; row < chart.height; ++row) {
                std::copy_n(owner.begin() + std::ptrdiff_t(row) * chart.width, chart.width,
                            result.owner.begin() + std::ptrdiff_t(chart.top + row) * width_ +
                                chart.left);
            }
        });
        return result;
    }

    // Fills the margin round a chart with its nearest triangle.
    static void widen(std::vector<std::uint32_t>& owner, int width, int height) {
        for (int ring = 0; ring < margin; ++ring) {
            const std::vector<std::uint32_t> before = owner;
            for (int row = 0; row < height; ++row) {
                for (int column = 0; column < width; ++column) {
                    const auto index = std::size_t(row) * std::size_t(width) + std::size_t(column);
                    for (int k = 0; k < 9 && owner[index] == Unwrapping::nobody; ++k) {
                        const int beside = column + k % 3 - 1, below = row + k / 3 - 1;
                        if (beside >= 0 && below >= 0 && beside < width && below < height) {
                            owner[index] = before[std::size_t(below) * std::size_t(width) +
                                                  std::size_t(beside)];
                        }
                    }
                }
            }
        }
    }

    const TriangleMesh& mesh_;
    const Progress& progress_;
    std::vector<std::uint32_t> opposite_;
    std::vector<Eigen::Vector3d> normals_;
    std::vector<std::uint32_t> visited_; // round in which a triangle was last visited
    std::uint32_t round_ = 0;
    double texel_ = 0;
    std::vector<Chart> charts_;
    int width_ = 0, height_ = 0;
};

} // namespace

Unwrapping unwrapped(const TriangleMesh& mesh, const std::vector<std::uint32_t>& begins,
                     double texel, qint64 mostTexels, const Progress& progress) {
    const double extent = double(longestEdgeOf(mesh));
    const double side = double(budgetLimit(Budget::PictureSide) / 4);
    texel = std::max({texel, std::sqrt(surfaceArea(mesh) / double(mostTexels)), 2 * extent / side,
                      1e-6 * extent});
    while (true) {
        Unwrapping result = Unwrapper(mesh, progress).unwrap(begins, texel);
        const qint64 texels = qint64(result.width) * result.height;
        const bool canShrink = texels > 64 * qint64(mesh.triangles.size());
        if (texels <= mostTexels || !canShrink) {
            requireWithin(Budget::PictureSide, std::max(result.width, result.height), {});
            return result;
        }
        texel *= std::max(texelGrowth, std::sqrt(double(texels) / double(mostTexels)));
    }
}

} // namespace dipwright
