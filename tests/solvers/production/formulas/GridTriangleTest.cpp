// Tests the film's triangles in its grid: their corners, edges, forces and areas.

#include "production/formulas/GridTriangle.h"

#include "production/formulas/FilmModel.h"

#include <QTest>
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

using namespace dipwright;
using namespace dipwright::numerics;

namespace {

const double resistance = gatheredResistance(0.8); // resistance of gathered film

constexpr int columns = 5, rows = 4;
constexpr double spacingX = 2, spacingZ = 3;

double x(std::uint32_t point) {
    return spacingX * double(point % columns);
}
double z(std::uint32_t point) {
    return spacingZ * double(point / columns);
}

EdgePair<double> edgesOf(const TriangleCorners& triangle, const std::vector<double>& dx,
                         const std::vector<double>& dz) {
    const std::uint32_t left = triangle.points[0], right = triangle.points[1];
    const std::uint32_t third = triangle.points[2];
    const std::uint32_t shared = triangle.points[triangle.shared()];
    const std::uint32_t lower = triangle.thirdAbove ? shared : third;
    const std::uint32_t upper = triangle.thirdAbove ? third : shared;
    return {x(right) + dx[right] - x(left) - dx[left], z(right) + dz[right] - z(left) - dz[left],
            x(upper) + dx[upper] - x(lower) - dx[lower],
            z(upper) + dz[upper] - z(lower) - dz[lower]};
}

// Returns the energy W of PlaneStress.h for film in tension.
double energyOf(const EdgePair<double>& edges, const Matrix2<double>& inverseShape) {
    const Matrix2<double> F = gradientOf(edges, inverseShape);
    const double s = std::hypot(F.a + F.d, F.c - F.b);
    return ((F.a - F.d) * (F.a - F.d) + (F.b + F.c) * (F.b + F.c)) / 2 + (s - 2) * (s - 2);
}

} // namespace

class GridTriangleTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void triangleCorners_twoTriangles_makeACell();
    void triangleCorners_neighbours_shareWholeEdges();
    void triangleCorners_haveAHorizontalAndAVerticalEdge();
    void gradientOf_undeformedFilm_isTheIdentity();
    void edgeForces_areTheEnergysGradient();
    void planePosition_evenFilm_isOnTheGrid();
    void filmModel_gradedFilm_hasItsLinesAndAreas();
};

void GridTriangleTest::triangleCorners_twoTriangles_makeACell() {
    for (int row = 0; row + 1 < rows; ++row) {
        for (int column = 0; column + 1 < columns; ++column) {
            const auto first = triangleCorners(columns, column, row, false);
            const auto second = triangleCorners(columns, column, row, true);
            const std::size_t number = 2 * std::size_t(row * (columns - 1) + column);
            QVERIFY(std::ranges::equal(triangleCorners(columns, number).points, first.points));
            QVERIFY(std::ranges::equal(triangleCorners(columns, number + 1).points, second.points));
            std::set<std::uint32_t> corners(first.points, first.points + 3);
            corners.insert(second.points, second.points + 3);
            const auto lower = std::uint32_t(row * columns + column);
            QVERIFY(corners == (std::set<std::uint32_t>{lower, lower + 1, lower + columns,
                                                        lower + columns + 1}));
        }
    }
}

// Each inner edge belongs to two triangles, each edge on the border to one. So triangles do not
// overlap, and the diagonals of neighbouring cells meet at the same points.
void GridTriangleTest::triangleCorners_neighbours_shareWholeEdges() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (std::size_t number = 0; number < 2 * (columns - 1) * (rows - 1); ++number) {
        const auto triangle = triangleCorners(columns, number);
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = triangle.points[k], b = triangle.points[(k + 1) % 3];
            ++uses[std::minmax(a, b)];
        }
    }
    int border = 0;
    for (const auto& [edge, count] : uses) {
        const auto [a, b] = edge;
        const bool isAlongX = b - a == 1, isAlongZ = b - a == columns;
        const bool isOnBorder = (isAlongX && (a / columns == 0 || a / columns == rows - 1)) ||
                                (isAlongZ && (a % columns == 0 || a % columns == columns - 1));
        QCOMPARE(count, isOnBorder ? 1 : 2);
        border += isOnBorder;
    }
    QCOMPARE(border, 2 * (columns - 1) + 2 * (rows - 1));
}

