// Tests several parts on one jig, each in its place and with its own colours.
#include "DippedByHand.h"

#include "base/Error.h"
#include "dip/JigModel.h"
#include "geometry/Shapes.h"

#include <QtTest>

using namespace dipwright;

namespace {

std::shared_ptr<const TexturedMesh> charted(TexturedMesh model) {
    model.chart = findCharts(model);
    return std::make_shared<const TexturedMesh>(std::move(model));
}

JigPart ball(const QString& name, QColor colour, double x, double height = 0) {
    JigPart part;
    part.model = charted(test::plainModel(sphereMesh(15, 20, 40), colour));
    part.placed.name = name;
    part.placed.offset[0] = Millimetres(x);
    part.height = Millimetres(height);
    return part;
}

} // namespace

class JigModelTest : public QObject {
    Q_OBJECT

private slots:
    void jigModel_twoParts_keepsPlacesAndNames() {
        const std::vector<JigPart> parts{ball("Left", Qt::red, -20),
                                         ball("Right", Qt::blue, 20, 7)};
        const TexturedMesh jig = jigModel(parts);
        const std::size_t half = parts[0].model->mesh.triangles.size();
        QCOMPARE(jig.mesh.triangles.size(), 2 * half);
        const BoundingBox box = boundingBox(jig.mesh);
        QVERIFY((box.min() - Eigen::Vector3f(-35, 0, -15)).norm() < 0.1f);
        QVERIFY((box.max() - Eigen::Vector3f(35, 37, 15)).norm() < 0.1f);
        QVERIFY(isClosed(jig.mesh));
        for (std::size_t triangle = 0; triangle < jig.mesh.triangles.size(); ++triangle) {
            const bool isLeft = cornersOf(jig.mesh, triangle)[0].x() < 0;
            QCOMPARE(isLeft, triangle < half);
            const QString name = jig.materials[jig.material[triangle]].name;
            QVERIFY2(name.startsWith(isLeft ? "Left: " : "Right: "), qPrintable(name));
        }
        QCOMPARE(jig.chart, findCharts(jig));
        QCOMPARE(jig.textures.size(), 2 * parts[0].model->textures.size());
    }

    // A mask names a material. It must not cover another part that has the same name.
    void jigModel_equalNames_areNumbered() {
        const TexturedMesh jig =
            jigModel({ball("K", Qt::red, -80), ball("K 2", Qt::red, -40), ball("K", Qt::red, 0),
                      ball("L", Qt::red, 40), ball("K", Qt::red, 80)});
        QStringList parts;
        for (const Material& material : jig.materials) {
            parts << material.name.section(QLatin1Char(':'), 0, 0);
        }
        QCOMPARE(parts, (QStringList{"K", "K 2", "K 3", "L", "K 4"}));
    }

    void jigModel_turnedPart_turnsAboutItsOwnCentre() {
        JigPart part;
        part.model = charted(test::plainModel(boxMesh({10, 20, 40}), Qt::white));
        part.placed.rotation[0] = Degrees(90);
        part.placed.offset = {Millimetres(100), Millimetres(-50)};
        const BoundingBox box = boundingBox(jigModel({part}).mesh);
        QVERIFY((box.sizes() - Eigen::Vector3f(10, 40, 20)).norm() < 1e-3f);
        QVERIFY((box.center() - Eigen::Vector3f(100, 20, -50)).norm() < 1e-3f);
    }

    void jigModel_partsOverlap_areRefused() {
        QVERIFY_EXCEPTION_THROWN(jigModel({ball("A", Qt::red, 0), ball("B", Qt::red, 20)}), Error);
        QVERIFY_EXCEPTION_THROWN(jigModel({}), Error);
    }
};

QTEST_MAIN(JigModelTest)
#include "JigModelTest.moc"
