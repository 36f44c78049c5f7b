// Repairs of meshes: of seams, doubled triangles and parts inside out, and those that files could be
// made for to take without end.
#include "model/MeshRepair.h"

#include "base/Progress.h"
#include "geometry/Shapes.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace dipwright;

namespace {

constexpr int half = 300;

void add(TexturedMesh& model, double edge, bool turned) {
    const TriangleMesh box = boxMesh({edge, edge, edge});
    const auto first = std::uint32_t(model.mesh.positions.size());
    model.mesh.positions.insert(model.mesh.positions.end(), box.positions.begin(),
                                box.positions.end());
    for (const auto& [a, b, c] : box.triangles) {
        const std::uint32_t second = turned ? c : b, third = turned ? b : c;
        model.mesh.triangles.push_back({first + a, first + second, first + third});
        model.textureCoordinates.emplace_back();
        model.material.push_back(0);
    }
}

// Cavities in one another, in bodies in one another.
TexturedMesh nested() {
    TexturedMesh model;
    model.materials.resize(1);
    for (int i = 0; i < half; ++i) {
        add(model, 10 + 0.01 * i, true);
        add(model, 20 + 0.01 * i, false);
    }
    return model;
}

TexturedMesh textured(const TriangleMesh& mesh) {
    TexturedMesh model;
    model.materials.resize(1);
    model.mesh = mesh;
    model.textureCoordinates.resize(mesh.triangles.size());
    model.material.resize(mesh.triangles.size());
    return model;
}

TriangleMesh insideOut(TriangleMesh mesh) {
    for (auto& triangle : mesh.triangles) {
        std::swap(triangle[0], triangle[1]);
    }
    return mesh;
}

// Without the triangles that lie higher than this with all their corners.
TriangleMesh cutOff(const TriangleMesh& mesh, float height) {
    TriangleMesh cut = mesh;
    std::erase_if(cut.triangles, [&](const auto& triangle) {
        return std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t corner) {
            return mesh.positions[corner].y() > height;
        });
    });
    return cut;
}

// Every triangle with corners of its own, each of them moved by as much as `noise` in each
// direction.
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

std::size_t turnedParts(const TriangleMesh& mesh) {
    TexturedMesh model = textured(mesh);
    return turnInsideOutParts(model, [] {});
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
    TriangleMesh both = a;
    const auto first = std::uint32_t(a.positions.size());
    both.positions.insert(both.positions.end(), b.positions.begin(), b.positions.end());
    for (const auto& triangle : b.triangles) {
        both.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
    }
    return both;
}

} // namespace

class MeshRepairTest : public QObject {
    Q_OBJECT

private slots:
    void seamsThatRoundingOpenedAreJoined() {
        const TriangleMesh sphere = sphereMesh(35, 20, 40);
        TriangleMesh torn = tornApart(sphere, 1e-5F);
        weldPositions(torn);
        QVERIFY(joinOpenSeams(torn) > 0);
        QCOMPARE(torn.positions.size(), sphere.positions.size());
        QVERIFY(isClosed(torn));
    }

    // Two plates a hundredth of a millimetre apart, and what is closed anyway.
    void whatLiesFartherApartThanRoundingStays() {
        TriangleMesh plates = cutOff(boxMesh({40, 0.01, 40}), -1);
        plates.triangles.resize(4);
        TriangleMesh untouched = plates;
        QCOMPARE(joinOpenSeams(plates), std::size_t(0));
        QCOMPARE(plates.positions, untouched.positions);
        TriangleMesh closed = boxMesh({40, 1e-5, 40});
        QCOMPARE(joinOpenSeams(closed), std::size_t(0));
    }

    void openPartsThatFaceInwardsAreTurned() {
        const TriangleMesh open = cutOff(sphereMesh(35, 20, 40), 25);
        QVERIFY(!isClosed(open));
        QCOMPARE(turnedParts(open), std::size_t(0));
        QCOMPARE(turnedParts(insideOut(open)), std::size_t(1));
        const TriangleMesh lidless = cutOff(boxMesh({40, 30, 20}), 14);
        QCOMPARE(turnedParts(lidless), std::size_t(0));
        QCOMPARE(turnedParts(insideOut(lidless)), std::size_t(1));
    }

