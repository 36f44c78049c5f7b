// Tests the multigrid cycle's row kernels on every instruction set of this processor. Results are
// compared bit for bit with plain loops where the arithmetic is the same. Otherwise they are
// compared with the matrices that the kernels apply.

#include "production/cpu/StencilKernels.h"
#include "RandomRows.h"

#include "production/formulas/EdgeStiffness.h"

#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <hwy/targets.h>
#include <random>
#include <vector>

using namespace dipwright;
using namespace dipwright::cpu;
using test::haveSameBits;
using test::randomRow;
using test::Row;

namespace {

// Returns whether `work` gives the same bits on all of the processor's instruction sets.
bool isSameOnAll(const std::function<Row()>& work) {
    const std::int64_t all = hwy::SupportedTargets();
    const Row first = work();
    bool isSame = true;
    for (std::int64_t rest = all; rest != 0; rest &= rest - 1) {
        hwy::SetSupportedTargetsForTest(rest & -rest);
        isSame = isSame && haveSameBits(first, work());
    }
    hwy::SetSupportedTargetsForTest(0);
    return isSame;
}

Row joined(std::initializer_list<Row> rows) {
    Row all;
    for (const Row& row : rows) {
        all.insert(all.end(), row.begin(), row.end());
    }
    return all;
}

// `room`: numbers past a row's end that the kernels need.
constexpr std::size_t longest = 40, room = 16;

// The stiffness of a grid, row after row. No entry connects to a point outside the grid.
struct Grid {
    Grid(int columnCount, int rowCount)
        : columns(columnCount), rows(rowCount), pitch(std::size_t(columnCount) + room),
          stencils(std::size_t(rowCount) * stencilLines * pitch) {}

    Grid(int columnCount, int rowCount, unsigned seed) : Grid(columnCount, rowCount) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> number(-1, 1);
        forEntries([&](int row, int column, int dr, int dc, int k) {
            if (row + dr >= 0 && row + dr < rows && column + dc >= 0 && column + dc < columns) {
                at(row, column, dr, dc, k) = number(random);
            }
        });
    }
    template <typename Work>
    void forEntries(const Work& work) const {
        for (int row = 0; row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                for (int neighbour = 0; neighbour < 9; ++neighbour) {
                    for (int k = 0; k < 4; ++k) {
                        work(row, column, neighbour / 3 - 1, neighbour % 3 - 1, k);
                    }
                }
            }
        }
    }
    Lines<float> row(int r) {
        return {stencils.data() + std::size_t(r) * stencilLines * pitch, pitch};
    }
    Lines<const float> constRow(int r) const {
        return {stencils.data() + std::size_t(r) * stencilLines * pitch, pitch};
    }
    // Returns a coefficient of a point's stencil for the neighbour that is `dr` rows and `dc`
    // columns away. `k` = 0 … 3 selects xx, xz, zx or zz.
    float& at(int r, int column, int dr, int dc, int k) {
        return row(r)[std::size_t(4 * (3 * (dr + 1) + dc + 1) + k)][column];
    }
    float at(int r, int column, int dr, int dc, int k) const {
        return constRow(r)[std::size_t(4 * (3 * (dr + 1) + dc + 1) + k)][column];
    }

    int columns, rows;
    std::size_t pitch;
    Row stencils;
};

// Returns the weight of a coarse point at a fine point. The coarse grid has every second point.
double share(int fine, int coarse) {
    const int apart = std::abs(fine - 2 * coarse);
    return apart == 0 ? 1 : apart == 1 ? 0.5 : 0;
}

// Returns PᵀKP, summed over the entries of K.
Grid galerkin(const Grid& fine) {
    Grid coarse(fine.columns / 2 + 1, fine.rows / 2 + 1);
    fine.forEntries([&](int row, int column, int dr, int dc, int k) {
        const double value = double(fine.at(row, column, dr, dc, k));
        for (int r = row / 2; r <= (row + 1) / 2; ++r) {
            for (int c = column / 2; c <= (column + 1) / 2; ++c) {
                const double own = share(row, r) * share(column, c);
                const int toRow = row + dr, toColumn = column + dc;
                for (int r2 = std::max(toRow / 2, 0); value != 0 && r2 <= (toRow + 1) / 2; ++r2) {
                    for (int c2 = toColumn / 2; c2 <= (toColumn + 1) / 2; ++c2) {
                        coarse.at(r, c, r2 - r, c2 - c, k) +=
                            float(own * value * share(toRow, r2) * share(toColumn, c2));
                    }
                }
            }
        }
    });
    return coarse;
}

