// Repairs that files could be made for to take without end.
#include "model/MeshRepair.h"

#include "base/Progress.h"
#include "geometry/Shapes.h"

#include <QtTest>

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

} // namespace

class MeshRepairTest : public QObject {
    Q_OBJECT

private slots:
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
