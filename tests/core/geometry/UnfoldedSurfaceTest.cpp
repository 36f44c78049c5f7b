// Surfaces that are unfolded around a place, compared with closed forms.
#include "geometry/UnfoldedSurface.h"
#include "base/Units.h"
#include "geometry/Shapes.h"
#include "geometry/SurfaceQuery.h"

#include <QtTest>

#include <cmath>

using namespace dipwright;

namespace {

SurfacePoint placeAt(const SurfaceQuery& query, const Eigen::Vector3d& position) {
    return query.closest(position.cast<float>()).point;
}

// Returns the length along a regular prism's outline from the middle of one side to `angle`
// (radians).
double alongPolygon(double angle, double radius, int sides) {
    const double half = pi / sides;
    const double apothem = radius * std::cos(half);
    const double side = std::round(angle / (2 * half));
    return side * 2 * radius * std::sin(half) + apothem * std::tan(angle - side * 2 * half);
}

Eigen::Vector3d onPrism(double angle, double radius, int sides, double z) {
    const double half = pi / sides;
    const double side = std::round(angle / (2 * half)) * 2 * half;
    const double distance = radius * std::cos(half) / std::cos(angle - side);
    const double turned = angle + half; // a corner lies at angle 0
    return {distance * std::cos(turned), distance * std::sin(turned), z};
}

} // namespace

class UnfoldedSurfaceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void unfoldedSurface_cylinder_unrollsWithin0p01mm();
    void unfoldedSurface_cube_unfoldsOverItsEdge();
    void unfoldedSurface_placesBehindACorner_areUnfolded();
    void unfoldedSurface_sphere_keepsDistancesFromTheMiddle();
    void uprightFrame_seenFromOutside_isUprightAndNotMirrored();
    void unfoldedSurface_largeTriangles_areExact();
    void unfoldedSurface_pastTheRadius_isEmpty();
    void unfoldedSurface_openSeam_isCrossed_data();
    void unfoldedSurface_openSeam_isCrossed();
};

void UnfoldedSurfaceTest::unfoldedSurface_cylinder_unrollsWithin0p01mm() {
    constexpr double radius = 20;
    constexpr int sides = 48;
    const TriangleMesh mesh = cylinderMesh(radius, 100, sides);
    const SurfaceQuery query(mesh);
    const UnfoldedSurface unfolded(mesh, placeAt(query, onPrism(0, radius, sides, 0)), 45);
    const auto at = [&](double angle, double z) {
        return unfolded.at(placeAt(query, onPrism(angle, radius, sides, z)));
    };
    const auto origin = at(0, 0);
    QVERIFY(origin && origin->norm() < 1e-3);
    for (double angle = -1.8; angle <= 1.8; angle += 0.17) {
        for (const double z : {-24.0, -10.0, 0.0, 3.0, 20.0}) {
            const double around = alongPolygon(angle, radius, sides);
            if (std::hypot(around, z) > 44) {
                continue;
            }
            const auto flat = at(angle, z);
            QVERIFY(flat);
            QVERIFY2(std::abs(flat->norm() - std::hypot(around, z)) < 0.01,
                     qPrintable(QStringLiteral("angle %1 rad, z = %2 mm: unfolded to (%3, %4) mm")
                                    .arg(angle)
                                    .arg(z)
                                    .arg(flat->x())
                                    .arg(flat->y())));
            QVERIFY(std::abs(std::abs(flat->x()) - std::abs(z)) <
                    0.01); // straight lines stay straight
        }
    }
}

void UnfoldedSurfaceTest::unfoldedSurface_cube_unfoldsOverItsEdge() {
    const TriangleMesh mesh = boxMesh({60, 60, 60});
    const SurfaceQuery query(mesh);
    // 5 mm left of the edge between front (+z) and right (+x).
    const UnfoldedSurface unfolded(mesh, placeAt(query, {25, 3, 30}), 25);
    for (double right = -10; right <= 18; right += 2) {
        for (double up = -15; up <= 15; up += 3) {
            const Eigen::Vector3d place = right <= 5 ? Eigen::Vector3d(25 + right, 3 + up, 30)
                                                     : Eigen::Vector3d(30, 3 + up, 35 - right);
            const auto flat = unfolded.at(placeAt(query, place));
            QVERIFY(flat);
            QVERIFY((*flat - Eigen::Vector2d(right, up)).norm() < 1e-3);
        }
    }
}

