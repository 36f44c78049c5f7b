// Tests a triangle that crosses the contact line: which part strains and which part pulls.

#include "production/formulas/CrossingTriangle.h"

#include <QTest>
#include <cmath>
#include <utility>

using namespace dipwright::numerics;

namespace {

using Matrix = Matrix2<double>;
using Crossing = CrossingTriangle<double>;
using Anchor = CrossingAnchor<double>;

const Matrix rest{0.5, 0, 0, 0.25}; // inverse of a shape with edges 2 and 4 mm long
constexpr double area = 4;

double distance(const Matrix& a, const Matrix& b) {
    return std::hypot(std::hypot(a.a - b.a, a.b - b.b), std::hypot(a.c - b.c, a.d - b.d));
}

// A triangle with the corners s (shared), h (end of the horizontal edge) and v (end of the vertical
// edge).
Crossing crossing(bool sharedFree, bool horizontalFree, bool verticalFree) {
    Crossing triangle;
    triangle.sharedFree = sharedFree;
    triangle.horizontalFree = horizontalFree;
    triangle.verticalFree = verticalFree;
    return triangle;
}

Anchor anchorFor(double nx, double nz, double before, double after,
                 const Matrix& gradient = {1, 0, 0, 1}) {
    Crossing start, end;
    start.normalX = nx;
    start.normalZ = nz;
    start.floating = before;
    end.floating = after;
    return anchorOverStep(crossingAnchor(start, gradient), end);
}

} // namespace

class CrossingTriangleTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void crossingTriangle_fullyFloating_equalsAFloatingTriangle();
    void crossingForces_onlyFloatingPartsOfTheSidesPull();
    void crossingForces_heldCorners_balanceTheForces();
    void floatingChange_acrossTheLine_isInTheFloatingPart();
    void crossingAnchor_usesTheLineInTheMiddleOfTheStep();
    void crossingAnchor_smallFloatingPart_isLimited();
    void unfoldedEdges_addTheUnfoldedOffsets();
    void relaxedCrossingShape_hasTheFloatingGradient();
    void crossingAnchor_rotatedFilm_rotatesTheNormal();
};

void CrossingTriangleTest::crossingTriangle_fullyFloating_equalsAFloatingTriangle() {
    const Matrix P{0.3, -0.1, 0.2, 0.5};
    for (const bool second : {false, true}) {
        for (const bool onRight : {false, true}) {
            Crossing triangle = crossing(true, true, false);
            triangle.second = second;
            triangle.thirdOnRight = onRight;
            const EdgePair<double> all = crossingForces(triangle, P, rest, area);
            const EdgePair<double> ordinary = edgeForces(P, rest, area);
            QVERIFY(std::abs(all.hx - ordinary.hx) < 1e-12);
            QVERIFY(std::abs(all.hz - ordinary.hz) < 1e-12);
            QVERIFY(std::abs(all.vx - ordinary.vx) < 1e-12);
            QVERIFY(std::abs(all.vz - ordinary.vz) < 1e-12);
        }
    }
    const Matrix whole{1.1, 0.2, -0.1, 0.9};
    QVERIFY(distance(floatingGradient(anchorFor(1, 0, 1, 1), whole), whole) < 1e-12);
}

// The force on a corner is ½ P Σ share ℓ n over the two sides that meet at the corner. For s = (0,
// 0), h = (2, 0), v = (0, 4), the sides s–h, h–v and v–s have ℓ n = (0, −2), (4, 2) and (−4, 0).
void CrossingTriangleTest::crossingForces_onlyFloatingPartsOfTheSidesPull() {
    const Matrix P{0.3, -0.1, 0.2, 0.5};
    Crossing triangle = crossing(false, true, true);
    triangle.horizontalShare = 0.4;
    triangle.verticalShare = 0.7;
    triangle.diagonalShare = 1;
    const EdgePair<double> force = crossingForces(triangle, P, rest, area);
    const auto half = [&](double nx, double nz) {
        return std::pair{(P.a * nx + P.b * nz) / 2, (P.c * nx + P.d * nz) / 2};
    };
    const auto onH = half(4, 2 - 0.4 * 2), onV = half(4 - 0.7 * 4, 2);
    QVERIFY(std::abs(force.hx - onH.first) < 1e-12);
    QVERIFY(std::abs(force.hz - onH.second) < 1e-12);
    QVERIFY(std::abs(force.vx - onV.first) < 1e-12);
    QVERIFY(std::abs(force.vz - onV.second) < 1e-12);
}

