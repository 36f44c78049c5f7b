// The multigrid V-cycle on the GPU for the current stiffness of the film (GalerkinCycle.h). On the
// way down, a block smooths one tile after the other, computes the residual and restricts it to the
// coarser level. The block loads enough points around the tile for all smoothing steps, so it need
// not exchange data. The way up works in the same way. Every block computes all levels that fit
// into one block for itself, which saves barriers. Some loops must not be unrolled, because their
// code would not fit into the instruction cache.
#pragma once

#include "common/cuda/Tiles.h"
#include "production/cuda/Block.cuh"
#include "production/formulas/EdgeStiffness.h"

namespace dipwright::cuda {

__device__ inline float2 operator+(float2 a, float2 b) {
    return {a.x + b.x, a.y + b.y};
}
__device__ inline float2 operator-(float2 a, float2 b) {
    return {a.x - b.x, a.y - b.y};
}
__device__ inline float2 operator*(float2 a, float factor) {
    return {a.x * factor, a.y * factor};
}
__device__ inline float4 operator+(float4 a, float4 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}
__device__ inline float4 operator*(float4 a, float factor) {
    return {a.x * factor, a.y * factor, a.z * factor, a.w * factor};
}

__device__ inline PlaneRange grown(const PlaneRange& range, int by, int columns, int rows) {
    return {max(range.x0 - by, 0), min(range.x1 + by, columns), max(range.z0 - by, 0),
            min(range.z1 + by, rows)};
}

// Calls work(x, z) for the points of the range that belong to thread `thread` of `threads`.
template <typename Work>
__device__ inline void forRange(const PlaneRange& range, const Work& work,
                                int thread = int(threadIdx.x), int threads = Team::threads) {
    const int width = range.width(), count = range.count();
    const float inverse = __fdividef(1.0f, float(width));
#pragma unroll 1
    for (int i = thread; i < count; i += threads) {
        const int row = int((float(i) + 0.5f) * inverse);
        work(range.x0 + i - row * width, range.z0 + row);
    }
}

// A tile of the film, and what surrounds it.
struct FilmTile {
    PlaneRange points;  // the tile's own points
    PlaneRange corners; // the corners of all triangles that touch these points
    PlaneRange cells;

    __device__ FilmTile(const ProductionModel& model, int index) {
        const int across = index % model.tiles.across, down = index / model.tiles.across;
        points = {tileStart(model.columns, model.tiles.across, across),
                  tileStart(model.columns, model.tiles.across, across + 1),
                  tileStart(model.rows, model.tiles.down, down),
                  tileStart(model.rows, model.tiles.down, down + 1)};
        corners = grown(points, 1, model.columns, model.rows);
        cells = {corners.x0, corners.x1 - 1, corners.z0, corners.z1 - 1};
    }
};

// The stiffness of a level. Each point has nine blocks, row by row: one for itself and one for each
// of its eight neighbours. Each block has the order xx, xz, zx, zz.
struct PlaneStencils {
    float4* first;
    int points; // number of points of the level

    __device__ float4& at(int neighbour, int point) const {
        return first[neighbour * points + point];
    }
};
inline constexpr int neighbours = 9, middle = 4;

// The largest number of cells whose stiffness a block keeps in shared memory at once. At least two
// rows of the cells of any tile fit.
inline constexpr int mostAssembledCells = 768;

__device__ inline PlaneStencils stencilsOf(const ProductionDip& dip, const PlaneLevel& level) {
    return {dip.stencils + std::size_t(neighbours) * level.offset, level.columns * level.rows};
}

// Some points of a level in shared memory, surrounded by zeros. Smoothing steps write to `result`
// and `other` in turn, so each step needs only one barrier.
struct PlanePatch {
    const PlaneLevel* level;
    PlaneRange range;
    float2 *result, *other;

    // Returns the number of values in each of the two arrays.
    __host__ __device__ static constexpr int values(int width, int height) {
        return (width + 2) * (height + 2);
    }

