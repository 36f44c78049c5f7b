// The kernels of the paper's film in vector instructions. They are compiled for each instruction
// set that Highway supports, and the best one is chosen at run time. The arithmetic is that of
// PaperKernelsScalar.cpp, line by line: no fused multiply-add, and exact square root and division.

#include "paper/cpu/PaperKernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "paper/cpu/PaperKernelsVector.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace dipwright::cpu::HWY_NAMESPACE {

namespace {

namespace hn = hwy::HWY_NAMESPACE;

// A vector is at most one chunk long, so a chunk always consists of whole vectors.
using Lanes = hn::CappedTag<float, chunkColumns>;
using Vector = hn::Vec<Lanes>;
constexpr Lanes lanes;

Vector constant(float value) {
    return hn::Set(lanes, value);
}

struct Pull {
    Vector x, y, z;
};
HWY_INLINE Pull operator+(const Pull& a, const Pull& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}
HWY_INLINE Pull operator-(const Pull& a, const Pull& b) {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Pull operator*(const Pull& a, Vector factor) {
    return {hn::Mul(a.x, factor), hn::Mul(a.y, factor), hn::Mul(a.z, factor)};
}
HWY_INLINE Pull noPull() {
    return {hn::Zero(lanes), hn::Zero(lanes), hn::Zero(lanes)};
}

struct Points {
    Vector x, y, z, weight;
};
HWY_INLINE Points loadPoints(const WorkingRow& row, int i) {
    return {hn::LoadU(lanes, row.x + i), hn::LoadU(lanes, row.y + i), hn::LoadU(lanes, row.z + i),
            hn::LoadU(lanes, row.weight + i)};
}

HWY_INLINE Vector squaredLength(const Pull& a) {
    return hn::Add(hn::Add(hn::Mul(a.x, a.x), hn::Mul(a.y, a.y)), hn::Mul(a.z, a.z));
}

HWY_INLINE Pull pull(const Points& first, const Points& second, Vector restX, Vector restZ,
                     Vector length, Vector exists) {
    const Pull difference{hn::Add(restX, hn::Sub(second.x, first.x)), hn::Sub(second.y, first.y),
                          hn::Add(restZ, hn::Sub(second.z, first.z))};
    const Vector squared = hn::Max(squaredLength(difference), constant(shortestSquared));
    const Vector excess = hn::Sub(constant(1), hn::Div(length, hn::Sqrt(squared)));
    const Vector sharing =
        hn::Sub(exists, hn::Mul(constant(0.5f), hn::Mul(first.weight, second.weight)));
    return difference * hn::Mul(excess, sharing);
}

// Shifts lanes by one: lane i receives lane i − 1 of `values`, and lane 0 the last lane of the
// previous vector.
class LaneShift {
public:
    LaneShift() : rotation_(hn::SetTableIndices(lanes, indices().data())) {}

    HWY_INLINE Pull operator()(const Pull& values, Pull& before) const {
        const Pull rotated{rotate(values.x), rotate(values.y), rotate(values.z)};
        const auto first = hn::FirstN(lanes, 1);
        const Pull shifted{hn::IfThenElse(first, before.x, rotated.x),
                           hn::IfThenElse(first, before.y, rotated.y),
                           hn::IfThenElse(first, before.z, rotated.z)};
        before = rotated;
        return shifted;
    }

private:
    HWY_INLINE Vector rotate(Vector values) const {
        return hn::TableLookupLanes(values, rotation_);
    }
    static std::array<std::int32_t, chunkColumns> indices() {
        std::array<std::int32_t, chunkColumns> indices{};
        const auto count = std::int32_t(hn::Lanes(lanes));
        for (std::int32_t lane = 0; lane < count; ++lane) {
            indices[std::size_t(lane)] = (lane + count - 1) % count;
        }
        return indices;
    }
    decltype(hn::SetTableIndices(lanes, static_cast<const std::int32_t*>(nullptr))) rotation_;
};

float largest(Vector values) {
    return hn::GetLane(hn::MaxOfLanes(lanes, values));
}

void load(const LoadTask& task) {
    const StoredRow& from = task.from;
    const int laneCount = int(hn::Lanes(lanes));
    const Vector inertia = constant(task.inertia), descent = constant(task.descent);
    for (int chunk = 0; chunk < task.chunks; ++chunk) {
        task.motion[chunk] = 0;
        if (!task.isNeeded[chunk]) {
            continue;
        }
        Vector farthest = hn::Zero(lanes);
        for (int i = chunk * chunkColumns; i < (chunk + 1) * chunkColumns; i += laneCount) {
            const Pull place{hn::Load(lanes, from.x + i), hn::Load(lanes, from.y + i),
                             hn::Load(lanes, from.z + i)};
            const Pull previous{hn::Load(lanes, from.previousX + i),
                                hn::Load(lanes, from.previousY + i),
                                hn::Load(lanes, from.previousZ + i)};
            const Pull step = place - previous;
            farthest = hn::Max(farthest, squaredLength(step));
            const Pull predicted = place + step * inertia;
            const Vector sunk = hn::Mul(hn::Load(lanes, from.sinking + i), descent);
            hn::Store(predicted.x, lanes, task.to.x + i);
            hn::Store(hn::Sub(predicted.y, sunk), lanes, task.to.y + i);
            hn::Store(predicted.z, lanes, task.to.z + i);
            hn::Store(hn::Load(lanes, from.weight + i), lanes, task.to.weight + i);
            if (task.keepsPrevious) {
                hn::Store(place.x, lanes, from.previousX + i);
                hn::Store(place.y, lanes, from.previousY + i);
                hn::Store(place.z, lanes, from.previousZ + i);
            }
        }
        task.motion[chunk] = std::sqrt(largest(farthest));
    }
}

void store(const StoreTask& task) {
    const int laneCount = int(hn::Lanes(lanes));
    for (int chunk = 0; chunk < task.chunks; ++chunk) {
        if (!task.isBusy[chunk]) {
            continue;
        }
        Vector farthest = hn::Zero(lanes);
        for (int i = chunk * chunkColumns; i < (chunk + 1) * chunkColumns; i += laneCount) {
            const Points points = loadPoints(task.from, i);
            const auto isFree = hn::Gt(points.weight, hn::Zero(lanes));
            hn::Store(points.x, lanes, task.to.x + i);
            hn::Store(hn::IfThenElse(isFree, points.y, hn::Load(lanes, task.to.y + i)), lanes,
                      task.to.y + i);
            hn::Store(points.z, lanes, task.to.z + i);
            farthest = hn::Max(hn::Max(farthest, hn::Abs(points.x)),
                               hn::Max(hn::Abs(points.y), hn::Abs(points.z)));
        }
        if (largest(farthest) > task.wakeDistance) {
            task.hasMoved[chunk] = 1;
        }
    }
}

template <bool diagonals>
void jacobi(const JacobiTask& task) {
    const WorkingRow &row = task.row, &below = task.below;
    const int laneCount = int(hn::Lanes(lanes));
    const Vector restX = constant(task.rest[0]), restZ = constant(task.rest[1]);
    const Vector minusRestZ = constant(-task.rest[1]), restDiagonal = constant(task.rest[2]);
    const Vector none = hn::Zero(lanes), half = constant(0.5f);
    const Vector hasBelow = constant(task.hasBelow), vertical = constant(task.vertical);
    const Vector rowStiffness = constant(task.rowStiffness);
    const LaneShift fromLeft;
    Pull left = noPull(), leftDown = noPull(), leftUp = noPull();
    for (int chunk = 0; chunk < task.chunks; ++chunk) {
        const bool isBusy = task.isBusy[chunk];
        bool isNeeded = isBusy || task.isBusy[chunk + 1] || task.isBusyBelow[chunk];
        if constexpr (diagonals) {
            isNeeded = isNeeded || task.isBusyBelow[chunk + 1];
        }
        if (!isNeeded) {
            continue;
        }
        for (int i = chunk * chunkColumns; i < (chunk + 1) * chunkColumns; i += laneCount) {
            const Points here = loadPoints(row, i), toRight = loadPoints(row, i + 1);
            const Points under = loadPoints(below, i);
            const Vector hasRight = hn::Load(lanes, task.hasRight + i);
            Pull right = pull(here, toRight, restX, none, restX, hasRight);
            Pull down = pull(here, under, none, restZ, restZ, hasBelow);
            Pull onRow, onBelow;
            if constexpr (diagonals) {
                right = right * rowStiffness;
                down = down * hn::Load(lanes, task.columnStiffness + i);
                const Vector exists = hn::Mul(hasRight, hasBelow);
                const Points underRight = loadPoints(below, i + 1);
                const Pull rightDown =
                    pull(here, underRight, restX, restZ, restDiagonal, exists) * half;
                const Pull rightUp =
                    pull(under, toRight, restX, minusRestZ, restDiagonal, exists) * half;
                onRow = ((right - fromLeft(right, left)) + down) +
                        (rightDown - fromLeft(rightUp, leftUp));
                onBelow = (down + fromLeft(rightDown, leftDown)) - rightUp;
            } else {
                onRow = (right - fromLeft(right, left)) + down;
                onBelow = down;
            }
            onRow = onRow - Pull{hn::Load(lanes, task.fromAbove[0] + i),
                                 hn::Load(lanes, task.fromAbove[1] + i),
                                 hn::Load(lanes, task.fromAbove[2] + i)};
            hn::Store(onBelow.x, lanes, task.fromAbove[0] + i);
            hn::Store(onBelow.y, lanes, task.fromAbove[1] + i);
            hn::Store(onBelow.z, lanes, task.fromAbove[2] + i);
            if (isBusy) {
                const Vector share = hn::Mul(here.weight, hn::Load(lanes, task.share + i));
                hn::Store(hn::Add(here.x, hn::Mul(onRow.x, share)), lanes, row.x + i);
                hn::Store(hn::Add(here.y, hn::Mul(onRow.y, hn::Mul(share, vertical))), lanes,
                          row.y + i);
                hn::Store(hn::Add(here.z, hn::Mul(onRow.z, share)), lanes, row.z + i);
            }
        }
    }
}

void pairs(const PairTask& task) {
    const WorkingRow &first = task.first, &second = task.second;
    const int laneCount = int(hn::Lanes(lanes));
    const Vector restX = constant(task.rest[0]), restZ = constant(task.rest[1]);
    const Vector length = constant(task.length), vertical = constant(task.vertical);
    const Vector stiffness = constant(task.stiffness);
    for (int i = 0; i < task.count; i += laneCount) {
        const Points a = loadPoints(first, i), b = loadPoints(second, i);
        const Pull e =
            pull(a, b, restX, restZ, length, hn::Load(lanes, task.exists + i)) * stiffness;
        hn::StoreU(hn::Add(a.x, hn::Mul(e.x, a.weight)), lanes, first.x + i);
        hn::StoreU(hn::Add(a.y, hn::Mul(e.y, hn::Mul(a.weight, vertical))), lanes, first.y + i);
        hn::StoreU(hn::Add(a.z, hn::Mul(e.z, a.weight)), lanes, first.z + i);
        hn::StoreU(hn::Sub(b.x, hn::Mul(e.x, b.weight)), lanes, second.x + i);
        hn::StoreU(hn::Sub(b.y, hn::Mul(e.y, hn::Mul(b.weight, vertical))), lanes, second.y + i);
        hn::StoreU(hn::Sub(b.z, hn::Mul(e.z, b.weight)), lanes, second.z + i);
    }
}

void split(const float* from, float* to, int half) {
    const int laneCount = int(hn::Lanes(lanes));
    for (int i = 0; i < half; i += laneCount) {
        Vector even, odd;
        hn::LoadInterleaved2(lanes, from + 2 * i, even, odd);
        hn::Store(even, lanes, to + i);
        hn::Store(odd, lanes, to + half + i);
    }
}

void merge(const float* from, float* to, int half) {
    const int laneCount = int(hn::Lanes(lanes));
    for (int i = 0; i < half; i += laneCount) {
        hn::StoreInterleaved2(hn::Load(lanes, from + i), hn::Load(lanes, from + half + i), lanes,
                              to + 2 * i);
    }
}

PaperKernels kernels() {
    return {load,  store, jacobi<false>, jacobi<true>,
            pairs, split, merge,         hwy::TargetName(HWY_TARGET)};
}

} // namespace

} // namespace dipwright::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dipwright::cpu {

namespace {

HWY_EXPORT(kernels);

// Returns the instruction set's name that users know.
std::string commonName(const std::string& target) {
    if (target.starts_with("AVX3")) {
        return "AVX-512";
    }
    return target.starts_with("SSE4") ? "SSE4.2" : target;
}

} // namespace

PaperKernels vectorPaperKernels() {
    PaperKernels kernels = HWY_DYNAMIC_DISPATCH(kernels)();
    kernels.instructionSet = commonName(kernels.instructionSet);
    return kernels;
}

} // namespace dipwright::cpu
#endif
