// The multigrid V-cycle on the GPU (PlaneGrid.h). On the way down, one tile after the other is
// smoothed, its residual taken and carried over to the coarser level without leaving the block: it
// begins with so many points round the tile as the three smoothing steps use up. The same on the
// way up. The coarser levels, which one block can hold, every block computes whole for itself, and
// so saves the meetings with the others.
#pragma once

#include "cuda/QuasiStaticModel.h"
#include "cuda/Team.cuh"
#include "cuda/Tiles.h"

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
    const float inverse = 1.0f / float(width);
    for (int i = thread; i < count; i += threads) {
        const int row = int((float(i) + 0.5f) * inverse);
        work(range.x0 + i - row * width, range.z0 + row);
    }
}

// Some points of a level in shared memory.
struct PlanePatch {
    const PlaneLevel* level;
    PlaneRange range;
    float2 *result, *direction, *right;
    float* free;

    static constexpr std::size_t bytesPerPoint = 3 * sizeof(float2) + sizeof(float);

    __device__ int index(int x, int z) const {
        return (z - range.z0) * range.width() + x - range.x0;
    }
};

// A patch over `range` from `memory` on, which is left behind its end.
__device__ inline PlanePatch makePatch(const PlaneLevel& level, const PlaneRange& range,
                                       float2*& memory) {
    const int count = range.count();
    PlanePatch patch{&level,
                     range,
                     memory,
                     memory + count,
                     memory + 2 * count,
                     reinterpret_cast<float*>(memory + 3 * count)};
    memory += 3 * count + (count + 1) / 2;
    return patch;
}

// The stiffness times `result` at one point.
__device__ inline float2 stiffness(const PlanePatch& patch, int x, int z) {
    const PlaneLevel& level = *patch.level;
    const auto at = [&](int i, int j) { return patch.result[patch.index(i, j)]; };
    if (x > 0 && x < level.columns - 1 && z > 0 && z < level.rows - 1) {
        const pbd::multigrid::Stencil& s = level.stencil;
        const float2 own = at(x, z), alongX = at(x - 1, z) + at(x + 1, z),
                     alongZ = at(x, z - 1) + at(x, z + 1);
        const float2 mixed =
            (at(x + 1, z + 1) - at(x - 1, z + 1)) - (at(x + 1, z - 1) - at(x - 1, z - 1));
        return {2 * (s.xx + s.xz) * own.x - s.xx * alongX.x - s.xz * alongZ.x - 0.5f * mixed.y,
                2 * (s.zx + s.zz) * own.y - s.zx * alongX.y - s.zz * alongZ.y - 0.5f * mixed.x};
    }
    float2 sum{0, 0};
    for (int j = max(z - 1, 0); j < min(z + 1, level.rows - 1); ++j) {
        for (int i = max(x - 1, 0); i < min(x + 1, level.columns - 1); ++i) {
            const int own = 2 * ((z - j) * 2 + (x - i));
            for (int node = 0; node < 4; ++node) {
                const float2 v = at(i + node % 2, j + node / 2);
                sum.x += level.cell[own][2 * node] * v.x + level.cell[own][2 * node + 1] * v.y;
                sum.y +=
                    level.cell[own + 1][2 * node] * v.x + level.cell[own + 1][2 * node + 1] * v.y;
            }
        }
    }
    return sum;
}

__device__ inline float2 residual(const PlanePatch& patch, int x, int z) {
    const int i = patch.index(x, z);
    return patch.right[i] - stiffness(patch, x, z) * patch.free[i];
}

// The inverse of the stiffness's diagonal, 0 where held, times v.
__device__ inline float2 byDiagonal(const PlanePatch& patch, int x, int z, float2 v) {
    const PlaneLevel& level = *patch.level;
    const float cells = (x == 0 || x == level.columns - 1 ? 1.0f : 2.0f) *
                        (z == 0 || z == level.rows - 1 ? 1.0f : 2.0f);
    const float share = patch.free[patch.index(x, z)] / cells;
    return {v.x * (share / level.cell[0][0]), v.y * (share / level.cell[1][1])};
}

struct WholeBlock {
    __device__ static void meet() { __syncthreads(); }
    static constexpr int threads = Team::threads;
};
struct OneWarp {
    __device__ static void meet() { __syncwarp(); }
    static constexpr int threads = 32;
};

