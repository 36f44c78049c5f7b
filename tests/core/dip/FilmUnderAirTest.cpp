// Tests trapped air: the field that solvers get, and what film paints on hollow bodies.
#include "HollowBodies.h"
#include "dip/Coverage.h"
#include "dip/Dip.h"
#include "geometry/Shapes.h"
#include "paper/cpu/PaperFilm.h"
#include "production/cpu/ProductionFilm.h"

#include <QtTest>

#include <cmath>

using namespace dipwright;
using namespace dipwright::test;

namespace {

constexpr double innerRadius = bowlRadius - bowlWall;
constexpr double filmCell = 2.5; // mm

std::shared_ptr<const LaidFilm> dipped(const TriangleMesh& mesh, double turn, bool isPaper) {
    Immersion immersion;
    immersion.rotation[0] = Degrees(turn);
    FilmSettings film;
    film.width = film.height = Millimetres(120);
    film.columns = film.rows = int(120 / filmCell) + 1;
    film.resolution = FilmResolution::Points;
    if (isPaper) {
        film.lattice = solver::Lattice::Structural;
        film.support = solver::Support::None;
    }
    const auto body = std::make_shared<const PosedBody>(posedBody(mesh, immersion));
    const DistanceField own = buildDistanceField(mesh, 96, {});
    const FilledField field(*body, own);
    solver::BatchItem item;
    item.setup = dipSetup(*body, field, immersion, film, {});
    const std::unique_ptr<solver::FilmSolver> solver =
        isPaper ? cpu::makePaperFilm() : cpu::makeProductionFilm();
    solver->begin(item.setup);
    solver::DipState state;
    while (!state.finished) {
        state = solver->advance(64);
    }
    item.finish(state, [&](auto positions, auto states, auto marks) {
        solver->read(positions, states);
        solver->readMarks(marks);
    });
    return layFilm(body, dippedFilm(item, immersion), {});
}

// Area (mm²) of the body's triangles whose middle fulfils `holds`, and the painted part of it.
struct Painted {
    double whole = 0, painted = 0;
};
template <typename Holds>
Painted paintedWhere(const LaidFilm& laid, const Holds& holds) {
    const TriangleMesh& mesh = laid.body().mesh;
    Painted area;
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        if (holds(position(mesh, middleOf(triangle)))) {
            area.whole += triangleArea(mesh, triangle);
            area.painted += laid.place(middleOf(triangle)) ? triangleArea(mesh, triangle) : 0;
        }
    }
    return area;
}

} // namespace

class FilmUnderAirTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void filledField_withoutAir_isTheBodysField();
    void filledField_bowlRimDown_equalsTheFieldOfHalfABall();
    void dip_bowlRimDown_insideStaysUnpainted_data();
    void dip_bowlRimDown_insideStaysUnpainted();
    void dip_bowlWithHole_insideIsPainted();
    void dip_tippedCup_isUnpaintedAboveTheAirsLevel();
};

void FilmUnderAirTest::filledField_withoutAir_isTheBodysField() {
    for (const TriangleMesh& mesh : {sphereMesh(20, 40, 80), torusMesh(24, 7, 40, 24)}) {
        const PosedBody body = posedBody(mesh, {});
        const DistanceField own = buildDistanceField(mesh, 64, {});
        QCOMPARE(&FilledField(body, own).field(), &own);
    }
}

// With its hollow filled, a bowl is half a ball with its flat face down.
void FilmUnderAirTest::filledField_bowlRimDown_equalsTheFieldOfHalfABall() {
    const TriangleMesh mesh = bowl();
    for (const double turn : {0.0, 31.0}) { // degrees, rotation of the model against its field
        const Eigen::Isometry3d askew(Eigen::AngleAxisd(turn * pi / 180, Eigen::Vector3d::UnitX()));
        Immersion immersion;
        immersion.rotation[0] = Degrees(-turn);
        const TriangleMesh model = transformed(mesh, askew);
        const PosedBody body = posedBody(model, immersion);
        const DistanceField own = buildDistanceField(model, 96, {});
        const FilledField filled(body, own);
        // Largest error of the filled body's surface, on its face and round its dome, mm.
        double worst = 0;
        for (double radius = 0; radius < bowlRadius - 0.5; radius += 0.37) {
            for (const double height : {0.6, 0.2, -0.2, -0.6}) {
                for (const double angle : {0.3, 1.9, 4.4}) {
                    const Eigen::Vector3d place(radius * std::cos(angle), height,
                                                radius * std::sin(angle));
                    const double outside = std::hypot(radius, height) - bowlRadius;
                    const double wanted = std::max(-height, outside);
                    const double found = filled.field().sample(askew * place);
                    worst = std::max(worst, std::abs(found - wanted));
                }
            }
        }
        QVERIFY2(worst < 0.25 * own.spacing + 0.05,
                 qPrintable(QStringLiteral("largest error %1 mm, expected < %2 mm")
                                .arg(worst)
                                .arg(0.25 * own.spacing + 0.05)));
        // Deep in the hollow the field is negative; above the dome it has not changed.
        QVERIFY(filled.field().sample(askew * Eigen::Vector3d(4, 15, 3)) < -own.spacing);
        const Eigen::Vector3d over = askew * Eigen::Vector3d(3, bowlRadius + 0.8, -2);
        QCOMPARE(filled.field().sample(over), own.sample(over));
    }
}