Grid coarsened(const Grid& fine) {
    Grid coarse(fine.columns / 2 + 1, fine.rows / 2 + 1);
    for (int row = 0; row < coarse.rows; ++row) {
        Row across(stencilLines * fine.pitch);
        const Row outside(across.size());
        const auto rowAt = [&](int from) {
            return from >= 0 && from < fine.rows ? fine.constRow(from)
                                                 : Lines<const float>{outside.data(), fine.pitch};
        };
        const auto linesAt = [&](int from) -> StencilLines<const float> {
            return {rowAt(from), rowAt(from)};
        };
        coarsenAcross(std::size_t(fine.columns),
                      {linesAt(2 * row - 1), linesAt(2 * row), linesAt(2 * row + 1)},
                      {across.data(), fine.pitch});
        coarsenAlong(std::size_t(fine.columns), {across.data(), fine.pitch}, coarse.row(row));
    }
    return coarse;
}

double largestDifference(const Row& a, const Row& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        most = std::max(most, std::abs(double(a[i]) - double(b[i])));
    }
    return most;
}

// Three rows of points, surrounded by zeros.
struct Points {
    Points(std::size_t count, unsigned seed)
        : columns(count), pitch(count + 2 * room), x(3 * pitch), z(3 * pitch) {
        for (unsigned row = 0; row < 3; ++row) {
            std::ranges::copy(randomRow(count, seed + row), x.begin() + long(at(row)));
            std::ranges::copy(randomRow(count, seed + 3 + row), z.begin() + long(at(row)));
        }
    }
    std::size_t at(std::size_t row) const { return row * pitch + room; }
    RowOfVectors<const float> middle() const { return {x.data() + at(1), z.data() + at(1)}; }
    RowOfVectors<float> middle() { return {x.data() + at(1), z.data() + at(1)}; }
    Row row() const {
        const auto part = [&](const Row& all) {
            return Row(all.begin() + long(at(1)), all.begin() + long(at(1) + columns));
        };
        return joined({part(x), part(z)});
    }

    std::size_t columns, pitch;
    Row x, z;
};

// A row of stencils, and the residual right − K·now.
struct RandomStencils {
    explicit RandomStencils(std::size_t count)
        : columns(count), pitch(count + room), stencil(stencilLines * pitch),
          inverse(inverseLines * pitch) {
        for (std::size_t line = 0; line < stencilLines; ++line) {
            std::ranges::copy(randomRow(count, unsigned(line)),
                              stencil.begin() + long(line * pitch));
        }
        for (std::size_t line = 0; line < inverseLines; ++line) {
            std::ranges::copy(randomRow(count, 50 + unsigned(line)),
                              inverse.begin() + long(line * pitch));
        }
    }
    Lines<const float> lines() const { return {stencil.data(), pitch}; }
    Lines<const float> inverses() const { return {inverse.data(), pitch}; }
    std::array<float, 2> residual(std::size_t i, const Points& right, const Points& now) const {
        float x = right.middle().x[i], z = right.middle().z[i];
        for (std::size_t neighbour = 0; neighbour < 9; ++neighbour) {
            const std::size_t there = now.at(neighbour / 3) + i + neighbour % 3 - 1;
            const float nx = now.x[there], nz = now.z[there];
            const auto k = [&](std::size_t part) { return lines()[4 * neighbour + part][i]; };
            x -= k(0) * nx + k(1) * nz;
            z -= k(2) * nx + k(3) * nz;
        }
        return {x, z};
    }

    std::size_t columns, pitch;
    Row stencil, inverse;
};