// The force on s is minus the sum of the forces on the edges s–h and s–v.
void CrossingTriangleTest::crossingForces_heldCorners_balanceTheForces() {
    const Matrix P{0.3, -0.1, 0.2, 0.5};
    Crossing triangle = crossing(true, false, true);
    triangle.horizontalShare = 0.4;
    triangle.diagonalShare = 0.8;
    const EdgePair<double> force = crossingForces(triangle, P, rest, area);
    const double sharedX = (P.a * -4 + P.b * -2 * 0.4) / 2;
    const double sharedZ = (P.c * -4 + P.d * -2 * 0.4) / 2;
    QVERIFY(std::abs(-force.hx - force.vx - sharedX) < 1e-12);
    QVERIFY(std::abs(-force.hz - force.vz - sharedZ) < 1e-12);
}

void CrossingTriangleTest::floatingChange_acrossTheLine_isInTheFloatingPart() {
    const Anchor anchor = anchorFor(1, 0, 0.5, 0.5);
    const Matrix across = floatingChange(anchor, Matrix{0.1, 0, 0.02, 0});
    QVERIFY(distance(across, {0.2, 0, 0.04, 0}) < 1e-12); // one half floats, so the change doubles
    const Matrix along{0, 0.1, 0, -0.05};
    QVERIFY(distance(floatingChange(anchor, along), along) < 1e-12);
    const Matrix whole{1.1, 0.1, 0, 1};
    QVERIFY(distance(floatingGradient(anchor, whole), {1.2, 0.1, 0, 1}) < 1e-12);
}

void CrossingTriangleTest::crossingAnchor_usesTheLineInTheMiddleOfTheStep() {
    QCOMPARE(anchorFor(1, 0, 0.8, 0.6).gain, 1 / 0.7 - 1);
    QCOMPARE(anchorFor(1, 0, 1, 1).gain, 0.0);
}

void CrossingTriangleTest::crossingAnchor_smallFloatingPart_isLimited() {
    QCOMPARE(anchorFor(1, 0, 0.01, 0.01).gain, 1 / leastFloatingFraction - 1);
    // Without a contact line, the change of the whole triangle is used.
    const Matrix change{0.1, 0.2, 0.3, 0.4};
    QVERIFY(distance(floatingChange(anchorFor(0, 0, 0.5, 0.5), change), change) < 1e-12);
}

void CrossingTriangleTest::unfoldedEdges_addTheUnfoldedOffsets() {
    Crossing triangle;
    triangle.hx = 0.1;
    triangle.hz = 0.2;
    triangle.vx = -0.3;
    triangle.vz = 0.4;
    const auto edges = unfoldedEdges(EdgePair<double>{2, 0, 0, 4}, triangle);
    QCOMPARE(edges.hx, 2.1);
    QCOMPARE(edges.hz, 0.2);
    QCOMPARE(edges.vx, -0.3);
    QCOMPARE(edges.vz, 4.4);
}

void CrossingTriangleTest::relaxedCrossingShape_hasTheFloatingGradient() {
    const Anchor anchor = anchorFor(0.6, 0.8, 0.7, 0.5);
    const Matrix whole{1.1, 0.05, -0.02, 1.04};
    const Matrix floating = floatingGradient(anchor, whole);
    const Matrix edges = whole * inverse(rest);
    QVERIFY(distance(edges * relaxedCrossingShape(anchor, whole, rest, 1.0), floating) < 1e-12);
    // A triangle that is squeezed to almost no area keeps its rest shape.
    const Matrix flat{1, 0, 0, 0.001};
    QVERIFY(distance(relaxedCrossingShape(anchor, flat, rest, 1.0), rest) == 0);
}

void CrossingTriangleTest::crossingAnchor_rotatedFilm_rotatesTheNormal() {
    const double c = std::cos(0.5), s = std::sin(0.5);
    const Anchor anchor = anchorFor(c, s, 0.5, 0.5, {c, -s, s, c});
    // The direction across the line is the film's X direction.
    QVERIFY(std::abs(anchor.mx - 1) < 1e-12);
    QVERIFY(std::abs(anchor.mz) < 1e-12);
}

QTEST_GUILESS_MAIN(CrossingTriangleTest)
#include "CrossingTriangleTest.moc"
