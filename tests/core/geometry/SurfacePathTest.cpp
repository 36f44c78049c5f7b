// Tests ways along a surface.
#include "geometry/SurfacePath.h"
#include "geometry/Shapes.h"
#include "geometry/SurfaceQuery.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace dipwright;

class SurfacePathTest : public QObject {
    Q_OBJECT

private slots:
    void path_onSphere_isArc() {
        constexpr float radius = 30;
        const TriangleMesh sphere = sphereMesh(radius, 48, 96);
        const SurfaceQuery query(sphere);
        for (const double degrees : {5.0, 60.0, 90.0, 150.0}) {
            const double angle = degrees * std::numbers::pi / 180;
            const Eigen::Vector3f from = radius * Eigen::Vector3f(0.2f, 0.3f, 0.93f).normalized();
            const Eigen::Vector3f axis = from.unitOrthogonal();
            const Eigen::Vector3f to = Eigen::AngleAxisf(float(angle), axis) * from;
            const auto path =
                surfacePath(sphere, query.closest(from).point, query.closest(to).point);
            const double arc = double(radius) * angle;
            QVERIFY2(
                std::abs(lengthOf(path) - arc) < 0.01 * arc,
                qPrintable(
                    QStringLiteral("%1 mm, expected %2 mm ± 1 %").arg(lengthOf(path)).arg(arc)));
            QVERIFY((path.front() - from).norm() < 0.2f && (path.back() - to).norm() < 0.2f);
            for (std::size_t point = 1; point < path.size(); ++point) {
                const Eigen::Vector3f middle = (path[point - 1] + path[point]) / 2;
                QVERIFY(query.closest(middle).distance < 0.01f);
            }
        }
    }

    void path_withinTriangle_isStraight() {
        const TriangleMesh sphere = sphereMesh(30, 8, 16);
        const SurfacePoint from{20, {0.8f, 0.1f, 0.1f}}, to{20, {0.1f, 0.2f, 0.7f}};
        const auto path = surfacePath(sphere, from, to);
        QCOMPARE(path.size(), std::size_t(2));
        QVERIFY((path.front() - position(sphere, from)).norm() < 1e-4f);
        QVERIFY((path.back() - position(sphere, to)).norm() < 1e-4f);
    }

    void path_cancelled_throws() {
        const TriangleMesh sphere = sphereMesh(30, 8, 16);
        CancelToken cancel;
        cancel.cancel();
        QVERIFY_EXCEPTION_THROWN(surfacePath(sphere, middleOf(20), middleOf(90), cancel),
                                 Cancelled);
    }

    void path_toSeparatePiece_isNone() {
        TriangleMesh two = sphereMesh(10, 8, 16);
        const auto count = std::uint32_t(two.positions.size());
        const std::size_t triangles = two.triangles.size();
        for (std::uint32_t point = 0; point < count; ++point) {
            two.positions.push_back(two.positions[point] + Eigen::Vector3f(50, 0, 0));
        }
        for (std::size_t t = 0; t < triangles; ++t) {
            const auto [a, b, c] = two.triangles[t];
            two.triangles.push_back({a + count, b + count, c + count});
        }
        QVERIFY(surfacePath(two, middleOf(3), middleOf(std::uint32_t(triangles) + 3)).empty());
    }
};

QTEST_APPLESS_MAIN(SurfacePathTest)
#include "SurfacePathTest.moc"
