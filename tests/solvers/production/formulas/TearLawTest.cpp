// When film tears, and that the quick look never passes over film that has torn.
#include "production/formulas/TearLaw.h"

#include <QtTest>

#include <random>

using namespace dipwright::numerics;

namespace {

constexpr double spacingX = 1.75, spacingZ = 1.5; // mm

bool torn(const Matrix2<double>& F, double limit) {
    return isTorn(EdgePair<double>{F.a * spacingX, F.c * spacingX, F.b * spacingZ, F.d * spacingZ},
                  spacingX, spacingZ, limit);
}

} // namespace

class TearLawTest : public QObject {
    Q_OBJECT
private slots:
    void tearsByLengthAndByArea();
    void quickLookMissesNothing();
};

void TearLawTest::tearsByLengthAndByArea() {
    QVERIFY(!torn({1.49, 0, 0, 1}, 1.5));
    QVERIFY(torn({1.51, 0, 0, 0.5}, 1.5));
    QVERIFY(torn({0.5, 0, 0, 1.51}, 1.5));
    QVERIFY(!torn({1.2, 0, 0, 1.2}, 1.5));
    QVERIFY(torn({1.25, 0, 0, 1.25}, 1.5)); // 1.56 times the area
    // Whichever way it is turned: stretched by 1.51 along a diagonal.
    const double a = (1.51 + 0.6) / 2, b = (1.51 - 0.6) / 2;
    QVERIFY(torn({a, b, b, a}, 1.5));
    QVERIFY(!torn({a, b, b, a}, 1.52));
}

void TearLawTest::quickLookMissesNothing() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> entry(-3, 3), limits(1.05, 4);
    int found = 0, passedOver = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Matrix2<double> F{entry(random), entry(random), entry(random), entry(random)};
        const double limit = limits(random);
        const bool mayBe = mayBeTorn(F.a * F.a + F.b * F.b + F.c * F.c + F.d * F.d, limit);
        QVERIFY(mayBe || !torn(F, limit));
        found += torn(F, limit) ? 1 : 0;
        passedOver += mayBe ? 0 : 1;
    }
    QVERIFY(found > 1000 && passedOver > 1000);
}

QTEST_APPLESS_MAIN(TearLawTest)
#include "TearLawTest.moc"