    __device__ PlanePatch(const PlaneLevel& level, const PlaneRange& range, float2* memory)
        : level(&level), range(range), result(memory),
          other(memory + values(range.width(), range.height())) {}

    __device__ int pitch() const { return range.width() + 2; }
    __device__ int index(int x, int z) const {
        return (z - range.z0 + 1) * pitch() + x - range.x0 + 1;
    }
    __device__ void turn() {
        float2* next = other;
        other = result;
        result = next;
    }
    // Does not include a barrier; the caller needs one.
    __device__ void clear() const {
        const int count = 2 * values(range.width(), range.height());
        float2* first = result < other ? result : other;
#pragma unroll 1
        for (int i = int(threadIdx.x); i < count; i += Team::threads) {
            first[i] = {0, 0};
        }
    }
};

// At most `most` points of a patch, which this thread smooths, and their data in registers.
template <int most>
class PatchPoints {
public:
    static constexpr int mostInPatch = most * Team::threads;

    // Returns whether the threads of a block have registers for a patch of this size.
    __host__ __device__ static constexpr bool cover(int width, int height) {
        return width * height <= mostInPatch;
    }

    // right(x, z) returns the right side at a point of the level.
    template <typename Right>
    __device__ PatchPoints(const PlanePatch& patch, const PlaneStencils& stencils,
                           const Right& right)
        : stencils_(stencils), pitch_(patch.pitch()) {
        const int width = patch.range.width(), count = patch.range.count();
        const float byWidth = __fdividef(1.0f, float(width));
#pragma unroll
        for (int k = 0; k < most; ++k) {
            const int i = int(threadIdx.x) + k * Team::threads;
            if (i < count) {
                const int row = int((float(i) + 0.5f) * byWidth);
                const int x = patch.range.x0 + i - row * width, z = patch.range.z0 + row;
                index_[k] = patch.index(x, z);
                point_[k] = z * patch.level->columns + x;
                right_[k] = right(x, z);
                setInverse(k);
                if constexpr (keepsStencils) {
#pragma unroll
                    for (int n = 0; n < neighbours; ++n) {
                        kept_[n] = stencils_.at(n, point_[k]);
                    }
                }
            } else {
                index_[k] = -1;
            }
        }
    }

    // Runs `degree` Chebyshev steps on the patch's `result`, from zero or from its current value.
    // Results become invalid at edges of the patch that are not edges of the level. Each step that
    // takes a residual makes one more row of points invalid.
    __device__ void smooth(PlanePatch& patch, const numerics::galerkin::ChebyshevStep* steps,
                           int degree, bool fromZero) {
#pragma unroll 1
        for (int s = 0; s < degree; ++s) {
            const numerics::galerkin::ChebyshevStep step = steps[s];
#pragma unroll
            for (int k = 0; k < most; ++k) {
                if (index_[k] >= 0) {
                    const bool isFirst = fromZero && s == 0;
                    const float2 from = isFirst ? float2{0, 0} : patch.result[index_[k]];
                    const float2 left = isFirst ? right_[k] : residual(patch, k);
                    const float3 inverse = inverse_[k];
                    const float2 change{step.gain * (inverse.x * left.x + inverse.y * left.y),
                                        step.gain * (inverse.y * left.x + inverse.z * left.y)};
                    direction_[k] = s == 0 ? change : direction_[k] * step.keep + change;
                    patch.other[index_[k]] = from + direction_[k];
                }
            }
            patch.turn();
            __syncthreads();
        }
    }

    // Writes the residual to `other`.
    __device__ void keepResidual(const PlanePatch& patch) const {
#pragma unroll
        for (int k = 0; k < most; ++k) {
            if (index_[k] >= 0) {
                patch.other[index_[k]] = residual(patch, k);
            }
        }
        __syncthreads();
    }

private:
    // A thread with only one point reads its stencil once for all steps.
    static constexpr bool keepsStencils = most == 1;