// Adds the stiffness of a triangle's edges to the stencils of its corners.
void addTriangle(Grid& grid, int row, int column, bool isUpper, bool onRight,
                 const Lines<const float>& stiffness) {
    const int base = isUpper ? row + 1 : row, side = onRight ? column + 1 : column;
    const std::array<std::array<int, 2>, 4> ends{
        {{base, column}, {base, column + 1}, {row, side}, {row + 1, side}}};
    for (std::size_t of = 0; of < 4; ++of) {
        for (std::size_t by = 0; by < 4; ++by) {
            for (int k = 0; k < 4; ++k) {
                const std::size_t block = 2 * (of / 2) + by / 2;
                const float value = stiffness[4 * block + std::size_t(k)][column];
                grid.at(ends[of][0], ends[of][1], ends[by][0] - ends[of][0],
                        ends[by][1] - ends[of][1], k) += of % 2 == by % 2 ? value : -value;
            }
        }
    }
}

// The stiffness of the triangles in rows of cells (RowOfTriangles), and rows of zeros around them.
struct TriangleRows {
    TriangleRows(std::size_t cellCount, std::size_t rows)
        : cells(cellCount), numbers((rows + 2) * 2 * triangleLines * pitch()) {}
    std::size_t pitch() const { return cells + 2; }
    // The cells' part of the lines of the first (0) or second (1) triangles.
    Lines<float> at(int row, std::size_t second) {
        return {numbers.data() + (2 * std::size_t(row + 1) + second) * triangleLines * pitch() + 1,
                pitch()};
    }
    RowOfTriangles row(int row) {
        const Lines<float> first = at(row, 0), second = at(row, 1);
        return {{first.first - 1, pitch()}, {second.first - 1, pitch()}};
    }

    std::size_t cells;
    Row numbers;
};

// Assembles all rows of a grid; `free` is surrounded by zeros. The early lines are assembled
// elsewhere if `apart`.
Row assembledGrid(TriangleRows& triangles, int rows, const Row& free, float drag, const Row& area,
                  bool apart = false) {
    const std::size_t width = triangles.cells + 1;
    Grid grid(int(width), rows), early(int(width), rows);
    for (int row = 0; row < rows; ++row) {
        const float* below = free.data() + std::size_t(row) * (width + 2);
        assembleStencils(width, unsigned(row) % 2, triangles.row(row - 1), triangles.row(row),
                         {below, below + width + 2, below + 2 * (width + 2)}, drag,
                         area.data() + std::size_t(row) * width,
                         {(apart ? early : grid).row(row), grid.row(row)});
    }
    std::ranges::transform(grid.stencils, early.stencils, grid.stencils.begin(),
                           [](float a, float b) { return a != 0 ? a : b; });
    return grid.stencils;
}

// 1 for free points, 0 for held ones and around the grid.
Row someFree(std::size_t width, int rows) {
    Row free(std::size_t(rows + 2) * (width + 2));
    const Row random = randomRow(width * std::size_t(rows), 4, -0.2f, 1);
    for (int row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < width; ++column) {
            free[std::size_t(row + 1) * (width + 2) + column + 1] =
                random[std::size_t(row) * width + column] > 0 ? 1.f : 0.f;
        }
    }
    return free;
}

} // namespace

class StencilKernelsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void assembleStencils_assemblesTheTrianglesOfFreePoints();
    void invertMiddle_invertsTheDiagonalBlocks();
    void coarsen_givesTheGalerkinOperator();
    void smoothFirst_withoutStiffness_equalsScalarBits();
    void smoothRow_isAChebyshevStep();
    void residualRow_equalsScalarBits();
    void symmetricAndHeldPoints_giveTheSameBits();
    void assembledFilm_isSymmetricToTheLastBit();
    void restrictRow_isTheTransposeOfInterpolateRow();
    void interpolateRow_linearValues_isExact();
};

