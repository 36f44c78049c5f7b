#include "ImplicitSurface.h"

#include <cmath>
#include <map>
#include <unordered_map>

namespace dipwright::samples {

namespace {

using Cell = Eigen::Vector3i;
using Triangle = std::array<std::uint32_t, 3>;

// Holds the field's values at the points of a uniform grid.
class SampledGrid {
public:
    SampledGrid(const Field& field, const BoundingBox& box, float step)
        : origin_(box.min()), step_(step),
          size_((box.sizes() / step).array().ceil().cast<int>().matrix() + Cell::Ones()) {
        values_.reserve(std::size_t(size_.prod()));
        for (int z = 0; z < size_.z(); ++z) {
            for (int y = 0; y < size_.y(); ++y) {
                for (int x = 0; x < size_.x(); ++x) {
                    values_.push_back(field(place(Cell(x, y, z))));
                }
            }
        }
    }
    const Cell& size() const { return size_; }
    Eigen::Vector3f place(const Cell& corner) const {
        return origin_ + step_ * corner.cast<float>();
    }
    float value(const Cell& corner) const { return values_[index(corner)]; }
    bool inside(const Cell& corner) const { return value(corner) < 0; }
    std::uint32_t index(const Cell& corner) const {
        return std::uint32_t((corner.z() * size_.y() + corner.y()) * size_.x() + corner.x());
    }

private:
    Eigen::Vector3f origin_;
    float step_;
    Cell size_;
    std::vector<float> values_;
};

Cell cornerOfCell(int corner) {
    return {corner & 1, (corner >> 1) & 1, (corner >> 2) & 1};
}

// Computes the mean of the places where the surface crosses the cell's edges. Returns false if the
// surface crosses no edge.
bool crossingMean(const SampledGrid& grid, const Cell& cell, Eigen::Vector3f& mean) {
    mean.setZero();
    int crossings = 0;
    for (int corner = 0; corner < 8; ++corner) {
        for (int axis = 0; axis < 3; ++axis) {
            if (corner & (1 << axis)) {
                continue;
            }
            const Cell from = cell + cornerOfCell(corner);
            const Cell to = from + Cell::Unit(axis);
            if (grid.inside(from) != grid.inside(to)) {
                const float share = grid.value(from) / (grid.value(from) - grid.value(to));
                mean += grid.place(from) + share * (grid.place(to) - grid.place(from));
                ++crossings;
            }
        }
    }
    if (crossings > 0) {
        mean /= float(crossings);
    }
    return crossings > 0;
}

void appendQuadrilateral(TriangleMesh& mesh, const std::array<std::uint32_t, 4>& corners) {
    const auto length = [&](int a, int b) {
        return (mesh.positions[corners[a]] - mesh.positions[corners[b]]).squaredNorm();
    };
    const int first = length(0, 2) <= length(1, 3) ? 0 : 1;
    for (const int turn : {0, 2}) {
        mesh.triangles.push_back({corners[(first + turn) % 4], corners[(first + turn + 1) % 4],
                                  corners[(first + turn + 2) % 4]});
    }
}

TriangleMesh surfaceNets(const SampledGrid& grid) {
    TriangleMesh mesh;
    std::unordered_map<std::uint32_t, std::uint32_t> vertexOfCell;
    for (int z = 0; z + 1 < grid.size().z(); ++z) {
        for (int y = 0; y + 1 < grid.size().y(); ++y) {
            for (int x = 0; x + 1 < grid.size().x(); ++x) {
                Eigen::Vector3f place;
                if (crossingMean(grid, {x, y, z}, place)) {
                    vertexOfCell[grid.index({x, y, z})] = std::uint32_t(mesh.positions.size());
                    mesh.positions.push_back(place);
                }
            }
        }
    }
    for (int z = 1; z + 1 < grid.size().z(); ++z) {
        for (int y = 1; y + 1 < grid.size().y(); ++y) {
            for (int x = 1; x + 1 < grid.size().x(); ++x) {
                for (int axis = 0; axis < 3; ++axis) {
                    const Cell corner(x, y, z);
                    const Cell u = Cell::Unit((axis + 1) % 3);
                    const Cell v = Cell::Unit((axis + 2) % 3);
                    const bool inside = grid.inside(corner);
                    if (inside == grid.inside(corner + Cell::Unit(axis))) {
                        continue;
                    }
                    std::array<Cell, 4> round{corner - u - v, corner - v, corner, corner - u};
                    if (!inside) {
                        std::swap(round[1], round[3]);
                    }
                    std::array<std::uint32_t, 4> quadrilateral{};
                    for (int i = 0; i < 4; ++i) {
                        quadrilateral[i] = vertexOfCell.at(grid.index(round[i]));
                    }
                    appendQuadrilateral(mesh, quadrilateral);
                }
            }
        }
    }
    return mesh;
}

// Moves each vertex halfway to the mean of its neighbours and back onto the surface.
void smoothVertices(TriangleMesh& mesh, const Field& field) {
    std::vector<Eigen::Vector3f> sum(mesh.positions.size(), Eigen::Vector3f::Zero());
    std::vector<float> count(mesh.positions.size(), 0);
    for (const Triangle& triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t from = triangle[corner];
            sum[from] += mesh.positions[triangle[(corner + 1) % 3]];
            count[from] += 1;
        }
    }
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        Eigen::Vector3f& place = mesh.positions[i];
        place = 0.5F * (place + sum[i] / count[i]);
        const Eigen::Vector3f gradient = slope(field, place);
        place -= field(place) / gradient.squaredNorm() * gradient;
    }
}

} // namespace