// `degree` Chebyshev steps on the patch's `result` (from zero, or from what it is), so that it is
// right within `range` at the end.
template <typename Threads>
__device__ inline void smooth(const PlanePatch& patch, const PlaneRange& range,
                              const pbd::multigrid::ChebyshevStep* steps, int degree,
                              bool fromZero) {
    for (int k = 0; k < degree; ++k) {
        const PlaneRange now =
            grown(range, degree - 1 - k, patch.level->columns, patch.level->rows);
        const pbd::multigrid::ChebyshevStep step = steps[k];
        const bool isTrivial = fromZero && k == 0; // the residual is the right side
        forRange(
            now,
            [&](int x, int z) {
                const int i = patch.index(x, z);
                const float2 left = isTrivial ? patch.right[i] : residual(patch, x, z);
                float2 direction = byDiagonal(patch, x, z, left) * step.gain;
                if (k > 0) {
                    direction = patch.direction[i] * step.keep + direction;
                }
                patch.direction[i] = direction;
                if (isTrivial) {
                    patch.result[i] = direction;
                }
            },
            int(threadIdx.x), Threads::threads);
        Threads::meet();
        if (isTrivial) {
            continue;
        }
        forRange(
            now,
            [&](int x, int z) {
                const int i = patch.index(x, z);
                patch.result[i] = patch.result[i] + patch.direction[i];
            },
            int(threadIdx.x), Threads::threads);
        Threads::meet();
    }
}

// Leaves the residual within `range` in `direction`.
__device__ inline void keepResidual(const PlanePatch& patch, const PlaneRange& range) {
    forRange(range,
             [&](int x, int z) { patch.direction[patch.index(x, z)] = residual(patch, x, z); });
}

// What the residual of a finer patch, in its `direction`, comes to at a coarse point, by the
// transpose of the interpolation.
__device__ inline float2 restricted(const PlanePatch& fine, int coarseX, int coarseZ) {
    const PlaneLevel& level = *fine.level;
    float2 sum{0, 0};
    for (int z = level.leanZ[coarseZ]; z < level.leanZ[coarseZ + 2]; ++z) {
        const float weightZ = level.firstZ[z] == coarseZ ? 1 - level.weightZ[z] : level.weightZ[z];
        float2 row{0, 0};
        for (int x = level.leanX[coarseX]; x < level.leanX[coarseX + 2]; ++x) {
            const float weightX =
                level.firstX[x] == coarseX ? 1 - level.weightX[x] : level.weightX[x];
            row = row + fine.direction[fine.index(x, z)] * weightX;
        }
        sum = sum + row * weightZ;
    }
    return sum;
}

// A coarser level's values between its points, at a point of `level`.
__device__ inline float2 interpolated(const PlaneLevel& level, const float2* coarse,
                                      int coarseColumns, int x, int z) {
    const float2* lower = coarse + level.firstZ[z] * coarseColumns + level.firstX[x];
    const float2* upper = lower + coarseColumns;
    const float weightX = level.weightX[x], weightZ = level.weightZ[z];
    const float2 first = lower[0] + (upper[0] - lower[0]) * weightZ;
    const float2 second = lower[1] + (upper[1] - lower[1]) * weightZ;
    return first + (second - first) * weightX;
}

// Tile `index` of a level: its part of the coarser level, and the fine points that are its own.
struct CoarseTile {
    PlaneRange coarse, own;
    PlaneRange leaning; // fine points that its coarse points take from

    __device__ CoarseTile(const PlaneLevel& level, const PlaneLevel& coarser, int index) {
        const int across = index % level.tiles.across, down = index / level.tiles.across;
        coarse = {tileStart(coarser.columns, level.tiles.across, across),
                  tileStart(coarser.columns, level.tiles.across, across + 1),
                  tileStart(coarser.rows, level.tiles.down, down),
                  tileStart(coarser.rows, level.tiles.down, down + 1)};
        leaning = {level.leanX[coarse.x0], level.leanX[coarse.x1 + 1], level.leanZ[coarse.z0],
                   level.leanZ[coarse.z1 + 1]};
        own = leaning;
        own.x0 = level.leanX[coarse.x0 + 1];
        own.z0 = level.leanZ[coarse.z0 + 1];
    }
};

// From a level to the right side of the next coarser one, and its own `result`.
__device__ inline void descend(const QuasiStaticModel& model, const QuasiStaticDip& dip, int index,
                               const Team& team, float2* memory) {
    const PlaneLevel &level = model.levels[index], &coarser = model.levels[index + 1];
    const float2* right = dip.right + level.offset;
    const float* free = dip.levelFree + level.offset;
    for (int t = team.block(); t < level.tiles.count(); t += team.blocks()) {
        const CoarseTile tile(level, coarser, t);
        const PlaneRange smoothed = grown(tile.leaning, 1, level.columns, level.rows);
        float2* end = memory;
        const PlanePatch patch = makePatch(
            level, grown(smoothed, pbd::multigrid::smoothingDegree - 1, level.columns, level.rows),
            end);
        forRange(patch.range, [&](int x, int z) {
            patch.right[patch.index(x, z)] = right[z * level.columns + x];
            patch.free[patch.index(x, z)] = free[z * level.columns + x];
        });
        __syncthreads();
        smooth<WholeBlock>(patch, smoothed, model.smoothing, pbd::multigrid::smoothingDegree, true);
        keepResidual(patch, tile.leaning);
        forRange(tile.own, [&](int x, int z) {
            dip.result[level.offset + z * level.columns + x] = patch.result[patch.index(x, z)];
        });
        __syncthreads();
        forRange(tile.coarse, [&](int x, int z) {
            const int i = coarser.offset + z * coarser.columns + x;
            dip.right[i] = restricted(patch, x, z) * dip.levelFree[i];
        });
        __syncthreads();
    }
}

