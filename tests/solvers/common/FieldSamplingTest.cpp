// Compares the sampling of distance fields with fields in closed form.

#include "common/FieldSampling.h"

#include "solvers/TestFilm.h"

#include <QTest>
#include <limits>
#include <random>

using namespace dipwright;
using namespace dipwright::numerics;

namespace {

using Place = Vector3<double>;

double linearAt(double x, double y, double z) {
    return 0.3 * x - 0.8 * y + 0.5 * z + 2;
}

double sphereError(int samples) {
    const test::SampledBody body = test::sphere(30, samples);
    const auto field = fieldGrid<double>(body.view);
    double largest = 0;
    for (double angle = 0; angle < 6.28; angle += 0.01) {
        const Place place{29 * std::cos(angle), 3, 29 * std::sin(angle)};
        largest =
            std::max(largest, std::abs(sampleField(field, place).distance - (length(place) - 30)));
    }
    return largest;
}

} // namespace

class FieldSamplingTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void sampleField_linearField_isExact();
    void sampleField_error_fallsWithTheSquareOfTheSpacing();
    void sampleField_outsideTheGrid_addsTheDistanceToTheGrid();
    void clearance_neverExceedsTheDistance();
    void onLevel_reachesTheLevel();
    void smoothGradient_acrossCells_isContinuous();
    void sampleField_notANumber_givesNaN();
};

void FieldSamplingTest::sampleField_linearField_isExact() {
    const test::SampledBody body = test::sampledBody(10, 11, linearAt);
    const auto field = fieldGrid<double>(body.view);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> within(-5, 5);
    for (int i = 0; i < 200; ++i) {
        const Place place{within(random), within(random), within(random)};
        const FieldSample<double> sample = sampleField(field, place);
        QVERIFY(std::abs(sample.distance - linearAt(place.x, place.y, place.z)) < 1e-5);
        QVERIFY(length(sample.gradient - Place{0.3, -0.8, 0.5}) < 1e-5);
        QCOMPARE(sample.outside, 0.0);
    }
}

void FieldSamplingTest::sampleField_error_fallsWithTheSquareOfTheSpacing() {
    const double coarse = sphereError(33), fine = sphereError(65);
    QVERIFY2(fine < coarse / 3,
             qPrintable(QStringLiteral("error %1 mm on the coarse grid, %2 mm on the fine one")
                            .arg(coarse)
                            .arg(fine)));
}

void FieldSamplingTest::sampleField_outsideTheGrid_addsTheDistanceToTheGrid() {
    const test::SampledBody body = test::sampledBody(10, 11, linearAt);
    const auto field = fieldGrid<double>(body.view);
    const FieldSample<double> sample = sampleField(field, Place{8, 9, 0});
    QVERIFY(std::abs(sample.outside - 5) < 1e-9); // 3 and 4 mm from the grid's corner
    QVERIFY(std::abs(sample.distance - (linearAt(5, 5, 0) + 5)) < 1e-5);
}

void FieldSamplingTest::clearance_neverExceedsTheDistance() {
    const test::SampledBody body = test::sphere(30, 65);
    const auto field = fieldGrid<double>(body.view);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> anywhere(-120, 120);
    for (int i = 0; i < 2000; ++i) {
        const Place place{anywhere(random), anywhere(random), anywhere(random)};
        QVERIFY(clearance(sampleField(field, place)) <= length(place) - 30 + 0.05);
    }
}

void FieldSamplingTest::onLevel_reachesTheLevel() {
    const test::SampledBody body = test::sphere(30, 65);
    const auto field = fieldGrid<double>(body.view);
    for (const double level : {0.0, 0.2}) {
        const Place place = onLevel(field, Place{20, 15, 12}, level);
        QVERIFY(std::abs(sampleField(field, place).distance - level) <= 1e-4 * field.spacing);
        QVERIFY(std::abs(length(place) - (30 + level)) < 0.02);
        // The place moved radially outwards from the centre.
        QVERIFY(std::abs(place.x / place.y - 20.0 / 15) < 0.02);
    }
}

void FieldSamplingTest::smoothGradient_acrossCells_isContinuous() {
    const test::SampledBody body = test::sphere(30, 65);
    const auto field = fieldGrid<double>(body.view);
    Place last = smoothGradient(field, Place{30, 0, 0});
    for (double angle = 0.001; angle < 6.28; angle += 0.001) {
        const Place outwards{std::cos(angle), 0, std::sin(angle)};
        const Place gradient = smoothGradient(field, outwards * 30.0);
        QVERIFY(length(gradient - outwards) < 0.01);
        QVERIFY(length(gradient - last) < 0.003);
        last = gradient;
    }
}

void FieldSamplingTest::sampleField_notANumber_givesNaN() {
    const test::SampledBody body = test::sphere(30, 17);
    const double none = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(std::isnan(sampleField(fieldGrid<double>(body.view), Place{none, 0, 0}).distance));
}

QTEST_GUILESS_MAIN(FieldSamplingTest)
#include "FieldSamplingTest.moc"
