// The paper's step on the GPU (docs/film-model.md, "The paper's model").
//
// A block keeps its tile of the film in registers while the kernel runs. Around the tile lies a
// halo. A pass is a few sweeps between two exchanges of halos; the halo is as wide as the distance
// over which these sweeps act. A warp's lanes hold neighbours along a row; neighbouring rows are
// read from shared memory. A pass begins with a halo exchange: each block sends its own points near
// its edges and receives its halo from the neighbouring blocks. Each sent point carries the number
// of the pass, so the receiver sees when the point has arrived. So no block waits longer than it
// needs, and there is no barrier between blocks.
//
// As on the CPU, points are displacements from the flat film. The arithmetic is the CPU's,
// operation by operation, so this file must be compiled without contraction. The motion is so
// sensitive that a difference of a millionth of a millimetre would change the result.
#pragma once

#include "common/BodyFrame.h"
#include "common/FieldSampling.h"
#include "common/cuda/Tiles.h"
#include "paper/cuda/PaperTiles.h"

#include <cstdint>

namespace dipwright::cuda {

// How a point is held.
enum class Hold : unsigned { Free, Pinned, Adhered, Missing }; // missing: outside the film

// A point in memory: its displacement and how it is held. In a sent point, `mark` also contains the
// number of the pass.
struct alignas(16) StoredPoint {
    float x, y, z;
    unsigned mark;