    // Inverts the symmetric part of the point's own block. For a nearly singular block, the result
    // is the identity matrix divided by the trace. The result is 0 for a held point.
    __device__ void setInverse(int k) {
        const float4 own = stencils_.at(middle, point_[k]);
        const float mixed = (own.y + own.z) / 2, trace = own.x + own.w;
        const float determinant = own.x * own.w - mixed * mixed;
        const bool isRegular =
            trace > 0 && determinant > numerics::galerkin::leastDeterminant * trace * trace;
        const float inverse = 1 / (isRegular ? determinant : trace);
        const float scale = isRegular ? inverse : 0, common = !isRegular && trace > 0 ? inverse : 0;
        inverse_[k] = {own.w * scale + common, -mixed * scale, own.x * scale + common};
    }

    __device__ float2 residual(const PlanePatch& patch, int k) const {
        const float2* at = patch.result + index_[k];
        float2 sum = right_[k];
#pragma unroll
        for (int n = 0; n < neighbours; ++n) {
            float4 block;
            if constexpr (keepsStencils) {
                block = kept_[n];
            } else {
                block = stencils_.at(n, point_[k]);
            }
            const float2 value = at[(n / 3 - 1) * pitch_ + n % 3 - 1];
            sum.x -= block.x * value.x + block.y * value.y;
            sum.y -= block.z * value.x + block.w * value.y;
        }
        return sum;
    }

    PlaneStencils stencils_;
    int pitch_;
    int index_[most], point_[most]; // index in the patch; index in the level
    float2 right_[most], direction_[most];
    float3 inverse_[most]; // xx, xz, zz
    float4 kept_[keepsStencils ? neighbours : 1];
};

// One point per thread if there are enough threads.
using FewPoints = PatchPoints<1>;
// For patches with more points: as many per thread as the registers hold.
using ManyPoints = PatchPoints<4>;

// The right side of a level: one entry per point, times a factor. `pitch` is the distance between
// rows.
struct ScaledVector {
    const float2* values;
    float factor;
    int pitch;
};

enum class Smoothing { Down, Up, Coarsest };

// Does the work of smooth(). Not inlined, so that all levels run the same copy of the code, with
// all registers of a thread.
template <typename Points>
__device__ __noinline__ void smoothPoints(int index, PlaneRange range, int place,
                                          ScaledVector right, Smoothing way) {
    using numerics::galerkin::coarsestDegree, numerics::galerkin::smoothingDegree;
    // The number of steps is even, so the solution is always in `result`.
    static_assert(smoothingDegree % 2 == 0 && coarsestDegree % 2 == 0);
    const ProductionModel& model = thisBlock.block.model;
    const PlaneLevel& level = model.levels[index];
    PlanePatch patch(level, range, tileMemory + place);
    Points points(patch, stencilsOf(thisBlock.block.dip, level),
                  [&](int x, int z) { return right.values[z * right.pitch + x] * right.factor; });
    const bool isCoarsest = way == Smoothing::Coarsest;
    points.smooth(patch, isCoarsest ? model.coarsest : model.smoothing,
                  isCoarsest ? coarsestDegree : smoothingDegree, way != Smoothing::Up);
    if (way == Smoothing::Down) {
        points.keepResidual(patch);
    }
}

// Smooths a patch of level `index`, whose memory starts at tileMemory[place]. On the way down, also
// writes the residual to `other`.
__device__ inline void smooth(int index, const PlaneRange& range, int place,
                              const ScaledVector& right, Smoothing way) {
    if (FewPoints::cover(range.width(), range.height())) {
        smoothPoints<FewPoints>(index, range, place, right, way);
    } else {
        smoothPoints<ManyPoints>(index, range, place, right, way);
    }
}

// Restricts the residual in `other` of a finer patch to a coarse point, with the transpose of the
// interpolation.
__device__ inline float2 restricted(const PlanePatch& fine, int coarseX, int coarseZ) {
    const float2* at = fine.other + fine.index(2 * coarseX, 2 * coarseZ);
    const int pitch = fine.pitch();
    const bool isInX = 2 * coarseX < fine.level->columns, isInZ = 2 * coarseZ < fine.level->rows;
    const auto column = [&](int x) {
        const float2* here = at + x;
        // Past the last point of the level, the patch has zeros for one more point only.
        return isInZ ? here[0] + (here[-pitch] + here[pitch]) * 0.5f : here[-pitch] * 0.5f;
    };
    return isInX ? column(0) + (column(-1) + column(1)) * 0.5f : column(-1) * 0.5f;
}

// Interpolates a coarser level's values at a point of the finer level. `pitch` is the distance
// between coarse rows.
__device__ inline float2 interpolated(const float2* coarse, int pitch, int x, int z) {
    const float2 *lower = coarse + (z / 2) * pitch, *upper = coarse + ((z + 1) / 2) * pitch;
    const int left = x / 2, right = (x + 1) / 2;
    return ((lower[left] + upper[left]) + (lower[right] + upper[right])) * 0.25f;
}

// Returns 0 for a held point of the finest level, and 1 for any other point.
__device__ inline float freedom(const ProductionDip& dip, int level, int point) {
    return level == 0 ? dip.masked[point] : 1.0f;
}

// Tile `index` of a level: the points of the coarser level in the tile, and the fine points that
// the tile owns.
struct CoarseTile {
    PlaneRange coarse, own;
    PlaneRange leaning; // fine points from which the coarse points are computed