    void aFlatSheetAndAShallowBowlStayAsTheyAre() {
        TriangleMesh sheet = boxMesh({40, 1, 40});
        sheet.triangles.resize(2);
        QCOMPARE(turnedParts(sheet), std::size_t(0));
        QCOMPARE(turnedParts(insideOut(sheet)), std::size_t(0));
        const TriangleMesh bowl = cutOff(sphereMesh(35, 20, 40), -20);
        QCOMPARE(turnedParts(bowl), std::size_t(0));
        QCOMPARE(turnedParts(insideOut(bowl)), std::size_t(0));
    }

    // An open cavity of an open body faces the hollow; a surface of which no two triangles hang
    // together is judged by all of them.
    void openCavitiesStayAndLooseTrianglesAreTurned() {
        const TriangleMesh outer = cutOff(sphereMesh(35, 20, 40), 33);
        const TriangleMesh inner = cutOff(sphereMesh(20, 20, 40), 18);
        QCOMPARE(turnedParts(joined(outer, insideOut(inner))), std::size_t(0));
        QCOMPARE(turnedParts(joined(insideOut(outer), inner)), std::size_t(2));
        const TriangleMesh loose = tornApart(sphereMesh(35, 110, 110), 0);
        QVERIFY(loose.triangles.size() > 20'000); // more parts than are asked one by one
        QCOMPARE(turnedParts(loose), std::size_t(0));
        QCOMPARE(turnedParts(insideOut(loose)), std::size_t(1));
    }

    void trianglesGivenTwiceAreMerged() {
        const TriangleMesh sphere = sphereMesh(35, 20, 40);
        TexturedMesh model = textured(joined(sphere, sphere));
        weldPositions(model.mesh);
        QCOMPARE(mergeDoubledTriangles(model), sphere.triangles.size());
        QVERIFY(isClosed(model.mesh));
        QVERIFY(std::abs(volume(model.mesh) - volume(sphere)) < 0.1);
        QCOMPARE(model.material.size(), sphere.triangles.size());
        QCOMPARE(mergeDoubledTriangles(model), std::size_t(0));
    }

    void aSurfaceGivenFromBothSidesBecomesOneAndAWallStays() {
        const TriangleMesh box = boxMesh({20, 20, 20});
        TexturedMesh model = textured(joined(insideOut(box), box));
        weldPositions(model.mesh);
        QCOMPARE(mergeDoubledTriangles(model), box.triangles.size());
        QVERIFY(isClosed(model.mesh));

        TriangleMesh beside = box;
        for (auto& position : beside.positions) {
            position.x() += 20;
        }
        TexturedMesh walled = textured(joined(box, beside));
        weldPositions(walled.mesh);
        QCOMPARE(mergeDoubledTriangles(walled), std::size_t(0));
    }

    void nestedCavitiesStayAndEachOfThemIsAskedAbout() {
        TexturedMesh model = nested();
        int asked = 0;
        QCOMPARE(turnInsideOutParts(model, [&] { ++asked; }), std::size_t(0));
        QCOMPARE(asked, half * 12);
        QCOMPARE(model.mesh.triangles, nested().mesh.triangles);
    }

    void theSearchForPartsInsideOutCanBeEnded() {
        TexturedMesh model = nested();
        add(model, 40, true); // which would be turned
        const auto before = model.mesh.triangles;
        int asked = 0;
        const auto goOn = [&] {
            if (++asked == 100) {
                throw Cancelled();
            }
        };
        QVERIFY_EXCEPTION_THROWN(turnInsideOutParts(model, goOn), Cancelled);
        QCOMPARE(asked, 100);
        QCOMPARE(model.mesh.triangles, before);
    }
};

QTEST_GUILESS_MAIN(MeshRepairTest)
#include "MeshRepairTest.moc"
