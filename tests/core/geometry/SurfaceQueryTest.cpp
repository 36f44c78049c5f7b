// Closest points, rays and inside tests on bodies with closed forms.
#include "geometry/SurfaceQuery.h"
#include "JoinedMeshes.h"
#include "base/Units.h"
#include "geometry/BuriedSurface.h"
#include "geometry/Shapes.h"
#include "parallel/ParallelFor.h"

#include <QtTest>

#include <cmath>
#include <random>

using namespace dipwright;

namespace {

std::vector<Eigen::Vector3f> randomPlaces(int count, float reach) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> coordinate(-reach, reach);
    std::vector<Eigen::Vector3f> places;
    for (int i = 0; i < count; ++i) {
        const float x = coordinate(random), y = coordinate(random), z = coordinate(random);
        places.emplace_back(x, y, z);
    }
    return places;
}

// Unsigned distance to the surface of a box about the origin.
float boxDistance(const Eigen::Vector3f& place, const Eigen::Vector3f& size) {
    const Eigen::Vector3f beyond = place.cwiseAbs() - size / 2;
    return std::abs(beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0F));
}

bool isSame(const ClosestPoint& a, const ClosestPoint& b) {
    return a.point.triangle == b.point.triangle && a.point.weights == b.point.weights &&
           a.distance == b.distance;
}

double buriedShareOf(const TriangleMesh& mesh) {
    return BuriedSurface().share(mesh, SurfaceQuery(mesh));
}

} // namespace

class SurfaceQueryTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void closest_box_isExact();
    void closest_sphere_isRadial();
    void closest_beyondTheGivenDistance_isInvalid();
    void closest_equallyNearTriangles_givesTheFirst();
    void closest_degenerateTriangles_areIgnored();
    void hit_box_isExact();
    void hit_beyondItsReach_isInvalid();
    void isInside_box_isExact();
    void isInside_overlappingParts_areOneBody();
    void isInside_hollow_isFalse();
    void isInside_smallHole_keepsTheAnswer();
    void buriedSurface_overlappingSpheres_isTheirCaps();
    void buriedSurface_touchingBoxes_isTheSharedFaces_data();
    void buriedSurface_touchingBoxes_isTheSharedFaces();
    void buriedSurface_ofOnePiece_isNone();
    void closest_manyThreads_giveTheSameAnswers();
    void surfaceQuery_emptyMesh_findsNothing();
};

void SurfaceQueryTest::closest_box_isExact() {
    const Eigen::Vector3f size(10, 20, 30);
    const TriangleMesh box = boxMesh(size.cast<double>());
    const SurfaceQuery query(box);
    for (const auto& place : randomPlaces(5000, 25)) {
        const ClosestPoint closest = query.closest(place);
        QVERIFY(closest.point.isValid());
        QVERIFY(std::abs(closest.distance - boxDistance(place, size)) < 1e-5F);
        QVERIFY(std::abs(closest.point.weights.sum() - 1) < 1e-6F);
        QVERIFY(closest.point.weights.minCoeff() >= 0);
        const float reached = (position(box, closest.point) - place).norm();
        QVERIFY(std::abs(reached - closest.distance) < 1e-5F);
    }
}

void SurfaceQueryTest::closest_sphere_isRadial() {
    const TriangleMesh sphere = sphereMesh(35, 200, 400);
    const SurfaceQuery query(sphere);
    for (const auto& place : randomPlaces(2000, 60)) {
        if (place.norm() < 5) {
            continue; // near the centre all directions are equally near
        }
        const ClosestPoint closest = query.closest(place);
        QVERIFY(std::abs(closest.distance - std::abs(place.norm() - 35)) < 0.01F);
        QVERIFY((position(sphere, closest.point) - place.normalized() * 35).norm() < 0.7F);
    }
}

void SurfaceQueryTest::closest_beyondTheGivenDistance_isInvalid() {
    const SurfaceQuery query(boxMesh({10, 10, 10}));
    QVERIFY(!query.closest({8, 0, 0}, 2.99F).point.isValid());
    QVERIFY(std::isinf(query.closest({8, 0, 0}, 2.99F).distance));
    QCOMPARE(query.closest({8, 0, 0}, 3.0F).distance, 3.0F);
    QVERIFY(isSame(query.closest({8, 1, 2}, 4), query.closest({8, 1, 2})));
}

