// Tests when and where film adheres, how it lies then, and where the body releases it.

#include "production/formulas/Adhesion.h"

#include "solvers/TestFilm.h"

#include <QTest>
#include <cmath>

using namespace dipwright;
using namespace dipwright::numerics;

namespace {

using Place = Vector3<double>;
constexpr double radius = 30;

struct Dipped {
    test::SampledBody sampled = test::sphere(radius, 129);
    ContactBody<double> body;

    // The body's lowest point starts `gap` mm above the water.
    explicit Dipped(double gap, double contactDistance = 0) {
        solver::DipSetup setup;
        setup.field = sampled.view;
        setup.motion.start = {0, radius + gap, 0};
        setup.settings.contactDistance = contactDistance;
        body = contactBody<double>(setup);
    }
};

} // namespace

class AdhesionTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void attachment_touchedPoint_adheresAtTheMomentOfContact();
    void attachment_movingPoint_adheresWhereItTouches();
    void attachment_pastOverhang_staysFreeOrIsTrapped();
    void grip_fadesTowardsTheOverhang();
    void slide_firmlyHeldFilm_doesNotSlip();
    void slide_looseFilm_staysInItsPlace();
    void releaseTriangle_isCutAtTheContactLine();
};

// The point is under the sphere, 12 mm from its axis. There the sphere is h mm higher than at its
// lowest point. The point touches when the body has descended by the gap and h, and adheres there.
void AdhesionTest::attachment_touchedPoint_adheresAtTheMomentOfContact() {
    const double h = radius - std::sqrt(radius * radius - 144);
    for (const double start : {0.1, 0.4, 0.9}) { // mm from the start of a step of 1 mm
        const Dipped dip(5);
        const auto met = attachment(dip.body, 5 + h - start, 1.0, Place{12, 0, 0}, Place{});
        QVERIFY(met.state == solver::PointState::Adhered);
        QVERIFY(length(met.place - Place{12, h - radius, 0}) < 0.01);
    }
    const Dipped far(5, 0.3); // with a contact distance
    const auto met = attachment(far.body, 4.5, 1.0, Place{}, Place{});
    QVERIFY(length(met.place - Place{0, -radius - 0.3, 0}) < 0.01);
}

// The point moves 2 mm towards the axis during the step. The contact line moves towards the point.
void AdhesionTest::attachment_movingPoint_adheresWhereItTouches() {
    const Dipped dip(0);
    const double before = 5, increment = 1;
    const Place start{18.5, 0, 0}, way{-2, 0, 0};
    const auto met = attachment(dip.body, before, increment, start, way);
    double share = 0; // solves x² = R² − (R − descent)²
    for (double step = 0.5; step > 1e-9; step /= 2) {
        const double x = 18.5 - 2 * (share + step), down = before + increment * (share + step);
        share += x * x > radius * radius - (radius - down) * (radius - down) ? step : 0;
    }
    const Place meeting{18.5 - 2 * share, before + increment * share - radius, 0};
    QVERIFY(met.state == solver::PointState::Adhered);
    QVERIFY(length(met.place - meeting) < 0.01);
}

void AdhesionTest::attachment_pastOverhang_staysFreeOrIsTrapped() {
    const Dipped dip(0);
    const double down =
        radius + 20; // mm, past the equator: the contact line has a radius of 22.4 mm and shrinks
    const double edge = std::sqrt(radius * radius - 400);
    // Film that crosses the contact line is free. Film that was inside the body before is trapped.
    QVERIFY(attachment(dip.body, down, 0.1, Place{edge + 0.5, 0, 0}, Place{-1.5, 0, 0}).state ==
            solver::PointState::Free);
    QVERIFY(attachment(dip.body, down, 0.1, Place{edge - 1, 0, 0}, Place{-0.5, 0, 0}).state ==
            solver::PointState::Trapped);
}

