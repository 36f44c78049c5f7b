// Holds one running dip of the paper's film: its constants, its points, and which points need work.
#pragma once

#include "common/BodyFrame.h"
#include "common/FieldSampling.h"
#include "common/cpu/AlignedVector.h"
#include "paper/cpu/PaperKernels.h"

#include <dipwright/FilmSolver.h>

#include <cstring>
#include <vector>

namespace dipwright::cpu {

// The constants of a dip of the paper's film.
struct PaperModel {
    PaperModel() = default;
    PaperModel(const solver::DipSetup& setup, PaperKernels kernels);

    solver::FilmGrid grid;
    solver::Settings settings;
    solver::BodyMotion motion;
    numerics::FieldGrid<double> field;
    numerics::BodyFrame<double> frameAtStart; // the body's frame at descent 0
    PaperKernels kernels;

    int chunks = 0; // chunks per row, each of chunkColumns columns
    int stride = 0; // floats per row, including the padding
    bool hasDiagonals = false;
    float vertical = 1;          // 0: the water keeps free points in its plane
    std::array<float, 3> rest{}; // rest lengths: along a row, between rows, along a diagonal
    // All four have one value per column. A share is 1 / the sum of a point's constraint
    // stiffnesses: `borderShare` in the first and last row, `innerShare` in the others.
    AlignedVector<float> borderShare, innerShare, hasRight, columnStiffness;
    double clearanceMargin = 0; // mm: a point farther than this from the body cannot touch it

    bool isBorderRow(int row) const { return row == 0 || row == grid.rows - 1; }
    double stepLength() const { return motion.speed * settings.timeStep; } // mm
};

// The points of all rows. The arrays of one row are stored side by side.
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

// Tracks which parts of the film need work. Tiles of film sleep if they are at rest far from the
// body, or have adhered entirely. A tile wakes if film beside it has moved or the body is near.
// Motion spreads by at most one tile in a Jacobi pass, so sleep does not change a bit of the
// result. Gauss–Seidel sweeps spread motion farther, so there the film never sleeps.
class FilmActivity {
public:
    FilmActivity() = default;
    FilmActivity(int rows, int chunks);

    // One flag per chunk of the row. Written by the thread that works on the row.
    std::uint8_t* hasMoved(int row) { return &hasMoved_[cell(row, 0)]; }
    std::uint8_t* freePoints(int row) { return &freePoints_[cell(row, 0)]; }
    // One flag per chunk, and one extra flag: whether the chunk's free points move.
    const std::uint8_t* isBusy(int row) const { return &isBusy_[tile(row)]; }
    // One flag per chunk, and one extra flag: whether the chunk or a neighbour is busy.
    const std::uint8_t* isPresent(int row) const { return &isPresent_[tile(row)]; }
    const std::uint8_t* nothing() const { return nothing_.data(); }

    // Prepares the next pass from the motion of the last one.
    void update();

private:
    static constexpr int tileRows = 8; // at least the Jacobi sweeps of a pass
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
