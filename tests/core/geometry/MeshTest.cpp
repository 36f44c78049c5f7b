// Meshes and shapes, compared with their closed forms.
#include "base/Units.h"
#include "geometry/Shapes.h"
#include "geometry/Solid.h"
#include "geometry/SurfaceSamples.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace dipwright;

namespace {

// Whether every triangle of a star-shaped body faces away from the place `centre` inside it.
bool looksOutwards(const TriangleMesh& mesh, const Eigen::Vector3f& centre) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Eigen::Vector3f corner = mesh.positions[mesh.triangles[t][0]];
        if (triangleNormal(mesh, t).dot(corner - centre) <= 0) {
            return false;
        }
    }
    return true;
}

} // namespace

class MeshTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void shapes_areClosedAndFaceOutwards();
    void sphereMesh_volumeAndArea_matchClosedForm();
    void boxMesh_volumeAreaAndExtent_matchClosedForm();
    void coneMesh_apex_isAtY0();
    void cylinderMesh_liesAlongZ();
    void tetrahedronMesh_isRegular();
    void volume_farFromTheOrigin_isTheSame();
    void isClosed_triangleRemoved_isFalse();
    void isClosed_triangleFlipped_isFalse();
    void boundsSolid_boxesThatTouchAtAnEdge_isTrue();
    void oppositeEdges_sharedEdge_findsTheNeighbour();
    void evenSamples_bodyWithoutArea_isEmpty();
    void vertexNormals_sphere_areRadial();
    void transformed_movesPositions();
    void surfacePoint_interpolatesPositions();
    void evenSamples_sphere_coverTheSurfaceEvenly();
};

void MeshTest::shapes_areClosedAndFaceOutwards() {
    for (const TriangleMesh& mesh :
         {sphereMesh(35, 12, 24), ellipsoidMesh({10, 20, 30}, 9, 15), boxMesh({10, 20, 30}),
          cylinderMesh(10, 40, 32), tetrahedronMesh(60)}) {
        QVERIFY(isClosed(mesh));
        QVERIFY(looksOutwards(mesh, Eigen::Vector3f::Zero()));
    }
    const TriangleMesh cone = coneMesh(pi / 6, 40, 32);
    QVERIFY(isClosed(cone));
    QVERIFY(looksOutwards(cone, {0, 30, 0}));
    const TriangleMesh torus = torusMesh(30, 10, 200, 400);
    QVERIFY(isClosed(torus));
    QVERIFY(std::abs(volume(torus) / (2 * pi * pi * 30 * 100) - 1) < 1e-3); // > 0: outwards
    QVERIFY(std::abs(boundingBox(torus).max().x() - 40) < 1e-4F);
    QVERIFY(std::abs(boundingBox(torus).min().y() + 10) < 1e-4F);
}

void MeshTest::sphereMesh_volumeAndArea_matchClosedForm() {
    const TriangleMesh sphere = sphereMesh(35, 160, 320);
    QCOMPARE(sphere.positions.size(), std::size_t(2 + 159 * 320));
    QVERIFY(std::abs(volume(sphere) / (4 * pi / 3 * std::pow(35, 3)) - 1) < 1e-3);
    QVERIFY(std::abs(surfaceArea(sphere) / (4 * pi * 35 * 35) - 1) < 1e-3);
    QVERIFY(sphere.positions.front().isApprox(Eigen::Vector3f(0, 35, 0)));
    QVERIFY(sphere.positions.back().isApprox(Eigen::Vector3f(0, -35, 0)));
}

void MeshTest::boxMesh_volumeAreaAndExtent_matchClosedForm() {
    const TriangleMesh box = boxMesh({10, 20, 30});
    QCOMPARE(volume(box), 6000.0);
    QCOMPARE(surfaceArea(box), 2200.0);
    QVERIFY(boundingBox(box).min().isApprox(Eigen::Vector3f(-5, -10, -15)));
    QVERIFY(boundingBox(box).max().isApprox(Eigen::Vector3f(5, 10, 15)));
}

void MeshTest::coneMesh_apex_isAtY0() {
    const TriangleMesh cone = coneMesh(pi / 4, 40, 400);
    QVERIFY(std::abs(volume(cone) / (pi * 40 * 40 * 40 / 3) - 1) < 1e-3);
    const BoundingBox box = boundingBox(cone);
    QCOMPARE(box.min().y(), 0.0F);
    QCOMPARE(box.max().y(), 40.0F);
    QVERIFY(std::abs(box.max().z() - 40) < 1e-4F);
}

void MeshTest::cylinderMesh_liesAlongZ() {
    const TriangleMesh cylinder = cylinderMesh(10, 40, 400);
    QVERIFY(std::abs(volume(cylinder) / (pi * 100 * 40) - 1) < 1e-3);
    QCOMPARE(boundingBox(cylinder).max().z(), 20.0F);
    QCOMPARE(boundingBox(cylinder).min().z(), -20.0F);
}

void MeshTest::tetrahedronMesh_isRegular() {
    const TriangleMesh tetrahedron = tetrahedronMesh(60);
    Eigen::Vector3f centroid = Eigen::Vector3f::Zero();
    for (std::size_t a = 0; a < 4; ++a) {
        centroid += tetrahedron.positions[a];
        for (std::size_t b = 0; b < a; ++b) {
            const float edge = (tetrahedron.positions[a] - tetrahedron.positions[b]).norm();
            QVERIFY(std::abs(edge - 60) < 1e-4F);
        }
    }
    QVERIFY(centroid.norm() < 1e-4F);
    QVERIFY(std::abs(volume(tetrahedron) - 60 * 60 * 60 / (6 * std::sqrt(2.0))) < 0.01);
}