void StencilKernelsTest::assembleStencils_assemblesTheTrianglesOfFreePoints() {
    constexpr int rows = 4;
    for (const std::size_t cells : {std::size_t(1), std::size_t(2), std::size_t(7), std::size_t(15),
                                    std::size_t(16), longest}) {
        const std::size_t width = cells + 1;
        TriangleRows triangles(cells, rows - 1);
        Grid expected(int(width), rows);
        for (int row = 0; row + 1 < rows; ++row) {
            for (std::size_t second = 0; second < 2; ++second) {
                const Lines<float> lines = triangles.at(row, second);
                for (std::size_t line = 0; line < triangleLines; ++line) {
                    std::ranges::copy(randomRow(cells, unsigned(100 * row + 2 * line + second)),
                                      lines[line]);
                }
                for (int column = 0; column < int(cells); ++column) {
                    const bool even = (column + row) % 2 == 0;
                    addTriangle(expected, row, column, second != 0, even != (second != 0),
                                {lines.first, lines.pitch});
                }
            }
        }
        const Row free = someFree(width, rows), area = randomRow(width * rows, 9, 0.5f, 2);
        const auto isFree = [&](int row, int column) {
            return free[std::size_t(row + 1) * (width + 2) + std::size_t(column + 1)];
        };
        expected.forEntries([&](int row, int column, int dr, int dc, int k) {
            const float own = isFree(row, column);
            const bool isDiagonal = dr == 0 && dc == 0 && (k == 0 || k == 3);
            float& value = expected.at(row, column, dr, dc, k);
            value = value * own * isFree(row + dr, column + dc) +
                    (isDiagonal ? 0.25f * area[std::size_t(row) * width + std::size_t(column)] * own
                                : 0);
        });
        const auto assembled = [&] { return assembledGrid(triangles, rows, free, 0.25f, area); };
        QVERIFY(largestDifference(assembled(), expected.stencils) < 1e-5);
        QVERIFY(isSameOnAll(assembled));
        QVERIFY(assembledGrid(triangles, rows, free, 0.25f, area, true) == assembled());
    }
}

void StencilKernelsTest::invertMiddle_invertsTheDiagonalBlocks() {
    Grid grid(4, 1);
    const auto put = [&](int column, std::array<float, 4> block) {
        for (int k = 0; k < 4; ++k) {
            grid.at(0, column, 0, 0, k) = block[std::size_t(k)];
        }
    };
    put(0, {4, 1, 3, 3}); // symmetric part: 4, 2, 3
    put(1, {0, 0, 0, 0}); // a held point
    put(2, {2, 2, 2, 2}); // nearly singular
    put(3, {1, 0, 0, 0}); // stiff in one direction only
    const auto inverted = [&] {
        Row inverse(inverseLines * 4);
        invertMiddle(4, grid.constRow(0), {inverse.data(), 4});
        return inverse;
    };
    const Row found = inverted();
    const auto is = [&](std::size_t column, float xx, float xz, float zz) {
        return std::abs(found[column] - xx) < 1e-6f && std::abs(found[4 + column] - xz) < 1e-6f &&
               std::abs(found[8 + column] - zz) < 1e-6f;
    };
    QVERIFY(is(0, 3.f / 8, -2.f / 8, 4.f / 8));
    QVERIFY(is(1, 0, 0, 0));
    QVERIFY(is(2, 0.25f, 0, 0.25f));
    QVERIFY(is(3, 1, 0, 1));
    QVERIFY(isSameOnAll(inverted));
}

void StencilKernelsTest::coarsen_givesTheGalerkinOperator() {
    for (const auto [columns, rows] :
         {std::array{9, 7}, std::array{8, 6}, std::array{9, 6}, std::array{37, 5},
          std::array{38, 4}, std::array{2, 2}, std::array{3, 3}}) {
        const Grid fine(columns, rows, unsigned(columns));
        const Grid coarse = coarsened(fine);
        QVERIFY(largestDifference(coarse.stencils, galerkin(fine).stencils) < 1e-5);
        QVERIFY(isSameOnAll([&] { return coarsened(fine).stencils; }));
    }
}

