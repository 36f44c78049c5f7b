// What one dip of the paper's film consists of while it runs: constants, points, and which of them
// need work.
#pragma once

#include "common/BodyFrame.h"
#include "common/FieldSampling.h"
#include "paper/cpu/AlignedVector.h"
#include "paper/cpu/PaperKernels.h"

#include <dipwright/FilmSolver.h>

#include <cstring>
#include <vector>

namespace dipwright::cpu {

// The constants of a dip.
struct PaperModel {
    PaperModel() = default;
    PaperModel(const solver::DipSetup& setup, PaperKernels kernels);

    solver::FilmGrid grid;
    solver::Settings settings;
    solver::BodyMotion motion;
    numerics::FieldGrid<double> field;
    numerics::BodyFrame<double> frameAtStart; // of the body, at descent 0
    PaperKernels kernels;

    int chunks = 0; // of chunkColumns in a row
    int stride = 0; // floats in a row, padding included
    bool hasDiagonals = false;
    float vertical = 1;          // 0: the water holds free points in the plane
    std::array<float, 3> rest{}; // lengths: along a row, between rows, along a diagonal
    // Per column; `share` is the inverse of the sum of a point's constraint stiffnesses (of their
    // number, where all have stiffness 1) in the first and last rows, and in those between.
    AlignedVector<float> borderShare, innerShare, hasRight, columnStiffness;
    double clearanceMargin = 0; // mm: a point farther than this from the body cannot touch it

    bool isBorderRow(int row) const { return row == 0 || row == grid.rows - 1; }
    double stepLength() const { return motion.speed * settings.timeStep; } // mm
};

// The points of all rows, the arrays of one row beside each other.
class FilmRows {
public:
    static constexpr int arraysPerRow = 8;

    FilmRows() = default;
    FilmRows(int rows, int stride)
        : stride_(stride), values_(std::size_t(rows) * arraysPerRow * std::size_t(stride)) {}

    StoredRow row(int index) {
        float* start = rowStart(index);
        const auto array = [&](int which) { return start + std::ptrdiff_t(which) * stride_; };
        return {array(0), array(1), array(2), array(3), array(4), array(5), array(6), array(7)};
    }
    void copyRow(int index, FilmRows& from) {
        std::memcpy(rowStart(index), from.rowStart(index),
                    sizeof(float) * arraysPerRow * std::size_t(stride_));
    }

private:
    float* rowStart(int index) {
        return values_.data() + std::size_t(index) * arraysPerRow * std::size_t(stride_);
    }
    int stride_ = 0;
    AlignedVector<float> values_;
};

// Which parts of the film need work. Film at rest far from the body, and film whose points have all
// adhered, sleeps in tiles; a tile wakes when film beside it has moved or the body has come near.
// In one pass motion spreads by no more than a tile, so that sleep changes no bit; Gauss–Seidel
// sweeps carry it farther, and there film at rest does not sleep.
class FilmActivity {
public:
    FilmActivity() = default;
    FilmActivity(int rows, int chunks);

    // Per row and chunk, written by whoever works on the row.
    std::uint8_t* hasMoved(int row) { return &hasMoved_[cell(row, 0)]; }
    std::uint8_t* freePoints(int row) { return &freePoints_[cell(row, 0)]; }
    // Per chunk and one more: whether its free points move; whether it or a neighbour does.
    const std::uint8_t* isBusy(int row) const { return &isBusy_[tile(row)]; }
    const std::uint8_t* isPresent(int row) const { return &isPresent_[tile(row)]; }
    const std::uint8_t* nothing() const { return nothing_.data(); }

    // Takes what has happened in a pass into account for the next one.
    void update();

private:
    static constexpr int tileRows = 8; // no fewer than the Jacobi sweeps of a pass
    std::size_t cell(int row, int chunk) const {
        return std::size_t(row) * std::size_t(chunks_) + std::size_t(chunk);
    }
    std::size_t tile(int row) const {
        return std::size_t(row / tileRows) * std::size_t(chunks_ + 1);
    }
    bool anyAround(const std::vector<std::uint8_t>& tiles, int tileRow, int chunk) const;

    int rows_ = 0, chunks_ = 0, tileRowCount_ = 0;
    std::vector<std::uint8_t> hasMoved_, freePoints_;
    std::vector<std::uint8_t> tileMoved_, tileFree_, isBusy_, isPresent_, nothing_;
};

} // namespace dipwright::cpu
