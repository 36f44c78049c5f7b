// Compares Functions.h with the C++ library.

#include "common/Functions.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace dipwright::numerics;

namespace {

constexpr double rightAngle = 1.5707963267948966;

// Returns the largest value of error(share) for shares from 0 to 1.
template <typename Error>
double largest(const Error& error) {
    constexpr int count = 100'000;
    double most = 0;
    for (int i = 0; i <= count; ++i) {
        most = std::max(most, std::abs(error(double(i) / count)));
    }
    return most;
}

} // namespace

class FunctionsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void decay_equalsTheExponential();
    void decay_limits_areExact();
    void sineOf_equalsTheSine();
    void angleOf_equalsTheArcCosine();
};

void FunctionsTest::decay_equalsTheExponential() {
    for (const double range : {1e-6, 1.0, 40.0, 699.0}) {
        const auto error = [range](double share) {
            return decay(-share * range) / std::exp(-share * range) - 1;
        };
        QVERIFY(largest(error) < 1e-15);
    }
}

void FunctionsTest::decay_limits_areExact() {
    QVERIFY(decay(0) == 1);
    QVERIFY(decay(-1e4) == 0);
    QVERIFY(decay(-std::numeric_limits<double>::infinity()) == 0);
    QVERIFY(std::isnan(decay(std::numeric_limits<double>::quiet_NaN())));
}

void FunctionsTest::sineOf_equalsTheSine() {
    QVERIFY(largest([](double share) {
                return sineOf(share * rightAngle) - std::sin(share * rightAngle);
            }) < 1e-15);
}

void FunctionsTest::angleOf_equalsTheArcCosine() {
    QVERIFY(largest([](double cosine) { return angleOf(cosine) - std::acos(cosine); }) < 2e-15);
    QVERIFY(angleOf(1) == 0);
}

QTEST_GUILESS_MAIN(FunctionsTest)
#include "FunctionsTest.moc"
