#include "geometry/DistanceField.h"

#include "base/Error.h"
#include "geometry/SurfaceQuery.h"
#include "parallel/ParallelFor.h"
#include "parallel/ParallelSort.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

namespace dipwright {

namespace {

constexpr int exactCells = 5;
constexpr int coarsestStride = 8;

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::DistanceField)
};

std::size_t sampleIndex(const DistanceField& field, int i, int j, int k) {
    return (std::size_t(k) * std::size_t(field.size[1]) + std::size_t(j)) *
               std::size_t(field.size[0]) +
           std::size_t(i);
}

// Computes the unsigned distance, from coarse to fine. A level holds the samples whose indices are
// multiples of its stride. Each new sample lies between samples of the coarser level, which bound
// its distance from below and above. If the lower bound is many strides, it is kept as the sample's
// distance. Otherwise the distance is measured.
class DistanceSweep {
public:
    DistanceSweep(DistanceField& field, const SurfaceQuery& query) : field_(field), query_(query) {}

    void refine(int stride, const CancelToken& cancelToken) {
        const int planes = (field_.size[2] + stride - 1) / stride;
        parallelFor(0, planes, [&](int plane) {
            cancelToken.throwIfCancelled();
            for (int j = 0; j < field_.size[1]; j += stride) {
                refineRow(j, plane * stride, stride);
            }
        });
    }

private:
    void refineRow(int j, int k, int stride) {
        const double step = stride * field_.spacing;
        for (int i = 0; i < field_.size[0]; i += stride) {
            if (stride == coarsestStride) {
                at(i, j, k) = measure(i, j, k, std::numeric_limits<double>::infinity());
            } else if ((i | j | k) % (2 * stride) != 0) {
                const auto [lower, upper] = bounds(i, j, k, stride);
                at(i, j, k) = lower > exactCells * step ? float(lower) : measure(i, j, k, upper);
            }
        }
    }

    struct Bounds {
        double lower, upper;
    };

    // Bounds from the samples of the coarser level around (i, j, k): at most eight, all equally far
    // away.
    Bounds bounds(int i, int j, int k, int stride) const {
        const std::array<int, 3> index{i, j, k};
        std::array<int, 3> low{}, high{};
        int odd = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const int beside = index[axis] % (2 * stride);
            odd += beside != 0;
            low[axis] = index[axis] - beside;
            high[axis] =
                index[axis] + beside < field_.size[axis] ? index[axis] + beside : low[axis];
        }
        float farthest = 0, nearest = std::numeric_limits<float>::infinity();
        for (const int z : {low[2], high[2]}) {
            for (const int y : {low[1], high[1]}) {
                const float a = at(low[0], y, z), b = at(high[0], y, z);
                farthest = std::max({farthest, a, b});
                nearest = std::min({nearest, a, b});
            }
        }
        const double step = stride * field_.spacing, away = step * std::sqrt(odd);
        // Near the surface, the coarser level's distances are measured. Farther away they are only
        // lower bounds, which give no upper bound.
        const bool isMeasured = nearest <= exactCells * 2 * step;
        // The factors keep float rounding from making either bound too tight.
        return {(farthest - away) * (1 - 1e-6), isMeasured
                                                    ? (nearest + away) * (1 + 1e-3)
                                                    : std::numeric_limits<double>::infinity()};
    }

    float measure(int i, int j, int k, double within) const {
        const Eigen::Vector3d place = field_.origin + field_.spacing * Eigen::Vector3d(i, j, k);
        return query_.closestNear(place.cast<float>(), float(within)).distance;
    }

    float& at(int i, int j, int k) { return field_.distance[sampleIndex(field_, i, j, k)]; }
    float at(int i, int j, int k) const { return field_.distance[sampleIndex(field_, i, j, k)]; }

    DistanceField& field_;
    const SurfaceQuery& query_;
};

// Decides which samples lie inside, by ray parity in all three directions. Along every row of
// samples the surface's crossings are counted with their sign. A sample gets a vote for inside from
// each end of the row from which the signed count is not zero. In a closed mesh all six votes
// agree. In an open mesh the majority closes the holes.
class InsideVotes {
public:
    InsideVotes(const TriangleMesh& body, const DistanceField& field)
        : field_(field), votes_(field.distance.size()) {
        corners_.reserve(body.positions.size());
        for (const auto& position : body.positions) {
            corners_.push_back((position.cast<double>() - field.origin) / field.spacing);
        }
        for (int axis = 0; axis < 3; ++axis) {
            voteAlong(axis, crossingsAlong(axis, body));
        }
    }

