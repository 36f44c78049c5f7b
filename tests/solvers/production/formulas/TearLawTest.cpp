// Tests when film tears or folds, whether the quick check finds all such film, and which rest
// shapes are accepted.
#include "production/formulas/TearLaw.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace dipwright::numerics;

namespace {

constexpr double spacingX = 1.75, spacingZ = 1.5; // mm

TriangleStretch<double> stretched(const Matrix2<double>& F) {
    return triangleStretch(
        EdgePair<double>{F.a * spacingX, F.c * spacingX, F.b * spacingZ, F.d * spacingZ}, spacingX,
        spacingZ);
}
bool torn(const Matrix2<double>& F, double limit) {
    return isTorn(stretched(F), limit);
}
bool folded(const Matrix2<double>& F) {
    return isFolded(stretched(F));
}

// Returns whether a rest shape of F times the undeformed shape is within the limits.
bool sound(const Matrix2<double>& F) {
    return isShapeWithinLimits(Matrix2<double>{1 / spacingX, 0, 0, 1 / spacingZ} * inverse(F),
                               spacingX, spacingZ);
}

} // namespace

class TearLawTest : public QObject {
    Q_OBJECT
private slots:
    void isTorn_lengthOrAreaPastTheLimit_isTrue();
    void isFolded_insideOut_isTrue();
    void mayBeTornOrFolded_tornOrFoldedFilm_isNeverMissed();
    void isShapeWithinLimits_creptPastTheLimit_isFalse();
};

void TearLawTest::isTorn_lengthOrAreaPastTheLimit_isTrue() {
    QVERIFY(!torn({1.49, 0, 0, 1}, 1.5));
    QVERIFY(torn({1.51, 0, 0, 0.5}, 1.5));
    QVERIFY(torn({0.5, 0, 0, 1.51}, 1.5));
    QVERIFY(!torn({1.2, 0, 0, 1.2}, 1.5));
    QVERIFY(torn({1.25, 0, 0, 1.25}, 1.5)); // 1.56 times the area, more than 1.5
    // Stretched by 1.51 along a diagonal direction.
    const double a = (1.51 + 0.6) / 2, b = (1.51 - 0.6) / 2;
    QVERIFY(torn({a, b, b, a}, 1.5));
    QVERIFY(!torn({a, b, b, a}, 1.52));
}

void TearLawTest::isFolded_insideOut_isTrue() {
    QVERIFY(!folded({1, 0, 0, 1}));
    QVERIFY(!folded({0.01, 0, 0, 0.01})); // gathered, but not folded
    QVERIFY(!folded({-1, 0, 0, -1}));     // rotated by 180°
    QVERIFY(folded({1, 0, 0, -0.01}));    // a corner past the opposite side
    QVERIFY(folded({0, 1, 1, 0}));        // mirrored
    QCOMPARE(stretched({1, 0, 0, -0.5}).area, -0.5);
    QCOMPARE(stretched({1, 0, 0, -0.5}).larger, 1.0);
}

// Checks one triangle, and a row of two triangles. For the row, the quick check gets the extreme
// values.
void TearLawTest::mayBeTornOrFolded_tornOrFoldedFilm_isNeverMissed() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> entry(-3, 3), limits(1.05, 4);
    const auto squaresOf = [](const Matrix2<double>& F) {
        return F.a * F.a + F.b * F.b + F.c * F.c + F.d * F.d;
    };
    int foundTorn = 0, foundFolded = 0, passedOver = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Matrix2<double> F{entry(random), entry(random), entry(random), entry(random)};
        const Matrix2<double> other{entry(random), entry(random), entry(random), entry(random)};
        const double limit = limits(random);
        const bool mayBe = mayBeTornOrFolded(squaresOf(F), stretched(F).area, limit);
        const bool mayBeInRow =
            mayBeTornOrFolded(std::max(squaresOf(F), squaresOf(other)),
                              std::min(stretched(F).area, stretched(other).area), limit);
        const bool isLost = torn(F, limit) || folded(F);
        QVERIFY(mayBe || !isLost);
        QVERIFY(mayBeInRow || (!isLost && !torn(other, limit) && !folded(other)));
        foundTorn += torn(F, limit) ? 1 : 0;
        foundFolded += folded(F) && !torn(F, limit) ? 1 : 0;
        passedOver += mayBe ? 0 : 1;
    }
    QVERIFY(foundTorn > 1000 && foundFolded > 1000 && passedOver > 1000);
}

void TearLawTest::isShapeWithinLimits_creptPastTheLimit_isFalse() {
    QVERIFY(sound({1, 0, 0, 1}));
    QVERIFY(sound({1.5, 0.2, -0.1, 0.7}));
    QVERIFY(sound({0.1, 0, 0, 10}));
    QVERIFY(!sound({1, 0, 0, largestCreepFactor * 1.01}));
    QVERIFY(!sound({1 / (largestCreepFactor * 1.01), 0, 0, 1}));
    QVERIFY(!sound({1, 0, 0, -1})); // inside out
    const double none = std::nan("");
    QVERIFY(!isShapeWithinLimits(Matrix2<double>{none, 0, 0, none}, spacingX, spacingZ));
}

QTEST_APPLESS_MAIN(TearLawTest)
#include "TearLawTest.moc"
