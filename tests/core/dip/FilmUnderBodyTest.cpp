// Tests how fine the film's cells are for a body and its pose.
#include "dip/FilmUnderBody.h"
#include "film/FilmGrid.h"

#include "DippedByHand.h"
#include "base/Error.h"
#include "dip/FilmFit.h"
#include "film/FilmLines.h"
#include "geometry/Shapes.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace dipwright;

namespace {

FilmSettings filmOf(FilmResolution resolution) {
    FilmSettings film;
    film.resolution = resolution;
    return film;
}

Underside undersideOf(const TriangleMesh& mesh, const Immersion& immersion = {}) {
    return undersideOf(posedBody(mesh, immersion), {});
}

Underside ball() {
    return undersideOf(sphereMesh(35, 60, 120));
}

double cellFor(const Underside& underside) {
    return automaticCell(underside, filmOf(FilmResolution::Automatic)).value();
}

// Returns the film's largest cell between two places along X, mm.
double coarsest(const solver::FilmGrid& grid, double from, double to) {
    double largest = 0;
    for (int column = 0; column + 1 < grid.columns; ++column) {
        if (grid.restX(column + 1) > from && grid.restX(column) < to) {
            largest = std::max(largest, grid.spacingX(column));
        }
    }
    return largest;
}

} // namespace

class FilmUnderBodyTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void automaticCell_thinBody_isFiner();
    void automaticCell_uprightPlate_ignoresItsSides();
    void filmUnderBody_ball_isFineWhereFilmIsDrawnIn();
    void filmUnderBody_offset_movesTheFineCells();
    void filmUnderBody_givenCell_isKept();
    void filmUnderBody_tooSmallCell_isRefused();
    void filmUnderBody_givenPoints_areKept();
    void filmUnderBody_papersFilm_staysEven();
    void adviceOnFilm_partLargerThanAnyFilm_isAnAdvice();
    void adviceOnFilm_filmFitsTurned_isToTurnIt();
};

// The advice ends sentences such as "move or turn the part, or …".
void FilmUnderBodyTest::adviceOnFilm_partLargerThanAnyFilm_isAnAdvice() {
    const Eigen::AlignedBox2d vast(Eigen::Vector2d(-4000, -10), Eigen::Vector2d(4000, 10));
    QCOMPARE(
        adviceOnFilm(vast, {}),
        QStringLiteral("check the model's size and unit, because no film is larger than 3000 mm"));
}

void FilmUnderBodyTest::adviceOnFilm_filmFitsTurned_isToTurnIt() {
    FilmSettings film;
    film.width = Millimetres(210);
    film.height = Millimetres(297);
    const auto adviceOn = [&](double width, double depth) {
        const Eigen::Vector2d half(width / 2, depth / 2);
        return adviceOnFilm({-half, half}, film);
    };
    QCOMPARE(adviceOn(250, 100), QStringLiteral("turn the film by 90° (297 × 210 mm)"));
    QVERIFY(adviceOn(250, 220).startsWith(
        QStringLiteral("choose a film that is clearly larger than ")));
}

void FilmUnderBodyTest::automaticCell_thinBody_isFiner() {
    const double thick = cellFor(undersideOf(boxMesh({60, 40, 60})));
    const double thin = cellFor(undersideOf(boxMesh({60, 4, 60})));
    QVERIFY(thick <=
            1.0 + 1e-9); // limited by the number of cells along the body, whatever its thickness
    QVERIFY(thin < 0.6 * thick);
    QVERIFY(thin > 0.2);
}

void FilmUnderBodyTest::automaticCell_uprightPlate_ignoresItsSides() {
    // A plate that lies flat needs cells fine enough for its thickness. If it stands on its edge,
    // its sides do not come down on the film.
    Immersion upright;
    upright.rotation[0] = Degrees(90);
    const TriangleMesh plate = boxMesh({60, 4, 60});
    QVERIFY(cellFor(undersideOf(plate)) < 0.6 * cellFor(undersideOf(plate, upright)));
    // The model's own frame gives the same result.
    const Underside asked = undersideOf(plate, SurfaceQuery(plate), upright, {});
    QVERIFY(std::abs(cellFor(asked) / cellFor(undersideOf(plate, upright)) - 1) < 1e-4);
}

void FilmUnderBodyTest::filmUnderBody_ball_isFineWhereFilmIsDrawnIn() {
    const Underside under = ball();
    const FilmSettings film = filmOf(FilmResolution::Automatic);
    const double cell = automaticCell(under, film).value();
    const solver::FilmGrid grid = filmUnderBody(film, under, {});
    QVERIFY(!grid.isEven());
    QCOMPARE(grid.width, 210.0);
    // Viscous film that lies on the equator after the dip was up to 35·√2 mm from the film's middle
    // before it.
    QVERIFY(coarsest(grid, -49.5, 49.5) <= cell * (1 + 1e-9));
    QVERIFY(coarsest(grid, -105, 105) > 1.5 * cell);
    QVERIFY(double(grid.pointCount()) < 0.6 * (210 / cell) * (297 / cell));
}

void FilmUnderBodyTest::filmUnderBody_offset_movesTheFineCells() {
    const Underside under = undersideOf(sphereMesh(20, 60, 120));
    const FilmSettings film = filmOf(FilmResolution::Automatic);
    const double cell = automaticCell(under, film).value();
    const solver::FilmGrid grid = filmUnderBody(film, under, {Millimetres(50), Millimetres(0)});
    QVERIFY(coarsest(grid, 30, 70) <= cell * (1 + 1e-9));
    QVERIFY(coarsest(grid, -60, -30) > 2 * cell);
}

void FilmUnderBodyTest::filmUnderBody_givenCell_isKept() {
    FilmSettings film = filmOf(FilmResolution::Cell);
    film.cell = Millimetres(1.3);
    const solver::FilmGrid grid = filmUnderBody(film, ball(), {});
    QVERIFY(grid.leastSpacing() <= 1.3 && grid.leastSpacing() > 1.2);
    film.refinement = 0.5;
    const solver::FilmGrid half = filmUnderBody(film, ball(), {});
    QCOMPARE(half.columns, grid.columns / 2 + 1);
    QCOMPARE(half.rows, grid.rows / 2 + 1);
}

void FilmUnderBodyTest::filmUnderBody_tooSmallCell_isRefused() {
    FilmSettings film = filmOf(FilmResolution::Cell);
    film.cell = Millimetres(0.05);
    QVERIFY_EXCEPTION_THROWN(filmUnderBody(film, ball(), {}), Error);
}

void FilmUnderBodyTest::filmUnderBody_givenPoints_areKept() {
    const FilmSettings film = filmOf(FilmResolution::Points);
    QCOMPARE(filmUnderBody(film, ball(), {}), filmGrid(film));
}

void FilmUnderBodyTest::filmUnderBody_papersFilm_staysEven() {
    FilmSettings film = filmOf(FilmResolution::Automatic);
    film.lattice = solver::Lattice::Structural;
    film.support = solver::Support::None;
    QVERIFY(filmUnderBody(film, ball(), {}).isEven());
}

QTEST_APPLESS_MAIN(FilmUnderBodyTest)
#include "FilmUnderBodyTest.moc"
