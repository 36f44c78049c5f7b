// A film without a dip: its grid, its constraints and its stretch.
#include "film/DippedFilm.h"
#include "film/FilmGrid.h"
#include "settings/FilmSettings.h"

#include <Eigen/Geometry>
#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace dipwright;

namespace {

const solver::FilmGrid smallGrid{7, 5, 60, 40};

// A film with cells 5 to 20 mm wide and 8 or 12 mm long.
solver::FilmGrid gradedGrid() {
    return {7, 5, 60, 40, {-30, -25, -20, -10, 0, 10, 30}, {-20, -8, 0, 12, 20}};
}

// Returns the flat film after a linear map of its plane into space.
DippedFilm mapped(const solver::FilmGrid& grid, const Eigen::Matrix<float, 3, 2>& map) {
    DippedFilm film;
    film.grid = grid;
    for (std::size_t point = 0; point < grid.pointCount(); ++point) {
        film.positions.emplace_back(map * restPosition(grid, point));
    }
    film.states.assign(grid.pointCount(), solver::PointState::Free);
    return film;
}

bool isNear(double value, double expected, double tolerance = 1e-5) {
    return std::abs(value - expected) <= tolerance;
}

} // namespace

class FilmTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void filmGrid_swell_enlargesTheFilm();
    void pinnedPoints_noPinnedEdge_isEmpty();
    void pinnedPoints_pinnedEdges_markTheirPoints();
    void restPosition_evenFilm_isCentred();
    void restPosition_gradedFilm_isOnItsLines();
    void stretches_gradedFilm_equalTheEvenOnes();
    void filmTriangles_coverTheFilmFacingUp();
    void filmTriangles_diagonalsAlternate();
    void constraintCount_matchesThePapersTable_data();
    void constraintCount_matchesThePapersTable();
    void principalAndPointStretches_flatFilm_are1();
    void principalStretches_stretchedAndTurnedFilm_matchTheMap();
    void principalStretches_shear_keepsTheArea();
    void constraintStretches_horizontalComeFirst();
    void pointStretches_areTheMeanOfTheirConstraints();
    void distribution_values_givesMinimumMeanPercentileMaximum();
};

void FilmTest::filmGrid_swell_enlargesTheFilm() {
    FilmSettings settings;
    settings.swellX = 1.1;
    settings.swellY = 1.2;
    const solver::FilmGrid grid = filmGrid(settings);
    QCOMPARE(grid.columns, 120);
    QCOMPARE(grid.rows, 170);
    QCOMPARE(grid.width, 210 * 1.1);
    QCOMPARE(grid.depth, 297 * 1.2);
}

void FilmTest::pinnedPoints_noPinnedEdge_isEmpty() {
    QVERIFY(pinnedPoints({}, filmGrid({})).empty());
}