void AdhesionTest::grip_fadesTowardsTheOverhang() {
    const Dipped dip(0);
    const ContactBody<double>& body = dip.body;
    QVERIFY(body.firmlyHeld < body.steepestHeld);
    QCOMPARE(detail::grip(body, -1.0), 1.0);
    QCOMPARE(detail::grip(body, body.firmlyHeld), 1.0);
    QCOMPARE(detail::grip(body, body.steepestHeld), 0.0);
    QCOMPARE(detail::grip(body, 1.0), 0.0);
    QVERIFY(std::abs(detail::grip(body, (body.firmlyHeld + body.steepestHeld) / 2) - 0.5) < 1e-12);
    // No film is laid at the overhang. The share g − (1 − g)·u of the unfolded film is laid.
    const double overhang = std::sin(solver::Settings().overhang);
    const double share = detail::grip(body, overhang);
    QVERIFY(std::abs(share - (1 - share) * overhang) < 0.01);
}

namespace {

CrossingCorner<double> heldCorner(double x) {
    return crossingCorner(solver::PointState::Adhered, Place{x, 0, 0}, Place{x, -0.5, 0});
}

} // namespace

void AdhesionTest::slide_firmlyHeldFilm_doesNotSlip() {
    const Dipped dip(0);
    LaidCorners<double> film;
    for (const double x : {9.0, 8.5, 8.0}) {
        detail::slide(dip.body, heldCorner(10), 0, Place{x, 0, 0}, -0.5, true, film);
        QCOMPARE(detail::offset(film, 0).x, x - 10);
    }
}

void AdhesionTest::slide_looseFilm_staysInItsPlace() {
    const Dipped dip(0);
    LaidCorners<double> film;
    detail::slide(dip.body, heldCorner(10), 0, Place{10, 0, 0}, 1.0, true, film);
    const double lay = detail::offset(film, 0).x;
    for (const double x : {9.0, 8.5, 8.0}) {
        detail::slide(dip.body, heldCorner(10), 0, Place{x, 0, 0}, 1.0, true, film);
        QCOMPARE(detail::offset(film, 0).x, lay);
    }
    // But the corner moves with the film if only the film moves and the body does not.
    detail::slide(dip.body, heldCorner(10), 0, Place{7.5, 0, 0}, 1.0, false, film);
    QCOMPARE(detail::offset(film, 0).x, lay - 0.5);
}

// The left corner of the triangle is held, and 0.4 of the triangle floats. Its edge moves to the
// contact line, and its stretch stays the same.
void AdhesionTest::releaseTriangle_isCutAtTheContactLine() {
    const Dipped dip(0);
    const TriangleCorners triangle{
        {0, 1, 2}, true, true}; // the third corner is above the right one
    CrossingCorner<double> corners[3];
    corners[0] = crossingCorner(solver::PointState::Adhered, Place{0, 0, 0}, Place{0, -1, 0});
    corners[1] = crossingCorner(solver::PointState::Free, Place{2, 0, 0}, Place{});
    corners[2] = crossingCorner(solver::PointState::Free, Place{2, 0, 2}, Place{});
    CrossingTriangle<double> crossing;
    crossing.normalX = 1;
    crossing.horizontalShare = crossing.diagonalShare = 0.4;
    LaidCorners<double> film;
    film.isHeld[0] = true;
    film.upwards[0] = dip.body.steepestHeld + 0.1;
    const auto change = releaseTriangle(dip.body, triangle, crossing, corners, film);
    QVERIFY(film.isReleased[0]);
    QVERIFY(std::abs(film.lost - 0.6) < 1e-12);
    const Place cut = Place{0, 0, 0} + detail::offset(film, 0);
    QVERIFY(length(cut - Place{2 * 0.6, 0, 1 * 0.6}) <
            1e-12); // moves towards the middle of the free corners
    const Matrix2<double> rest{0.5, 0, 0, 0.5};
    const auto before = gradientOf(EdgePair<double>{2, 0, 0, 2}, rest);
    const auto after = gradientOf(EdgePair<double>{2 - cut.x, -cut.z, 0, 2}, change * rest);
    QVERIFY(std::abs(after.a - before.a) + std::abs(after.b - before.b) +
                std::abs(after.c - before.c) + std::abs(after.d - before.d) <
            1e-12);
}

QTEST_GUILESS_MAIN(AdhesionTest)
#include "AdhesionTest.moc"
