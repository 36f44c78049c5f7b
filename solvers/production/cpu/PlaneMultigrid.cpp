#include "production/cpu/PlaneMultigrid.h"

#include "common/cpu/RowParallel.h"
#include "production/cpu/RowKernels.h"

#include <cmath>

namespace dipwright::cpu {

namespace multigrid = numerics::multigrid;

PlaneMultigrid::Level PlaneMultigrid::makeLevel(int columns, int rows, double width, double depth) {
    Level level;
    level.columns = columns;
    level.rows = rows;
    const double hx = width / (columns - 1), hz = depth / (rows - 1);
    level.stencil = multigrid::stencil(hx, hz);
    level.cell = multigrid::cellStiffness(hx, hz);
    const std::size_t points = std::size_t(columns) * std::size_t(rows);
    level.free.assign(points, 1.f);
    level.diagonal = level.right = level.result = level.residual = level.direction =
        PlaneVector(points);
    return level;
}

PlaneMultigrid::PlaneMultigrid(const solver::FilmGrid& grid) {
    int columns = grid.columns, rows = grid.rows;
    levels_.push_back(makeLevel(columns, rows, grid.width, grid.depth));
    while (!multigrid::isCoarsest(columns, rows)) {
        const int coarseColumns = multigrid::coarser(columns),
                  coarseRows = multigrid::coarser(rows);
        levels_.back().toCoarseColumns = multigrid::interpolation(columns, coarseColumns);
        levels_.back().toCoarseRows = multigrid::interpolation(rows, coarseRows);
        columns = coarseColumns;
        rows = coarseRows;
        levels_.push_back(makeLevel(columns, rows, grid.width, grid.depth));
    }
}

void PlaneMultigrid::setFree(const std::vector<float>& free) {
    levels_.front().free = free;
    for (std::size_t index = 0; index < levels_.size(); ++index) {
        if (index > 0) {
            holdCoarse(levels_[index - 1], levels_[index]);
        }
        setDiagonal(levels_[index]);
    }
}

// A coarse point is held where the fine point nearest to it is. A held patch too small to be seen
// by any coarse point still holds the coarse points nearest to it: without one the level could not
// tell where the film is.
void PlaneMultigrid::holdCoarse(const Level& fine, Level& coarse) {
    const auto nearest = [](int i, int from, int to) {
        return int(std::lround(double(i) * (to - 1) / (from - 1)));
    };
    bool anyHeld = false;
    for (int j = 0; j < coarse.rows; ++j) {
        const int fineRow = nearest(j, coarse.rows, fine.rows);
        for (int i = 0; i < coarse.columns; ++i) {
            const int fineColumn = nearest(i, coarse.columns, fine.columns);
            const float free = fine.free[std::size_t(fineRow * fine.columns + fineColumn)];
            coarse.free[std::size_t(j * coarse.columns + i)] = free;
            anyHeld = anyHeld || free == 0;
        }
    }
    for (int j = 0; j < fine.rows && !anyHeld; ++j) {
        for (int i = 0; i < fine.columns; ++i) {
            if (fine.free[std::size_t(j * fine.columns + i)] == 0) {
                coarse.free[std::size_t(nearest(j, fine.rows, coarse.rows) * coarse.columns +
                                        nearest(i, fine.columns, coarse.columns))] = 0;
            }
        }
    }
}

void PlaneMultigrid::setDiagonal(Level& level) {
    for (int j = 0; j < level.rows; ++j) {
        const float cellsZ = (j == 0 || j == level.rows - 1) ? 1.f : 2.f;
        for (int i = 0; i < level.columns; ++i) {
            const float cells = cellsZ * ((i == 0 || i == level.columns - 1) ? 1.f : 2.f);
            const std::size_t p = std::size_t(j * level.columns + i);
            level.diagonal.x[p] = level.free[p] / (cells * level.cell[0][0]);
            level.diagonal.z[p] = level.free[p] / (cells * level.cell[1][1]);
        }
    }
}

void PlaneMultigrid::applyStiffness(const Level& level, const PlaneVector& v, PlaneVector& result) {
    const int columns = level.columns, rows = level.rows;
    const auto at = [columns](int i, int j) { return std::size_t(j * columns + i); };
    const auto borderPoint = [&](int i, int j) {
        float x = 0, z = 0;
        for (int cj = std::max(j - 1, 0); cj < std::min(j + 1, rows - 1); ++cj) {
            for (int ci = std::max(i - 1, 0); ci < std::min(i + 1, columns - 1); ++ci) {
                const std::size_t own = std::size_t(2 * ((j - cj) * 2 + (i - ci)));
                for (int node = 0; node < 4; ++node) {
                    const std::size_t other = at(ci + node % 2, cj + node / 2);
                    const std::size_t n = std::size_t(2 * node);
                    x += level.cell[own][n] * v.x[other] + level.cell[own][n + 1] * v.z[other];
                    z += level.cell[own + 1][n] * v.x[other] +
                         level.cell[own + 1][n + 1] * v.z[other];
                }
            }
        }
        result.x[at(i, j)] = level.free[at(i, j)] * x;
        result.z[at(i, j)] = level.free[at(i, j)] * z;
    };
    forRowBands(rows, columns, [&](int begin, int end) {
        for (int j = begin; j < end; ++j) {
            if (j == 0 || j == rows - 1) {
                for (int i = 0; i < columns; ++i) {
                    borderPoint(i, j);
                }
                continue;
            }
            const StencilRow x{&v.x[at(0, j - 1)], &v.x[at(0, j)], &v.x[at(0, j + 1)]};
            const StencilRow z{&v.z[at(0, j - 1)], &v.z[at(0, j)], &v.z[at(0, j + 1)]};
            const float* free = &level.free[at(0, j)];
            stencilRow(std::size_t(columns), x, z, level.stencil.xx, level.stencil.xz, free,
                       &result.x[at(0, j)]);
            stencilRow(std::size_t(columns), z, x, level.stencil.zx, level.stencil.zz, free,
                       &result.z[at(0, j)]);
            borderPoint(0, j);
            borderPoint(columns - 1, j);
        }
    });
}

// Chebyshev iteration on the level's `result` for its `right`.
void PlaneMultigrid::smooth(Level& level, int degree, bool fromZero) {
    const std::size_t width = std::size_t(level.columns);
    const std::vector<multigrid::ChebyshevStep> steps = multigrid::chebyshev(degree);
    for (int k = 0; k < degree; ++k) {
        const bool trivial = fromZero && k == 0; // the residual is the right side
        if (!trivial) {
            applyStiffness(level, level.result, level.residual);
        }
        const multigrid::ChebyshevStep step = steps[std::size_t(k)];
        forRowBands(level.rows, level.columns, [&](int begin, int end) {
            const std::size_t first = std::size_t(begin) * width;
            const std::size_t count = std::size_t(end - begin) * width;
            for (const bool isX : {true, false}) {
                const auto pick = [isX, first](PlaneVector& v) {
                    return (isX ? v.x : v.z).data() + first;
                };
                if (trivial) {
                    std::fill_n(pick(level.result), count, 0.f);
                    std::copy_n(pick(level.right), count, pick(level.residual));
                } else {
                    subtract(count, pick(level.right), pick(level.residual), pick(level.residual));
                }
                if (k == 0) {
                    std::fill_n(pick(level.direction), count, 0.f);
                }
                chebyshevRow(count, step.keep, step.gain, pick(level.diagonal),
                             pick(level.residual), pick(level.direction), pick(level.result));
            }
        });
    }
}

// The residual of `fine` to the right side of `coarse`, by the transpose of the interpolation.
void PlaneMultigrid::restrictResidual(const Level& fine, Level& coarse) {
    const multigrid::Interpolation& columns = fine.toCoarseColumns;
    const multigrid::Interpolation& rows = fine.toCoarseRows;
    const std::size_t fineWidth = std::size_t(fine.columns);
    const std::size_t coarseWidth = std::size_t(coarse.columns);
    forRowBands(coarse.rows, coarse.columns, [&](int begin, int end) {
        std::vector<float> sum(fineWidth);
        for (int j = begin; j < end; ++j) {
            // the fine rows that lean on coarse row j lie within two of its own place
            const int middle = int(std::lround(double(j) * (fine.rows - 1) / (coarse.rows - 1)));
            for (const bool isX : {true, false}) {
                const std::vector<float>& residual = isX ? fine.residual.x : fine.residual.z;
                float* out =
                    (isX ? coarse.right.x : coarse.right.z).data() + std::size_t(j) * coarseWidth;
                std::fill(sum.begin(), sum.end(), 0.f);
                for (int fineRow = std::max(middle - 2, 0);
                     fineRow <= std::min(middle + 2, fine.rows - 1); ++fineRow) {
                    const int first = rows.first[std::size_t(fineRow)];
                    const float weight = first == j       ? 1 - rows.weight[std::size_t(fineRow)]
                                         : first + 1 == j ? rows.weight[std::size_t(fineRow)]
                                                          : 0.f;
                    if (weight > 0) {
                        const float* from = residual.data() + std::size_t(fineRow) * fineWidth;
                        for (std::size_t i = 0; i < fineWidth; ++i) {
                            sum[i] += weight * from[i];
                        }
                    }
                }
                std::fill_n(out, coarseWidth, 0.f);
                for (std::size_t i = 0; i < fineWidth; ++i) {
                    const std::size_t first = std::size_t(columns.first[i]);
                    out[first] += (1 - columns.weight[i]) * sum[i];
                    out[first + 1] += columns.weight[i] * sum[i];
                }
                const float* free = coarse.free.data() + std::size_t(j) * coarseWidth;
                for (std::size_t i = 0; i < coarseWidth; ++i) {
                    out[i] *= free[i];
                }
            }
        }
    });
}

void PlaneMultigrid::addCorrection(const Level& coarse, Level& fine) {
    const multigrid::Interpolation& columns = fine.toCoarseColumns;
    const multigrid::Interpolation& rows = fine.toCoarseRows;
    const std::size_t fineWidth = std::size_t(fine.columns);
    const std::size_t coarseWidth = std::size_t(coarse.columns);
    forRowBands(fine.rows, fine.columns, [&](int begin, int end) {
        std::vector<float> line(coarseWidth);
        for (int j = begin; j < end; ++j) {
            const std::size_t first = std::size_t(rows.first[std::size_t(j)]);
            const float weight = rows.weight[std::size_t(j)];
            const float* free = fine.free.data() + std::size_t(j) * fineWidth;
            for (const bool isX : {true, false}) {
                const std::vector<float>& from = isX ? coarse.result.x : coarse.result.z;
                float* out =
                    (isX ? fine.result.x : fine.result.z).data() + std::size_t(j) * fineWidth;
                const float* lower = from.data() + first * coarseWidth;
                const float* upper = lower + coarseWidth;
                for (std::size_t i = 0; i < coarseWidth; ++i) {
                    line[i] = lower[i] + weight * (upper[i] - lower[i]);
                }
                for (std::size_t i = 0; i < fineWidth; ++i) {
                    const std::size_t c = std::size_t(columns.first[i]);
                    out[i] += free[i] * (line[c] + columns.weight[i] * (line[c + 1] - line[c]));
                }
            }
        }
    });
}

void PlaneMultigrid::cycle(std::size_t index) {
    Level& level = levels_[index];
    if (index + 1 == levels_.size()) {
        smooth(level, multigrid::coarsestDegree, true);
        return;
    }
    smooth(level, multigrid::smoothingDegree, true);
    applyStiffness(level, level.result, level.residual);
    const std::size_t width = std::size_t(level.columns);
    forRowBands(level.rows, level.columns, [&](int begin, int end) {
        const std::size_t first = std::size_t(begin) * width;
        const std::size_t count = std::size_t(end - begin) * width;
        subtract(count, level.right.x.data() + first, level.residual.x.data() + first,
                 level.residual.x.data() + first);
        subtract(count, level.right.z.data() + first, level.residual.z.data() + first,
                 level.residual.z.data() + first);
    });
    restrictResidual(level, levels_[index + 1]);
    cycle(index + 1);
    addCorrection(levels_[index + 1], level);
    smooth(level, multigrid::smoothingDegree, false);
}

void PlaneMultigrid::apply(const PlaneVector& right, PlaneVector& result) {
    levels_.front().right = right;
    cycle(0);
    result = levels_.front().result;
}

} // namespace dipwright::cpu
