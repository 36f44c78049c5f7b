// Tests the search for a root between two places.

#include "common/RootBetween.h"

#include <QTest>
#include <algorithm>
#include <cmath>

using namespace dipwright::numerics;

namespace {

struct Search {
    double root = 0;
    int values = 0;
};

template <typename Function>
Search searched(const Function& function) {
    Search search;
    const auto counted = [&](double share) {
        ++search.values;
        return function(share);
    };
    search.root = rootBetween(counted, function(0.0), function(1.0));
    return search;
}

} // namespace

class RootBetweenTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void rootBetween_straightLine_needsOneValue();
    void rootBetween_curve_isFoundInFewValues();
    void rootBetween_fallingFunction_isFoundToo();
    void rootBetween_kink_isFound_data();
    void rootBetween_kink_isFound();
    void rootBetween_rootAtStart_isTheStart();
    void rootBetween_jump_endsAtTheJump();
};

void RootBetweenTest::rootBetween_straightLine_needsOneValue() {
    const Search search = searched([](double share) { return 3 * share - 1; });
    QVERIFY(std::abs(search.root - 1.0 / 3) < 1e-9);
    QCOMPARE(search.values, 1);
}

void RootBetweenTest::rootBetween_curve_isFoundInFewValues() {
    // A sphere of radius 30 that goes through a plane: the excess along a chord of 3 mm
    const Search search =
        searched([](double share) { return std::hypot(28.5 + 3 * share, 4) - 30; });
    QVERIFY(std::abs(search.root - (std::sqrt(900.0 - 16) - 28.5) / 3) < 2e-5);
    QVERIFY(search.values <= 5);
}

void RootBetweenTest::rootBetween_fallingFunction_isFoundToo() {
    const Search search = searched([](double share) { return 0.25 - share * share; });
    QVERIFY(std::abs(search.root - 0.5) < 2e-5);
}

void RootBetweenTest::rootBetween_kink_isFound_data() {
    QTest::addColumn<double>("depth");
    QTest::addColumn<double>("kink");
    for (const double depth : {1e-4, 1e-3, 1e-2}) { // mm
        for (const double kink : {0.1, 0.5, 0.9}) {
            QTest::addRow("%g mm, %g", depth, kink) << depth << kink;
        }
    }
}

// A flat face lies `depth` past the contact distance. The chord, 3 mm long, leaves it at the kink.
void RootBetweenTest::rootBetween_kink_isFound() {
    QFETCH(double, depth);
    QFETCH(double, kink);
    const double root = kink + depth / 3;
    const Search rising =
        searched([&](double share) { return 3 * std::max(share - kink, 0.0) - depth; });
    QVERIFY2(std::abs(rising.root - root) < 1e-3, qPrintable(QString::number(rising.root)));
    QVERIFY(rising.values <= rootSteps);
    const Search falling =
        searched([&](double share) { return 3 * std::max(1 - share - kink, 0.0) - depth; });
    QVERIFY2(std::abs(falling.root - (1 - root)) < 1e-3, qPrintable(QString::number(falling.root)));
}

void RootBetweenTest::rootBetween_rootAtStart_isTheStart() {
    QCOMPARE(searched([](double share) { return share; }).root, 0.0);
}

void RootBetweenTest::rootBetween_jump_endsAtTheJump() {
    const Search search = searched([](double share) { return share < 0.3 ? -1.0 : 2.0; });
    QVERIFY(std::abs(search.root - 0.3) < 1e-4);
}

QTEST_GUILESS_MAIN(RootBetweenTest)
#include "RootBetweenTest.moc"