void UnfoldedSurfaceTest::unfoldedSurface_placesBehindACorner_areUnfolded() {
    const TriangleMesh mesh = boxMesh({60, 60, 60});
    const SurfaceQuery query(mesh);
    const Eigen::Vector3d middle(24, 25, 30);
    const UnfoldedSurface unfolded(mesh, placeAt(query, middle), 20);
    for (double right = -10; right < 18; right += 1.3) {
        for (double up = -10; up < 18; up += 1.3) {
            // Behind the corner, where the unfolded surface is cut, the paths over both faces are
            // equally long.
            const double overTop = right > 6 ? std::hypot(11 - up, right - 1) : 1e3;
            const double overSide = up > 5 ? std::hypot(up + 1, 11 - right) : 1e3;
            const double straight = std::hypot(right, up);
            if (straight > 19 || (right > 6 && up > 5) || straight > overTop - 0.8 ||
                straight > overSide - 0.8) {
                continue;
            }
            const Eigen::Vector3d place = right > 6 ? Eigen::Vector3d(30, 25 + up, 36 - right)
                                          : up > 5  ? Eigen::Vector3d(24 + right, 30, 35 - up)
                                                    : middle + Eigen::Vector3d(right, up, 0);
            const auto flat = unfolded.at(placeAt(query, place));
            QVERIFY(flat);
            QVERIFY2((*flat - Eigen::Vector2d(right, up)).norm() < 1e-3,
                     qPrintable(QStringLiteral("(%1, %2) mm is unfolded to (%3, %4) mm")
                                    .arg(right)
                                    .arg(up)
                                    .arg(flat->x())
                                    .arg(flat->y())));
        }
    }
}

void UnfoldedSurfaceTest::unfoldedSurface_sphere_keepsDistancesFromTheMiddle() {
    constexpr double radius = 40;
    const TriangleMesh mesh = sphereMesh(radius, 80, 160);
    const SurfaceQuery query(mesh);
    const UnfoldedSurface unfolded(mesh, placeAt(query, {0, 0, radius}), 50);
    for (double away = 2; away <= 48; away += 5) {
        for (double direction = 0.1; direction < 6.2; direction += 0.7) {
            const double angle = away / radius;
            const auto flat = unfolded.at(placeAt(
                query, {radius * std::sin(angle) * std::cos(direction),
                        radius * std::sin(angle) * std::sin(direction), radius * std::cos(angle)}));
            QVERIFY(flat);
            QVERIFY(std::abs(flat->norm() - away) < 0.01 * away + 0.02);
            const Eigen::Vector2d wanted =
                away * Eigen::Vector2d(std::cos(direction), std::sin(direction));
            QVERIFY2((*flat - wanted).norm() < 0.02 * away + 0.05,
                     qPrintable(QStringLiteral("%1 mm away at %2 rad: unfolded to (%3, %4) mm")
                                    .arg(away)
                                    .arg(direction)
                                    .arg(flat->x())
                                    .arg(flat->y())));
        }
    }
}

void UnfoldedSurfaceTest::uprightFrame_seenFromOutside_isUprightAndNotMirrored() {
    for (const Eigen::Vector3d& outward :
         {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(0, 1, 0),
          Eigen::Vector3d(0, -1, 0), Eigen::Vector3d(0.6, 0.48, 0.64)}) {
        const SurfaceFrame frame = uprightFrame(outward);
        QVERIFY((frame.right.cross(frame.up) - outward).norm() < 1e-9);
        QVERIFY(std::abs(outward.y()) > 0.99 ? std::abs(frame.up.z()) > 0.99 : frame.up.y() > 0);
    }
}