    bool isInside(std::size_t sample) const { return votes_[sample] > 3; }

private:
    // Ordered by row, then by the first sample past the surface.
    struct Crossing {
        std::int32_t row, pastSurface;
        std::int32_t entered; // +1 into the body, −1 out of it
        bool operator<(const Crossing& other) const {
            return std::tie(row, pastSurface, entered) <
                   std::tie(other.row, other.pastSurface, other.entered);
        }
    };

    std::vector<Crossing> crossingsAlong(int axis, const TriangleMesh& body) const {
        std::vector<Crossing> crossings;
        for (const auto& triangle : body.triangles) {
            addCrossings(axis, triangle, crossings);
        }
        parallelSort(crossings.begin(), crossings.end());
        return crossings;
    }

    void addCrossings(int axis, const std::array<std::uint32_t, 3>& triangle,
                      std::vector<Crossing>& crossings) const {
        const int across = (axis + 1) % 3, up = (axis + 2) % 3;
        const auto& a = corners_[triangle[0]];
        const auto& b = corners_[triangle[1]];
        const auto& c = corners_[triangle[2]];
        const Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
        for (int v = int(std::ceil(low[up])); v <= high[up]; ++v) {
            for (int u = int(std::ceil(low[across])); u <= high[across]; ++u) {
                const double sideA = side(axis, triangle[1], triangle[2], u, v);
                const double sideB = side(axis, triangle[2], triangle[0], u, v);
                const double sideC = side(axis, triangle[0], triangle[1], u, v);
                const bool facesAlong = sideA > 0 && sideB > 0 && sideC > 0;
                const bool facesAgainst = sideA < 0 && sideB < 0 && sideC < 0;
                if (!facesAlong && !facesAgainst) {
                    continue;
                }
                const double meets =
                    (sideA * a[axis] + sideB * b[axis] + sideC * c[axis]) / (sideA + sideB + sideC);
                const double past = std::ceil(std::clamp(meets, low[axis], high[axis]));
                crossings.push_back({v * field_.size[across] + u, int(past), facesAlong ? -1 : 1});
            }
        }
    }

    // Returns on which side of the edge the row at (u, v) passes, as twice the signed area. An edge
    // is always measured in the same direction, so that both its triangles get the same answer. A
    // row that meets an edge is shifted by an infinitesimal amount (ε, ε²). Then no row passes
    // between two triangles or hits both.
    double side(int axis, std::uint32_t from, std::uint32_t to, int u, int v) const {
        if (from > to) {
            return -side(axis, to, from, u, v);
        }
        const int across = (axis + 1) % 3, up = (axis + 2) % 3;
        const Eigen::Vector3d& begin = corners_[from];
        const Eigen::Vector3d edge = corners_[to] - begin;
        const double area = edge[across] * (v - begin[up]) - edge[up] * (u - begin[across]);
        if (area != 0) {
            return area;
        }
        const double aside = edge[up] != 0 ? -edge[up] : edge[across];
        return std::copysign(aside != 0 ? std::numeric_limits<double>::min() : 0.0, aside);
    }

    void voteAlong(int axis, const std::vector<Crossing>& crossings) {
        const int rowsAcross = field_.size[(axis + 1) % 3];
        parallelFor(0, field_.size[(axis + 2) % 3], [&](int plane) {
            const auto before = [](const Crossing& crossing, int row) {
                return crossing.row < row;
            };
            auto first =
                std::lower_bound(crossings.begin(), crossings.end(), plane * rowsAcross, before);
            const auto end =
                std::lower_bound(first, crossings.end(), (plane + 1) * rowsAcross, before);
            while (first != end) {
                const auto next =
                    std::find_if(first, end, [row = first->row](const Crossing& crossing) {
                        return crossing.row != row;
                    });
                voteInRow(axis, std::span(first, next));
                first = next;
            }
        });
    }