// From a level's `result` and the coarser level's solution to this level's, in `smoothed`. Returns
// this thread's share of its product with the right side.
__device__ inline double ascend(const QuasiStaticModel& model, const QuasiStaticDip& dip, int index,
                                const float2* coarseSolution, const Team& team, float2* memory) {
    const PlaneLevel &level = model.levels[index], &coarser = model.levels[index + 1];
    double product = 0;
    for (int t = team.block(); t < level.tiles.count(); t += team.blocks()) {
        const CoarseTile tile(level, coarser, t);
        float2* end = memory;
        const PlanePatch patch = makePatch(
            level, grown(tile.own, pbd::multigrid::smoothingDegree, level.columns, level.rows),
            end);
        forRange(patch.range, [&](int x, int z) {
            const int i = patch.index(x, z), global = level.offset + z * level.columns + x;
            const float free = dip.levelFree[global];
            patch.right[i] = dip.right[global];
            patch.free[i] = free;
            patch.result[i] = dip.result[global] +
                              interpolated(level, coarseSolution, coarser.columns, x, z) * free;
        });
        __syncthreads();
        smooth<WholeBlock>(patch, tile.own, model.smoothing, pbd::multigrid::smoothingDegree,
                           false);
        forRange(tile.own, [&](int x, int z) {
            const int i = patch.index(x, z);
            const float2 result = patch.result[i], right = patch.right[i];
            dip.smoothed[level.offset + z * level.columns + x] = result;
            product += double(result.x * right.x + result.y * right.y);
        });
        __syncthreads();
    }
    return product;
}

// The levels from `wholeLevel` on, in this block's shared memory. Returns the solution of the first
// of them, which stays where `memory` begins, up to the new `memory`.
__device__ inline const float2* solveWhole(const QuasiStaticModel& model, const QuasiStaticDip& dip,
                                           float2*& memory) {
    const int first = model.wholeLevel, last = model.levelCount - 1;
    PlanePatch patches[QuasiStaticModel::mostLevels];
    float2 *solution = memory, *end = memory;
    for (int l = first; l <= last; ++l) {
        const PlaneLevel& level = model.levels[l];
        const PlanePatch patch = makePatch(level, {0, level.columns, 0, level.rows}, end);
        patches[l - first] = patch;
        for (int i = int(threadIdx.x); i < patch.range.count(); i += Team::threads) {
            patch.free[i] = dip.levelFree[level.offset + i];
            if (l == first) {
                patch.right[i] = dip.right[level.offset + i];
            }
        }
    }
    __syncthreads();
    for (int l = first; l < last; ++l) {
        const PlanePatch &patch = patches[l - first], &coarser = patches[l - first + 1];
        smooth<WholeBlock>(patch, patch.range, model.smoothing, pbd::multigrid::smoothingDegree,
                           true);
        keepResidual(patch, patch.range);
        __syncthreads();
        forRange(coarser.range, [&](int x, int z) {
            const int i = coarser.index(x, z);
            coarser.right[i] = restricted(patch, x, z) * coarser.free[i];
        });
        __syncthreads();
    }
    if (threadIdx.x < 32) {
        const PlanePatch& coarsest = patches[last - first];
        smooth<OneWarp>(coarsest, coarsest.range, model.coarsest, pbd::multigrid::coarsestDegree,
                        true);
    }
    __syncthreads();
    for (int l = last - 1; l >= first; --l) {
        const PlanePatch &patch = patches[l - first], &coarser = patches[l - first + 1];
        forRange(patch.range, [&](int x, int z) {
            const int i = patch.index(x, z);
            patch.result[i] = patch.result[i] + interpolated(*patch.level, coarser.result,
                                                             coarser.level->columns, x, z) *
                                                    patch.free[i];
        });
        __syncthreads();
        smooth<WholeBlock>(patch, patch.range, model.smoothing, pbd::multigrid::smoothingDegree,
                           false);
    }
    memory += patches[0].range.count();
    return solution;
}

// smoothed ≈ stiffness⁻¹ · right on the finest level by one V-cycle. Returns this thread's share of
// their product; the blocks have yet to meet.
__device__ inline double multigridCycle(const QuasiStaticModel& model, const QuasiStaticDip& dip,
                                        Team& team, float2* memory) {
    for (int l = 0; l < model.wholeLevel; ++l) {
        descend(model, dip, l, team, memory);
        team.meet();
    }
    const float2* solution = solveWhole(model, dip, memory);
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
        product = ascend(model, dip, l, solution, team, memory);
        if (l > 0) {
            team.meet();
            solution = dip.smoothed + model.levels[l].offset;
        }
    }
    return product;
}

} // namespace dipwright::cuda
