// Tests the length of a step, the stress that remains after it, and the drag of the water.

#include "production/formulas/StepLength.h"

#include "production/formulas/WaterDrag.h"

#include <QTest>
#include <cmath>
#include <limits>

using namespace dipwright::numerics;

class StepLengthTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void contactIncrement_followsTheSteepness();
    void contactIncrement_flatFace_hasAMinimum();
    void approachIncrement_endsAtTheFirstContact();
    void isNextToContact_reachesTwoCells();
    void keptStress_decaysExponentially();
    void pointDrag_growsWithAreaAndSpeed();
};

// If the contact line moves by `travel` along a surface with the steepness sin(angle), the body
// descends by travel · sin(angle).
void StepLengthTest::contactIncrement_followsTheSteepness() {
    QCOMPARE(contactIncrement(0.5, 1), 0.5);
    QCOMPARE(contactIncrement(0.5, std::sin(0.5)), 0.5 * std::sin(0.5));
}

void StepLengthTest::contactIncrement_flatFace_hasAMinimum() {
    QCOMPARE(contactIncrement(0.5, 0), 0.5 * leastSteepness);
    QCOMPARE(contactIncrement(0.5, 0.01), 0.5 * leastSteepness);
}

void StepLengthTest::approachIncrement_endsAtTheFirstContact() {
    QCOMPARE(approachIncrement(0.5, 3.25), 3.25);
    QCOMPARE(approachIncrement(0.5, 0.2), 0.2);
    QCOMPARE(approachIncrement(0.5, 0.001), 0.05); // at least this much, so that the dip continues
    QCOMPARE(approachIncrement(0.5, -2), 0.05);
}

void StepLengthTest::isNextToContact_reachesTwoCells() {
    constexpr int columns = 9, rows = 7, held = 3 * columns + 4;
    const auto isFree = [](std::size_t point) { return point != held; };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const bool isNear = std::abs(row - 3) <= 2 && std::abs(column - 4) <= 2;
            QCOMPARE(isNextToContact(columns, rows, row * columns + column, isFree), isNear);
        }
    }
}

void StepLengthTest::keptStress_decaysExponentially() {
    QVERIFY(std::abs(keptStress(2, 2) - std::exp(-1)) < 1e-15); // two seconds are one time constant
    QVERIFY(std::abs(keptStress(0.8, 2) * keptStress(1.2, 2) - keptStress(2, 2)) < 1e-15);
    QCOMPARE(keptStress(2, std::numeric_limits<double>::infinity()), 1.0); // elastic film
    QCOMPARE(keptStress(2, 0), 0.0);                                       // viscous film
}

void StepLengthTest::pointDrag_growsWithAreaAndSpeed() {
    const double drag = pointDrag(1.5, 2, 0.5);
    QCOMPARE(drag, waterDrag * 1.5 * 2 / 0.5);
    QCOMPARE(pointDrag(3, 2, 0.5), 2 * drag);
    // The same displacement in half the descent means twice the speed.
    QCOMPARE(pointDrag(1.5, 2, 0.25), 2 * drag);
}

QTEST_GUILESS_MAIN(StepLengthTest)
#include "StepLengthTest.moc"