void SurfaceQueryTest::closest_equallyNearTriangles_givesTheFirst() {
    const TriangleMesh box = boxMesh({10, 10, 10});
    const SurfaceQuery query(box);
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        std::uint32_t first = 0;
        while (std::count(box.triangles[first].begin(), box.triangles[first].end(), corner) == 0) {
            ++first;
        }
        QCOMPARE(query.closest(2 * box.positions[corner]).point.triangle, first);
    }
}

void SurfaceQueryTest::closest_degenerateTriangles_areIgnored() {
    TriangleMesh box = boxMesh({10, 10, 10});
    box.triangles.insert(box.triangles.begin(), {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}});
    const SurfaceQuery query(box);
    for (const auto& place : randomPlaces(500, 15)) {
        const ClosestPoint closest = query.closest(place);
        QVERIFY(std::abs(closest.distance - boxDistance(place, {10, 10, 10})) < 1e-5F);
        QVERIFY(closest.point.weights.allFinite());
    }
}

void SurfaceQueryTest::hit_box_isExact() {
    const TriangleMesh box = boxMesh({10, 20, 30});
    const SurfaceQuery query(box);
    const RayHit hit = query.hit({3, 40, -7}, {0, -2, 0});
    QVERIFY(hit.point.isValid());
    QCOMPARE(hit.distance, 15.0F); // in lengths of the direction
    QVERIFY(position(box, hit.point).isApprox(Eigen::Vector3f(3, 10, -7), 1e-5F));
    QVERIFY(!query.hit({3, 40, -7}, {0, 1, 0}).point.isValid());
    // Rays at an edge and at a corner hit, too.
    QVERIFY(query.hit({0, 40, 0}, {0, -1, 0}).point.isValid());
    QVERIFY(query.hit({50, 100, 150}, {-1, -2, -3}).point.isValid());
}

void SurfaceQueryTest::hit_beyondItsReach_isInvalid() {
    const SurfaceQuery query(boxMesh({10, 10, 10}));
    QVERIFY(!query.hit({0, 8, 0}, {0, -1, 0}, 2.9F).point.isValid());
    QVERIFY(query.hit({0, 8, 0}, {0, -1, 0}, 3.1F).point.isValid());
}

void SurfaceQueryTest::isInside_box_isExact() {
    const SurfaceQuery query(boxMesh({10, 10, 10}));
    for (const auto& place : randomPlaces(3000, 8)) {
        QCOMPARE(query.isInside(place), place.cwiseAbs().maxCoeff() < 5);
    }
    QVERIFY(query.isInside(Eigen::Vector3f::Zero()));
}

void SurfaceQueryTest::isInside_overlappingParts_areOneBody() {
    const TriangleMesh pair = test::joined(boxMesh({10, 10, 10}), boxMesh({6, 6, 20}));
    const SurfaceQuery query(pair);
    QVERIFY(query.isInside({0, 0, 0}));
    QVERIFY(query.isInside({0, 0, 8}));
    QVERIFY(query.isInside({4, 0, 0}));
    QVERIFY(!query.isInside({4, 0, 8}));
}

void SurfaceQueryTest::isInside_hollow_isFalse() {
    TriangleMesh shell = boxMesh({20, 20, 20});
    const TriangleMesh hollow = boxMesh({10, 10, 10});
    for (const auto& triangle : hollow.triangles) {
        shell.triangles.push_back({triangle[0] + 8, triangle[2] + 8, triangle[1] + 8});
    }
    shell.positions.insert(shell.positions.end(), hollow.positions.begin(), hollow.positions.end());
    const SurfaceQuery query(shell);
    QVERIFY(!query.isInside({0, 0, 0}));
    QVERIFY(query.isInside({7, 0, 0}));
    QVERIFY(!query.isInside({11, 0, 0}));
}

void SurfaceQueryTest::isInside_smallHole_keepsTheAnswer() {
    TriangleMesh sphere = sphereMesh(35, 30, 60);
    sphere.triangles.erase(sphere.triangles.begin(), sphere.triangles.begin() + 60);
    const SurfaceQuery query(sphere);
    for (const auto& place : randomPlaces(3000, 50)) {
        if (place.norm() < 32) {
            QVERIFY(query.isInside(place));
        } else if (place.norm() > 36) {
            QVERIFY(!query.isInside(place));
        }
    }
}

