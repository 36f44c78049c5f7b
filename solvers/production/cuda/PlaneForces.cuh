// Computes the elastic forces of the production film on the GPU and their derivative
// (PlaneStress.h, CrossingTriangle.h), tile by tile. A block computes all triangles that touch its
// tile's points and sums their forces in shared memory. Neighbouring blocks compute the triangles
// on a tile's border again.
#pragma once

#include "production/cuda/PlaneMultigrid.cuh"
#include "production/formulas/FilmBackend.h"

namespace dipwright::cuda {

// The forces on the edges of one cell: on the lower (first) and upper (second) horizontal edge, and
// the cell's contribution to its left and right vertical edge.
struct CellForces {
    float2 first, second, left, right;
};

// Returns the edges of a triangle between displaced points. restX, restZ: lengths of the undeformed
// edges; 0 if at() returns changes of displacements.
template <typename At>
__device__ inline numerics::EdgePair<float> triangleEdges(const numerics::TriangleCorners& triangle,
                                                          float restX, float restZ, const At& at) {
    const float2 left = at(triangle.points[0]), right = at(triangle.points[1]),
                 third = at(triangle.points[2]);
    const float2 shared = triangle.thirdOnRight ? right : left;
    const float2 vertical = triangle.thirdAbove ? third - shared : shared - third;
    return {restX + (right.x - left.x), right.y - left.y, vertical.x, restZ + vertical.y};
}

__device__ inline numerics::Matrix2<float> shapeOf(const ProductionDip& dip, int triangle) {
    const float4 shape = dip.inverseShape[triangle];
    return {shape.x, shape.y, shape.z, shape.w};
}

// Calls triangleForces(triangle, corners, x, z, at) → EdgePair for both triangles of each cell of a
// tile; at(point) reads `values` in shared memory. Then calls gather(x, z, force) for each point of
// the tile.
template <typename TriangleForces, typename Gather>
__device__ inline void gatherForces(const ProductionModel& model, const FilmTile& tile,
                                    const float2* values, CellForces* forces,
                                    const TriangleForces& triangleForces, const Gather& gather) {
    const int cellColumns = model.columns - 1;
    const auto at = [&](std::uint32_t point) {
        const int z = int(point) / model.columns, x = int(point) - z * model.columns;
        return values[(z - tile.corners.z0) * tile.corners.width() + x - tile.corners.x0];
    };
    // Each triangle has a thread of its own.
    const bool second = threadIdx.x % 2 != 0;
    forRange(
        tile.cells,
        [&](int x, int z) {
            const numerics::TriangleCorners corners =
                numerics::triangleCorners(model.columns, x, z, second);
            const numerics::EdgePair<float> force =
                triangleForces(2 * (z * cellColumns + x) + second, corners, x, z, at);
            CellForces& cell = forces[(z - tile.cells.z0) * tile.cells.width() + x - tile.cells.x0];
            (second ? cell.second : cell.first) = {force.hx, force.hz};
            (corners.thirdOnRight ? cell.right : cell.left) = {force.vx, force.vz};
        },
        int(threadIdx.x) / 2, Team::threads / 2);
    __syncthreads();
    forRange(tile.points, [&](int x, int z) {
        float2 sum{0, 0};
        for (int j = max(z - 1, 0); j < min(z + 1, model.rows - 1); ++j) {
            // The cells to the left and to the right of the point.
            const CellForces* cells =
                forces + (j - tile.cells.z0) * tile.cells.width() + x - tile.cells.x0;
            float2 edges{0, 0}, sides{0, 0};
            if (x > 0) {
                edges = j == z ? cells[-1].first : cells[-1].second;
                sides = cells[-1].right;
            }
            if (x < cellColumns) {
                edges = edges - (j == z ? cells[0].first : cells[0].second);
                sides = sides + cells[0].left;
            }
            sum = sum + (j == z ? edges - sides : edges + sides);
        }
        gather(x, z, sum);
    });
    __syncthreads();
}

// Computes the forces, including a water drag of `drag` per point. If `isAlong`, the displacement
// first becomes start + length·newtonStep. Writes the forces to `forces` and to the first basis
// vector, and to `stress` the values from which its derivative is computed later. Returns the roots
// of the sums of squares of the forces on free points and of the elastic forces in the film. One
// function, because a tile's places and sums stay in shared memory and registers from the first to
// the last line.
__device__ inline numerics::FilmForce force(const ProductionModel& model, const ProductionDip& dip,
                                            float drag, bool isAlong, float length, Team& team) {
    numerics::SquareSum squares, elastic;
#pragma unroll 1
    for (int t = team.block(); t < model.tiles.count(); t += team.blocks()) {
        const FilmTile tile(model, t);
        float2* values = tileMemory;
        auto* forces = reinterpret_cast<CellForces*>(tileMemory + tile.corners.count());
        forRange(tile.corners, [&](int x, int z) {
            const int point = z * model.columns + x;
            const float2 place = isAlong ? dip.start[point] + dip.newtonStep[point] * length
                                         : dip.displacement[point];
            values[(z - tile.corners.z0) * tile.corners.width() + x - tile.corners.x0] = place;
            if (isAlong && x >= tile.points.x0 && x < tile.points.x1 && z >= tile.points.z0 &&
                z < tile.points.z1) {
                dip.displacement[point] = place;
            }
        });
        __syncthreads();
        gatherForces(
            model, tile, values, forces,
            [&](int triangle, const numerics::TriangleCorners& corners, int x, int z,
                const auto& at) {
                const numerics::TriangleSize<float> size = triangleSize(model, x, z);
                const numerics::EdgePair<float> edges = triangleEdges(corners, size.x, size.z, at);
                const numerics::Matrix2<float> shape = shapeOf(dip, triangle);
                const bool crosses = dip.crosses[triangle] != 0;
                numerics::StressState<float> state;
                numerics::EdgePair<float> result;
                if (crosses) {
                    const numerics::CrossingTriangle<float>& crossing = dip.crossing[triangle];
                    const numerics::Matrix2<float> P = numerics::stress(
                        numerics::floatingGradient(
                            dip.anchors[triangle],
                            gradientOf(numerics::unfoldedEdges(edges, crossing), shape)),
                        model.gatheredResistance, state);
                    result = numerics::crossingForces(crossing, P, shape, size.area());
                } else {
                    result = numerics::edgeForces(
                        numerics::stress(gradientOf(edges, shape), model.gatheredResistance, state),
                        shape, size.area());
                }
                if (x >= tile.points.x0 && z >= tile.points.z0) { // counts each triangle once
                    dip.stress[triangle] = {state.cosine, state.sine, state.turn, state.resists};
                    float moves = 0;
                    for (const std::uint32_t point : corners.points) {
                        moves = fmaxf(moves, dip.masked[point]);
                    }
                    elastic.add(double(moves * (result.hx * result.hx + result.hz * result.hz)));
                }
                return result;
            },
            [&](int x, int z, float2 sum) {
                const int point = z * model.columns + x;
                const float2 way =
                    values[(z - tile.corners.z0) * tile.corners.width() + x - tile.corners.x0] -
                    dip.before[point];
                const float own = drag * pointArea(model, x, z);
                const float2 left = (sum + way * own) * dip.masked[point];
                dip.forces[point] = left;
                dip.basis[0][point] = left;
                squares.add(double(left.x * left.x + left.y * left.y));
            });
    }
    std::int64_t sums[4] = {squares.coarse, squares.rest, elastic.coarse, elastic.rest};
    team.sum(sums);
    return {numerics::SquareSum{sums[0], sums[1]}.root(),
            numerics::SquareSum{sums[2], sums[3]}.root()};
}

// Calls work(point, product) for all points. `product` is the Hessian times `vector`, including the
// drag.
template <typename Work>
__device__ inline void multiply(const ProductionModel& model, const ProductionDip& dip, float drag,
                                numerics::Tangent tangent, const float2* vector, const Team& team,
                                const Work& work) {
#pragma unroll 1
    for (int t = team.block(); t < model.tiles.count(); t += team.blocks()) {
        const FilmTile tile(model, t);
        float2* values = tileMemory;
        auto* forces = reinterpret_cast<CellForces*>(tileMemory + tile.corners.count());
        const auto value = [&](int x, int z) -> float2& {
            return values[(z - tile.corners.z0) * tile.corners.width() + x - tile.corners.x0];
        };
        forRange(tile.corners, [&](int x, int z) { value(x, z) = vector[z * model.columns + x]; });
        __syncthreads();
        gatherForces(
            model, tile, values, forces,
            [&](int triangle, const numerics::TriangleCorners& corners, int x, int z,
                const auto& at) {
                const float area = triangleSize(model, x, z).area();
                const numerics::Matrix2<float> shape = shapeOf(dip, triangle);
                const float4 stress = dip.stress[triangle];
                const numerics::StressState<float> state{stress.x, stress.y, stress.z, stress.w};
                const numerics::Matrix2<float> change =
                    gradientOf(triangleEdges(corners, 0, 0, at), shape);
                if (dip.crosses[triangle] == 0) {
                    return numerics::edgeForces(numerics::stressDerivative(change, state, tangent),
                                                shape, area);
                }
                return numerics::crossingForces(
                    dip.crossing[triangle],
                    numerics::stressDerivative(
                        numerics::floatingChange(dip.anchors[triangle], change), state, tangent),
                    shape, area);
            },
            [&](int x, int z, float2 sum) {
                const int point = z * model.columns + x;
                const float own = drag * pointArea(model, x, z);
                work(point, (sum + value(x, z) * own) * dip.masked[point]);
            });
    }
}

} // namespace dipwright::cuda
