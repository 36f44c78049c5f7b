// The multigrid V-cycle on the GPU (MultigridCycle.h). On the way down, one tile after the other is
// smoothed, its residual taken and carried over to the coarser level without leaving the block: it
// begins with so many points round the tile as the three smoothing steps use up. The same on the
// way up. The coarser levels, which one block can hold, every block computes whole for itself, and
// so saves barriers with the others. Loops are kept from being unrolled where all their copies
// would crowd the instructions of a step out of the caches.
#pragma once

#include "common/cuda/Team.cuh"
#include "common/cuda/Tiles.h"
#include "production/cuda/ProductionModel.h"

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

__device__ inline PlaneRange grown(const PlaneRange& range, int by, int columns, int rows) {
    return {max(range.x0 - by, 0), min(range.x1 + by, columns), max(range.z0 - by, 0),
            min(range.z1 + by, rows)};
}

// Calls work(x, z) for every point of the range, by `threads` threads of which this is `thread`.
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

// Some points of a level in shared memory. Smoothing goes from `result` to `other` and back: so the
// threads have one barrier a step.
struct PlanePatch {
    const PlaneLevel* level;
    PlaneRange range;
    float2 *result, *other;

    static constexpr int valuesPerPoint = 2;

    __device__ PlanePatch(const PlaneLevel& level, const PlaneRange& range, float2* memory)
        : level(&level), range(range), result(memory), other(memory + range.count()) {}

    __device__ int index(int x, int z) const {
        return (z - range.z0) * range.width() + x - range.x0;
    }
    __device__ void turn() {
        float2* next = other;
        other = result;
        result = next;
    }
};

// The points of a patch that this thread smooths, `rows` one above the other, and what it keeps of
// them in registers.
template <int rows>
class PlaneStrip {
public:
    static constexpr int mostInPatch = rows * Team::threads;

    // Whether the threads of a block have enough strips for a patch.
    __host__ __device__ static constexpr bool cover(int width, int height) {
        return width * ((height + rows - 1) / rows) <= Team::threads;
    }

    // free(x, z): 1 where a point moves, else 0; right(x, z): the right side, 0 where it is held.
    template <typename Free, typename Right>
    __device__ PlaneStrip(const PlanePatch& patch, const Free& free, const Right& right)
        : stencil_(patch.level->stencil), width_(patch.range.width()),
          height_(patch.range.height()) {
        const PlaneLevel& level = *patch.level;
        const int strip = int(__fdividef(float(threadIdx.x) + 0.5f, float(width_)));
        column_ = int(threadIdx.x) - strip * width_;
        first_ = strip * rows;
        left_ = column_ > 0 ? 1.0f : 0.0f;
        right_ = column_ < width_ - 1 ? 1.0f : 0.0f;
        const int x = patch.range.x0 + column_;
        forRows([&](int row) {
            const int z = patch.range.z0 + first_ + row;
            const float cell = (x > 0 && x < level.columns - 1 ? 0.5f : 1.0f) *
                               (z > 0 && z < level.rows - 1 ? 0.5f : 1.0f);
            share_[row] = 2 * free(x, z) * cell;
            rightSide_[row] = right(x, z);
        });
    }

    // `degree` Chebyshev steps on the patch's `result` (from zero, or from what it is). Beside an
    // edge of the patch that is none of the level, a point's result is of no use, and one point
    // more with each step that takes a residual. From zero, it ends where `result` was.
    __device__ void smooth(PlanePatch& patch, const numerics::multigrid::ChebyshevStep* steps,
                           int degree, bool fromZero) {
        if (fromZero && degree % 2 != 0) {
            patch.turn();
        }
        const float2 byDiagonal{__fdividef(1.0f, stencil_.xx + stencil_.xz),
                                __fdividef(1.0f, stencil_.zx + stencil_.zz)};
#pragma unroll 1
        for (int k = 0; k < degree; ++k) {
            const numerics::multigrid::ChebyshevStep step = steps[k];
            const auto move = [&](int row, float2 left, float2 from) {
                const float gain = step.gain * share_[row];
                const float2 change{left.x * byDiagonal.x * gain, left.y * byDiagonal.y * gain};
                direction_[row] = k == 0 ? change : direction_[row] * step.keep + change;
                patch.other[index(row)] = from + direction_[row];
            };
            if (fromZero && k == 0) { // the residual is the right side
                forRows([&](int row) { move(row, rightSide_[row], {0, 0}); });
            } else {
                forResiduals(patch, move);
            }
            patch.turn();
            __syncthreads();
        }
    }