void MeshTest::volume_farFromTheOrigin_isTheSame() {
    Eigen::Isometry3d away = Eigen::Isometry3d::Identity();
    away.translation() = Eigen::Vector3d(4096, -8192, 2048);
    QCOMPARE(volume(transformed(boxMesh({10, 20, 30}), away)), 6000.0);
}

void MeshTest::isClosed_triangleRemoved_isFalse() {
    TriangleMesh box = boxMesh({10, 10, 10});
    box.triangles.pop_back();
    QVERIFY(!isClosed(box));
    QVERIFY(!isClosed(TriangleMesh()));
}

void MeshTest::isClosed_triangleFlipped_isFalse() {
    TriangleMesh box = boxMesh({10, 10, 10});
    std::swap(box.triangles[3][0], box.triangles[3][1]);
    QVERIFY(!isClosed(box));
}

void MeshTest::boundsSolid_boxesThatTouchAtAnEdge_isTrue() {
    TriangleMesh boxes = boxMesh({10, 10, 10});
    const std::vector<Eigen::Vector3f> first = boxes.positions;
    for (const Eigen::Vector3f& position : first) {
        boxes.positions.push_back(position + Eigen::Vector3f(10, 10, 0));
    }
    const auto indexOf = [&](std::uint32_t corner) { // points at one place are one point
        const auto place =
            std::find(boxes.positions.begin(), boxes.positions.end(), boxes.positions[corner]);
        return std::uint32_t(place - boxes.positions.begin());
    };
    const auto ofFirst = boxes.triangles;
    const auto count = std::uint32_t(first.size());
    for (const auto& [a, b, c] : ofFirst) {
        boxes.triangles.push_back({indexOf(a + count), indexOf(b + count), indexOf(c + count)});
    }
    QVERIFY(!isClosed(boxes) && boundsSolid(boxes));
    boxes.triangles.pop_back();
    QVERIFY(!boundsSolid(boxes));
    QVERIFY(!boundsSolid(TriangleMesh()));
}

void MeshTest::oppositeEdges_sharedEdge_findsTheNeighbour() {
    const TriangleMesh box = boxMesh({10, 10, 10});
    const auto opposite = oppositeEdges(box);
    for (std::uint32_t edge = 0; edge < opposite.size(); ++edge) {
        QVERIFY(opposite[edge] != noEdge);
        QCOMPARE(opposite[opposite[edge]], edge);
        const auto& here = box.triangles[edge / 3];
        const auto& there = box.triangles[opposite[edge] / 3];
        QCOMPARE(here[edge % 3], there[(opposite[edge] + 1) % 3]);
    }
    // Three triangles share one edge, so that none has a unique other side.
    TriangleMesh book;
    book.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0}};
    book.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
    for (const auto other : oppositeEdges(book)) {
        QCOMPARE(other, noEdge);
    }
}

void MeshTest::vertexNormals_sphere_areRadial() {
    const TriangleMesh sphere = sphereMesh(35, 40, 80);
    const auto normals = vertexNormals(sphere);
    for (std::size_t v = 0; v < normals.size(); ++v) {
        QVERIFY(normals[v].dot(sphere.positions[v].normalized()) > 0.999F);
    }
}

void MeshTest::transformed_movesPositions() {
    Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
    turn.rotate(Eigen::AngleAxisd(pi / 2, Eigen::Vector3d::UnitZ()));
    turn.pretranslate(Eigen::Vector3d(1, 2, 3));
    const TriangleMesh box = transformed(boxMesh({10, 20, 30}), turn);
    QVERIFY(boundingBox(box).min().isApprox(Eigen::Vector3f(-9, -3, -12), 1e-5F));
    QVERIFY(boundingBox(box).max().isApprox(Eigen::Vector3f(11, 7, 18), 1e-5F));
    QVERIFY(isClosed(box));
}

void MeshTest::surfacePoint_interpolatesPositions() {
    const TriangleMesh box = boxMesh({10, 10, 10});
    const auto& corners = box.triangles[0];
    const Eigen::Vector3f middle =
        (box.positions[corners[0]] + box.positions[corners[1]] + box.positions[corners[2]]) / 3;
    const SurfacePoint point{0, Eigen::Vector3f::Constant(1.0F / 3)};
    QVERIFY(point.isValid());
    QVERIFY(position(box, point).isApprox(middle, 1e-5F));
    QVERIFY(!SurfacePoint().isValid());
}

void MeshTest::evenSamples_sphere_coverTheSurfaceEvenly() {
    const TriangleMesh sphere = sphereMesh(20, 20, 40);
    constexpr double area = 1;
    const std::vector<SurfacePoint> samples = evenSamples(sphere, area);
    QVERIFY(std::abs(double(samples.size()) * area - surfaceArea(sphere)) <= area);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    qsizetype above = 0;
    for (const SurfacePoint& sample : samples) {
        QVERIFY(sample.weights.minCoeff() >= 0);
        const Eigen::Vector3d place = position(sphere, sample).cast<double>();
        sum += place;
        above += place.y() > 10 ? 1 : 0;
    }
    const auto count = double(samples.size());
    QVERIFY((sum / count).norm() < 0.1);
    QVERIFY2(std::abs(double(above) / count - 0.25) < 0.01,
             "the share of samples on the cap is not within 0.01 of 0.25");
}

void MeshTest::evenSamples_bodyWithoutArea_isEmpty() {
    TriangleMesh line;
    line.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    line.triangles = {{0, 1, 2}, {0, 2, 1}};
    QVERIFY(evenSamples(line, surfaceArea(line) / 1000).empty());
    QCOMPARE(evenSamples(sphereMesh(10, 20, 10), 1e9).size(), std::size_t(0));
}

QTEST_APPLESS_MAIN(MeshTest)
#include "MeshTest.moc"
