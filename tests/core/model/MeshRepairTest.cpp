// Repairs of seams, duplicate triangles and inside-out parts, also for meshes made to take very
// long.
#include "model/MeshRepair.h"

#include "JoinedMeshes.h"
#include "base/Progress.h"
#include "geometry/Shapes.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace dipwright;

namespace {

constexpr int half = 300;

TexturedMesh textured(const std::vector<TriangleMesh>& parts) {
    TexturedMesh model;
    model.materials.resize(1);
    for (const TriangleMesh& part : parts) {
        model.mesh = test::joined(std::move(model.mesh), part);
    }
    model.textureCoordinates.resize(model.mesh.triangles.size());
    model.material.resize(model.mesh.triangles.size());
    return model;
}

TriangleMesh cube(double edge) {
    return boxMesh({edge, edge, edge});
}

TriangleMesh insideOut(TriangleMesh mesh) {
    for (auto& triangle : mesh.triangles) {
        std::swap(triangle[0], triangle[1]);
    }
    return mesh;
}

// Returns the mesh without the triangles whose corners all lie above `height`.
TriangleMesh cutOff(const TriangleMesh& mesh, float height) {
    TriangleMesh cut = mesh;
    std::erase_if(cut.triangles, [&](const auto& triangle) {
        return std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t corner) {
            return mesh.positions[corner].y() > height;
        });
    });
    return cut;
}

// Returns the mesh with separate corners for every triangle. Each corner is moved at random by up
// to `noise` in each direction.
TriangleMesh tornApart(const TriangleMesh& mesh, float noise) {
    TriangleMesh torn;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> off(-noise, noise);
    for (const auto& triangle : mesh.triangles) {
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = std::uint32_t(torn.positions.size());
            torn.positions.push_back(mesh.positions[triangle[i]] +
                                     Eigen::Vector3f(off(random), off(random), off(random)));
        }
        torn.triangles.push_back(corners);
    }
    return torn;
}

std::size_t turnedParts(const std::vector<TriangleMesh>& parts) {
    TexturedMesh model = textured(parts);
    return flipInsideOutParts(model, [] {});
}

// Nested cavities inside nested bodies.
std::vector<TriangleMesh> nested() {
    std::vector<TriangleMesh> boxes;
    for (int i = 0; i < half; ++i) {
        boxes.push_back(insideOut(cube(10 + 0.01 * i)));
        boxes.push_back(cube(20 + 0.01 * i));
    }
    return boxes;
}

} // namespace

class MeshRepairTest : public QObject {
    Q_OBJECT

private slots:
    void joinOpenSeams_roundingErrors_areJoined() {
        const TriangleMesh sphere = sphereMesh(35, 20, 40);
        TriangleMesh torn = tornApart(sphere, 1e-5F);
        weldPositions(torn);
        QVERIFY(joinOpenSeams(torn) > 0);
        QCOMPARE(torn.positions.size(), sphere.positions.size());
        QVERIFY(isClosed(torn));
    }

    // Two plates 0.01 mm apart, and a body that is closed already.
    void joinOpenSeams_fartherThanRounding_stay() {
        TriangleMesh plates = boxMesh({40, 0.01, 40});
        std::erase_if(plates.triangles, [&](const auto& triangle) {
            const float height = plates.positions[triangle[0]].y();
            return plates.positions[triangle[1]].y() != height ||
                   plates.positions[triangle[2]].y() != height;
        });
        QCOMPARE(plates.triangles.size(), std::size_t(4));
        const TriangleMesh untouched = plates;
        QCOMPARE(joinOpenSeams(plates), std::size_t(0));
        QCOMPARE(plates.positions, untouched.positions);
        TriangleMesh closed = boxMesh({40, 1e-5, 40});
        QCOMPARE(joinOpenSeams(closed), std::size_t(0));
    }

    void flipInsideOutParts_openInwardParts_areFlipped() {
        const TriangleMesh open = cutOff(sphereMesh(35, 20, 40), 25);
        QVERIFY(!isClosed(open));
        QCOMPARE(turnedParts({open}), std::size_t(0));
        QCOMPARE(turnedParts({insideOut(open)}), std::size_t(1));
        const TriangleMesh lidless = cutOff(boxMesh({40, 30, 20}), 14);
        QCOMPARE(turnedParts({lidless}), std::size_t(0));
        QCOMPARE(turnedParts({insideOut(lidless)}), std::size_t(1));
    }

    void flipInsideOutParts_flatSheetAndShallowBowl_stay() {
        TriangleMesh sheet = boxMesh({40, 1, 40});
        sheet.triangles.resize(2);
        QCOMPARE(turnedParts({sheet}), std::size_t(0));
        QCOMPARE(turnedParts({insideOut(sheet)}), std::size_t(0));
        const TriangleMesh bowl = cutOff(sphereMesh(35, 20, 40), -20);
        QCOMPARE(turnedParts({bowl}), std::size_t(0));
        QCOMPARE(turnedParts({insideOut(bowl)}), std::size_t(0));
    }