    // Leaves the residual in `other`.
    __device__ void keepResidual(const PlanePatch& patch) const {
        forResiduals(patch, [&](int row, float2 left, float2) {
            patch.other[index(row)] = share_[row] > 0 ? left : float2{0, 0};
        });
        __syncthreads();
    }

private:
    __device__ int index(int row) const {
        return (first_ + row) * width_ + column_;
    }

    template <typename Work>
    __device__ void forRows(const Work& work) const {
#pragma unroll
        for (int row = 0; row < rows; ++row) {
            if (first_ + row < height_) {
                work(row);
            }
        }
    }

    // What a point takes from those in its row: itself, its differences to them, and theirs.
    struct Row {
        float2 own, alongX, across;
    };
    // Past the patch's edge, that of the row on the edge.
    __device__ Row rowOf(const float2* values, int row) const {
        const float2* at = values + min(max(first_ + row, 0), height_ - 1) * width_ + column_;
        const float2 own = *at, left = at[left_ > 0 ? -1 : 0], right = at[right_ > 0 ? 1 : 0];
        return {own, (own - left) * left_ + (own - right) * right_, right * right_ - left * left_};
    }

    // work(row, the right side less the stiffness times `result`, the `result`): each of the cells
    // round a point has its share of the stencil.
    template <typename Work>
    __device__ void forResiduals(const PlanePatch& patch, const Work& work) const {
        if (first_ >= height_) {
            return;
        }
        const float cellsZ = 0.5f * (left_ + right_);
        Row lower = rowOf(patch.result, -1), here = rowOf(patch.result, 0);
#pragma unroll
        for (int row = 0; row < rows; ++row) {
            const Row upper = rowOf(patch.result, row + 1);
            const float below = row > 0 || first_ > 0 ? 1.0f : 0.0f;
            const float above = first_ + row + 1 < height_ ? 1.0f : 0.0f;
            const float cellsX = 0.5f * (below + above);
            const float2 alongZ = (here.own - lower.own) * below + (here.own - upper.own) * above;
            const float2 mixed = here.own * ((right_ - left_) * (above - below)) +
                                 lower.across * below - upper.across * above;
            const float2 stiffness{stencil_.xx * cellsX * here.alongX.x +
                                       stencil_.xz * cellsZ * alongZ.x + 0.5f * mixed.y,
                                   stencil_.zx * cellsX * here.alongX.y +
                                       stencil_.zz * cellsZ * alongZ.y + 0.5f * mixed.x};
            if (first_ + row < height_) {
                work(row, rightSide_[row] - stiffness, here.own);
            }
            lower = here;
            here = upper;
        }
    }

    numerics::multigrid::Stencil stencil_;
    int width_, height_; // of the patch
    int column_, first_; // where the strip is in it
    float left_, right_; // 1 where the patch goes on there, else 0
    float share_[rows];  // twice free / the cells round the point, with which the diagonal grows
    float2 rightSide_[rows], direction_[rows];
};

// One point a thread where there are threads enough, which makes the shortest steps; else as many
// as registers hold.
using ShortStrip = PlaneStrip<1>;
using LongStrip = PlaneStrip<4>;

// Calls work(strip) with this thread's strip of the patch; the arguments are those of PlaneStrip.
template <typename Free, typename Right, typename Work>
__device__ inline void withStrip(const PlanePatch& patch, const Free& free, const Right& right,
                                 const Work& work) {
    if (ShortStrip::cover(patch.range.width(), patch.range.height())) {
        work(ShortStrip(patch, free, right));
    } else {
        work(LongStrip(patch, free, right));
    }
}

// What the residual of a finer patch, in its `other`, comes to at a coarse point, by the transpose
// of the interpolation.
__device__ inline float2 restricted(const PlanePatch& fine, int coarseX, int coarseZ) {
    const PlaneAxis &alongX = fine.level->alongX, &alongZ = fine.level->alongZ;
    const int firstX = alongX.firstAfter(coarseX - 1), endX = alongX.firstFrom(coarseX + 1);
    const int firstZ = alongZ.firstAfter(coarseZ - 1), endZ = alongZ.firstFrom(coarseZ + 1);
    float2 sum{0, 0};
#pragma unroll 1
    for (int z = firstZ; z < endZ; ++z) {
        float2 row{0, 0};
#pragma unroll 1
        for (int x = firstX; x < endX; ++x) {
            row = row + fine.other[fine.index(x, z)] * alongX.weight(x, coarseX);
        }
        sum = sum + row * alongZ.weight(z, coarseZ);
    }
    return sum;
}