void UnfoldedSurfaceTest::unfoldedSurface_largeTriangles_areExact() {
    // The unfolded area, 2 mm in radius, lies in two large triangles, with its middle on their
    // edge.
    const TriangleMesh mesh = boxMesh({100, 100, 100});
    const SurfaceQuery query(mesh);
    const UnfoldedSurface unfolded(mesh, placeAt(query, {0, 0, 50}), 2);
    for (const Eigen::Vector2d& wanted : {Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1),
                                          Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, -1)}) {
        const auto flat = unfolded.at(placeAt(query, {wanted.x(), wanted.y(), 50}));
        QVERIFY(flat && (*flat - wanted).norm() < 1e-4);
    }
}

void UnfoldedSurfaceTest::unfoldedSurface_pastTheRadius_isEmpty() {
    const TriangleMesh mesh = boxMesh({60, 60, 60});
    const SurfaceQuery query(mesh);
    const UnfoldedSurface unfolded(mesh, placeAt(query, {0, 0, 30}), 10);
    QVERIFY(!unfolded.at(placeAt(query, {11, 0, 30})));
    QVERIFY(!unfolded.at(placeAt(query, {0, 0, -30})));
    QVERIFY(unfolded.at(placeAt(query, {9.9, 0, 30})));
}

void UnfoldedSurfaceTest::unfoldedSurface_openSeam_isCrossed_data() {
    QTest::addColumn<double>("z");
    QTest::newRow("middle in the seam") << 0.0;
    QTest::newRow("middle at its end") << 50.0;
}

// Files store the places on a texture seam twice, with a rounding error between them.
void UnfoldedSurfaceTest::unfoldedSurface_openSeam_isCrossed() {
    QFETCH(const double, z);
    const TriangleMesh closed = cylinderMesh(20, 100, 48);
    TriangleMesh open = closed;
    for (auto& corners : open.triangles) {
        const bool isBehind =
            std::any_of(corners.begin(), corners.end(),
                        [&](std::uint32_t corner) { return closed.positions[corner].y() < -0.1f; });
        for (std::uint32_t& corner : corners) {
            const Eigen::Vector3f place = closed.positions[corner];
            if (isBehind && place.x() > 19.9f && std::abs(place.y()) < 1e-3f) {
                open.positions.push_back(place + Eigen::Vector3f(0, -3e-5f, 2e-5f));
                corner = std::uint32_t(open.positions.size() - 1);
            }
        }
    }
    QVERIFY(open.positions.size() > closed.positions.size());
    const SurfaceQuery query(closed), openQuery(open);
    const Eigen::Vector3d middle(20, 0, z);
    const UnfoldedSurface whole(closed, placeAt(query, middle), 30);
    const UnfoldedSurface cut(open, placeAt(openQuery, middle), 30);
    // Up and right are those of the middle's triangle, which can be on either side of the seam.
    int compared = 0;
    for (double angle = -0.9; angle <= 0.9; angle += 0.1) {
        for (double away = -20; away <= 0; away += 2.5) {
            const Eigen::Vector3d place = onPrism(angle, 20, 48, z + away);
            const auto wanted = whole.at(placeAt(query, place));
            const auto flat = cut.at(placeAt(openQuery, place));
            QCOMPARE(flat.has_value(), wanted.has_value());
            if (flat) {
                QVERIFY2(
                    std::abs(flat->norm() - wanted->norm()) < 0.02,
                    qPrintable(QStringLiteral("%1 rad, %2 mm along: distance %3 mm, expected %4 mm")
                                   .arg(angle)
                                   .arg(away)
                                   .arg(flat->norm())
                                   .arg(wanted->norm())));
                ++compared;
            }
        }
    }
    QVERIFY(compared > 50);
}

QTEST_GUILESS_MAIN(UnfoldedSurfaceTest)
#include "UnfoldedSurfaceTest.moc"
