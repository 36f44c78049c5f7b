#include "paper/cpu/PaperModel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dipwright::cpu {

namespace {

// Returns the sum of the stiffnesses of a point's constraints. With diagonals, edges count 1,
// diagonals 1/2, and edges on the film's border 1/2 (docs/film-model.md, "Lattice with diagonals").
// Without diagonals, it is the number of constraints.
float stiffnessSum(const solver::FilmGrid& grid, int column, int row, bool hasDiagonals) {
    const int alongRow = (column > 0) + (column < grid.columns - 1);
    const int alongColumn = (row > 0) + (row < grid.rows - 1);
    if (!hasDiagonals) {
        return float(alongRow + alongColumn);
    }
    const float rowStiffness = alongColumn == 2 ? 1.0f : 0.5f;
    const float columnStiffness = alongRow == 2 ? 1.0f : 0.5f;
    return rowStiffness * float(alongRow) + columnStiffness * float(alongColumn) +
           0.5f * float(alongRow * alongColumn);
}

} // namespace

PaperModel::PaperModel(const solver::DipSetup& setup, PaperKernels usedKernels)
    : grid(setup.film), settings(setup.settings), motion(setup.motion),
      field(numerics::fieldGrid<double>(setup.field)),
      frameAtStart(numerics::bodyFrame<double>(setup.motion, 0)), kernels(std::move(usedKernels)),
      chunks((grid.columns + chunkColumns - 1) / chunkColumns),
      stride((chunks + 3) / 2 * 2 * chunkColumns),
      hasDiagonals(settings.lattice == solver::Lattice::Isotropic),
      vertical(settings.support == solver::Support::Water ? 0.0f : 1.0f) {
    const double x = grid.spacingX(0), z = grid.spacingZ(0);
    rest = {float(x), float(z), float(std::hypot(x, z))};
    for (auto* columns : {&borderShare, &innerShare, &hasRight, &columnStiffness}) {
        columns->assign(std::size_t(stride), 0.0f);
    }
    for (int column = 0; column < grid.columns; ++column) {
        const auto i = std::size_t(column);
        const bool isBorder = column == 0 || column == grid.columns - 1;
        borderShare[i] = 1 / stiffnessSum(grid, column, 0, hasDiagonals);
        innerShare[i] = grid.rows > 2 ? 1 / stiffnessSum(grid, column, 1, hasDiagonals) : 0;
        hasRight[i] = column < grid.columns - 1 ? 1.0f : 0.0f;
        columnStiffness[i] = isBorder ? 0.5f : 1.0f;
    }
    // Between two places, the trilinear φ of a distance field falls by at most their distance plus
    // the diagonal of a cell.
    clearanceMargin = settings.contactDistance + 1.01 * std::numbers::sqrt3 * field.spacing;
}

FilmActivity::FilmActivity(int rows, int chunks)
    : rows_(rows), chunks_(chunks), tileRowCount_((rows + tileRows - 1) / tileRows),
      hasMoved_(std::size_t(rows) * std::size_t(chunks)), freePoints_(hasMoved_.size()),
      tileMoved_(std::size_t(tileRowCount_) * std::size_t(chunks + 1)),
      tileFree_(tileMoved_.size()), isBusy_(tileMoved_.size()), isPresent_(tileMoved_.size()),
      nothing_(std::size_t(chunks + 1)) {}

bool FilmActivity::anyAround(const std::vector<std::uint8_t>& tiles, int tileRow, int chunk) const {
    const int firstRow = std::max(0, tileRow - 1);
    const int lastRow = std::min(tileRowCount_ - 1, tileRow + 1);
    const int firstChunk = std::max(0, chunk - 1);
    const int lastChunk = std::min(chunks_ - 1, chunk + 1);
    for (int row = firstRow; row <= lastRow; ++row) {
        for (int c = firstChunk; c <= lastChunk; ++c) {
            if (tiles[std::size_t(row) * std::size_t(chunks_ + 1) + std::size_t(c)]) {
                return true;
            }
        }
    }
    return false;
}

void FilmActivity::update() {
    std::fill(tileMoved_.begin(), tileMoved_.end(), std::uint8_t(0));
    std::fill(tileFree_.begin(), tileFree_.end(), std::uint8_t(0));
    for (int row = 0; row < rows_; ++row) {
        const std::size_t cells = cell(row, 0), tiles = tile(row);
        for (std::size_t chunk = 0; chunk < std::size_t(chunks_); ++chunk) {
            tileMoved_[tiles + chunk] |= hasMoved_[cells + chunk];
            tileFree_[tiles + chunk] |= freePoints_[cells + chunk];
        }
    }
    for (int tileRow = 0; tileRow < tileRowCount_; ++tileRow) {
        for (int chunk = 0; chunk < chunks_; ++chunk) {
            const std::size_t index = tile(tileRow * tileRows) + std::size_t(chunk);
            isBusy_[index] = tileFree_[index] && anyAround(tileMoved_, tileRow, chunk);
        }
    }
    for (int tileRow = 0; tileRow < tileRowCount_; ++tileRow) {
        for (int chunk = 0; chunk < chunks_; ++chunk) {
            isPresent_[tile(tileRow * tileRows) + std::size_t(chunk)] =
                anyAround(isBusy_, tileRow, chunk);
        }
    }
}

} // namespace dipwright::cpu
