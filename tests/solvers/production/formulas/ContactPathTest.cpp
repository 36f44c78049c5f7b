// Tests the contact line and the unfolding of the surface about it, on bodies with closed forms.

#include "production/formulas/ContactPath.h"

#include "solvers/TestFilm.h"

#include <QTest>
#include <cmath>

using namespace dipwright;
using namespace dipwright::numerics;

namespace {

using Place = Vector3<double>;
constexpr double radius = 30, cell = 1.5;

// A body whose centre is `height` mm above the water.
struct Placed {
    test::SampledBody body;
    FieldGrid<double> field;
    BodyFrame<double> frame;

    Placed(test::SampledBody sampled, double height)
        : body(std::move(sampled)), field(fieldGrid<double>(body.view)) {
        solver::BodyMotion motion;
        motion.start = {0, height, 0};
        frame = bodyFrame<double>(motion, 0);
    }
    ContactLine<double> lineAt(const Place& adhered, const Place& free,
                               double contactDistance = 0) const {
        return contactLine(field, frame, contactDistance, cell, adhered, free);
    }
};

// Returns a place on the sphere. `angle` is measured from straight down and `around` about the
// vertical axis, both in radians.
Place onSphere(double angle, double around, double height) {
    return {radius * std::sin(angle) * std::cos(around), height - radius * std::cos(angle),
            radius * std::sin(angle) * std::sin(around)};
}

} // namespace

class ContactPathTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void contactLine_sphere_equalsItsWaterline_data();
    void contactLine_sphere_equalsItsWaterline();
    void contactLine_contactDistance_isKept();
    void contactLine_flatFace_isNotFound();
    void unfolded_sphere_distanceIsTheArcLength();
    void unfolded_wall_distanceIsTheHeight();
    void unfolded_cornerBesideTheLine_liesOnItsOwnMeridian();
};

void ContactPathTest::contactLine_sphere_equalsItsWaterline_data() {
    QTest::addColumn<double>("height");
    QTest::newRow("less than half under water") << 22.0;
    QTest::newRow("half") << 0.0;
    QTest::newRow("more than half under water") << -12.0;
}

void ContactPathTest::contactLine_sphere_equalsItsWaterline() {
    QFETCH(double, height);
    const Placed sphere(test::sphere(radius, 129), height);
    const double edge = std::sqrt(radius * radius - height * height);
    for (const double around : {0.0, 0.8, 2.5, -1.2}) {
        const Place outwards{std::cos(around), 0, std::sin(around)};
        const auto line =
            sphere.lineAt(outwards * (edge - 0.7) + Place{0, -1, 0}, outwards * (edge + 0.9));
        QVERIFY(line.found);
        QVERIFY(std::abs(length(line.place) - edge) < 0.01);
        QVERIFY(length(line.outwards - outwards) < 0.01);
        QVERIFY(std::abs(line.steepness - edge / radius) < 0.01);
        QVERIFY(std::abs(line.upwards - -height / radius) < 0.01);
    }
}

void ContactPathTest::contactLine_contactDistance_isKept() {
    const Placed sphere(test::sphere(radius, 129), 20);
    const auto line = sphere.lineAt({22, -1, 0}, {25, 0, 0}, 0.5);
    QVERIFY(line.found);
    QVERIFY(std::abs(line.place.x - std::sqrt(30.5 * 30.5 - 400)) < 0.01);
}

void ContactPathTest::contactLine_flatFace_isNotFound() {
    const Placed box(test::box(20, 10, 20, 65), 10.5); // the lower face is 0.5 mm above the water
    QVERIFY(!box.lineAt({0, 0.5, 0}, {1.5, 0, 0}, 1).found);
}

// Film on an arc of the meridian is unfolded inwards of the line, by the length of the arc.
void ContactPathTest::unfolded_sphere_distanceIsTheArcLength() {
    const double height = 20, lineAngle = std::acos(height / radius);
    const double edge = radius * std::sin(lineAngle);
    const Placed sphere(test::sphere(radius, 129), height);
    for (const double around : {0.0, 1.1}) {
        const Place outwards{std::cos(around), 0, std::sin(around)};
        for (const double arc : {0.3, 1.0, 2.0}) {
            const Place corner = onSphere(lineAngle - arc / radius, around, height);
            const auto line = sphere.lineAt(corner, outwards * (edge + 1));
            const auto result = unfolded(sphere.field, sphere.frame, 0.0, cell, line, corner);
            QVERIFY(std::abs(result.path - arc) < 0.01);
            QVERIFY(length(result.position - outwards * (edge - arc)) < 0.02);
        }
    }
}

void ContactPathTest::unfolded_wall_distanceIsTheHeight() {
    const Placed box(test::box(20, 25, 20, 129), 5);
    const Place corner{20, -1.2, 3}; // on the wall, under water
    const auto line = box.lineAt({19.9, -1.2, 3}, {21, 0, 3});
    QVERIFY(line.found);
    QVERIFY(std::abs(line.place.x - 20) < 0.01);
    QVERIFY(std::abs(line.steepness - 1) < 0.001);
    const auto result = unfolded(box.field, box.frame, 0.0, cell, line, corner);
    QVERIFY(std::abs(result.path - 1.2) < 0.01);
    QVERIFY(length(result.position - Place{18.8, 0, 3}) < 0.02);
}

// A corner beside the triangle's contact line is unfolded along the meridian through the corner.
void ContactPathTest::unfolded_cornerBesideTheLine_liesOnItsOwnMeridian() {
    const double height = 20, lineAngle = std::acos(height / radius);
    const double edge = radius * std::sin(lineAngle);
    const Placed sphere(test::sphere(radius, 129), height);
    const auto line = sphere.lineAt(onSphere(lineAngle - 0.03, 0, height), {edge + 1, 0, 0});
    const double around = 0.05;
    const Place corner = onSphere(lineAngle - 1.0 / radius, around, height);
    const auto result = unfolded(sphere.field, sphere.frame, 0.0, cell, line, corner);
    const Place outwards{std::cos(around), 0, std::sin(around)};
    QVERIFY(length(result.position - outwards * (edge - 1)) < 0.02);
}

QTEST_GUILESS_MAIN(ContactPathTest)
#include "ContactPathTest.moc"