// The cap of a sphere that lies inside the other has the share h / (2 R) of it; h: its height.
void SurfaceQueryTest::buriedSurface_overlappingSpheres_isTheirCaps() {
    const double radius = 10, apart = 12;
    const TriangleMesh ball = sphereMesh(radius, 90, 180);
    const TriangleMesh pair = test::joined(ball, ball, {float(apart), 0, 0});
    const SurfaceQuery query(pair);
    const BuriedSurface buried;
    const double share = (radius - apart / 2) / (2 * radius);
    QVERIFY(std::abs(buried.share(pair, query) - share) < 0.003);
    for (std::uint32_t triangle = 0; triangle < pair.triangles.size(); ++triangle) {
        const float x = position(pair, middleOf(triangle)).x();
        const bool isFirst = triangle < ball.triangles.size();
        const float depth = isFirst ? x - float(apart / 2) : float(apart / 2) - x;
        if (std::abs(depth) > 0.1F) { // not on the line where the spheres meet
            QCOMPARE(buried.covers(middleOf(triangle), pair, query), depth > 0);
        }
    }
}

void SurfaceQueryTest::buriedSurface_touchingBoxes_isTheSharedFaces_data() {
    QTest::addColumn<float>("gap");
    QTest::addColumn<bool>("touches");
    QTest::newRow("flush") << 0.F << true;
    QTest::newRow("gap narrower than the reach") << 0.5F * buriedReach << true;
    QTest::newRow("overlap") << -0.5F * buriedReach << true;
    QTest::newRow("gap wider than the reach") << 2 * buriedReach << false;
}

void SurfaceQueryTest::buriedSurface_touchingBoxes_isTheSharedFaces() {
    QFETCH(float, gap);
    QFETCH(bool, touches);
    const Eigen::Vector3d size(10, 20, 30);
    const TriangleMesh box = boxMesh(size), pair = test::joined(box, box, {10 + gap, 0, 0});
    const double shared = size.y() * size.z() / surfaceArea(box);
    QVERIFY(std::abs(buriedShareOf(pair) - (touches ? shared : 0)) < 0.002);
}

void SurfaceQueryTest::buriedSurface_ofOnePiece_isNone() {
    QCOMPARE(buriedShareOf(sphereMesh(10, 60, 90)), 0.0);
    QCOMPARE(buriedShareOf(torusMesh(20, 5, 60, 60)), 0.0);
    TriangleMesh open = sphereMesh(10, 60, 90); // a bowl without thickness
    std::erase_if(open.triangles,
                  [&](const auto& corners) { return open.positions[corners[0]].y() > 1; });
    QCOMPARE(buriedShareOf(open), 0.0);
    for (auto& corners : open.triangles) { // its inner side
        std::swap(corners[1], corners[2]);
    }
    QCOMPARE(buriedShareOf(open), 0.0);
    const TriangleMesh box = boxMesh({20, 20, 20});
    for (int axis = 0; axis < 3; ++axis) { // a sheet that faces each side
        for (const float side : {-1.F, 1.F}) {
            TriangleMesh sheet = box;
            std::uint32_t number = 0;
            std::erase_if(sheet.triangles, [&](const auto&) {
                return triangleNormal(box, number++)[axis] * side < 0.5F;
            });
            QCOMPARE(sheet.triangles.size(), std::size_t(2));
            QCOMPARE(buriedShareOf(sheet), 0.0);
        }
    }
}

void SurfaceQueryTest::closest_manyThreads_giveTheSameAnswers() {
    const TriangleMesh sphere = sphereMesh(35, 60, 120);
    const auto places = randomPlaces(4000, 50);
    std::vector<ClosestPoint> alone;
    const SurfaceQuery query(sphere);
    for (const auto& place : places) {
        alone.push_back(query.closest(place));
    }
    std::vector<ClosestPoint> together(places.size());
    parallelFor(std::size_t(0), places.size(),
                [&](std::size_t i) { together[i] = query.closest(places[i]); });
    QVERIFY(std::equal(alone.begin(), alone.end(), together.begin(), isSame));
}

void SurfaceQueryTest::surfaceQuery_emptyMesh_findsNothing() {
    const SurfaceQuery query{TriangleMesh()};
    QVERIFY(!query.closest({0, 0, 0}).point.isValid());
    QVERIFY(!query.hit({0, 0, 0}, {0, 1, 0}).point.isValid());
    QVERIFY(!query.isInside({0, 0, 0}));
}

QTEST_APPLESS_MAIN(SurfaceQueryTest)
#include "SurfaceQueryTest.moc"