    void voteInRow(int axis, std::span<const Crossing> crossings) {
        int total = 0;
        for (const auto& crossing : crossings) {
            total += crossing.entered;
        }
        int entered = 0, from = 0;
        for (const auto& crossing : crossings) {
            addVotes(axis, crossing.row, from, crossing.pastSurface,
                     (entered != 0) + (entered != total));
            entered += crossing.entered;
            from = crossing.pastSurface;
        }
        addVotes(axis, crossings.front().row, from, field_.size[axis], total != 0);
    }

    void addVotes(int axis, int row, int from, int to, int votes) {
        if (votes == 0) {
            return;
        }
        const int across = (axis + 1) % 3, up = (axis + 2) % 3;
        std::array<int, 3> index{};
        index[axis] = from;
        index[across] = row % field_.size[across];
        index[up] = row / field_.size[across];
        const std::array<std::size_t, 3> strides{1, std::size_t(field_.size[0]),
                                                 sampleIndex(field_, 0, 0, 1)};
        std::size_t sample = sampleIndex(field_, index[0], index[1], index[2]);
        for (int i = from; i < to; ++i, sample += strides[axis]) {
            votes_[sample] += std::uint8_t(votes);
        }
    }

    const DistanceField& field_;
    // The body's corners, in cells from the field's first sample.
    std::vector<Eigen::Vector3d> corners_;
    std::vector<std::uint8_t> votes_;
};

void applySigns(DistanceField& field, const InsideVotes& votes) {
    parallelFor(std::size_t(0), std::size_t(field.size[2]), [&](std::size_t plane) {
        const std::size_t count = sampleIndex(field, 0, 0, 1);
        for (std::size_t sample = plane * count; sample < (plane + 1) * count; ++sample) {
            if (votes.isInside(sample)) {
                field.distance[sample] = -field.distance[sample];
            }
        }
    });
}

} // namespace

double DistanceField::sample(const Eigen::Vector3d& position) const {
    const Eigen::Vector3d last(size[0] - 1, size[1] - 1, size[2] - 1);
    const Eigen::Vector3d cells = (position - origin) / spacing;
    const Eigen::Vector3d inGrid = cells.cwiseMax(0).cwiseMin(last);
    const Eigen::Vector3i cell =
        inGrid.cast<int>().cwiseMin(Eigen::Vector3i(size[0] - 2, size[1] - 2, size[2] - 2));
    const Eigen::Vector3d share = inGrid - cell.cast<double>();
    const auto row = [&](int j, int k) {
        const std::size_t first = sampleIndex(*this, cell.x(), cell.y() + j, cell.z() + k);
        return distance[first] + share.x() * (double(distance[first + 1]) - distance[first]);
    };
    const auto layer = [&](int k) { return row(0, k) + share.y() * (row(1, k) - row(0, k)); };
    const double inside = layer(0) + share.z() * (layer(1) - layer(0));

    const double beyond = (cells - inGrid).norm() * spacing;
    // At the nearest point of the grid, the directions to the body and to `position` form an obtuse
    // angle. So the hypotenuse is never too large.
    return beyond > 0 ? std::hypot(beyond, std::max(inside, 0.0)) : inside;
}

Eigen::Vector3d DistanceField::gradient(const Eigen::Vector3d& position) const {
    Eigen::Vector3d result;
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d half = Eigen::Vector3d::Unit(axis) * (spacing / 2);
        result[axis] = (sample(position + half) - sample(position - half)) / spacing;
    }
    return result;
}

DistanceField buildDistanceField(const TriangleMesh& model, int resolution,
                                 const Progress& progress) {
    const TriangleMesh body = inBodyCoordinates(model);
    return buildDistanceField(body, SurfaceQuery(body), cubeGrid(body, resolution), progress);
}

DistanceField buildDistanceField(const TriangleMesh& body, const SurfaceQuery& query,
                                 const FieldGrid& grid, const Progress& progress) {
    const QString what = Text::tr("Building the distance field");
    progress(0, what);
    DistanceField field{grid, std::vector<float>(grid.sampleCount()), nullptr};
    DistanceSweep sweep(field, query);
    for (int stride = coarsestStride; stride > 0; stride /= 2) {
        progress(0.5 / stride, what);
        sweep.refine(stride, progress.cancelToken);
    }
    progress(0.9, what);
    applySigns(field, InsideVotes(body, field));
    progress(1, what);
    return field;
}

} // namespace dipwright