// A coarser level's values between its points, at a point of `level`.
__device__ inline float2 interpolated(const PlaneLevel& level, const float2* coarse, int x, int z) {
    const int coarseX = level.alongX.below(x), coarseZ = level.alongZ.below(z);
    const float2* lower = coarse + coarseZ * level.alongX.coarse + coarseX;
    const float2* upper = lower + level.alongX.coarse;
    const float weightX = level.alongX.weight(x, coarseX + 1);
    const float weightZ = level.alongZ.weight(z, coarseZ + 1);
    const float2 first = lower[0] + (upper[0] - lower[0]) * weightZ;
    const float2 second = lower[1] + (upper[1] - lower[1]) * weightZ;
    return first + (second - first) * weightX;
}

// Tile `index` of a level: its part of the coarser level, and the fine points that are its own.
struct CoarseTile {
    PlaneRange coarse, own;
    PlaneRange leaning; // fine points that its coarse points take from

    __device__ CoarseTile(const PlaneLevel& level, int index) {
        const PlaneAxis &alongX = level.alongX, &alongZ = level.alongZ;
        const int across = index % level.tiles.across, down = index / level.tiles.across;
        coarse = {tileStart(alongX.coarse, level.tiles.across, across),
                  tileStart(alongX.coarse, level.tiles.across, across + 1),
                  tileStart(alongZ.coarse, level.tiles.down, down),
                  tileStart(alongZ.coarse, level.tiles.down, down + 1)};
        own = {alongX.firstFrom(coarse.x0), alongX.firstFrom(coarse.x1),
               alongZ.firstFrom(coarse.z0), alongZ.firstFrom(coarse.z1)};
        leaning = own;
        leaning.x0 = alongX.firstAfter(coarse.x0 - 1);
        leaning.z0 = alongZ.firstAfter(coarse.z0 - 1);
    }
};

// A patch round a tile, so large that smoothing is right within the tile.
__device__ inline PlanePatch patchRound(const PlaneRange& tile, const PlaneLevel& level,
                                        float2* memory) {
    return {level, grown(tile, numerics::multigrid::smoothingDegree, level.columns, level.rows),
            memory};
}

// The same of a part of a level in device memory.
template <typename Work>
__device__ inline void withStrip(const PlanePatch& patch, const ProductionDip& dip,
                                 const Work& work) {
    const float* free = dip.levelFree + patch.level->offset;
    const float2* right = dip.right + patch.level->offset;
    const int columns = patch.level->columns;
    withStrip(
        patch, [&](int x, int z) { return free[z * columns + x]; },
        [&](int x, int z) { return right[z * columns + x]; }, work);
}

// From a level to the right side of the next coarser one, and its own `result`.
__device__ inline void descend(const ProductionModel& model, const ProductionDip& dip, int index,
                               const Team& team, float2* memory) {
    const PlaneLevel &level = model.levels[index], &coarser = model.levels[index + 1];
#pragma unroll 1
    for (int t = team.block(); t < level.tiles.count(); t += team.blocks()) {
        const CoarseTile tile(level, t);
        PlanePatch patch = patchRound(tile.leaning, level, memory);
        withStrip(patch, dip, [&](auto strip) {
            strip.smooth(patch, model.smoothing, numerics::multigrid::smoothingDegree, true);
            strip.keepResidual(patch);
        });
        forRange(tile.own, [&](int x, int z) {
            dip.result[level.offset + z * level.columns + x] = patch.result[patch.index(x, z)];
        });
        forRange(tile.coarse, [&](int x, int z) {
            const int i = coarser.offset + z * coarser.columns + x;
            dip.right[i] = restricted(patch, x, z) * dip.levelFree[i];
        });
        __syncthreads();
    }
}

// From a level's `result` and the coarser level's solution to this level's, in `smoothed`. Returns
// this thread's share of its product with the right side.
__device__ inline double ascend(const ProductionModel& model, const ProductionDip& dip, int index,
                                const float2* coarseSolution, const Team& team, float2* memory) {
    const PlaneLevel& level = model.levels[index];
    double product = 0;
#pragma unroll 1
    for (int t = team.block(); t < level.tiles.count(); t += team.blocks()) {
        const CoarseTile tile(level, t);
        PlanePatch patch = patchRound(tile.own, level, memory);
        forRange(patch.range, [&](int x, int z) {
            const int global = level.offset + z * level.columns + x;
            patch.result[patch.index(x, z)] =
                dip.result[global] +
                interpolated(level, coarseSolution, x, z) * dip.levelFree[global];
        });
        __syncthreads();
        withStrip(patch, dip, [&](auto strip) {
            strip.smooth(patch, model.smoothing, numerics::multigrid::smoothingDegree, false);
        });
        forRange(tile.own, [&](int x, int z) {
            const int global = level.offset + z * level.columns + x;
            const float2 result = patch.result[patch.index(x, z)], right = dip.right[global];
            dip.smoothed[global] = result;
            product += double(result.x * right.x + result.y * right.y);
        });
        __syncthreads();
    }
    return product;
}

