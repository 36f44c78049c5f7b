// The kernels of the paper's film in plain C++. They are the reference for the vector kernels.

#include "paper/cpu/PaperKernels.h"

#include <algorithm>
#include <cmath>

namespace dipwright::cpu {

namespace {

struct Pull {
    float x = 0, y = 0, z = 0;
};
Pull operator+(Pull a, Pull b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Pull operator-(Pull a, Pull b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Pull operator*(Pull a, float factor) {
    return {a.x * factor, a.y * factor, a.z * factor};
}

// Returns how far the constraint between point `a` of row `first` and point `b` of row `second`
// moves the first point, if its weight is 1. The second point moves as far in the opposite
// direction. `exists` is 0 for a constraint that does not exist; the result is then zero.
Pull pull(const WorkingRow& first, int a, const WorkingRow& second, int b, float restX, float restZ,
          float length, float exists) {
    const float dx = restX + (second.x[b] - first.x[a]);
    const float dy = second.y[b] - first.y[a];
    const float dz = restZ + (second.z[b] - first.z[a]);
    const float squared = std::max((dx * dx + dy * dy) + dz * dz, shortestSquared);
    const float excess = 1.0f - length / std::sqrt(squared);
    // 1/(w1 + w2), which is one half if both points are free.
    const float sharing = exists - 0.5f * (first.weight[a] * second.weight[b]);
    return Pull{dx, dy, dz} * (excess * sharing);
}

void load(const LoadTask& task) {
    const StoredRow& from = task.from;
    for (int chunk = 0; chunk < task.chunks; ++chunk) {
        task.motion[chunk] = 0;
        if (!task.isNeeded[chunk]) {
            continue;
        }
        float farthest = 0;
        for (int i = chunk * chunkColumns; i < (chunk + 1) * chunkColumns; ++i) {
            const float x = from.x[i], y = from.y[i], z = from.z[i];
            const Pull step{x - from.previousX[i], y - from.previousY[i], z - from.previousZ[i]};
            farthest = std::max(farthest, (step.x * step.x + step.y * step.y) + step.z * step.z);
            task.to.x[i] = x + task.inertia * step.x;
            task.to.y[i] = (y + task.inertia * step.y) - from.sinking[i] * task.descent;
            task.to.z[i] = z + task.inertia * step.z;
            task.to.weight[i] = from.weight[i];
            if (task.keepsPrevious) {
                from.previousX[i] = x;
                from.previousY[i] = y;
                from.previousZ[i] = z;
            }
        }
        task.motion[chunk] = std::sqrt(farthest);
    }
}

void store(const StoreTask& task) {
    for (int chunk = 0; chunk < task.chunks; ++chunk) {
        if (!task.isBusy[chunk]) {
            continue;
        }
        float farthest = 0;
        for (int i = chunk * chunkColumns; i < (chunk + 1) * chunkColumns; ++i) {
            const float x = task.from.x[i], y = task.from.y[i], z = task.from.z[i];
            task.to.x[i] = x;
            task.to.y[i] = task.from.weight[i] > 0 ? y : task.to.y[i];
            task.to.z[i] = z;
            farthest = std::max({farthest, std::abs(x), std::abs(y), std::abs(z)});
        }
        if (farthest > task.wakeDistance) {
            task.hasMoved[chunk] = 1;
        }
    }
}

template <bool diagonals>
void jacobi(const JacobiTask& task) {
    const WorkingRow &row = task.row, &below = task.below;
    const auto [restX, restZ, restDiagonal] = task.rest;
    Pull left, leftDown, leftUp; // pulls of the previous column's constraints
    for (int chunk = 0; chunk < task.chunks; ++chunk) {
        const bool isBusy = task.isBusy[chunk];
        bool isNeeded = isBusy || task.isBusy[chunk + 1] || task.isBusyBelow[chunk];
        if constexpr (diagonals) {
            isNeeded = isNeeded || task.isBusyBelow[chunk + 1];
        }
        if (!isNeeded) {
            continue;
        }
        for (int i = chunk * chunkColumns; i < (chunk + 1) * chunkColumns; ++i) {
            const float hasRight = task.hasRight[i];
            Pull right = pull(row, i, row, i + 1, restX, 0, restX, hasRight);
            Pull down = pull(row, i, below, i, 0, restZ, restZ, task.hasBelow);
            Pull onRow, onBelow;
            if constexpr (diagonals) {
                right = right * task.rowStiffness;
                down = down * task.columnStiffness[i];
                const float exists = hasRight * task.hasBelow;
                const Pull rightDown =
                    pull(row, i, below, i + 1, restX, restZ, restDiagonal, exists) * 0.5f;
                const Pull rightUp =
                    pull(below, i, row, i + 1, restX, -restZ, restDiagonal, exists) * 0.5f;
                onRow = ((right - left) + down) + (rightDown - leftUp);
                onBelow = (down + leftDown) - rightUp;
                leftDown = rightDown;
                leftUp = rightUp;
            } else {
                onRow = (right - left) + down;
                onBelow = down;
            }
            left = right;
            onRow = onRow - Pull{task.fromAbove[0][i], task.fromAbove[1][i], task.fromAbove[2][i]};
            task.fromAbove[0][i] = onBelow.x;
            task.fromAbove[1][i] = onBelow.y;
            task.fromAbove[2][i] = onBelow.z;
            if (isBusy) {
                const float share = row.weight[i] * task.share[i];
                row.x[i] = row.x[i] + onRow.x * share;
                row.y[i] = row.y[i] + onRow.y * (share * task.vertical);
                row.z[i] = row.z[i] + onRow.z * share;
            }
        }
    }
}

void pairs(const PairTask& task) {
    const WorkingRow &first = task.first, &second = task.second;
    for (int i = 0; i < task.count; ++i) {
        const Pull e =
            pull(first, i, second, i, task.rest[0], task.rest[1], task.length, task.exists[i]) *
            task.stiffness;
        const float w1 = first.weight[i], w2 = second.weight[i];
        first.x[i] = first.x[i] + e.x * w1;
        first.y[i] = first.y[i] + e.y * (w1 * task.vertical);
        first.z[i] = first.z[i] + e.z * w1;
        second.x[i] = second.x[i] - e.x * w2;
        second.y[i] = second.y[i] - e.y * (w2 * task.vertical);
        second.z[i] = second.z[i] - e.z * w2;
    }
}

void split(const float* from, float* to, int half) {
    for (int i = 0; i < half; ++i) {
        to[i] = from[2 * i];
        to[half + i] = from[2 * i + 1];
    }
}

void merge(const float* from, float* to, int half) {
    for (int i = 0; i < half; ++i) {
        to[2 * i] = from[i];
        to[2 * i + 1] = from[half + i];
    }
}

} // namespace

PaperKernels scalarPaperKernels() {
    return {load, store, jacobi<false>, jacobi<true>, pairs, split, merge, "scalar"};
}

} // namespace dipwright::cpu
