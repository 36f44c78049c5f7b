#include "production/cpu/StiffnessMultigrid.h"

#include "common/cpu/RowParallel.h"
#include "production/formulas/GalerkinCycle.h"

#include <algorithm>
#include <utility>

namespace dipwright::cpu {

namespace {

using namespace numerics::galerkin;

constexpr std::size_t margin = 16;          // numbers before a row, so that its vectors are aligned
constexpr std::size_t widestVector = 16;    // numbers past the end of a row
constexpr int rowsBelow = 1, rowsAbove = 2; // number of rows of zeros

std::size_t pitchOf(int columns) {
    return margin + (std::size_t(columns) + 2 * widestVector) / widestVector * widestVector;
}

std::size_t kindsPerRow(int columns) {
    return (std::size_t(columns) + pointsPerKind - 1) / pointsPerKind;
}

} // namespace

StiffnessMultigrid::Level::Level(int columnCount, int rowCount)
    : columns(columnCount), rows(rowCount), pitch(pitchOf(columnCount)),
      stencils(std::size_t(rowCount) * stencilLines * pitch),
      inverses(std::size_t(rowCount) * inverseLines * pitch) {
    const std::size_t count = std::size_t(rows + rowsBelow + rowsAbove) * pitch + margin;
    for (Vectors* vectors : {&right, &now, &next, &direction}) {
        vectors->x.assign(count, 0.f);
        vectors->z.assign(count, 0.f);
    }
}

std::size_t StiffnessMultigrid::Level::at(int row) const {
    return std::size_t(row + rowsBelow) * pitch + margin;
}
Lines<float> StiffnessMultigrid::Level::stencil(int row) {
    return {stencils.data() + std::size_t(row) * stencilLines * pitch, pitch};
}
Lines<float> StiffnessMultigrid::Level::inverse(int row) {
    return {inverses.data() + std::size_t(row) * inverseLines * pitch, pitch};
}
StencilRow StiffnessMultigrid::Level::stencilRow(int row) {
    const Lines<float> here = stencil(row);
    if (kinds.empty() || row == 0) {
        return {{here.first, here.pitch}, {}, nullptr};
    }
    const Lines<float> below = stencil(row - 1);
    return {{here.first, here.pitch},
            {below.first, below.pitch},
            kinds.data() + std::size_t(row) * kindsPerRow(columns)};
}
RowOfVectors<float> StiffnessMultigrid::Level::row(Vectors& vectors, int row) const {
    return {vectors.x.data() + at(row), vectors.z.data() + at(row)};
}
RowOfVectors<const float> StiffnessMultigrid::Level::row(const Vectors& vectors, int row) const {
    return {vectors.x.data() + at(row), vectors.z.data() + at(row)};
}

namespace {

struct Nothing {
    void operator()(int) const {}
};

Lines<const float> constant(const Lines<float>& lines) {
    return {lines.first, lines.pitch};
}

// The stiffness of the triangles in a row of cells (RowOfTriangles).
class TriangleRow {
public:
    explicit TriangleRow(std::size_t columns)
        : pitch_((columns / widestVector + 1) * widestVector),
          numbers_(2 * triangleLines * pitch_) {}
    // The cells' part of the lines of the first (0) or second (1) triangles.
    Lines<float> cells(std::size_t second) {
        return {numbers_.data() + second * triangleLines * pitch_ + 1, pitch_};
    }
    RowOfTriangles lines() const {
        return {{numbers_.data(), pitch_}, {numbers_.data() + triangleLines * pitch_, pitch_}};
    }
    void clear() { std::ranges::fill(numbers_, 0.f); }

private:
    std::size_t pitch_;
    AlignedVector<float> numbers_;
};

// The early lines (StencilLines) of the last rows, which only the coarser grid needs.
class EarlyLines {
public:
    explicit EarlyLines(std::size_t pitch) : pitch_(pitch), numbers_(kept * middleLine * pitch) {}
    Lines<float> of(int row) {
        return {numbers_.data() + std::size_t(row) % kept * middleLine * pitch_, pitch_};
    }

private:
    static constexpr std::size_t kept = 3; // a coarse row uses so many
    std::size_t pitch_;
    AlignedVector<float> numbers_;
};

} // namespace

StiffnessMultigrid::StiffnessMultigrid(const solver::FilmGrid& grid)
    : free_(std::size_t(grid.columns + 2) * std::size_t(grid.rows + 2), 0.f) {
    int columns = grid.columns, rows = grid.rows;
    levels_.emplace_back(columns, rows);
    while (!isCoarsest(columns, rows)) {
        columns = coarser(columns);
        rows = coarser(rows);
        levels_.emplace_back(columns, rows);
    }
}

template <typename StencilOf>
void StiffnessMultigrid::coarsenRow(Level& fine, const StencilOf& stencil, Level& coarse, int row,
                                    AlignedVector<float>& scratch) {
    const std::vector<float> zeros(fine.pitch);
    const auto fineRow = [&](int j) -> StencilLines<const float> {
        if (j < 0 || j >= fine.rows) {
            return {{zeros.data(), 0}, {zeros.data(), 0}};
        }
        const StencilLines<float> lines = stencil(j);
        return {constant(lines.early), constant(lines.others)};
    };
    const std::size_t columns = std::size_t(fine.columns);
    const Lines<float> across{scratch.data(), fine.pitch};
    coarsenAcross(columns, {fineRow(2 * row - 1), fineRow(2 * row), fineRow(2 * row + 1)}, across);
    coarsenAlong(columns, constant(across), coarse.stencil(row));
    invert(coarse, row);
}

void StiffnessMultigrid::assemble(const PlaneFilm& film, const std::vector<float>& area,
                                  float drag) {
    Level& level = levels_.front();
    const int coarseRows = levels_.size() > 1 ? levels_[1].rows : 0;
    const std::size_t width = std::size_t(level.columns), padded = width + 2;
    const auto freeRow = [&](int row) { return free_.data() + std::size_t(row + 1) * padded; };
    forRowBands(level.rows, level.columns, [&](int begin, int end) {
        TriangleRow below(width), above(width);
        const auto compute = [&](int row, TriangleRow& triangles) {
            if (row >= 0 && row < level.rows - 1) {
                film.stiffness(row, triangles.cells(0), triangles.cells(1));
            } else {
                triangles.clear();
            }
        };
        compute(begin - 1, below); // both bands compute the row of cells between them
        EarlyLines early(level.pitch);
        const auto stencil = [&](int row) -> StencilLines<float> {
            const bool isAtOtherBand =
                (begin > 0 && row < begin + 2) || (end < level.rows && row >= end - 2);
            const Lines<float> all = level.stencil(row);
            return {isAtOtherBand || level.readsAll(row) ? all : early.of(row), all};
        };
        AlignedVector<float> scratch(stencilLines * level.pitch);
        int nextCoarse = begin > 0 ? begin / 2 + 1 : 0;
        for (int row = begin; row < end; ++row) {
            compute(row, above);
            assembleStencils(width, unsigned(row) & 1u, below.lines(), above.lines(),
                             {freeRow(row - 1), freeRow(row), freeRow(row + 1)}, drag,
                             area.data() + std::size_t(row) * width, stencil(row));
            invert(level, row);
            std::swap(below, above);
            // A coarse row is computed as soon as its fine rows are there, in the cache.
            while (nextCoarse < coarseRows && std::min(2 * nextCoarse + 1, level.rows - 1) <= row) {
                coarsenRow(level, stencil, levels_[1], nextCoarse++, scratch);
            }
        }
    });
    if (coarseRows > 0) {
        forBandStarts(level.rows, level.columns, [&](int row) {
            AlignedVector<float> scratch(stencilLines * level.pitch);
            coarsenRow(level, allLines(level), levels_[1], row / 2, scratch);
        });
    }
}

bool StiffnessMultigrid::Level::readsAll(int row) {
    const StencilKind* first = stencilRow(row).kinds;
    const StencilKind* end = first == nullptr ? nullptr : first + kindsPerRow(columns);
    return first == nullptr || std::find(first, end, StencilKind::Any) != end;
}

void StiffnessMultigrid::findKinds(const PlaneFilm& film, const std::vector<float>& free) {
    Level& level = levels_.front();
    const std::size_t width = std::size_t(level.columns), kinds = kindsPerRow(level.columns);
    level.kinds.assign(kinds * std::size_t(level.rows), StencilKind::Symmetric);
    film.forCrossingCells([&](std::size_t column, std::size_t row) {
        for (const std::size_t i : {column, column + 1}) {
            for (const std::size_t j : {row, row + 1}) {
                level.kinds[j * kinds + i / pointsPerKind] = StencilKind::Any;
            }
        }
    });
    forRows(level.rows, level.columns, [&](int row) {
        const float* ofRow = free.data() + std::size_t(row) * width;
        std::copy_n(ofRow, width, free_.data() + std::size_t(row + 1) * (width + 2) + 1);
        for (std::size_t kind = 0; kind < kinds; ++kind) {
            const std::size_t end = std::min(width, (kind + 1) * pointsPerKind);
            if (std::all_of(ofRow + kind * pointsPerKind, ofRow + end,
                            [](float isFree) { return isFree == 0; })) {
                level.kinds[std::size_t(row) * kinds + kind] = StencilKind::Held;
            }
        }
    });
}

void StiffnessMultigrid::coarsen(Level& fine, Level& coarse) {
    forRowBands(coarse.rows, coarse.columns, [&](int begin, int end) {
        AlignedVector<float> scratch(stencilLines * fine.pitch);
        for (int row = begin; row < end; ++row) {
            coarsenRow(fine, allLines(fine), coarse, row, scratch);
        }
    });
}

void StiffnessMultigrid::invert(Level& level, int row) {
    invertMiddle(std::size_t(level.columns), constant(level.stencil(row)), level.inverse(row));
}

void StiffnessMultigrid::prepare(const PlaneFilm& film, const std::vector<float>& free,
                                 const std::vector<float>& area, float drag) {
    findKinds(film, free);
    assemble(film, area, drag);
    for (std::size_t index = 2; index < levels_.size(); ++index) {
        coarsen(levels_[index - 1], levels_[index]);
    }
}

// Takes one smoothing step of a row, from `now` to `result`; without `now`, from zero.
void StiffnessMultigrid::smoothRowOf(Level& level, int row, const ChebyshevStep& step,
                                     const Level::Vectors* now, Level::Vectors& result) {
    const ChebyshevRow to{step.keep,
                          step.gain,
                          constant(level.inverse(row)),
                          level.row(std::as_const(level.right), row),
                          level.row(level.direction, row),
                          level.row(result, row)};
    if (now == nullptr) {
        smoothFirst(std::size_t(level.columns), to);
    } else {
        smoothRow(std::size_t(level.columns), level.pitch, to, level.stencilRow(row),
                  level.row(*now, row));
    }
}

// Solves on the coarsest grid, from zero. Writes the result into `now`.
void StiffnessMultigrid::solveCoarsest(Level& level) {
    for (std::size_t k = 0; k < coarsestSteps.size(); ++k) {
        for (int row = 0; row < level.rows; ++row) {
            smoothRowOf(level, row, coarsestSteps[k], k == 0 ? nullptr : &level.now, level.next);
        }
        std::swap(level.now, level.next);
    }
}

// Smooths from zero into `now`, and writes the residual that is left into `next`. First calls
// take(row) for each row, which sets its right side.
template <typename Take>
void StiffnessMultigrid::smoothFromZero(Level& level, const Take& take) {
    forRowStages<3>(level.rows, level.columns, [&](int stage, int row) {
        if (stage == 0) {
            take(row);
            smoothRowOf(level, row, smoothingSteps[0], nullptr, level.next);
        } else if (stage == 1) {
            smoothRowOf(level, row, smoothingSteps[1], &level.next, level.now);
        } else {
            residualRow(std::size_t(level.columns), level.pitch, level.stencilRow(row),
                        level.row(std::as_const(level.right), row),
                        level.row(std::as_const(level.now), row), level.row(level.next, row));
        }
    });
}

// Sets the right side of a coarse row to the fine grid's residual, which is in its `next`.
void StiffnessMultigrid::Restriction::operator()(int row) const {
    std::vector<float> sum(std::size_t(fine->columns) + 3);
    const auto restricted = [&](const AlignedVector<float>& from, AlignedVector<float>& to) {
        restrictRow(std::size_t(fine->columns), std::size_t(coarse->columns), fine->pitch,
                    from.data() + fine->at(2 * row), sum.data(), to.data() + coarse->at(row));
    };
    restricted(fine->next.x, coarse->right.x);
    restricted(fine->next.z, coarse->right.z);
}

// Adds the coarse grid's correction to a row of `now`.
void StiffnessMultigrid::addCorrection(const Level& coarse, Level& fine, bool isFinest,
                                       int row) const {
    const RowOfVectors<const float> lower = coarse.row(coarse.now, row / 2),
                                    upper = coarse.row(coarse.now, (row + 1) / 2);
    const RowOfVectors<float> to = fine.row(fine.now, row);
    const std::size_t columns = std::size_t(fine.columns);
    const float* free =
        isFinest ? free_.data() + std::size_t(row + 1) * (columns + 2) + 1 : nullptr;
    interpolateRow(columns, lower.x, upper.x, free, to.x);
    interpolateRow(columns, lower.z, upper.z, free, to.z);
}

template <typename Take, typename Give>
void StiffnessMultigrid::cycle(std::size_t index, const Take& take, const Give& give) {
    static_assert(smoothingSteps.size() == 2);
    Level& level = levels_[index];
    if (index + 1 == levels_.size()) {
        for (int row = 0; row < level.rows; ++row) {
            take(row);
        }
        solveCoarsest(level);
        for (int row = 0; row < level.rows; ++row) {
            give(row);
        }
        return;
    }
    Level& coarse = levels_[index + 1];
    smoothFromZero(level, take);
    cycle(index + 1, Restriction{&level, &coarse}, Nothing{});
    forRowStages<3>(level.rows, level.columns, [&](int stage, int row) {
        if (stage == 0) {
            addCorrection(coarse, level, index == 0, row);
        } else if (stage == 1) {
            smoothRowOf(level, row, smoothingSteps[0], &level.now, level.next);
        } else {
            smoothRowOf(level, row, smoothingSteps[1], &level.next, level.now);
            give(row);
        }
    });
}

void StiffnessMultigrid::apply(const PlaneVector& right, float factor, PlaneVector& result) {
    Level& finest = levels_.front();
    const std::size_t width = std::size_t(finest.columns);
    const auto take = [&](int row) {
        const std::size_t from = std::size_t(row) * width, to = finest.at(row);
        scaledRow(width, factor, right.x.data() + from, finest.right.x.data() + to);
        scaledRow(width, factor, right.z.data() + from, finest.right.z.data() + to);
    };
    const auto give = [&](int row) {
        const std::size_t from = finest.at(row), to = std::size_t(row) * width;
        std::copy_n(finest.now.x.data() + from, width, result.x.data() + to);
        std::copy_n(finest.now.z.data() + from, width, result.z.data() + to);
    };
    cycle(0, take, give);
}

} // namespace dipwright::cpu
