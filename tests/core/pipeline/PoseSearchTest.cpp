// The pose search, on a body whose best poses are plain to see: a board on its edge.
#include "pipeline/PoseSearch.h"
#include "base/Error.h"
#include "geometry/Shapes.h"

#include <QStandardPaths>
#include <QtTest>

using namespace dipwright;

namespace {

// 6 × 40 × 40 mm, its broad faces towards ±X.
Project boardJob() {
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = boxMesh({6, 40, 40});
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    const Eigen::Vector2f noCoordinate(none, none);
    model->textureCoordinates.resize(model->mesh.triangles.size(),
                                     {noCoordinate, noCoordinate, noCoordinate});
    model->material.resize(model->mesh.triangles.size(), 0);
    model->materials.resize(1);
    model->chart = findCharts(*model);
    Project project;
    project.model = model;
    project.film.width = project.film.height = Millimetres(100);
    project.film.columns = project.film.rows = 37;
    return project;
}

// The body's direction that points down in this immersion.
Eigen::Vector3d downOf(const Project& project, const Immersion& immersion) {
    return poseTransform(project.model->mesh, immersion).linear().transpose() *
           -Eigen::Vector3d::UnitY();
}

} // namespace

class PoseSearchTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        registry_ = std::make_unique<SolverRegistry>(QStringList{DIPWRIGHT_PLUGINS});
        project_ = boardJob();
        options_.candidates = 6; // the sides of the box
        pairs_ = search(2);
    }

    void oneDipGoesInEdgeFirst() {
        const auto ranking = search(1);
        QVERIFY(!ranking.empty() && ranking.size() <= 10);
        QCOMPARE(ranking[0].immersions.size(), 1U);
        // So that film rolls on to both broad faces.
        QVERIFY(std::abs(downOf(project_, ranking[0].immersions[0]).x()) < 0.02);
        QVERIFY(ranking[0].coverage > 0.6);
    }

    void twoDipsPaintBothBroadFaces() {
        const RankedPoses& best = pairs_[0];
        QCOMPARE(best.immersions.size(), 2U);
        const Eigen::Vector3d first = downOf(project_, best.immersions[0]);
        const Eigen::Vector3d second = downOf(project_, best.immersions[1]);
        QVERIFY2(first.dot(second) < -0.98, "from opposite sides");
        QVERIFY(std::abs(first.x()) > 0.99);
        QVERIFY(best.coverage > 0.8);
        QVERIFY(best.immersions[0].name != best.immersions[1].name);
    }

    void theRankingFallsAndIsTheSameEveryTime() {
        const auto again = search(2);
        QCOMPARE(again.size(), pairs_.size());
        for (std::size_t rank = 0; rank < pairs_.size(); ++rank) {
            QCOMPARE(again[rank].quality, pairs_[rank].quality);
            QVERIFY(again[rank].immersions == pairs_[rank].immersions);
            QVERIFY(pairs_[rank].quality <= pairs_[rank].coverage);
            QVERIFY(rank == 0 || pairs_[rank].quality <= pairs_[rank - 1].quality);
        }
    }

    void aCancelledSearchThrows() {
        Progress progress;
        progress.cancelSwitch.cancel();
        QVERIFY_EXCEPTION_THROWN(
            searchPoses(project_, registry_->module("auto"), options_, progress), Cancelled);
    }

    void stretchedAndGatheredFilmShowsLess() {
        QCOMPARE(printQuality(1, 1), 1.0);
        QCOMPARE(printQuality(1.2, 0.7), 1.0);
        QVERIFY(printQuality(1.5, 1) > printQuality(2, 1));
        QVERIFY(printQuality(1, 0.6) > printQuality(1, 0.4));
        QCOMPARE(printQuality(3, 1), 0.0);
        QCOMPARE(printQuality(1, 0.1), 0.0);
    }

private:
    std::vector<RankedPoses> search(int immersions) {
        options_.immersions = immersions;
        return searchPoses(project_, registry_->module("auto"), options_, {});
    }

    std::unique_ptr<SolverRegistry> registry_;
    Project project_;
    PoseSearchOptions options_;
    std::vector<RankedPoses> pairs_;
};

QTEST_GUILESS_MAIN(PoseSearchTest)
#include "PoseSearchTest.moc"
