// Finds the separate bodies of models.
#include "model/SeparateBodies.h"

#include "JoinedMeshes.h"
#include "geometry/Shapes.h"

#include <QtTest>

using namespace dipwright;

namespace {

// Returns boxes with these widths, middles along X and materials.
TexturedMesh boxes(const std::vector<std::tuple<double, float, QString>>& parts) {
    TexturedMesh model;
    for (const auto& [width, middle, material] : parts) {
        model.mesh = test::joined(model.mesh, boxMesh({width, 10, 10}), {middle, 0, 0});
        model.material.resize(model.mesh.triangles.size(), std::uint16_t(model.materials.size()));
        model.materials.push_back({material});
    }
    return model;
}

} // namespace

class SeparateBodiesTest : public QObject {
    Q_OBJECT

private slots:
    void separateBodies_apart_areNamedByPartOrPlace() {
        const auto bodies = separateBodies(boxes({{10, 0, "Knob: brass"},
                                                  {10, 20, ""},
                                                  {10, 40, "Lid"},
                                                  {10, -30, "Foot"},
                                                  {10, -60, "Foot"}}));
        QVERIFY(bodies);
        QCOMPARE(bodies->names, QStringList({"Knob", "The body at X 20.0, Y 0.0, Z 0.0 mm", "Lid",
                                             "The body at X −30.0, Y 0.0, Z 0.0 mm",
                                             "The body at X −60.0, Y 0.0, Z 0.0 mm"}));
        QCOMPARE(bodies->ofTriangle.size(), std::size_t(60));
        for (std::size_t t = 0; t < 60; ++t) {
            QCOMPARE(bodies->ofTriangle[t], std::uint32_t(t / 12));
        }
    }

    // The first and the last touch only the second.
    void separateBodies_overlapping_areOne() {
        QVERIFY(!separateBodies(boxes({{10, 0, "A"}, {30, 15, "B"}, {10, 32, "C"}})));
        QVERIFY(!separateBodies(boxes({{10, 0, "A"}})));
        const auto two = separateBodies(boxes({{10, 0, "A"}, {10, 50, "C"}, {30, 15, "B"}}));
        QVERIFY(two);
        QCOMPARE(two->names.size(), 2);
        QCOMPARE(two->names[1], QStringLiteral("C"));
    }
};

QTEST_GUILESS_MAIN(SeparateBodiesTest)
#include "SeparateBodiesTest.moc"
