// The inner loops of the paper's film over one row of points, once in plain C++ and once in vector
// instructions. Both use the same operations in the same order, without fused multiply-add, so both
// give the same bits.
//
// Points are stored as displacements from the flat film, so a film at rest is exactly zero. A
// constraint's difference vector is its rest vector plus the difference of two displacements. Rows
// are padded with points of weight 0 to whole chunks, and then by one or two more chunks.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace dipwright::cpu {

// Number of columns in a chunk (64 bytes). A chunk is skipped (it sleeps) until one of its points
// may move.
inline constexpr int chunkColumns = 16;
// mm²; points that are closer than this do not pull.
inline constexpr float shortestSquared = 1e-20f;

// Displacements of one row's points (mm) and their inverse masses: 1 free, 0 held.
struct WorkingRow {
    float* x = nullptr;
    float* y = nullptr;
    float* z = nullptr;
    float* weight = nullptr;
};

// One row as it is stored between steps. Adhered points are stored with their height at descent 0.
// Their height in the world is y − sinking·descent, so they move exactly with the body.
struct StoredRow {
    float* x = nullptr;
    float* y = nullptr;
    float* z = nullptr;
    float* previousX = nullptr; // x one step ago
    float* previousY = nullptr;
    float* previousZ = nullptr;
    float* weight = nullptr;
    float* sinking = nullptr; // 1 if adhered, else 0
};

// Loads the stored row into the working row. Only chunks with `isNeeded` set are loaded.
struct LoadTask {
    StoredRow from;
    WorkingRow to;
    int chunks = 0;
    const std::uint8_t* isNeeded = nullptr;
    float descent = 0;
    float inertia = 0;          // 1: predict x + Δt·v; 0: only load
    bool keepsPrevious = false; // also copies the stored positions to the previous ones
    float* motion = nullptr;    // output, per chunk: largest motion of a point in the last step, mm
};

// Stores the working row. Only chunks with `isBusy` set are stored.
struct StoreTask {
    WorkingRow from;
    StoredRow to;
    int chunks = 0;
    const std::uint8_t* isBusy = nullptr;
    float wakeDistance = 0;
    // Output, per chunk: set if a point is farther than `wakeDistance` from rest.
    std::uint8_t* hasMoved = nullptr;
};

// One row in one Jacobi sweep. Sums the corrections of all constraints of each point and multiplies
// the sum by `share`. Each constraint is computed once. Its correction for the row below is passed
// on in `fromAbove`, which is read for this row and then overwritten.
struct JacobiTask {
    WorkingRow row, below;
    std::array<float*, 3> fromAbove{};      // x, y, z
    const float* share = nullptr;           // per column: factor on the summed corrections
    const float* hasRight = nullptr;        // per column: 1 if there is a column to the right
    const float* columnStiffness = nullptr; // per column, for the constraint to the row below
    float hasBelow = 0;
    float rowStiffness = 1;
    float vertical = 1;          // 0: the water keeps free points in its plane
    std::array<float, 3> rest{}; // rest lengths: along the row, between rows, diagonal
    int chunks = 0;
    // chunks + 1 values. Only the points of chunks whose value is not 0 move.
    const std::uint8_t* isBusy = nullptr;
    const std::uint8_t* isBusyBelow = nullptr;
};

// One colour of a Gauss–Seidel sweep: `count` constraints between points of one row and points of
// another or the same row. No point is in two of these constraints, and each constraint is solved
// fully.
struct PairTask {
    WorkingRow first, second;
    std::array<float, 2> rest{}; // rest distance along x and z, from first to second
    float length = 0;
    float stiffness = 1;
    float vertical = 1;
    const float* exists = nullptr; // per pair: 1 if the constraint exists, else 0
    int count = 0;                 // a multiple of chunkColumns
};

struct PaperKernels {
    void (*load)(const LoadTask&);
    void (*store)(const StoreTask&);
    void (*jacobi)(const JacobiTask&);
    void (*jacobiWithDiagonals)(const JacobiTask&);
    void (*pairs)(const PairTask&);
    // Moves even columns to the front half and odd columns to the back half. `half` is a multiple
    // of chunkColumns.
    void (*split)(const float* from, float* to, int half);
    // Reverses split.
    void (*merge)(const float* from, float* to, int half);
    std::string instructionSet;
};

PaperKernels scalarPaperKernels();
PaperKernels vectorPaperKernels(); // for the best instruction set of this CPU

} // namespace dipwright::cpu