void FilmTest::pinnedPoints_pinnedEdges_markTheirPoints() {
    FilmSettings settings;
    settings.columns = 4;
    settings.rows = 3;
    settings.edges.leftPinned = true;
    settings.edges.bottomPinned = true;
    const std::vector<std::uint8_t> expected = {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
    QVERIFY(pinnedPoints(settings.edges, filmGrid(settings)) == expected);
    settings.edges = {false, true, true, false};
    const std::vector<std::uint8_t> others = {1, 1, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    QVERIFY(pinnedPoints(settings.edges, filmGrid(settings)) == others);
}

void FilmTest::restPosition_evenFilm_isCentred() {
    QCOMPARE(restPosition(smallGrid, 0), Eigen::Vector2f(-30, -20));
    QCOMPARE(restPosition(smallGrid, 6), Eigen::Vector2f(30, -20));
    QCOMPARE(restPosition(smallGrid, 7), Eigen::Vector2f(-30, -10));
    QCOMPARE(restPosition(smallGrid, 17), Eigen::Vector2f(0, 0));
    QCOMPARE(restPosition(smallGrid, 34), Eigen::Vector2f(30, 20));
}

void FilmTest::restPosition_gradedFilm_isOnItsLines() {
    const solver::FilmGrid grid = gradedGrid();
    QVERIFY(!grid.isEven() && smallGrid.isEven());
    QCOMPARE(grid.restX(1), -25.0);
    QCOMPARE(grid.restZ(3), 12.0);
    QCOMPARE(grid.spacingX(0), 5.0);
    QCOMPARE(grid.spacingX(5), 20.0);
    QCOMPARE(grid.spacingZ(3), 8.0);
    QCOMPARE(grid.leastSpacingX(), 5.0);
    QCOMPARE(grid.leastSpacingZ(), 8.0);
    QCOMPARE(grid.leastSpacing(), 5.0);
    QCOMPARE(smallGrid.leastSpacing(), 10.0);
    QCOMPARE(restPosition(grid, 7 * 3 + 1), Eigen::Vector2f(-25, 12));
    for (int column = 0; column < grid.columns; ++column) {
        QVERIFY(isNear(columnAt(grid, grid.restX(column) / 60 + 0.5), column, 1e-12));
    }
    for (int row = 0; row < grid.rows; ++row) {
        QVERIFY(isNear(rowAt(grid, grid.restZ(row) / 40 + 0.5), row, 1e-12));
    }
    QCOMPARE(columnAt(grid, 50.0 / 60), 5.5); // in the middle of the last, wide cell
    QCOMPARE(columnAt(grid, -5.0 / 60), -1.0);
    QCOMPARE(columnAt(smallGrid, 50.0 / 60), 5.0);
    QCOMPARE(cellOfTriangle(grid, 2 * (6 + 5)), 20.f);
    QCOMPARE(cellOfTriangle(grid, 2 * (6 + 1)), 8.f);
    QCOMPARE(cellOfPoint(grid, 7 + 5), 20.f);
    QCOMPARE(cellOfPoint(grid, 7 + 1), 12.f);
}

void FilmTest::stretches_gradedFilm_equalTheEvenOnes() {
    Eigen::Matrix<float, 3, 2> map;
    map << 1.5f, 0, 0, 0, 0, 0.5f;
    const DippedFilm film = mapped(gradedGrid(), map);
    for (const PrincipalStretch& stretch : principalStretches(film)) {
        QVERIFY(isNear(stretch.larger, 1.5) && isNear(stretch.smaller, 0.5));
    }
    const std::vector<float> stretches = constraintStretches(film);
    for (std::size_t constraint = 0; constraint < stretches.size(); ++constraint) {
        QVERIFY(isNear(stretches[constraint], constraint < 5 * 6 ? 1.5 : 0.5));
    }
    double area = 0;
    for (std::size_t triangle = 0; triangle < filmTriangles(film.grid).size(); ++triangle) {
        area += restArea(film.grid, triangle);
    }
    QCOMPARE(area, 60.0 * 40);
}

void FilmTest::filmTriangles_coverTheFilmFacingUp() {
    double area = 0;
    for (const FilmTriangle& triangle : filmTriangles(smallGrid)) {
        const auto place = [&](std::size_t corner) {
            const Eigen::Vector2f rest = restPosition(smallGrid, triangle[corner]);
            return Eigen::Vector3d(rest.x(), 0, rest.y());
        };
        const Eigen::Vector3d normal = (place(1) - place(0)).cross(place(2) - place(0));
        QVERIFY(normal.y() > 0);
        area += normal.norm() / 2;
    }
    QVERIFY(isNear(area, 60 * 40, 1e-6));
}

void FilmTest::filmTriangles_diagonalsAlternate() {
    const std::vector<FilmTriangle> triangles = filmTriangles(smallGrid);
    QCOMPARE(triangles.size(), std::size_t(2 * 6 * 4));
    const auto has = [&](std::size_t triangle, std::uint32_t point) {
        const FilmTriangle& corners = triangles[triangle];
        return std::find(corners.begin(), corners.end(), point) != corners.end();
    };
    // Cell (0, 0) is cut along its falling diagonal, from point 0 to point 8; cell (1, 0) from
    // point 2 to point 8.
    for (const std::size_t triangle : {0, 1}) {
        QVERIFY(has(triangle, 0) && has(triangle, 8));
    }
    for (const std::size_t triangle : {2, 3}) {
        QVERIFY(has(triangle, 2) && has(triangle, 8));
    }
}

void FilmTest::constraintCount_matchesThePapersTable_data() {
    QTest::addColumn<int>("columns");
    QTest::addColumn<int>("rows");
    QTest::addColumn<int>("constraints");
    QTest::newRow("8x12") << 8 << 12 << 172;
    QTest::newRow("40x60") << 40 << 60 << 4700;
    QTest::newRow("80x120") << 80 << 120 << 19000;
    QTest::newRow("120x180") << 120 << 180 << 42900;
    QTest::newRow("160x240") << 160 << 240 << 76400;
    QTest::newRow("200x300") << 200 << 300 << 119500;
    QTest::newRow("240x360") << 240 << 360 << 172200;
    QTest::newRow("280x420") << 280 << 420 << 234500;
}

void FilmTest::constraintCount_matchesThePapersTable() {
    QFETCH(int, columns);
    QFETCH(int, rows);
    QFETCH(int, constraints);
    const solver::FilmGrid grid{columns, rows, 210, 297};
    QCOMPARE(constraintCount(grid, false), std::size_t(constraints));
    QCOMPARE(constraintCount(grid, true),
             std::size_t(constraints + 2 * (columns - 1) * (rows - 1)));
}

void FilmTest::principalAndPointStretches_flatFilm_are1() {
    Eigen::Matrix<float, 3, 2> flat;
    flat << 1, 0, 0, 0, 0, 1;
    const DippedFilm film = mapped(smallGrid, flat);
    for (const PrincipalStretch& stretch : principalStretches(film)) {
        QVERIFY(isNear(stretch.larger, 1) && isNear(stretch.smaller, 1));
    }
    for (const float stretch : pointStretches(film)) {
        QVERIFY(isNear(stretch, 1));
    }
}

void FilmTest::principalStretches_stretchedAndTurnedFilm_matchTheMap() {
    // The film is twice as long along one diagonal, half as long across it, and then turned
    // upright.
    const float turn = std::sqrt(0.5f);
    Eigen::Matrix2f axes;
    axes << turn, -turn, turn, turn;
    Eigen::Matrix<float, 3, 2> upright;
    upright << 0, 1, 0.6f, 0, 0.8f, 0;
    const Eigen::Matrix2f stretched =
        axes * Eigen::Vector2f(2, 0.5f).asDiagonal() * axes.transpose();
    for (const PrincipalStretch& stretch :
         principalStretches(mapped(smallGrid, upright * stretched))) {
        QVERIFY(isNear(stretch.larger, 2, 1e-4));
        QVERIFY(isNear(stretch.smaller, 0.5, 1e-4));
        QVERIFY(isNear(stretch.area(), 1, 1e-4));
    }
}

void FilmTest::principalStretches_shear_keepsTheArea() {
    Eigen::Matrix<float, 3, 2> shear;
    shear << 1, 0.75f, 0, 0, 0, 1;
    for (const PrincipalStretch& stretch : principalStretches(mapped(smallGrid, shear))) {
        QVERIFY(isNear(stretch.area(), 1));
        QVERIFY(stretch.larger > 1.4f && stretch.smaller < 0.72f);
    }
}

void FilmTest::constraintStretches_horizontalComeFirst() {
    Eigen::Matrix<float, 3, 2> map;
    map << 1.5f, 0, 0, 0, 0, 0.5f;
    const std::vector<float> stretches = constraintStretches(mapped(smallGrid, map));
    QCOMPARE(stretches.size(), constraintCount(smallGrid, false));
    for (std::size_t constraint = 0; constraint < stretches.size(); ++constraint) {
        QVERIFY(isNear(stretches[constraint], constraint < 5 * 6 ? 1.5 : 0.5));
    }
}

void FilmTest::pointStretches_areTheMeanOfTheirConstraints() {
    Eigen::Matrix<float, 3, 2> map;
    map << 1, 0, 0, 0, 0, 1;
    DippedFilm film = mapped(smallGrid, map);
    film.positions[0].x() -= 10; // its horizontal constraint is twice as long, the vertical √2
    const std::vector<float> means = pointStretches(film);
    QVERIFY(isNear(means[0], (2 + std::sqrt(2)) / 2));
    QVERIFY(isNear(means[1], (2.0 + 1 + 1) / 3));
    QVERIFY(isNear(means[7], (std::sqrt(2) + 1 + 1) / 3));
    QVERIFY(isNear(means[8], 1));
}

void FilmTest::distribution_values_givesMinimumMeanPercentileMaximum() {
    std::vector<float> values;
    for (int value = 100; value >= 1; --value) {
        values.push_back(float(value));
    }
    const Distribution spread = distribution(values);
    QCOMPARE(spread.minimum, 1.0);
    QCOMPARE(spread.mean, 50.5);
    QCOMPARE(spread.percentile95, 95.0);
    QCOMPARE(spread.maximum, 100.0);
    QCOMPARE(distribution({}).maximum, 0.0);
    QCOMPARE(distribution({3}).percentile95, 3.0);
}

QTEST_APPLESS_MAIN(FilmTest)
#include "FilmTest.moc"