void StencilKernelsTest::smoothFirst_withoutStiffness_equalsScalarBits() {
    for (std::size_t count = 1; count <= longest; ++count) {
        const RandomStencils row(count);
        const Points right(count, 60);
        const auto smoothed = [&] {
            Points direction(count, 70), result(count, 80);
            smoothFirst(count, {0.4f, 0.7f, row.inverses(), right.middle(), direction.middle(),
                                result.middle()});
            return joined({direction.row(), result.row()});
        };
        Points direction(count, 70), result(count, 80);
        for (std::size_t i = 0; i < count; ++i) {
            const float x = right.middle().x[i], z = right.middle().z[i];
            const float sx = row.inverses()[0][i] * x + row.inverses()[1][i] * z;
            const float sz = row.inverses()[1][i] * x + row.inverses()[2][i] * z;
            direction.middle().x[i] = 0.4f * direction.middle().x[i] + 0.7f * sx;
            direction.middle().z[i] = 0.4f * direction.middle().z[i] + 0.7f * sz;
            result.middle().x[i] = direction.middle().x[i];
            result.middle().z[i] = direction.middle().z[i];
        }
        QVERIFY(haveSameBits(smoothed(), joined({direction.row(), result.row()})));
        QVERIFY(isSameOnAll(smoothed));
    }
}

void StencilKernelsTest::smoothRow_isAChebyshevStep() {
    for (std::size_t count = 1; count <= longest; ++count) {
        const RandomStencils row(count);
        const Points right(count, 60), now(count, 90);
        const auto smoothed = [&] {
            Points direction(count, 70), result(count, 80);
            smoothRow(
                count, now.pitch,
                {0.4f, 0.7f, row.inverses(), right.middle(), direction.middle(), result.middle()},
                {row.lines(), {}}, now.middle());
            return joined({direction.row(), result.row()});
        };
        Points direction(count, 70), result(count, 80);
        for (std::size_t i = 0; i < count; ++i) {
            const auto [x, z] = row.residual(i, right, now);
            const float sx = row.inverses()[0][i] * x + row.inverses()[1][i] * z;
            const float sz = row.inverses()[1][i] * x + row.inverses()[2][i] * z;
            direction.middle().x[i] = 0.4f * direction.middle().x[i] + 0.7f * sx;
            direction.middle().z[i] = 0.4f * direction.middle().z[i] + 0.7f * sz;
            result.middle().x[i] = now.middle().x[i] + direction.middle().x[i];
            result.middle().z[i] = now.middle().z[i] + direction.middle().z[i];
        }
        QVERIFY(haveSameBits(smoothed(), joined({direction.row(), result.row()})));
        QVERIFY(isSameOnAll(smoothed));
    }
}

void StencilKernelsTest::residualRow_equalsScalarBits() {
    for (std::size_t count = 1; count <= longest; ++count) {
        const RandomStencils row(count);
        const Points right(count, 60), now(count, 90);
        const auto left = [&] {
            Points residual(count, 70);
            residualRow(count, now.pitch, {row.lines(), {}}, right.middle(), now.middle(),
                        residual.middle());
            return residual.row();
        };
        Points expected(count, 70);
        for (std::size_t i = 0; i < count; ++i) {
            const auto [x, z] = row.residual(i, right, now);
            expected.middle().x[i] = x;
            expected.middle().z[i] = z;
        }
        QVERIFY(haveSameBits(left(), expected.row()));
        QVERIFY(isSameOnAll(left));
    }
}

