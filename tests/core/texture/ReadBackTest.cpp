// Tests the read-back error with films whose positions the test sets.
#include "texture/ReadBack.h"
#include "DippedByHand.h"
#include "geometry/Shapes.h"

#include <QtTest>

#include <cmath>

using namespace dipwright;

namespace {

constexpr double radius = 35;

QImage anyPicture() {
    QImage image(64, 32, QImage::Format_RGBA8888);
    image.fill(Qt::red);
    return image;
}

// Returns the error of the film `dipped` with a sheet that was made for `planned`.
ReadBackError measured(const TexturedMesh& model, const DippedFilm& planned,
                       const DippedFilm& dipped) {
    return readBackError(*test::laid(model.mesh, planned), *test::laid(model.mesh, dipped), model);
}

} // namespace

class ReadBackTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void readBackError_flatFace_isZero();
    void readBackError_sphere_isWithinTheTargets_data();
    void readBackError_sphere_isWithinTheTargets();
    void readBackError_bodyWithoutTexture_isMeasured();
    void readBackError_slippedFilm_isTheSlip();
    void readBackError_bareBody_hasNoSamples();
};

void ReadBackTest::readBackError_flatFace_isZero() {
    const DippedFilm film = test::flatUnderBox(test::a4Grid(), {60, 30, 60});
    const ReadBackError error =
        measured(test::boxWithPicture({60, 30, 60}, anyPicture()), film, film);
    QVERIFY(error.maximum < 0.001);
    QVERIFY(error.samples > 10000);
}

void ReadBackTest::readBackError_sphere_isWithinTheTargets_data() {
    QTest::addColumn<int>("rings");
    QTest::addColumn<bool>("halved");
    QTest::newRow("fine globe") << 160 << false;
    QTest::newRow("coarse globe") << 24 << false;
    QTest::newRow("two charts") << 60 << true;
}

void ReadBackTest::readBackError_sphere_isWithinTheTargets() {
    QFETCH(int, rings);
    QFETCH(bool, halved);
    const TexturedMesh model = halved ? test::halvedBall(radius, rings, 2 * rings, anyPicture())
                                      : test::globe(radius, rings, 2 * rings, anyPicture());
    const DippedFilm film = test::viscousOnSphere(test::a4Grid(), radius, 1.9);
    const ReadBackError error = measured(model, film, film);
    QVERIFY2(error.mean <= 0.02,
             qPrintable(QStringLiteral("mean %1 mm, expected 0.02 mm or less").arg(error.mean)));
    QVERIFY2(
        error.percentile95 <= 0.05,
        qPrintable(
            QStringLiteral("95 % within %1 mm, expected 0.05 mm or less").arg(error.percentile95)));
    QVERIFY2(
        error.maximum <= 0.2,
        qPrintable(QStringLiteral("maximum %1 mm, expected 0.2 mm or less").arg(error.maximum)));
    QVERIFY(error.samples > 14000);
}

void ReadBackTest::readBackError_bodyWithoutTexture_isMeasured() {
    const DippedFilm film = test::viscousOnSphere(test::a4Grid(), radius, 1.9);
    const ReadBackError error =
        measured(test::plainModel(sphereMesh(radius, 60, 120), Qt::red), film, film);
    QVERIFY(error.maximum < 0.1);
    QVERIFY(error.samples > 14000);
}

void ReadBackTest::readBackError_slippedFilm_isTheSlip() {
    const DippedFilm film = test::flatUnderBox(test::a4Grid(), {58, 30, 58});
    DippedFilm slipped = film;
    for (Eigen::Vector3f& position : slipped.positions) {
        position.x() += 0.3f;
        position.z() -= 0.4f;
    }
    const ReadBackError error =
        measured(test::boxWithPicture({60, 30, 60}, anyPicture()), film, slipped);
    QVERIFY(std::abs(error.mean - 0.5) < 0.01);
    QVERIFY(std::abs(error.maximum - 0.5) < 0.01);
}

void ReadBackTest::readBackError_bareBody_hasNoSamples() {
    DippedFilm film = test::flatUnderBox(test::a4Grid(), {60, 30, 60});
    film.states.assign(film.states.size(), solver::PointState::Free);
    const ReadBackError error =
        measured(test::boxWithPicture({60, 30, 60}, anyPicture()), film, film);
    QCOMPARE(error.samples, std::size_t(0));
    QCOMPARE(error.maximum, 0.0);
}

QTEST_APPLESS_MAIN(ReadBackTest)
#include "ReadBackTest.moc"
