// Tests the difference of two films under a box that lie a known distance apart.
#include "accuracy/error/SheetDifference.h"

#include "DippedByHand.h"
#include "geometry/Shapes.h"

#include <QtTest>

#include <cmath>

using namespace dipwright;

namespace {

const Eigen::Vector3d boxSize(40, 30, 40);
const solver::FilmGrid grid{101, 101, 100, 100}; // lines 1 mm apart
constexpr double tolerance = 1e-4;               // mm, of single-precision places

// Returns film that lies flat under the box, with its middle at `middle` of the box's bottom.
std::shared_ptr<const LaidFilm> filmAt(const Eigen::Vector2f& middle) {
    DippedFilm film = test::flatUnderBox(grid, boxSize);
    for (std::size_t point = 0; point < film.positions.size(); ++point) {
        Eigen::Vector3f& place = film.positions[point];
        place += Eigen::Vector3f(middle.x(), 0, middle.y());
        const bool isUnder = std::abs(place.x()) <= 20 && std::abs(place.z()) <= 20;
        film.states[point] = isUnder ? solver::PointState::Adhered : solver::PointState::Free;
    }
    return test::laid(boxMesh(boxSize), film);
}

} // namespace

class SheetDifferenceTest : public QObject {
    Q_OBJECT

private slots:
    void difference_filmsApart_isTheirDistance() {
        const auto fine = fineBody(boxMesh(boxSize));
        const auto first = filmAt({0, 0}), second = filmAt({3, 4});
        const SheetDifference found = sheetDifference(*first, *second, *fine);
        QVERIFY(found.change.painted > 0.1);
        QVERIFY(std::abs(found.change.distance.minimum - 5) < tolerance);
        QVERIFY(std::abs(found.change.distance.maximum - 5) < tolerance);
        QVERIFY(found.farthest.isValid());
        QCOMPARE(found.pieces.size(), fine->mesh().triangles.size());
        std::size_t painted = 0;
        for (const float move : found.pieces) {
            QVERIFY(move < 0 || std::abs(move - 5) < tolerance);
            painted += move >= 0;
        }
        QVERIFY(painted > 100);
        QCOMPARE(found.points.size(), grid.pointCount());
        for (std::size_t point = 0; point < found.points.size(); ++point) {
            const bool isOn = second->contact().surface[point].isValid();
            const float move = found.points[point];
            QVERIFY(!isOn || std::isnan(move) || move == 0 || std::abs(move - 5) < tolerance);
        }
    }

    void difference_sameFilm_isZero() {
        const auto film = filmAt({0, 0});
        const SheetDifference found = sheetDifference(*film, *film, *fineBody(boxMesh(boxSize)));
        QCOMPARE(found.change.distance.maximum, 0.0);
        QCOMPARE(found.change.paintedOnce, 0.0);
    }

    void difference_filmBesideBody_isPaintedOnce() {
        const SheetDifference found =
            sheetDifference(*filmAt({0, 0}), *filmAt({200, 0}), *fineBody(boxMesh(boxSize)));
        QCOMPARE(found.change.painted, 0.0);
        QVERIFY(found.change.paintedOnce > 0.1);
        QVERIFY(!found.farthest.isValid());
    }
};

QTEST_GUILESS_MAIN(SheetDifferenceTest)
#include "SheetDifferenceTest.moc"