void FilmUnderAirTest::dip_bowlRimDown_insideStaysUnpainted_data() {
    QTest::addColumn<bool>("isPaper");
    QTest::newRow("production") << false;
    QTest::newRow("paper") << true;
}

void FilmUnderAirTest::dip_bowlRimDown_insideStaysUnpainted() {
    QFETCH(bool, isPaper);
    const auto laid = dipped(bowl(), 0, isPaper);
    const Painted inside = paintedWhere(
        *laid, [](const Eigen::Vector3f& place) { return place.norm() < 30.5f && place.y() > 1; });
    QVERIFY(inside.whole > 5000);
    QCOMPARE(inside.painted, 0.0);
    for (std::size_t point = 0; point < laid->film().positions.size(); ++point) {
        // Film under the air touches nothing and stays at the height of the rim.
        const Eigen::Vector2f rest = restPosition(laid->film().grid, point);
        if (rest.norm() < innerRadius - 2 * filmCell) {
            QVERIFY(!laid->contact().surface[point].isValid());
            QVERIFY(std::abs(laid->film().positions[point].y()) < 0.1f);
        }
    }
    // The rim, and the outer wall up to the overhang, are painted to within a cell.
    const Coverage cover = coverage(*laid);
    const double band =
        2 * pi * bowlRadius * bowlRadius * std::sin(radians(ProcessSettings().overhang));
    QVERIFY2(
        cover.paintedArea > (isPaper ? 0.5 : 0.75) * band &&
            cover.paintedArea <
                1.1 * band + pi * (bowlRadius * bowlRadius - innerRadius * innerRadius),
        qPrintable(QStringLiteral("painted %1 mm² of %2 mm²").arg(cover.paintedArea).arg(band)));
    const double dry = 2 * pi * innerRadius * innerRadius;
    QVERIFY(std::abs(cover.trappedAir.area - dry) < 0.01 * dry);
}

void FilmUnderAirTest::dip_bowlWithHole_insideIsPainted() {
    const auto laid = dipped(bowl(4), 0, false);
    const Painted inside = paintedWhere(
        *laid, [](const Eigen::Vector3f& place) { return place.norm() < 30.5f && place.y() > 1; });
    QVERIFY2(inside.painted > 0.8 * inside.whole,
             qPrintable(QStringLiteral("%1 of %2 mm² inside are painted, expected 80 %")
                            .arg(inside.painted)
                            .arg(inside.whole)));
}

void FilmUnderAirTest::dip_tippedCup_isUnpaintedAboveTheAirsLevel() {
    const auto laid = dipped(cup(), 150, false);
    const std::optional<double> cutOff = trappedAir(laid->body()).travelled;
    QVERIFY(cutOff);
    const double level = *cutOff - startHeight;
    const Eigen::Isometry3d toModel = laid->body().modelToPose.inverse();
    const auto isInside = [&](const Eigen::Vector3f& place) {
        const Eigen::Vector3d own = toModel * place.cast<double>();
        return std::hypot(own.x(), own.z()) < 28 && own.y() > 1.5 && own.y() < 39.9;
    };
    const Painted dry = paintedWhere(*laid, [&](const Eigen::Vector3f& place) {
        return isInside(place) && double(place.y()) > level + 0.5;
    });
    QVERIFY(dry.whole > 1000);
    QCOMPARE(dry.painted, 0.0);
}

QTEST_APPLESS_MAIN(FilmUnderAirTest)
#include "FilmUnderAirTest.moc"