void GridTriangleTest::triangleCorners_haveAHorizontalAndAVerticalEdge() {
    for (std::size_t number = 0; number < 2 * (columns - 1) * (rows - 1); ++number) {
        const auto triangle = triangleCorners(columns, number);
        const std::uint32_t left = triangle.points[0], right = triangle.points[1];
        const std::uint32_t third = triangle.points[2];
        QCOMPARE(right, left + 1);
        QCOMPARE(z(left), z(right));
        QCOMPARE(x(third), x(triangle.points[triangle.shared()]));
        QCOMPARE(triangle.thirdAbove, z(third) > z(left));
        QCOMPARE(triangle.thirdOnRight, x(third) == x(right));
    }
}

void GridTriangleTest::gradientOf_undeformedFilm_isTheIdentity() {
    const std::vector<double> none(columns * rows);
    for (std::size_t number = 0; number < 2 * (columns - 1) * (rows - 1); ++number) {
        const auto F = gradientOf(edgesOf(triangleCorners(columns, number), none, none),
                                  Matrix2<double>{1 / spacingX, 0, 0, 1 / spacingZ});
        QCOMPARE(F.a, 1.0);
        QCOMPARE(F.b, 0.0);
        QCOMPARE(F.c, 0.0);
        QCOMPARE(F.d, 1.0);
    }
}

void GridTriangleTest::edgeForces_areTheEnergysGradient() {
    const Matrix2<double> inverseShape{0.5, 0.02, -0.03, 0.35};
    const double area = 3, h = 1e-6;
    const EdgePair<double> edges{2.4, 0.2, -0.1, 3.3};
    StressState<double> state;
    const EdgePair<double> force =
        edgeForces(stress(gradientOf(edges, inverseShape), resistance, state), inverseShape, area);
    const auto slope = [&](double EdgePair<double>::*component) {
        EdgePair<double> ahead = edges, behind = edges;
        ahead.*component += h;
        behind.*component -= h;
        return area * (energyOf(ahead, inverseShape) - energyOf(behind, inverseShape)) / (2 * h);
    };
    QVERIFY(std::abs(force.hx - slope(&EdgePair<double>::hx)) < 1e-7);
    QVERIFY(std::abs(force.hz - slope(&EdgePair<double>::hz)) < 1e-7);
    QVERIFY(std::abs(force.vx - slope(&EdgePair<double>::vx)) < 1e-7);
    QVERIFY(std::abs(force.vz - slope(&EdgePair<double>::vz)) < 1e-7);
}

void GridTriangleTest::planePosition_evenFilm_isOnTheGrid() {
    solver::DipSetup setup;
    setup.film = {columns, rows, 8, 9};
    const auto along = columnsOf<double>(setup.film), down = rowsOf<double>(setup.film);
    const auto model = filmModel<double>(setup, along.lines(), down.lines());
    QCOMPARE(pointCount(model), columns * rows);
    QCOMPARE(triangleCount(model), 2 * (columns - 1) * (rows - 1));
    const auto corner = planePosition(model, columns * rows - 1, Vector2<double>{0.5, -0.25});
    QCOMPARE(corner.x, 4.5);
    QCOMPARE(corner.y, 0.0);
    QCOMPARE(corner.z, 4.25);
    QCOMPARE(planePosition(model, 0, Vector2<double>{}).x, -4.0);
    QCOMPARE(planePosition(model, columns, Vector2<double>{}).z, -1.5);
}

void GridTriangleTest::filmModel_gradedFilm_hasItsLinesAndAreas() {
    solver::DipSetup setup;
    setup.film = {4, 3, 7, 4};
    setup.film.columnPlaces = {-3.5, -1.5, -0.5, 3.5};
    setup.film.rowPlaces = {-2, 1, 2};
    const auto along = columnsOf<double>(setup.film), down = rowsOf<double>(setup.film);
    const auto model = filmModel<double>(setup, along.lines(), down.lines());
    QCOMPARE(model.cell, 1.0);
    QCOMPARE(planePosition(model, 6, Vector2<double>{}).x, -0.5);
    QCOMPARE(planePosition(model, 6, Vector2<double>{}).z, 1.0);
    // The second triangle of the last cell of the first row; the cell is 4 × 3 mm.
    QCOMPARE(triangleSize(model, 5).x, 4.0);
    QCOMPARE(triangleSize(model, 5).area(), 6.0);
    // The area of a point relative to the finest cell's area. At a border of the film, a whole cell
    // counts.
    QCOMPARE(pointArea(model, 6), 2.5 * 2);
    QCOMPARE(pointArea(model, 0), 2.0 * 3);
    double area = 0;
    for (int triangle = 0; triangle < triangleCount(model); ++triangle) {
        area += triangleSize(model, triangle).area();
    }
    QCOMPARE(area, 28.0);
}

QTEST_GUILESS_MAIN(GridTriangleTest)
#include "GridTriangleTest.moc"