    // The surface of an open cavity in an open body faces the hollow and stays. A surface of
    // separate triangles is judged as a whole.
    void flipInsideOutParts_openCavitiesStay_looseTrianglesAreFlipped() {
        const TriangleMesh outer = cutOff(sphereMesh(35, 20, 40), 33);
        const TriangleMesh inner = cutOff(sphereMesh(20, 20, 40), 18);
        QCOMPARE(turnedParts({outer, insideOut(inner)}), std::size_t(0));
        QCOMPARE(turnedParts({insideOut(outer), inner}), std::size_t(2));
        const TriangleMesh loose = tornApart(sphereMesh(35, 110, 110), 0);
        QVERIFY(loose.triangles.size() > 20'000); // more parts than are judged one by one
        QCOMPARE(turnedParts({loose}), std::size_t(0));
        QCOMPARE(turnedParts({insideOut(loose)}), std::size_t(1));
    }

    void mergeDoubledTriangles_duplicates_areMerged() {
        const TriangleMesh sphere = sphereMesh(35, 20, 40);
        TexturedMesh model = textured({sphere, sphere});
        weldPositions(model.mesh);
        QCOMPARE(mergeDoubledTriangles(model), sphere.triangles.size());
        QVERIFY(isClosed(model.mesh));
        QVERIFY(std::abs(volume(model.mesh) - volume(sphere)) < 0.1);
        QCOMPARE(model.material.size(), sphere.triangles.size());
        QCOMPARE(mergeDoubledTriangles(model), std::size_t(0));
    }

    void mergeDoubledTriangles_bothSidesMerge_sharedWallStays() {
        const TriangleMesh box = boxMesh({20, 20, 20});
        TexturedMesh model = textured({insideOut(box), box});
        weldPositions(model.mesh);
        QCOMPARE(mergeDoubledTriangles(model), box.triangles.size());
        QVERIFY(isClosed(model.mesh));

        TriangleMesh beside = box;
        for (auto& position : beside.positions) {
            position.x() += 20;
        }
        TexturedMesh walled = textured({box, beside});
        weldPositions(walled.mesh);
        QCOMPARE(mergeDoubledTriangles(walled), std::size_t(0));
    }

    void flipInsideOutParts_nestedCavities_stayAndReportProgress() {
        TexturedMesh model = textured(nested());
        int asked = 0;
        QCOMPARE(flipInsideOutParts(model, [&] { ++asked; }), std::size_t(0));
        QCOMPARE(asked, half * 12);
        QCOMPARE(model.mesh.triangles, textured(nested()).mesh.triangles);
    }

    void removeEnclosedParts_onlyClosedOnesInsideParts_areRemoved() {
        const auto removed = [](const std::vector<TriangleMesh>& parts) {
            TexturedMesh model = textured(parts);
            return removeEnclosedParts(model, [] {});
        };
        const TriangleMesh ball = sphereMesh(35, 20, 40), hollow = insideOut(cube(10));
        QCOMPARE(removed({ball, hollow}), hollow.triangles.size());
        QCOMPARE(removed({ball}), std::size_t(0));
        QCOMPARE(removed({sphereMesh(5, 20, 40), hollow}), std::size_t(0)); // not inside
        QCOMPARE(removed({cutOff(ball, 25), hollow}), std::size_t(0));      // water may enter
        // Bodies that face outwards are not seen either, wherever they are in the order of parts.
        const TriangleMesh inner = cube(10);
        QCOMPARE(removed({ball, inner}), inner.triangles.size());
        QCOMPARE(removed({inner, ball}), inner.triangles.size());
        QCOMPARE(removed({ball, hollow, cube(5)}), 2 * inner.triangles.size()); // in the cavity
        QCOMPARE(removed({cube(20), boxMesh({19, 19, 21})}), std::size_t(0));   // sticks out
        QCOMPARE(removed({cube(20), boxMesh({19, 19, 20})}), std::size_t(0));   // flush
        QCOMPARE(removed({torusMesh(30, 10, 40, 20), inner}), std::size_t(0));  // in the hole
        // A plate inside a thick torus closes its hole, like glass in a window. Only the middle of
        // the plate's faces meets the torus.
        TriangleMesh glass = boxMesh({50, 4, 50});
        for (Eigen::Vector3f& position : glass.positions) {
            position.x() += 8;
        }
        QCOMPARE(removed({torusMesh(30, 25, 80, 80), glass}), std::size_t(0));
    }

    void flipInsideOutParts_cancelled_leavesTheMesh() {
        std::vector<TriangleMesh> parts = nested();
        parts.push_back(insideOut(cube(40))); // this one would be flipped
        TexturedMesh model = textured(parts);
        const auto before = model.mesh.triangles;
        int asked = 0;
        const auto goOn = [&] {
            if (++asked == 100) {
                throw Cancelled();
            }
        };
        QVERIFY_EXCEPTION_THROWN(flipInsideOutParts(model, goOn), Cancelled);
        QCOMPARE(asked, 100);
        QCOMPARE(model.mesh.triangles, before);
    }
};

QTEST_GUILESS_MAIN(MeshRepairTest)
#include "MeshRepairTest.moc"
