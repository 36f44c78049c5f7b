// Compares the production film on the CPU with the reference solver.
#include "ProductionDips.h"
#include "TestFolders.h"
#include "WholeSample.h"
#include "film/FilmGrid.h"
#include "geometry/Shapes.h"
#include "model/TexturedMesh.h"
#include "production/reference/ReferenceFilm.h"
#include "project/Project.h"
#include "project/ProjectStore.h"

#include <QTest>

using namespace dipwright;
using namespace dipwright::test;

namespace {

Body turtle() {
    const Project project = loadProject(sampleFolder("/turtle.dipw"));
    return {
        posedBody(project.model->mesh, project.immersions.front()),
        std::make_shared<const DistanceField>(buildDistanceField(project.model->mesh, 128, {}))};
}

} // namespace

class ProductionReferenceTest : public QObject {
    Q_OBJECT

private slots:
    void productionFilm_dip_agreesWithTheReference_data();
    void productionFilm_dip_agreesWithTheReference();
};

void ProductionReferenceTest::productionFilm_dip_agreesWithTheReference_data() {
    QTest::addColumn<int>("which");
    QTest::addColumn<double>("growth"); // 1/s
    QTest::addColumn<bool>("held");
    QTest::newRow("turtle") << 2 << 0.0 << false;
    QTest::newRow("sphere, growing film held at one side") << 0 << 0.02 << true;
    if (isWholeRun()) {
        QTest::newRow("sphere") << 0 << 0.0 << false;
        QTest::newRow("cone") << 1 << 0.0 << false;
        QTest::newRow("sphere, growing film") << 0 << 0.02 << false;
    }
}

void ProductionReferenceTest::productionFilm_dip_agreesWithTheReference() {
    QFETCH(int, which);
    QFETCH(double, growth);
    QFETCH(bool, held);
    const Body body = which == 0   ? bodyOf(sphereMesh(35, 128, 256))
                      : which == 1 ? bodyOf(coneMesh(pi / 4, 40, 256))
                                   : turtle();
    solver::DipSetup setup = squareDip(body, 61, which == 2 ? 12 : 30);
    setup.settings.growthRate = growth;
    setup.settings.growthLimit = 0.2;
    if (held) {
        setup.pinned = pinnedPoints({.leftPinned = true}, setup.film);
    }
    const Ending fast = dipOnCpu(setup);
    const Ending exact = dip(*reference::makeReferenceFilm(), setup);
    int differing = 0;
    for (std::size_t point = 0; point < fast.states.size(); ++point) {
        differing += fast.states[point] != exact.states[point];
    }
    const auto [percentile95, largest] = difference(fast, exact, 1);
    qInfo("95 %% within %g mm, all within %g mm; %d points adhered in one film only", percentile95,
          largest, differing);
    QVERIFY(largest <= 0.02);
    QVERIFY(differing <= 2); // these points nearly touch the body at the end of the dip
}

QTEST_GUILESS_MAIN(ProductionReferenceTest)
#include "ProductionReferenceTest.moc"
