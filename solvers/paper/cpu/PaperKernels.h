// The inner loops of the paper's film over one row of points, once in plain C++ and once for the
// processor's vector instructions. Both do the same arithmetic in the same order, without fused
// multiply-add, and so give the same bits.
//
// Points are kept as displacements from the flat film: a film at rest is exactly zero, and a
// constraint's difference vector is its rest vector plus the difference of two displacements.
// Rows are padded with points of weight 0: to whole chunks, and one or two chunks more.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace dipwright::cpu {

inline constexpr int chunkColumns = 16;          // columns that sleep and wake together; 64 bytes
inline constexpr float shortestSquared = 1e-20f; // mm²: points in one place pull nowhere

// Displacements of one row's points (mm) and their inverse masses: 1 free, 0 held.
struct WorkingRow {
    float* x = nullptr;
    float* y = nullptr;
    float* z = nullptr;
    float* weight = nullptr;
};

// One row as it is kept between steps. Adhered points keep the height that they had at descent 0:
// their y in the world is y − sinking·descent, so that they move exactly with the body.
struct StoredRow {
    float* x = nullptr;
    float* y = nullptr;
    float* z = nullptr;
    float* previousX = nullptr; // one step ago
    float* previousY = nullptr;
    float* previousZ = nullptr;
    float* weight = nullptr;
    float* sinking = nullptr; // 1 adhered, else 0
};

// From the stored to the working row, for the chunks whose `isNeeded` is set.
struct LoadTask {
    StoredRow from;
    WorkingRow to;
    int chunks = 0;
    const std::uint8_t* isNeeded = nullptr;
    float descent = 0;
    float inertia = 0;          // 1: predict x + Δt·v, 0: just load
    bool keepsPrevious = false; // make the stored positions the previous ones
    float* motion = nullptr;    // out, per chunk: the farthest that a point moved in the last step
};

// From the working to the stored row, for the chunks whose `isBusy` is set.
struct StoreTask {
    WorkingRow from;
    StoredRow to;
    int chunks = 0;
    const std::uint8_t* isBusy = nullptr;
    float wakeDistance = 0;
    std::uint8_t* hasMoved = nullptr; // per chunk, set where a point is farther from its rest
};

// One row in one Jacobi sweep: the corrections of all constraints of a point are summed, and
// multiplied by `share`. Every constraint is computed once: those to the row below are handed on in
// `fromAbove`, which is read for this row and then overwritten.
struct JacobiTask {
    WorkingRow row, below;
    std::array<float*, 3> fromAbove{};      // x, y, z
    const float* share = nullptr;           // per column
    const float* hasRight = nullptr;        // per column: 1 where there is a column to the right
    const float* columnStiffness = nullptr; // per column, of the constraint to the row below
    float hasBelow = 0;
    float rowStiffness = 1;
    float vertical = 1;          // 0: the water holds free points in the plane
    std::array<float, 3> rest{}; // length along the row, between rows, along the diagonal
    int chunks = 0;
    const std::uint8_t* isBusy = nullptr; // chunks + 1 each; points of other chunks stay
    const std::uint8_t* isBusyBelow = nullptr;
};

// Constraints between `count` points of one row and as many of another (or the same), no point in
// two of them, each solved fully: one colour of a Gauss–Seidel sweep.
struct PairTask {
    WorkingRow first, second;
    std::array<float, 2> rest{}; // along x and z, from first to second
    float length = 0;
    float stiffness = 1;
    float vertical = 1;
    const float* exists = nullptr; // per pair
    int count = 0;                 // a multiple of chunkColumns
};

struct PaperKernels {
    void (*load)(const LoadTask&);
    void (*store)(const StoreTask&);
    void (*jacobi)(const JacobiTask&);
    void (*jacobiWithDiagonals)(const JacobiTask&);
    void (*pairs)(const PairTask&);
    // Even columns to the front half, odd ones to the back half, and the reverse. `half` is a
    // multiple of chunkColumns.
    void (*split)(const float* from, float* to, int half);
    void (*merge)(const float* from, float* to, int half);
    std::string instructionSet;
};

PaperKernels scalarPaperKernels();
PaperKernels vectorPaperKernels(); // the best of this processor

} // namespace dipwright::cpu