    __device__ CoarseTile(const PlaneLevel& level, const PlaneLevel& coarser, int index) {
        const int across = index % level.tiles.across, down = index / level.tiles.across;
        coarse = {tileStart(coarser.columns, level.tiles.across, across),
                  tileStart(coarser.columns, level.tiles.across, across + 1),
                  tileStart(coarser.rows, level.tiles.down, down),
                  tileStart(coarser.rows, level.tiles.down, down + 1)};
        own = {min(2 * coarse.x0, level.columns), min(2 * coarse.x1, level.columns),
               min(2 * coarse.z0, level.rows), min(2 * coarse.z1, level.rows)};
        leaning = own;
        leaning.x0 = max(2 * coarse.x0 - 1, 0);
        leaning.z0 = max(2 * coarse.z0 - 1, 0);
    }
};

// Returns a patch around a tile. The patch is large enough for a correct smoothing result in the
// tile.
__device__ inline PlanePatch patchAround(const PlaneRange& tile, const PlaneLevel& level,
                                         float2* memory) {
    return {level, grown(tile, numerics::galerkin::smoothingDegree, level.columns, level.rows),
            memory};
}

// Computes a level's `result` and the right side of the next coarser level.
__device__ inline void descend(const ProductionModel& model, const ProductionDip& dip, int index,
                               ScaledVector right, const Team& team, float2* patchMemory) {
    const PlaneLevel &level = model.levels[index], &coarser = model.levels[index + 1];
#pragma unroll 1
    for (int t = team.block(); t < level.tiles.count(); t += team.blocks()) {
        const CoarseTile tile(level, coarser, t);
        PlanePatch patch = patchAround(tile.leaning, level, patchMemory);
        patch.clear();
        __syncthreads();
        smooth(index, patch.range, int(patchMemory - tileMemory), right, Smoothing::Down);
        forRange(tile.own, [&](int x, int z) {
            dip.result[level.offset + z * level.columns + x] = patch.result[patch.index(x, z)];
        });
        forRange(tile.coarse, [&](int x, int z) {
            dip.right[coarser.offset + z * coarser.columns + x] = restricted(patch, x, z);
        });
        __syncthreads();
    }
}

// Computes a level's solution from its `result` and the coarser level's solution.
__device__ inline void ascend(const ProductionModel& model, const ProductionDip& dip, int index,
                              ScaledVector right, const float2* coarse, int coarsePitch,
                              float2* solution, const Team& team, float2* patchMemory) {
    const PlaneLevel &level = model.levels[index], &coarser = model.levels[index + 1];
#pragma unroll 1
    for (int t = team.block(); t < level.tiles.count(); t += team.blocks()) {
        const CoarseTile tile(level, coarser, t);
        PlanePatch patch = patchAround(tile.own, level, patchMemory);
        patch.clear();
        __syncthreads();
        forRange(patch.range, [&](int x, int z) {
            const int point = z * level.columns + x;
            patch.result[patch.index(x, z)] =
                dip.result[level.offset + point] +
                interpolated(coarse, coarsePitch, x, z) * freedom(dip, index, point);
        });
        __syncthreads();
        smooth(index, patch.range, int(patchMemory - tileMemory), right, Smoothing::Up);
        forRange(tile.own, [&](int x, int z) {
            solution[z * level.columns + x] = patch.result[patch.index(x, z)];
        });
        __syncthreads();
    }
}

// Solves the levels from `wholeLevel` on in this block's shared memory. Returns the patch with the
// solution on `wholeLevel`. This patch begins at tileMemory[0]. Both halves of the cycle are in one
// function, because they use the same layout of this memory.
__device__ inline PlanePatch solveWhole(const ProductionModel& model, const ProductionDip& dip,
                                        ScaledVector firstRight) {
    const int first = model.wholeLevel, last = model.levelCount - 1;
    // Each level has three arrays, surrounded by zeros: two belong to its patch, the third is its
    // right side.
    const auto patchOf = [&](int l) {
        float2* start = tileMemory;
        for (int finer = first; finer < l; ++finer) {
            start += 3 * PlanePatch::values(model.levels[finer].columns, model.levels[finer].rows);
        }
        const PlaneLevel& level = model.levels[l];
        return PlanePatch(level, {0, level.columns, 0, level.rows}, start);
    };
    const auto rightOf = [&](const PlanePatch& patch) {
        return patch.other + PlanePatch::values(patch.range.width(), patch.range.height());
    };
    PlanePatch top = patchOf(first);
    {
        const PlaneLevel& level = model.levels[first];
        float2* right = rightOf(top);
        top.clear();
        forRange(top.range, [&](int x, int z) {
            right[top.index(x, z)] = firstRight.values[z * level.columns + x] * firstRight.factor;
        });
        __syncthreads();
    }
    const auto smoothWhole = [&](int l, const PlanePatch& patch, Smoothing way) {
        smooth(l, patch.range, int(patch.result - tileMemory),
               {rightOf(patch) + patch.index(0, 0), 1.0f, patch.pitch()}, way);
    };
#pragma unroll 1
    for (int l = first; l < last; ++l) {
        PlanePatch patch = patchOf(l), coarser = patchOf(l + 1);
        float2* coarseRight = rightOf(coarser);
        coarser.clear();
        smoothWhole(l, patch, Smoothing::Down);
        forRange(coarser.range,
                 [&](int x, int z) { coarseRight[coarser.index(x, z)] = restricted(patch, x, z); });
        __syncthreads();
    }
#pragma unroll 1
    for (int l = last; l >= first; --l) {
        PlanePatch patch = patchOf(l);
        const bool isCoarsest = l == last;
        if (!isCoarsest) {
            const PlanePatch coarser = patchOf(l + 1);
            const float2* solution = coarser.result + coarser.index(0, 0);
            forRange(patch.range, [&](int x, int z) {
                float2& value = patch.result[patch.index(x, z)];
                value = value + interpolated(solution, coarser.pitch(), x, z) *
                                    freedom(dip, l, z * patch.level->columns + x);
            });
            __syncthreads();
        }
        smoothWhole(l, patch, isCoarsest ? Smoothing::Coarsest : Smoothing::Up);
    }
    return top;
}

// Computes solution ≈ stiffness⁻¹ · right on the finest level with one V-cycle. Ends with a
// barrier.
__device__ inline void multigridCycle(const ProductionModel& model, const ProductionDip& dip,
                                      ScaledVector right, float2* solution, Team& team) {
    const auto rightOf = [&](int l) {
        const PlaneLevel& level = model.levels[l];
        return l == 0 ? right : ScaledVector{dip.right + level.offset, 1.0f, level.columns};
    };
    for (int l = 0; l < model.wholeLevel; ++l) {
        descend(model, dip, l, rightOf(l), team, tileMemory);
        team.barrier();
    }
    const PlanePatch whole = solveWhole(model, dip, rightOf(model.wholeLevel));
    const float2* coarse = whole.result + whole.index(0, 0);
    int coarsePitch = whole.pitch();
    float2* patchMemory =
        tileMemory + 3 * PlanePatch::values(whole.range.width(), whole.range.height());
    if (model.wholeLevel == 0) {
        for (int i = team.thread(); i < model.columns * model.rows; i += team.threadCount()) {
            const int row = i / model.columns;
            solution[i] = coarse[row * coarsePitch + i - row * model.columns];
        }
    }
    for (int l = model.wholeLevel - 1; l >= 0; --l) {
        float2* found = l == 0 ? solution : dip.solution + model.levels[l].offset;
        ascend(model, dip, l, rightOf(l), coarse, coarsePitch, found, team, patchMemory);
        team.barrier();
        coarse = found;
        coarsePitch = model.levels[l].columns;
    }
    if (model.wholeLevel == 0) {
        team.barrier();
    }
}

namespace detail {

// Returns the projected stiffness of a triangle at the last force computation.
__device__ inline numerics::EdgeStiffness<float>
stiffnessOf(const ProductionModel& model, const ProductionDip& dip, int triangle) {
    const float4 shape = dip.inverseShape[triangle], stress = dip.stress[triangle];
    const numerics::Matrix2<float> inverse{shape.x, shape.y, shape.z, shape.w};
    const numerics::StressState<float> state{stress.x, stress.y, stress.z, stress.w};
    const float area = triangleSize(model, triangle).area();
    return dip.crosses[triangle] != 0
               ? numerics::edgeStiffness(dip.crossing[triangle], dip.anchors[triangle], inverse,
                                         state, area)
               : numerics::edgeStiffness(inverse, state, area);
}

// The stiffness of both triangles of some cells, in shared memory: a block of all cells, then the
// next block of all cells, so that neighbouring threads read neighbouring places.
struct CellStiffness {
    static constexpr int blocks =
        8; // per cell: hh, hv, vh, vv of the first triangle and the second