// The levels from `wholeLevel` on, in this block's shared memory. Returns the solution of the first
// of them, which is among the two values a point where `memory` begins.
__device__ inline const float2* solveWhole(const ProductionModel& model, const ProductionDip& dip,
                                           float2* memory) {
    const int first = model.wholeLevel, last = model.levelCount - 1;
    const std::uint32_t start = model.levels[first].offset;
    const int count = int(model.levels[last].offset - start) +
                      model.levels[last].columns * model.levels[last].rows; // on all levels
    float2* right = memory + PlanePatch::valuesPerPoint * count;
    auto* free = reinterpret_cast<float*>(right + count);
#pragma unroll 1
    for (int i = int(threadIdx.x); i < count; i += Team::threads) {
        free[i] = dip.levelFree[start + i];
        if (i < model.levels[first].columns * model.levels[first].rows) {
            right[i] = dip.right[start + i];
        }
    }
    __syncthreads();
    const auto patchOf = [&](const PlaneLevel& level) {
        return PlanePatch(level, {0, level.columns, 0, level.rows},
                          memory + PlanePatch::valuesPerPoint * (level.offset - start));
    };
    const auto withWholeStrip = [&](const PlanePatch& patch, const auto& work) {
        const PlaneLevel& level = *patch.level;
        const auto at = [&](int x, int z) { return level.offset - start + z * level.columns + x; };
        withStrip(
            patch, [&](int x, int z) { return free[at(x, z)]; },
            [&](int x, int z) { return right[at(x, z)]; }, work);
    };
#pragma unroll 1
    for (int l = first; l < last; ++l) {
        const PlaneLevel& coarser = model.levels[l + 1];
        PlanePatch patch = patchOf(model.levels[l]);
        withWholeStrip(patch, [&](auto strip) {
            strip.smooth(patch, model.smoothing, numerics::multigrid::smoothingDegree, true);
            strip.keepResidual(patch);
        });
        forRange({0, coarser.columns, 0, coarser.rows}, [&](int x, int z) {
            const std::uint32_t i = coarser.offset - start + z * coarser.columns + x;
            right[i] = restricted(patch, x, z) * free[i];
        });
        __syncthreads();
    }
    const float2* solution = nullptr;
#pragma unroll 1
    for (int l = last; l >= first; --l) {
        const PlaneLevel& level = model.levels[l];
        PlanePatch patch = patchOf(level);
        const bool isCoarsest = l == last;
        if (!isCoarsest) {
            forRange(patch.range, [&](int x, int z) {
                const int i = z * level.columns + x;
                patch.result[i] = patch.result[i] + interpolated(level, solution, x, z) *
                                                        free[level.offset - start + i];
            });
            __syncthreads();
        }
        withWholeStrip(patch, [&](auto strip) {
            strip.smooth(patch, isCoarsest ? model.coarsest : model.smoothing,
                         isCoarsest ? numerics::multigrid::coarsestDegree
                                    : numerics::multigrid::smoothingDegree,
                         isCoarsest);
        });
        solution = patch.result;
    }
    return solution;
}

// smoothed ≈ stiffness⁻¹ · right on the finest level by one V-cycle. Returns this thread's share of
// their product; a barrier is yet to come.
__device__ inline double multigridCycle(const ProductionModel& model, const ProductionDip& dip,
                                        Team& team, float2* memory) {
    for (int l = 0; l < model.wholeLevel; ++l) {
        descend(model, dip, l, team, memory);
        team.barrier();
    }
    const float2* solution = solveWhole(model, dip, memory);
    const PlaneLevel& whole = model.levels[model.wholeLevel];
    float2* tileMemory = memory + PlanePatch::valuesPerPoint * whole.columns * whole.rows;
    if (model.wholeLevel == 0) {
        double product = 0;
        for (int i = team.thread(); i < model.columns * model.rows; i += team.threadCount()) {
            dip.smoothed[i] = solution[i];
            product += double(solution[i].x * dip.right[i].x + solution[i].y * dip.right[i].y);
        }
        return product;
    }
    double product = 0;
    for (int l = model.wholeLevel - 1; l >= 0; --l) {
        product = ascend(model, dip, l, solution, team, tileMemory);
        if (l > 0) {
            team.barrier();
            solution = dip.smoothed + model.levels[l].offset;
        }
    }
    return product;
}

} // namespace dipwright::cuda
