// Tests where a job's warnings lie on the part.
#include "pipeline/JobWarnings.h"
#include "DippedByHand.h"
#include "geometry/Shapes.h"
#include "texture/ReverseTexture.h"

#include <QTest>
#include <cmath>

using namespace dipwright;

class JobWarningsTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        auto model = std::make_shared<TexturedMesh>();
        model->mesh = sphereMesh(30, 24, 48);
        result_ = {};
        result_.project.model = model;
        result_.immersions.resize(1);
    }

    void warnings_twoTornPieces_areAtTheirPlaces() {
        mark(solver::PointMark::Torn,
             [](const Eigen::Vector3f& place) { return place.y() < -20 || place.x() > 27; });
        const std::vector<JobWarning> warnings = jobWarnings(result_);
        QCOMPARE(warnings.size(), std::size_t(2));
        QCOMPARE(warnings[0].kind, WarningKind::Torn);
        QCOMPARE(warnings[0].dip, std::optional<std::size_t>(0));
        QVERIFY(warnings[0].area > warnings[1].area); // the larger piece is first
        QVERIFY((warnings[0].place - Eigen::Vector3f(0, -30, 0)).norm() < 5);
        QVERIFY((warnings[1].place - Eigen::Vector3f(30, 0, 0)).norm() < 5);
        for (const JobWarning& warning : warnings) {
            QVERIFY(std::abs(warning.place.norm() - 30) < 0.5f);
            QVERIFY(warning.outward.dot(warning.place.normalized()) > 0.9f);
        }
    }

    void warnings_releasedFilm_areNotTorn() {
        mark(solver::PointMark::LetGo, [](const Eigen::Vector3f& place) { return place.z() > 25; });
        const std::vector<JobWarning> warnings = jobWarnings(result_);
        QCOMPARE(warnings.size(), std::size_t(1));
        QCOMPARE(warnings[0].kind, WarningKind::Released);
    }

    void warnings_nothingMarked_areNone() {
        mark(solver::PointMark::Torn, [](const Eigen::Vector3f&) { return false; });
        QVERIFY(jobWarnings(result_).empty());
    }

    // The film has grown J = 1.96 sin θ/θ times at the angle θ from the pole. The grey has the
    // density 1.18. Ink of the density 2 shows visibly less (by 0.05) where J is above 1.77: within
    // θ = 0.775.
    void warnings_inkLimitReached_areTooPale() {
        makePale();
        const std::vector<JobWarning> warnings = jobWarnings(result_);
        QCOMPARE(warnings.size(), std::size_t(1));
        QCOMPARE(warnings[0].kind, WarningKind::TooPale);
        QVERIFY2(std::abs(warnings[0].area - 1616) < 80,
                 qPrintable(QString::number(warnings[0].area)));
        QVERIFY((warnings[0].place - Eigen::Vector3f(0, -30, 0)).norm() < 5);
    }

    void warnings_otherDipPaints_areNotTooPale() {
        makePale();
        const auto fine = fineBody(result_.project.model->mesh);
        auto share = std::make_shared<BodyShare>();
        share->fade.mesh = fine;
        share->painters.assign(fine->mesh().triangles.size(), Painter::Second);
        result_.share = share;
        QVERIFY(jobWarnings(result_).empty());
    }

private:
    void makePale() {
        const auto model = std::make_shared<TexturedMesh>(
            test::plainModel(sphereMesh(30, 24, 48), QColor(72, 72, 72)));
        result_.project.model = result_.painted = model;
        result_.project.ink.limit = 2;
        result_.immersions[0].laid =
            test::laid(model->mesh, test::onSphere(test::a4Grid(), 30, 1.5,
                                                   [](double rest) { return 1.4 * rest / 30; }));
        auto texture = std::make_shared<ReverseTexture>();
        texture->shortfallArea = 1900;
        result_.immersions[0].texture = texture;
        mark(solver::PointMark::Torn, [](const Eigen::Vector3f&) { return false; });
    }
    template <typename Belongs>
    void mark(solver::PointMark mark, const Belongs& belongs) {
        const TriangleMesh& mesh = result_.project.model->mesh;
        auto coverage = std::make_shared<Coverage>();
        coverage->covered.assign(mesh.triangles.size(), 1);
        for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
            const bool isMarked = belongs(position(mesh, middleOf(triangle)));
            coverage->marks.push_back(isMarked ? std::uint8_t(mark) : 0);
            coverage->marked.add(coverage->marks.back(), triangleArea(mesh, triangle));
        }
        result_.immersions[0].coverage = coverage;
    }

    JobResult result_;
};

QTEST_APPLESS_MAIN(JobWarningsTest)
#include "JobWarningsTest.moc"