    float4* values;
    PlaneRange cells;

    __device__ void set(int x, int z, int second, const numerics::EdgeStiffness<float>& s) const {
        float4* first = at(x, z, second);
        const int count = cells.count();
        const auto packed = [](const numerics::Matrix2<float>& m) {
            return float4{m.a, m.b, m.c, m.d};
        };
        first[0] = packed(s.hh);
        first[count] = packed(s.hv);
        first[2 * count] = packed(s.vh);
        first[3 * count] = packed(s.vv);
    }
    __device__ numerics::EdgeStiffness<float> get(int x, int z, int second) const {
        const float4* first = at(x, z, second);
        const auto block = [&](int i) {
            const float4 m = first[i * cells.count()];
            return numerics::Matrix2<float>{m.x, m.y, m.z, m.w};
        };
        return {block(0), block(1), block(2), block(3)};
    }

private:
    __device__ float4* at(int x, int z, int second) const {
        return values + (second * (blocks / 2) * cells.count() + (z - cells.z0) * cells.width() +
                         x - cells.x0);
    }
};

// Adds the stiffness of one cell to the stencil of its point `point`.
template <numerics::CellPoint point>
__device__ inline void addCell(const CellStiffness& stiffness, int x, int z,
                               float4 (&stencil)[neighbours]) {
    using numerics::CellPoint;
    constexpr bool isLower = point == CellPoint::LowerLeft || point == CellPoint::LowerRight;
    constexpr bool isLeft = point == CellPoint::LowerLeft || point == CellPoint::UpperLeft;
    const int cellX = isLeft ? x : x - 1, cellZ = isLower ? z : z - 1;
    const PlaneRange& cells = stiffness.cells;
    if (cellX < cells.x0 || cellZ < cells.z0 || cellX >= cells.x1 || cellZ >= cells.z1) {
        return; // past an edge of the film
    }
    const auto row = numerics::cellRow<point>(
        stiffness.get(cellX, cellZ, 0), stiffness.get(cellX, cellZ, 1), (cellX + cellZ) % 2 == 0);
    constexpr int first = middle - (isLeft ? 0 : 1) - (isLower ? 0 : 3);
    const auto add = [&](int neighbour, const numerics::Matrix2<float>& block) {
        stencil[neighbour] = stencil[neighbour] + float4{block.a, block.b, block.c, block.d};
    };
    add(first, row.toLowerLeft);
    add(first + 1, row.toLowerRight);
    add(first + 3, row.toUpperLeft);
    add(first + 4, row.toUpperRight);
}

// Computes the finest level's stencil of a point that moves, from the cells around it.
__device__ inline void stencilOf(const ProductionModel& model, const CellStiffness& stiffness,
                                 float drag, int x, int z, float4 (&stencil)[neighbours]) {
    using numerics::CellPoint;
    addCell<CellPoint::UpperLeft>(stiffness, x, z, stencil);
    addCell<CellPoint::UpperRight>(stiffness, x, z, stencil);
    addCell<CellPoint::LowerLeft>(stiffness, x, z, stencil);
    addCell<CellPoint::LowerRight>(stiffness, x, z, stencil);
    const float own = drag * pointArea(model, x, z);
    stencil[middle] = stencil[middle] + float4{own, 0, 0, own};
}

// Assembles the finest level's stencils from free points only. A block first computes the stiffness
// of each triangle in some rows of its tile. Ends with a barrier.
__device__ inline void assemble(const ProductionModel& model, const ProductionDip& dip, float drag,
                                Team& team) {
    const PlaneStencils stencils = stencilsOf(dip, model.levels[0]);
#pragma unroll 1
    for (int t = team.block(); t < model.tiles.count(); t += team.blocks()) {
        const FilmTile tile(model, t);
        const int most = mostAssembledCells / tile.cells.width() - 1; // rows
#pragma unroll 1
        for (int z0 = tile.points.z0; z0 < tile.points.z1; z0 += most) {
            PlaneRange points = tile.points, cells = tile.cells;
            points.z0 = z0;
            points.z1 = min(z0 + most, points.z1);
            cells.z0 = max(points.z0 - 1, 0);
            cells.z1 = min(points.z1, model.rows - 1);
            const CellStiffness stiffness{reinterpret_cast<float4*>(tileMemory), cells};
            const int second = int(threadIdx.x) % 2;
            forRange(
                cells,
                [&](int x, int z) {
                    const int triangle = 2 * (z * (model.columns - 1) + x) + second;
                    stiffness.set(x, z, second, stiffnessOf(model, dip, triangle));
                },
                int(threadIdx.x) / 2, Team::threads / 2);
            __syncthreads();
            forRange(points, [&](int x, int z) {
                float4 stencil[neighbours] = {};
                const int point = z * model.columns + x;
                if (dip.masked[point] > 0) {
                    stencilOf(model, stiffness, drag, x, z, stencil);
                }
#pragma unroll
                for (int n = 0; n < neighbours; ++n) {
                    const int i = x + n % 3 - 1, j = z + n / 3 - 1;
                    const bool isIn = i >= 0 && j >= 0 && i < model.columns && j < model.rows;
                    const float free = isIn ? dip.masked[j * model.columns + i] : 0;
                    stencils.at(n, point) = stencil[n] * free;
                }
            });
            __syncthreads();
        }
    }
    team.barrier();
}

// Adds the contribution of a fine operator to the operator of a coarse point that lies `offset`
// points from the fine point. `before`, `own` and `after` are the fine operator's numbers for the
// previous point, the point itself and the next point. See coarsenAcross in
// production/cpu/StencilKernels.cpp.
__device__ inline void addCoarse(int offset, float before, float own, float after, float& toBefore,
                                 float& toOwn, float& toAfter) {
    if (offset == 0) {
        toBefore = toBefore + before * 0.5f;
        toOwn = toOwn + (own + (before + after) * 0.5f);
        toAfter = toAfter + after * 0.5f;
    } else if (offset < 0) {
        toBefore = toBefore + (own * 0.5f + before) * 0.5f;
        toOwn = toOwn + (own * 0.5f + after) * 0.5f;
    } else {
        toOwn = toOwn + (own * 0.5f + before) * 0.5f;
        toAfter = toAfter + (own * 0.5f + after) * 0.5f;
    }
}

// Computes a level's stencils from the finer level's. Ends with a barrier. The four numbers of a
// block do not depend on one another. Four threads compute a point, each one number of all its
// blocks, so that a thread has registers for all that it loads.
__device__ inline void coarsen(const ProductionModel& model, const ProductionDip& dip, int index,
                               Team& team) {
    constexpr int numbers = 4;
    const PlaneLevel &fine = model.levels[index - 1], &coarse = model.levels[index];
    const PlaneStencils from = stencilsOf(dip, fine), to = stencilsOf(dip, coarse);
    const auto number = [](const PlaneStencils& stencils, int neighbour, int point) -> float& {
        return reinterpret_cast<float*>(&stencils.at(neighbour, point))[threadIdx.x % numbers];
    };
    forRange(
        {0, coarse.columns, 0, coarse.rows},
        [&](int x, int z) {
            float stencil[neighbours] = {};
#pragma unroll
            for (int ox = -1; ox <= 1; ++ox) {
                float line[neighbours] = {};
                float own[3][neighbours]; // all loads are under way before the first is used
#pragma unroll
                for (int oz = -1; oz <= 1; ++oz) {
                    const int i = 2 * x + ox, j = 2 * z + oz, point = j * fine.columns + i;
                    const bool isIn = i >= 0 && j >= 0 && i < fine.columns && j < fine.rows;
#pragma unroll
                    for (int n = 0; n < neighbours; ++n) {
                        own[oz + 1][n] = isIn ? number(from, n, point) : 0.0f;
                    }
                }
#pragma unroll
                for (int oz = -1; oz <= 1; ++oz) {
#pragma unroll
                    for (int c = 0; c < 3; ++c) {
                        addCoarse(oz, own[oz + 1][c], own[oz + 1][c + 3], own[oz + 1][c + 6],
                                  line[c], line[c + 3], line[c + 6]);
                    }
                }
#pragma unroll
                for (int r = 0; r < neighbours; r += 3) {
                    addCoarse(ox, line[r], line[r + 1], line[r + 2], stencil[r], stencil[r + 1],
                              stencil[r + 2]);
                }
            }
#pragma unroll
            for (int n = 0; n < neighbours; ++n) {
                number(to, n, z * coarse.columns + x) = stencil[n];
            }
        },
        team.thread() / numbers, team.threadCount() / numbers);
    team.barrier();
}

} // namespace detail

// Prepares multigridCycle() for the film's stiffness at the last force computation.
__device__ inline void prepareCycle(const ProductionModel& model, const ProductionDip& dip,
                                    float drag, Team& team) {
    detail::assemble(model, dip, drag, team);
#pragma unroll 1
    for (int l = 1; l < model.levelCount; ++l) {
        detail::coarsen(model, dip, l, team);
    }
}

} // namespace dipwright::cuda