// The kinds only say which stencils need not be read.
void StencilKernelsTest::symmetricAndHeldPoints_giveTheSameBits() {
    const int columns = 3 * int(pointsPerKind);
    const auto count = std::size_t(columns);
    Grid grid(columns, 3, 5);
    grid.forEntries([&](int row, int column, int dr, int dc, int k) { // K is its own transpose
        const int toRow = row + dr, toColumn = column + dc,
                  transposed = k == 1   ? 2
                               : k == 2 ? 1
                                        : k;
        if (toRow >= 0 && toRow < 3 && toColumn >= 0 && toColumn < columns) {
            grid.at(toRow, toColumn, -dr, -dc, transposed) = grid.at(row, column, dr, dc, k);
        }
    });
    for (int column = columns - int(pointsPerKind); column < columns; ++column) {
        for (int line = 0; line < int(stencilLines); ++line) {
            grid.row(1)[std::size_t(line)][column] = 0;
        }
    }
    // The points beside those that are held have one stencil that is not symmetric.
    const std::array kinds{StencilKind::Symmetric, StencilKind::Any, StencilKind::Held};
    const Points right(count, 60), now(count, 90);
    const RandomStencils row(count);
    const auto left = [&](const StencilKind* known) {
        Points residual(count, 70);
        residualRow(count, now.pitch, {grid.constRow(1), grid.constRow(0), known}, right.middle(),
                    now.middle(), residual.middle());
        return residual;
    };
    const auto smoothed = [&](const StencilKind* known) {
        Points direction(count, 70), result(count, 80);
        smoothRow(count, now.pitch,
                  {0.4f, 0.7f, row.inverses(), right.middle(), direction.middle(), result.middle()},
                  {grid.constRow(1), grid.constRow(0), known}, now.middle());
        return result;
    };
    const auto free = count - pointsPerKind;
    const auto agree = [&](const Points& all, const Points& some) {
        const auto part = [&](const float* values) { return Row(values, values + free); };
        return haveSameBits(part(all.middle().x), part(some.middle().x)) &&
               haveSameBits(part(all.middle().z), part(some.middle().z));
    };
    const auto isZero = [&](const Points& some) {
        const auto held = [&](const float* values) {
            return std::all_of(values + free, values + count, [](float v) { return v == 0; });
        };
        return held(some.middle().x) && held(some.middle().z);
    };
    QVERIFY(agree(left(nullptr), left(kinds.data())));
    QVERIFY(agree(smoothed(nullptr), smoothed(kinds.data())));
    QVERIFY(isZero(left(kinds.data())));
    QVERIFY(isZero(smoothed(kinds.data())));
    QVERIFY(isSameOnAll([&] { return left(kinds.data()).row(); }));
    QVERIFY(isSameOnAll([&] { return smoothed(kinds.data()).row(); }));
}

// StencilKind::Symmetric depends on this.
void StencilKernelsTest::assembledFilm_isSymmetricToTheLastBit() {
    constexpr int columns = 39, rows = 6;
    constexpr std::size_t width = columns, cells = width - 1;
    const auto assembled = [&] {
        const Row x = randomRow(width * rows, 1, -0.2f, 0.2f),
                  z = randomRow(width * rows, 2, -0.2f, 0.2f),
                  edgesX = randomRow(cells, 3, 0.8f, 1.2f), area(width * rows, 1.0f);
        Row inverses(cells);
        std::ranges::transform(edgesX, inverses.begin(), [](float edge) { return 1 / edge; });
        const RowOfShapes shapes{false, {}, {edgesX.data(), inverses.data(), 0.97f, 1 / 0.97f}};
        TriangleRows triangles(cells, rows - 1);
        for (int row = 0; row + 1 < rows; ++row) {
            const float *lowerX = x.data() + std::size_t(row) * width,
                        *lowerZ = z.data() + std::size_t(row) * width;
            const unsigned parity = unsigned(row) % 2;
            Row states[8], forces[8];
            for (std::size_t i = 0; i < 8; ++i) {
                states[i] = forces[i] = Row(cells);
            }
            RowOfStates<float*> written;
            RowOfStates<const float*> read;
            for (std::size_t k = 0; k < 2; ++k) {
                float *cosine = states[4 * k].data(), *sine = states[4 * k + 1].data(),
                      *turn = states[4 * k + 2].data(), *resists = states[4 * k + 3].data();
                written.states[k] = {cosine, sine, turn, resists};
                read.states[k] = {cosine, sine, turn, resists};
            }
            gradientRow(cells, parity, {lowerX, lowerZ, lowerX + width, lowerZ + width}, shapes,
                        -1.5f, written,
                        {forces[0].data(), forces[1].data(), forces[2].data(), forces[3].data(),
                         forces[4].data(), forces[5].data(), forces[6].data(), forces[7].data()});
            stiffnessRow(cells, shapes, read, triangles.at(row, 0), triangles.at(row, 1));
        }
        return assembledGrid(triangles, rows, someFree(width, rows), 0.25f, area);
    };
    Grid grid(columns, rows);
    grid.stencils = assembled();
    int differing = 0, compared = 0;
    grid.forEntries([&](int row, int column, int dr, int dc, int k) {
        const int toRow = row + dr, toColumn = column + dc,
                  transposed = k == 1   ? 2
                               : k == 2 ? 1
                                        : k;
        const bool isNeighbour = dr != 0 || dc != 0;
        if (isNeighbour && toRow >= 0 && toRow < rows && toColumn >= 0 && toColumn < columns) {
            const float there = grid.at(row, column, dr, dc, k),
                        back = grid.at(toRow, toColumn, -dr, -dc, transposed);
            differing += !haveSameBits({there}, {back});
            compared += there != 0;
        }
    });
    QVERIFY(compared > 1000);
    QVERIFY(differing == 0);
    QVERIFY(isSameOnAll(assembled));
}