    __host__ __device__ Hold hold() const { return Hold(mark % 4); }
};

constexpr unsigned sentIn(int pass) {
    return 4 * (unsigned(pass) + 1);
}

// The constants that all films of a batch share.
struct PaperModel {
    int columns = 0, rows = 0;
    double width = 0, depth = 0, spacingX = 0, spacingZ = 0; // mm
    float restX = 0, restZ = 0, restDiagonal = 0;            // rest lengths of the constraints, mm
    float firstX = 0, firstZ = 0; // rest position of the first column and row, mm
    float vertical = 1;           // 0: the water keeps free points in its plane
    float share[3][3] = {}; // 1 / total stiffness, by a point's number of neighbours along X and Z
    double stepLength = 0;  // descent of the body in one step, mm
    double contactDistance = 0;
    float clearanceMargin = 0; // mm: a point farther than this from the body cannot touch it
    // mm: a point has no contact if its distance, computed in single precision, exceeds this
    float noContactDistance = 0;
    int iterations = 0, passesPerStep = 0;
    PaperTiles tiles;
};

// The data of one dip.
struct PaperDip {
    numerics::FieldGrid<double> field;
    numerics::FieldGrid<float> singleField; // the same field, for arithmetic in single precision
    numerics::BodyFrame<double> frameAtStart;
    numerics::BodyFrame<float> singleFrameAtStart;
    double travel = 0;
    int steps = 0;
    StoredPoint* now = nullptr;    // adhered points are stored at their height at descent 0
    StoredPoint* before = nullptr; // one step ago
    // One for even and one for odd passes; adhered points are at their place in that step.
    StoredPoint* halo[2] = {};
};

// The work of a launch: the whole passes, or one part of one pass if the device cannot run all
// blocks at the same time.
enum class PaperWork { All, Send, Sweep };

namespace paper {

struct Pull {
    float x, y, z;
};
__device__ inline Pull operator+(Pull a, Pull b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
__device__ inline Pull operator-(Pull a, Pull b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
__device__ inline Pull operator*(Pull a, float factor) {
    return {a.x * factor, a.y * factor, a.z * factor};
}

// Computes length / √squared, with both operations rounded as in IEEE 754. Valid for numbers far
// from the limits of the floating point range. This is the code that the compiler generates,
// without its range checks and with one estimate for both operations.
__device__ inline float lengthOverRoot(float length, float squared) {
    float inverse;
    asm("rsqrt.approx.ftz.f32 %0, %1;" : "=f"(inverse) : "f"(squared));
    float root = squared * inverse;
    root = __fmaf_rn(__fmaf_rn(-root, root, squared), 0.5f * inverse, root);
    inverse = __fmaf_rn(inverse, __fmaf_rn(inverse, -root, 1.0f), inverse);
    const float quotient = length * inverse;
    return __fmaf_rn(inverse, __fmaf_rn(quotient, -root, length), quotient);
}

// A point as the sweeps use it. Weight 1: free; 0: held; 2: missing. With 2, a constraint between a
// free and a missing point has share 0.
struct Position {
    float x, y, z, weight;
};

__device__ inline float weightOf(Hold hold) {
    return hold == Hold::Free ? 1.0f : hold == Hold::Missing ? 2.0f : 0.0f;
}

// 1/(w1 + w2), which is one half if both points are free.
__device__ inline float sharing(float weight, float other) {
    return 1.0f - 0.5f * weight * other;
}

// Returns how far a constraint moves its first end, if that end is free. The second end moves as
// far in the opposite direction. (dx, dy, dz) points from the first end to the second.
__device__ inline Pull pull(float dx, float dy, float dz, float length, float share) {
    constexpr float shortestSquared = 1e-20f; // mm²; points that are closer than this do not pull
    const float squared = fmaxf((dx * dx + dy * dy) + dz * dz, shortestSquared);
    const float excess = 1.0f - lengthOverRoot(length, squared);
    return Pull{dx, dy, dz} * (excess * share);
}

// Both functions return the value of the adjacent lane in the same row. The result of the outermost
// lane is never used.
__device__ inline float fromRight(float value) {
    return __shfl_down_sync(0xffffffff, value, 1);
}
__device__ inline Position fromRight(const Position& p) {
    return {fromRight(p.x), fromRight(p.y), fromRight(p.z), 0};
}
__device__ inline Pull fromLeft(const Pull& p) {
    constexpr unsigned all = 0xffffffff;
    return {__shfl_up_sync(all, p.x, 1), __shfl_up_sync(all, p.y, 1), __shfl_up_sync(all, p.z, 1)};
}

// Writes the point's 16 bytes in one operation; receivePoint reads them in one operation.
__device__ inline void sendPoint(StoredPoint* to, const StoredPoint& point) {
    const std::uint64_t low =
        std::uint64_t(__float_as_uint(point.x)) | std::uint64_t(__float_as_uint(point.y)) << 32;
    const std::uint64_t high = std::uint64_t(__float_as_uint(point.z)) | std::uint64_t(point.mark)
                                                                             << 32;
    asm volatile(
        "{ .reg .b128 p; mov.b128 p, {%1, %2}; st.relaxed.gpu.global.b128 [%0], p; }" ::"l"(to),
        "l"(low), "l"(high)
        : "memory");
}

__device__ inline StoredPoint receivePoint(const StoredPoint* from) {
    std::uint64_t low, high;
    asm volatile("{ .reg .b128 p; ld.relaxed.gpu.global.b128 p, [%2]; mov.b128 {%0, %1}, p; }"
                 : "=l"(low), "=l"(high)
                 : "l"(from)
                 : "memory");
    return {__uint_as_float(unsigned(low)), __uint_as_float(unsigned(low >> 32)),
            __uint_as_float(unsigned(high)), unsigned(high >> 32)};
}

// The columns or rows that a tile owns.
struct Span {
    int first, last;
    __device__ bool owns(int index) const { return index >= first && index < last; }
    // Returns whether the point lies in the halo of another tile.
    __device__ bool isNearEdge(int index, int reach) const {
        return index < first + reach || index >= last - reach;
    }
};

__device__ inline Span tileSpan(int points, int tiles, int tile) {
    return {tileStart(points, tiles, tile), tileStart(points, tiles, tile + 1)};
}

// A point in the registers of its thread. Positions are displacements in mm.
struct Point {
    float x, y, z; // now; y of an adhered point is its height in the world
    // Free point: position one step ago; held point: beforeY is the stored height.
    float beforeX, beforeY, beforeZ;
    float clearance; // lower bound of the distance to the body, mm
    Hold hold;
};

// The place where a point adheres if it touches the body. It lies at the contact distance from the
// body, on the way from the point along ∇φ.
struct Anchor {
    float x, y, z; // displacement with the body at descent 0
    bool holds;
};

// Not inlined, because few points call it and the sweeps need the registers.
__device__ __noinline__ Anchor anchorOf(const PaperModel& film, const PaperDip& dip, int column,
                                        int row, double descent, float x, float y, float z) {
    const double restX = -film.width / 2 + column * film.spacingX;
    const double restZ = -film.depth / 2 + row * film.spacingZ;
    numerics::BodyFrame<double> frame = dip.frameAtStart;
    frame.translation.y -= descent;
    numerics::Vector3<double> place =
        frame.toBody({restX + double(x), double(y), restZ + double(z)});
    const numerics::FieldSample<double> sample = numerics::sampleField(dip.field, place);
    if (!(sample.distance <= film.contactDistance)) {
        return {0, 0, 0, false};
    }
    place = numerics::onLevel(dip.field, place, sample, film.contactDistance);
    const numerics::Vector3<double> anchor = dip.frameAtStart.toWorld(place);
    return {float(anchor.x - restX), float(anchor.y), float(anchor.z - restZ), true};
}

// Moves a free point to its place at the end of the step, without constraints. Returns whether the
// point may be near the body there.
__device__ inline bool moveOn(const PaperModel& film, Point& point, float& motion) {
    const Pull step{point.x - point.beforeX, point.y - point.beforeY, point.z - point.beforeZ};
    point.beforeX = point.x;
    point.beforeY = point.y;
    point.beforeZ = point.z;
    point.x += step.x;
    point.y += step.y;
    point.z += step.z;
    motion = fabsf(step.x) + fabsf(step.y) + fabsf(step.z);
    point.clearance -= float(film.stepLength) + motion;
    return !(point.clearance - motion >
             film.clearanceMargin); // the sweeps may move it as far again
}

// Predicts one column of a strip: advances its points from the end of a step to the places where
// the sweeps of the next step start. Samples the field for all points together, to overlap the
// memory accesses.
template <int stripRows>
__device__ inline void predict(const PaperModel& film, const PaperDip& dip, int column,
                               int firstRow, double descent, Point (&points)[stripRows],
                               const bool (&isOwn)[stripRows]) {
    bool isNear[stripRows], anyNear = false;
    float motion[stripRows];
#pragma unroll
    for (int r = 0; r < stripRows; ++r) {
        isNear[r] = isOwn[r] && points[r].hold == Hold::Free && moveOn(film, points[r], motion[r]);
        anyNear = anyNear || isNear[r];
    }
    if (!anyNear) {
        return;
    }
    numerics::BodyFrame<float> frame = dip.singleFrameAtStart;
    frame.translation.y -= float(descent);
    numerics::FieldSample<float> samples[stripRows];
#pragma unroll
    for (int r = 0; r < stripRows; ++r) {
        samples[r] = numerics::sampleField(
            dip.singleField,
            frame.toBody({film.firstX + column * film.restX + points[r].x, points[r].y,
                          film.firstZ + (firstRow + r) * film.restZ + points[r].z}));
    }
#pragma unroll
    for (int r = 0; r < stripRows; ++r) {
        if (!isNear[r]) {
            continue;
        }
        points[r].clearance = numerics::clearance(samples[r]) - motion[r];
        if (!(samples[r].distance > film.noContactDistance)) {
            const Anchor anchor = anchorOf(film, dip, column, firstRow + r, descent, points[r].x,
                                           points[r].y, points[r].z);
            if (anchor.holds) {
                points[r].hold = Hold::Adhered;
                points[r].x = anchor.x;
                points[r].beforeY = anchor.y;
                points[r].z = anchor.z;
            }
        }
    }
}

// The shares of the constraints in one strip of points.
template <int stripRows, bool hasDiagonals>
struct StripShares {
    static constexpr int gaps = stripRows + 1; // above the first row … below the last row
    float right[stripRows], down[gaps];        // `down` is indexed by the row above
    float rightDown[hasDiagonals ? gaps : 1], rightUp[hasDiagonals ? gaps : 1];

    // `weights` belong to the row above, the strip's rows and the row below.
    __device__ void set(const float (&weights)[stripRows + 2]) {
        float onRight[stripRows + 2];
#pragma unroll
        for (int v = 0; v < stripRows + 2; ++v) {
            onRight[v] = fromRight(weights[v]);
        }
#pragma unroll
        for (int v = 0; v < gaps; ++v) {
            down[v] = sharing(weights[v], weights[v + 1]);
            if (v > 0) {
                right[v - 1] = sharing(weights[v], onRight[v]);
            }
            if constexpr (hasDiagonals) {
                rightDown[v] = sharing(weights[v], onRight[v + 1]);
                rightUp[v] = sharing(weights[v + 1], onRight[v]);
            }
        }
    }
};

// A warp's strip of a tile and its halo: `stripRows` rows, with one column per lane. All threads of
// the block call all members. The members are inlined, so that the points stay in registers.
template <int stripRows, bool hasDiagonals>
class Strip {
public:
    // `edgeRows` is indexed by parity, warp, first or last row, and lane.
    __device__ __forceinline__ Strip(const PaperModel& film, const PaperDip& dip, int tile,
                                     Position* edgeRows)
        : film_(film), dip_(dip), edgeRows_(edgeRows), reach_(film.tiles.reach),
          columns_(tileSpan(film.columns, film.tiles.across, tile % film.tiles.across)),
          rows_(tileSpan(film.rows, film.tiles.down, tile / film.tiles.across)),
          lane_(int(threadIdx.x) % 32), warp_(int(threadIdx.x) / 32),
          column_(columns_.first - reach_ + lane_),
          firstRow_(rows_.first - reach_ + warp_ * stripRows),
          firstIndex_(firstRow_ * film.columns + column_),
          alongX_((column_ > 0) + (column_ < film.columns - 1)),
          columnStiffness_(hasDiagonals && alongX_ < 2 ? 0.5f : 1.0f) {
        load();
    }

    // Advances the points from the end of a step to the places where the sweeps of the next step
    // start.
    __device__ __forceinline__ void startStep(double descent) {
        predict(film_, dip_, column_, firstRow_, descent, points_, isOwn_);
    }

    // Moves adhered points with the body to `descent`. Sends the points that lie in other blocks'
    // halos, or all points if another launch runs the sweeps.
    __device__ __forceinline__ void sendHalo(int pass, double descent, bool sendsAll) {
        StoredPoint* halo = haloIn(pass);
#pragma unroll
        for (int r = 0; r < stripRows; ++r) {
            if (isOwn_[r] && points_[r].hold == Hold::Adhered) {
                points_[r].y = points_[r].beforeY - float(descent);
            }
            if (isSent_[r] || (sendsAll && isOwn_[r])) {
                sendPoint(halo + r * film_.columns, {points_[r].x, points_[r].y, points_[r].z,
                                                     sentIn(pass) + unsigned(points_[r].hold)});
            }
        }
    }

    // Receives each point of the halo as soon as its block has sent it. Receives all points of the
    // strip if another launch sent them.
    __device__ __forceinline__ void receiveHalo(int pass, bool receivesAll) {
        StoredPoint* halo = haloIn(pass);
        StoredPoint received[stripRows];
#pragma unroll
        for (int r = 0; r < stripRows; ++r) {
            if (isHalo_[r] || (receivesAll && isOwn_[r])) {
                received[r] = receivePoint(halo + r * film_.columns);
            }
        }
#pragma unroll
        for (int r = 0; r < stripRows; ++r) {
            if (isHalo_[r] || (receivesAll && isOwn_[r])) {
                while (received[r].mark - unsigned(received[r].hold()) != sentIn(pass)) {
                    __nanosleep(20);
                    received[r] = receivePoint(halo + r * film_.columns);
                }
                points_[r].x = received[r].x;
                points_[r].y = received[r].y;
                points_[r].z = received[r].z;
                points_[r].hold = received[r].hold();
            }
        }
    }

    __device__ __forceinline__ void sweep(int sweeps) {
        const bool works = hasFree(); // a strip without free points does not move
        keepEdges(parity_, weightOf(points_[0].hold), weightOf(points_[stripRows - 1].hold));
        __syncthreads();
        if (works) {
            setShares();
        } else {
            keepEdges(1 - parity_, 0, 0);
        }
        for (int sweep = 1; sweep <= sweeps; ++sweep) {
            // Number of rows beside the tile that are still needed.
            const int left = sweeps - sweep;
            if (works && firstRow_ + stripRows > rows_.first - left &&
                firstRow_ < rows_.last + left) {
                sweepOnce();
                if (left > 0) {
                    keepEdges(1 - parity_, 0, 0); // weights are read only before the sweeps
                }
            }
            parity_ = 1 - parity_;
            if (left > 0) {
                __syncthreads();
            }
        }
    }

    __device__ __forceinline__ void store(PaperWork work) const {
#pragma unroll
        for (int r = 0; r < stripRows; ++r) {
            if (isOwn_[r]) {
                const int index = firstIndex_ + r * film_.columns;
                const Point& point = points_[r];
                const bool isFree = point.hold == Hold::Free;
                // Before the sweeps, only the held points have their next place.
                if (work != PaperWork::Send || !isFree) {
                    dip_.now[index] = {point.x, isFree ? point.y : point.beforeY, point.z,
                                       unsigned(point.hold)};
                }
                if (work != PaperWork::Sweep) {
                    dip_.before[index] = {point.beforeX, point.beforeY, point.beforeZ, 0};
                }
            }
        }
    }

private:
    __device__ __forceinline__ void load() {
#pragma unroll
        for (int r = 0; r < stripRows; ++r) {
            const int row = firstRow_ + r;
            isOwn_[r] = columns_.owns(column_) && rows_.owns(row);
            isHalo_[r] = !isOwn_[r] && column_ >= 0 &&
                         column_ < min(film_.columns, columns_.last + reach_) && row >= 0 &&
                         row < min(film_.rows, rows_.last + reach_);
            isSent_[r] = isOwn_[r] &&
                         (columns_.isNearEdge(column_, reach_) || rows_.isNearEdge(row, reach_));
            // Points outside the film exist here; they are marked as missing.
            points_[r] = {0, 0, 0, 0, 0, 0, -INFINITY, Hold::Missing};
            if (isOwn_[r]) {
                const int index = firstIndex_ + r * film_.columns;
                const StoredPoint now = dip_.now[index], before = dip_.before[index];
                Point& point = points_[r];
                point = {now.x, now.y, now.z, before.x, before.y, before.z, -INFINITY, now.hold()};
                if (point.hold != Hold::Free) {
                    point.beforeY = now.y;
                }
            }
        }
    }

    __device__ __forceinline__ StoredPoint* haloIn(int pass) const {
        return dip_.halo[pass % 2] + firstIndex_;
    }
    __device__ __forceinline__ bool isBorder(int row) const {
        return row == 0 || row == film_.rows - 1;
    }
    __device__ __forceinline__ bool hasFree() const {
        bool hasFree = false;
#pragma unroll
        for (int r = 0; r < stripRows; ++r) {
            hasFree = hasFree || points_[r].hold == Hold::Free;
        }
        return __any_sync(0xffffffff, hasFree);
    }

    // The rows beside this strip, which other warps own. They are double buffered in shared memory.
    __device__ __forceinline__ Position& edgeRow(int parity, int ofWarp, int isLast) const {
        return edgeRows_[((parity * film_.tiles.warps + ofWarp) * 2 + isLast) * 32 + lane_];
    }
    __device__ __forceinline__ const Position& rowAbove() const {
        return edgeRow(parity_, max(warp_ - 1, 0), 1);
    }
    __device__ __forceinline__ const Position& rowBelow() const {
        return edgeRow(parity_, min(warp_ + 1, film_.tiles.warps - 1), 0);
    }
    __device__ __forceinline__ void keepEdges(int to, float firstWeight, float lastWeight) const {
        const Point &first = points_[0], &last = points_[stripRows - 1];
        edgeRow(to, warp_, 0) = {first.x, first.y, first.z, firstWeight};
        edgeRow(to, warp_, 1) = {last.x, last.y, last.z, lastWeight};
    }

    __device__ __forceinline__ void setShares() {
        float weights[stripRows + 2];
        weights[0] = rowAbove().weight;
        weights[stripRows + 1] = rowBelow().weight;
#pragma unroll
        for (int r = 0; r < stripRows; ++r) {
            weights[r + 1] = weightOf(points_[r].hold);
            share_[r] = points_[r].hold == Hold::Free
                            ? film_.share[alongX_][isBorder(firstRow_ + r) ? 1 : 2]
                            : 0.0f;
        }
        shares_.set(weights);
    }

    __device__ __forceinline__ void sweepOnce() {
        Position now[stripRows + 2], onRight[stripRows + 2];
        now[0] = rowAbove();
        now[stripRows + 1] = rowBelow();
#pragma unroll
        for (int r = 0; r < stripRows; ++r) {
            now[r + 1] = {points_[r].x, points_[r].y, points_[r].z, 0};
        }
#pragma unroll
        for (int v = hasDiagonals ? 0 : 1; v < stripRows + (hasDiagonals ? 2 : 1); ++v) {
            onRight[v] = fromRight(now[v]);
        }
        const auto down = [&](int v) {
            return pull(now[v + 1].x - now[v].x, now[v + 1].y - now[v].y,
                        film_.restZ + (now[v + 1].z - now[v].z), film_.restZ, shares_.down[v]) *
                   columnStiffness_;
        };
        const auto rightDown = [&](int v) {
            return pull(film_.restX + (onRight[v + 1].x - now[v].x), onRight[v + 1].y - now[v].y,
                        film_.restZ + (onRight[v + 1].z - now[v].z), film_.restDiagonal,
                        shares_.rightDown[v]) *
                   0.5f;
        };
        const auto rightUp = [&](int v) {
            return pull(film_.restX + (onRight[v].x - now[v + 1].x), onRight[v].y - now[v + 1].y,
                        -film_.restZ + (onRight[v].z - now[v + 1].z), film_.restDiagonal,
                        shares_.rightUp[v]) *
                   0.5f;
        };
        // The correction from the constraints to the row above. It is subtracted from a point of
        // this row.
        Pull above = down(0);
        if constexpr (hasDiagonals) {
            above = (above + fromLeft(rightDown(0))) - rightUp(0);
        }
#pragma unroll
        for (int r = 0; r < stripRows; ++r) {
            const int v = r + 1;
            Pull right = pull(film_.restX + (onRight[v].x - now[v].x), onRight[v].y - now[v].y,
                              onRight[v].z - now[v].z, film_.restX, shares_.right[r]);
            if constexpr (hasDiagonals) {
                right = right * (isBorder(firstRow_ + r) ? 0.5f : 1.0f);
            }
            const Pull below = down(v);
            Pull sum = (right - fromLeft(right)) + below;
            if constexpr (hasDiagonals) {
                const Pull ahead = rightDown(v), back = rightUp(v);
                sum = (sum + (ahead - fromLeft(back))) - above;
                above = (below + fromLeft(ahead)) - back;
            } else {
                sum = sum - above;
                above = below;
            }
            points_[r].x = now[v].x + sum.x * share_[r];
            points_[r].y = now[v].y + sum.y * (share_[r] * film_.vertical);
            points_[r].z = now[v].z + sum.z * share_[r];
        }
    }

    const PaperModel& film_;
    const PaperDip& dip_;
    Position* edgeRows_;
    int reach_;
    Span columns_, rows_; // columns and rows of the tile
    int lane_, warp_;
    int column_, firstRow_, firstIndex_; // column, row and index of this thread's first point
    int alongX_;                         // number of neighbours along X
    float columnStiffness_;
    Point points_[stripRows];
    bool isHalo_[stripRows], isOwn_[stripRows], isSent_[stripRows];
    StripShares<stripRows, hasDiagonals> shares_;
    float share_[stripRows]; // factors on the summed corrections
    int parity_ = 0;         // parity of the edge rows that are read next
};

} // namespace paper

// Runs the passes firstPass … lastPass − 1 of all dips.
template <int stripRows, bool hasDiagonals>
__global__ void __launch_bounds__(PaperTiles::mostWarps* PaperTiles::lanes)
    paperPasses(const __grid_constant__ PaperModel film, const PaperDip* dips, PaperWork work,
                int firstPass, int lastPass) {
    extern __shared__ paper::Position edgeRows[];
    __shared__ PaperDip dip;
    const int tiles = film.tiles.count();
    if (threadIdx.x == 0) {
        dip = dips[int(blockIdx.x) / tiles];
    }
    __syncthreads();
    lastPass = min(lastPass, dip.steps * film.passesPerStep);
    if (firstPass >= lastPass) {
        return;
    }
    paper::Strip<stripRows, hasDiagonals> strip(film, dip, int(blockIdx.x) % tiles, edgeRows);
    int step = firstPass / film.passesPerStep, part = firstPass % film.passesPerStep;
    for (int pass = firstPass; pass < lastPass; ++pass) {
        const double descent = fmin(dip.travel, double(step + 1) * film.stepLength);
        if (work != PaperWork::Sweep) {
            if (part == 0) {
                strip.startStep(descent);
            }
            strip.sendHalo(pass, descent, work == PaperWork::Send);
        }
        if (work == PaperWork::Send) {
            break;
        }
        strip.receiveHalo(pass, work == PaperWork::Sweep);
        strip.sweep(min(film.tiles.reach, film.iterations - part * film.tiles.reach));
        part = part + 1 == film.passesPerStep ? 0 : part + 1;
        step += part == 0;
    }
    strip.store(work);
}

} // namespace dipwright::cuda
