// Tests which dips of a search remain when it ends early, the verdict on what they leave bare, and
// the surface that counts.
#include "search/PoseDips.h"
#include "DippedByHand.h"
#include "JoinedMeshes.h"
#include "SearchSubjects.h"
#include "TestFolders.h"
#include "base/Error.h"
#include "solver/SolverRegistry.h"

#include <QStandardPaths>
#include <QtTest>

#include <algorithm>

using namespace dipwright;

namespace {

constexpr std::size_t batchSize = 32; // of small films

// Returns poses turned about the vertical.
std::vector<Immersion> turned(std::size_t count) {
    std::vector<Immersion> immersions(count);
    for (std::size_t index = 0; index < count; ++index) {
        immersions[index].rotation[1] = Degrees(double(index));
    }
    return immersions;
}

struct Judged {
    double area = 0, coverage = 0; // mm², share
};

// Judges the body with film under the whole bottom of a box of this size.
Judged judgedOn(const TriangleMesh& mesh, const Eigen::Vector3d& size) {
    const SearchSubject subject = subjectOf(mesh);
    const JudgedBody body(subject, {1, 1, 1}, SurfaceColours(*subject.model));
    const DippedFilm film =
        test::flatUnderBox({61, 61, 60, 60}, size + Eigen::Vector3d(0.1, 0, 0.1));
    const JudgedPose pose = body.judged(*test::laid(mesh, film), {});
    return {body.equator() * body.equator() / pi, body.measures({&pose})[Measure::Coverage]};
}

std::size_t doneOf(const std::vector<std::shared_ptr<const JudgedPose>>& judged) {
    return std::size_t(std::count_if(judged.begin(), judged.end(),
                                     [](const auto& pose) { return pose != nullptr; }));
}

} // namespace

class PoseDipsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        registry_ = std::make_unique<SolverRegistry>(QStringList{pluginFolder()});
    }

    void unpainted_onlyTwoDipsMustReachTheWholeBody() {
        JudgedPose half;
        half.samples.resize(body_.places() / 2);
        half.samples.resize(body_.places(), {4096, 4096, 0});
        body_.complete(half);
        const auto adviceOn = [&](const std::vector<const JudgedPose*>& dips, double limit) {
            VerdictSettings limits;
            limits.unreached = limit;
            return body_.unpainted(dips, body_.measures(dips), limits).advice;
        };
        QCOMPARE(adviceOn({&half}, 0.05), Advice::Print);
        QCOMPARE(adviceOn({&half, &half}, 0.6), Advice::Print);
        QCOMPARE(adviceOn({&half, &half}, 0.4), Advice::CheckFirst);
        QCOMPARE(adviceOn({&half, &half}, 0.05), Advice::DoNotPrint);
    }

    void judged_flushBoxes_isThatOfOneBox_data() {
        QTest::addColumn<float>("away");
        QTest::newRow("at the origin") << 0.F;
        QTest::newRow("1 km away") << 1e6F;
    }

    // The faces at which the boxes touch are no surface to paint.
    void judged_flushBoxes_isThatOfOneBox() {
        QFETCH(float, away);
        const Eigen::Vector3d size(40, 20, 40);
        const TriangleMesh whole = boxMesh(size), half = boxMesh({20, 20, 40});
        const TriangleMesh left = test::joined({}, half, {away - 10, 0, 0});
        const Judged one = judgedOn(whole, size);
        const Judged two = judgedOn(test::joined(left, half, {away + 10, 0, 0}), size);
        QVERIFY(std::abs(one.area / surfaceArea(whole) - 1) < 1e-6);
        QVERIFY(std::abs(two.area / one.area - 1) < 0.002);
        QVERIFY(std::abs(one.coverage - 0.25) < 0.01);
        QVERIFY(std::abs(two.coverage - one.coverage) < 0.005);
    }

    // When the second batch is told of, it is simulated, but not judged.
    void dip_cancelledAfterABatch_keepsItsDips() {
        Progress progress;
        const std::vector<Immersion> immersions = turned(2 + 2 * batchSize);
        std::vector<std::shared_ptr<const JudgedPose>> judged(immersions.size());
        int batches = 0;
        const auto cancelSecond = [&](std::size_t) {
            if (++batches == 2) {
                progress.cancelToken.cancel();
            }
        };
        const PoseDips dips(subject_, body_, registry_->module("auto"), coarseDetail, field_,
                            progress.cancelToken);
        QVERIFY_EXCEPTION_THROWN(dips.dip(immersions, judged, cancelSecond, 2), Cancelled);
        QCOMPARE(batches, 2);
        QCOMPARE(doneOf(judged), 2 + batchSize);
    }

    // The third batch cannot be set up while the second is simulated. With the paper's film, the
    // order of the dips is that of the list.
    void dip_batchThatCannotBeSetUp_keepsTheDipsBefore() {
        SearchSubject subject = subject_;
        subject.film.lattice = solver::Lattice::Structural;
        subject.film.support = solver::Support::None;
        std::vector<Immersion> immersions = turned(2 + 2 * batchSize);
        immersions.back().path.kind = PathKind::Poses; // without any pose
        std::vector<std::shared_ptr<const JudgedPose>> judged(immersions.size());
        const PoseDips dips(subject, body_, registry_->module("auto"), coarseDetail, field_, {});
        QVERIFY_EXCEPTION_THROWN(dips.dip(
                                     immersions, judged, [](std::size_t) {}, 2),
                                 Error);
        QCOMPARE(doneOf(judged), 2 + batchSize);
    }

private:
    std::unique_ptr<SolverRegistry> registry_;
    SearchSubject subject_ = subjectOf(boxMesh({6, 40, 40}));
    JudgedBody body_{subject_, {1, 1, 1}, SurfaceColours(*subject_.model)};
    std::shared_ptr<const DistanceField> field_ =
        cachedDistanceField(subject_.model->mesh, subject_.fieldResolution, {});
};

QTEST_GUILESS_MAIN(PoseDipsTest)
#include "PoseDipsTest.moc"
