// Tests how bodies are drawn: what a camera sees, against ray casting, and the table of the film's
// places, against the search for each place.
#include "DippedByHand.h"
#include "geometry/Shapes.h"
#include "geometry/SurfaceQuery.h"
#include "results/BodyViews.h"
#include "results/FilmPlaces.h"

#include <QTest>

#include <cmath>

using namespace dipwright;

namespace {

constexpr QSize tile(120, 100);
constexpr int samplesAcross = 3; // as in BodyViews.cpp

} // namespace

class BodyPicturesTest : public QObject {
    Q_OBJECT

private slots:
    void seenBody_everySide_showsWhatRaysHit_data() {
        QTest::addColumn<int>("side");
        for (int side = 0; side < 6; ++side) {
            QTest::addRow("side %d", side) << side;
        }
    }
    void seenBody_everySide_showsWhatRaysHit() {
        QFETCH(int, side);
        const TriangleMesh torus = torusMesh(30, 12, 60, 30);
        const SurfaceQuery query(torus);
        const std::vector<BodyCamera> cameras = sixSides(boundingBox(torus), 0.4f);
        const float span = commonSpan(cameras, torus, tile);
        const BodyCamera& camera = cameras[std::size_t(side)];
        const SeenBody seen = camera.see(torus, span, tile);
        int differing = 0, hits = 0;
        for (int y = 0; y < samplesAcross * tile.height(); ++y) {
            for (int x = 0; x < samplesAcross * tile.width(); ++x) {
                const BodyRay ray = camera.ray(
                    QPointF((x + 0.5) / samplesAcross, (y + 0.5) / samplesAcross), span, tile);
                const RayHit hit = query.hit(ray.origin, ray.direction);
                const SurfacePoint place = seen.at(x, y);
                hits += hit.point.isValid();
                if (place.isValid() != hit.point.isValid()) {
                    ++differing; // a place on the outline
                } else if (place.isValid()) {
                    differing += (position(torus, place) - position(torus, hit.point)).norm() >
                                 0.05f; // beside an edge that hides a farther place
                    QVERIFY(std::abs(place.weights.sum() - 1) < 1e-4f);
                    QVERIFY(place.weights.minCoeff() > -1e-4f);
                }
            }
        }
        QVERIFY2(hits > 10000, qPrintable(QString::number(hits)));
        QVERIFY2(differing < hits / 500,
                 qPrintable(QStringLiteral("%1 of %2 samples differ").arg(differing).arg(hits)));
    }

    void seenBody_twoBodies_nearerOneHasLargerNearness() {
        const TriangleMesh near = sphereMesh(10, 20, 40);
        TriangleMesh far = near;
        for (Eigen::Vector3f& position : far.positions) {
            position.z() -= 40;
        }
        const BodyCamera camera(boundingBox(near), 0, 0);
        const SeenBody front = camera.see(near, 0.4f, tile), back = camera.see(far, 0.4f, tile);
        const int x = samplesAcross * tile.width() / 2, y = samplesAcross * tile.height() / 2;
        QVERIFY(front.nearness(x, y) > back.nearness(x, y));
        QVERIFY(std::isinf(front.nearness(0, 0)) && !front.at(0, 0).isValid());
    }

    // On a ball, film ends in a circle; a table must give the same end and the same places.
    void filmPlaces_ball_matchTheSearch() {
        const TriangleMesh ball = sphereMesh(35, 60, 120);
        const auto laid = test::laid(ball, test::viscousOnSphere(test::gradedA4Grid(), 35, pi / 2));
        const RefinedMesh fine(ball, 2);
        const FilmPlaces places(fine, *laid);
        std::size_t painted = 0, differing = 0;
        float farthest = 0;
        for (std::uint32_t triangle = 0; triangle < fine.mesh().triangles.size(); ++triangle) {
            const SurfacePoint place{triangle, Eigen::Vector3f(0.6f, 0.1f, 0.3f)};
            const auto found = laid->place(fine.onCoarse(place));
            const auto given = places.at(place);
            painted += found.has_value();
            differing += found.has_value() != given.has_value();
            if (found && given) {
                farthest = std::max(farthest, (found->rest - given->rest).norm());
                QVERIFY(laid->weights(*given).minCoeff() > -1e-3f);
            }
        }
        QVERIFY2(painted > 5000, qPrintable(QString::number(painted)));
        QVERIFY2(differing < painted / 500, qPrintable(QString::number(differing)));
        QVERIFY2(farthest < 0.06f, qPrintable(QStringLiteral("%1 mm").arg(double(farthest))));
    }
};

QTEST_GUILESS_MAIN(BodyPicturesTest)
#include "BodyPicturesTest.moc"