// Checks that (P c) · f = c · (Pᵀ f) for all rows of a fine and a coarse grid.
void StencilKernelsTest::restrictRow_isTheTransposeOfInterpolateRow() {
    for (const auto [columns, rows] : {std::array{2, 2}, std::array{5, 7}, std::array{6, 6},
                                       std::array{33, 4}, std::array{34, 5}}) {
        const auto fineColumns = std::size_t(columns), coarseColumns = fineColumns / 2 + 1;
        const int coarseRows = rows / 2 + 1;
        const Row coarse = randomRow(coarseColumns * std::size_t(coarseRows), 2);
        // The fine grid has one row of zeros below it and two above it.
        Row fine = randomRow(fineColumns * std::size_t(rows + 3), 1);
        std::fill_n(fine.begin(), fineColumns, 0.f);
        std::fill_n(fine.end() - long(2 * fineColumns), 2 * fineColumns, 0.f);
        const auto fineRow = [&](int row) {
            return fine.data() + std::size_t(row + 1) * fineColumns;
        };
        const auto restricted = [&] {
            Row all;
            for (int row = 0; row < coarseRows; ++row) {
                Row sum(fineColumns + 3), out(coarseColumns);
                restrictRow(fineColumns, coarseColumns, fineColumns, fineRow(2 * row), sum.data(),
                            out.data());
                all.insert(all.end(), out.begin(), out.end());
            }
            return all;
        };
        const auto interpolated = [&] {
            Row all;
            for (int row = 0; row < rows; ++row) {
                Row out(fineColumns);
                interpolateRow(fineColumns, coarse.data() + std::size_t(row / 2) * coarseColumns,
                               coarse.data() + std::size_t((row + 1) / 2) * coarseColumns, nullptr,
                               out.data());
                all.insert(all.end(), out.begin(), out.end());
            }
            return all;
        };
        const auto dot = [](const float* a, const Row& b) {
            double sum = 0;
            for (std::size_t i = 0; i < b.size(); ++i) {
                sum += double(a[i]) * double(b[i]);
            }
            return sum;
        };
        QVERIFY(std::abs(dot(fineRow(0), interpolated()) - dot(coarse.data(), restricted())) <
                1e-5);
        QVERIFY(isSameOnAll(restricted));
        QVERIFY(isSameOnAll(interpolated));
    }
}

// interpolateRow() interpolates along a row and between two rows. It multiplies the result by
// `factor` and adds it to the fine row.
void StencilKernelsTest::interpolateRow_linearValues_isExact() {
    const std::size_t columns = 21;
    Row lower, upper, factor(columns, 1.f), fine(columns, 10.f);
    for (std::size_t c = 0; c <= columns / 2; ++c) {
        lower.push_back(float(2 * c));
        upper.push_back(float(2 * c) + 4);
    }
    factor[3] = 0;
    interpolateRow(columns, lower.data(), upper.data(), factor.data(), fine.data());
    for (std::size_t i = 0; i < columns; ++i) {
        QCOMPARE(fine[i], i == 3 ? 10.f : float(i) + 12);
    }
}

QTEST_GUILESS_MAIN(StencilKernelsTest)
#include "StencilKernelsTest.moc"