Eigen::Vector3f slope(const Field& field, const Eigen::Vector3f& place) {
    const float reach = 0.01F;
    Eigen::Vector3f result;
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3f offset = reach * Eigen::Vector3f::Unit(axis);
        result[axis] = (field(place + offset) - field(place - offset)) / (2 * reach);
    }
    return result;
}

TriangleMesh surfaceMesh(const Field& field, const BoundingBox& box, float step) {
    TriangleMesh mesh = surfaceNets(SampledGrid(field, box, step));
    for (int round = 0; round < 30; ++round) {
        smoothVertices(mesh, field);
    }
    return mesh;
}

TriangleMesh cutAtGround(TriangleMesh mesh, float snap) {
    for (Eigen::Vector3f& place : mesh.positions) {
        if (std::abs(place.y()) < snap) {
            place.y() = 0;
        }
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto crosses = [&](std::uint32_t a, std::uint32_t b) {
        return mesh.positions[a].y() * mesh.positions[b].y() < 0;
    };
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [entry, isNew] =
            middles.try_emplace(std::minmax(a, b), std::uint32_t(mesh.positions.size()));
        if (isNew) {
            const Eigen::Vector3f from = mesh.positions[a];
            const Eigen::Vector3f to = mesh.positions[b];
            Eigen::Vector3f place = from + from.y() / (from.y() - to.y()) * (to - from);
            place.y() = 0;
            mesh.positions.push_back(place);
        }
        return entry->second;
    };

    std::vector<Triangle> triangles;
    for (const Triangle& triangle : mesh.triangles) {
        // The triangle's outline, with a point inserted where it crosses the plane. The outline is
        // divided at these points.
        std::vector<std::uint32_t> above;
        std::vector<std::uint32_t> below;
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t from = triangle[corner];
            const std::uint32_t to = triangle[(corner + 1) % 3];
            const float height = mesh.positions[from].y();
            if (height >= 0) {
                above.push_back(from);
            }
            if (height <= 0) {
                below.push_back(from);
            }
            if (crosses(from, to)) {
                const std::uint32_t between = middle(from, to);
                above.push_back(between);
                below.push_back(between);
            }
        }
        if (above == below) {
            below.clear(); // the triangle lies in the plane
        }
        for (const std::vector<std::uint32_t>& side : {above, below}) {
            for (std::size_t i = 2; i < side.size(); ++i) {
                triangles.push_back({side[0], side[i - 1], side[i]});
            }
        }
    }
    mesh.triangles = std::move(triangles);
    return mesh;
}

} // namespace dipwright::samples
