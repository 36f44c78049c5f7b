// Checks that the sample projects match the README, can be dipped and can be printed.
#include "TestFolders.h"
#include "base/Units.h"
#include "geometry/SurfaceQuery.h"
#include "model/TexturedMesh.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/Pipeline.h"
#include "pipeline/SmallerFilm.h"
#include "project/Project.h"
#include "project/ProjectStore.h"

#include <QtTest>
#include <cmath>
#include <map>
#include <set>

using namespace dipwright;

namespace {

Project sample(const char* name) {
    return loadProject(sampleFolder("/%1.dipw").arg(QLatin1String(name)));
}

bool isPixelFree(std::vector<std::uint32_t>& owner, std::size_t pixel, std::uint32_t triangle) {
    const bool isFree = owner[pixel] == 0;
    owner[pixel] = triangle + 1;
    return isFree;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// Counts the pixel centres of a square picture that lie in more than one triangle of the texture.
int sharedPixels(const TexturedMesh& model, int side) {
    std::vector<std::uint32_t> owner(std::size_t(side) * std::size_t(side), 0);
    int shared = 0;
    for (std::uint32_t t = 0; t < model.textureCoordinates.size(); ++t) {
        std::array<Eigen::Vector2d, 3> corners;
        Eigen::AlignedBox2d box;
        for (int i = 0; i < 3; ++i) {
            corners[i] = side * model.textureCoordinates[t][i].cast<double>();
            box.extend(corners[i]);
        }
        const double area = cross(corners[1] - corners[0], corners[2] - corners[0]);
        for (int y = int(box.min().y()); y <= int(box.max().y()); ++y) {
            for (int x = int(box.min().x()); x <= int(box.max().x()); ++x) {
                const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
                bool isInside = true;
                for (int i = 0; i < 3; ++i) {
                    isInside =
                        isInside &&
                        cross(corners[i] - pixel, corners[(i + 1) % 3] - pixel) / area > 1e-6;
                }
                if (isInside &&
                    !isPixelFree(owner, std::size_t(y) * std::size_t(side) + std::size_t(x), t)) {
                    ++shared;
                }
            }
        }
    }
    return shared;
}

// Returns the result of a sample's job. Only the sheet's resolution is changed, to 72 dpi.
const JobResult& resultOf(const QByteArray& name) {
    static const SolverRegistry registry{QStringList{pluginFolder()}};
    static std::map<QByteArray, JobResult> results;
    if (!results.count(name)) {
        Project project = sample(name.constData());
        project.sheet.resolution = DotsPerInch(72);
        JobOptions options;
        options.solver = QStringLiteral("pbd-cpu");
        results[name] = runJob(project, registry, options, nullptr, {});
    }
    return results[name];
}

// Returns the largest difference between two pictures of a sheet, in grey levels averaged over 1 ×
// 1 mm. The letter on the turtle's shell, which shows whether it is mirrored, has strokes of 1 mm.
int largestDifference(const QImage& a, const QImage& b, const FilmSettings& film) {
    const QSize coarse(int(film.width.value()), int(film.height.value()));
    const auto blurred = [&](const QImage& image) {
        return image.convertToFormat(QImage::Format_RGB32)
            .scaled(coarse, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
            .convertToFormat(QImage::Format_Grayscale8);
    };
    const QImage left = blurred(a);
    const QImage right = blurred(b);
    int largest = 0;
    for (int y = 0; y < coarse.height(); ++y) {
        for (int x = 0; x < coarse.width(); ++x) {
            largest =
                std::max(largest, std::abs(qGray(left.pixel(x, y)) - qGray(right.pixel(x, y))));
        }
    }
    return largest;
}

std::size_t chartCount(const TexturedMesh& model) {
    return std::set<std::uint32_t>(model.chart.begin(), model.chart.end()).size();
}

} // namespace

class SamplesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void sample_sizeAndCharts_areAsExpected_data();
    void sample_sizeAndCharts_areAsExpected();
    void sample_mesh_isClosedAndTextured_data() { sample_sizeAndCharts_areAsExpected_data(); }
    void sample_mesh_isClosedAndTextured();
    void sample_ownFilm_verdictIsPrint_data() { sample_sizeAndCharts_areAsExpected_data(); }
    void sample_ownFilm_verdictIsPrint();
    void sample_flippedSheet_differsVisibly_data() { sample_sizeAndCharts_areAsExpected_data(); }
    void sample_flippedSheet_differsVisibly();
    void turtle_project_hasTwoDips();
    void turtle_texture_hasNoOverlaps();
};

void SamplesTest::sample_sizeAndCharts_areAsExpected_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QList<double>>("size"); // mm; 0: not checked
    QTest::addColumn<int>("charts");
    QTest::newRow("sphere") << QByteArray("sphere") << QList<double>{70, 70, 70} << 1;
    QTest::newRow("tetrahedron") << QByteArray("tetrahedron") << QList<double>{60, 48.990, 51.962}
                                 << 4;
    QTest::newRow("turtle") << QByteArray("turtle") << QList<double>{75, 0, 110} << 2;
}

void SamplesTest::sample_sizeAndCharts_areAsExpected() {
    QFETCH(QByteArray, name);
    QFETCH(QList<double>, size);
    QFETCH(int, charts);
    const Project project = sample(name);
    const Eigen::Vector3f measured = boundingBox(project.model->mesh).sizes();
    for (int axis = 0; axis < 3; ++axis) {
        QVERIFY2(size[axis] == 0 || std::abs(measured[axis] - size[axis]) < 0.01,
                 qPrintable(QStringLiteral("size along axis %1 is %2 mm, expected %3 ± 0.01 mm")
                                .arg(axis)
                                .arg(measured[axis])
                                .arg(size[axis])));
    }
    QCOMPARE(chartCount(*project.model), std::size_t(charts));
}

void SamplesTest::sample_mesh_isClosedAndTextured() {
    QFETCH(QByteArray, name);
    const Project project = sample(name);
    const TexturedMesh& model = *project.model;
    QVERIFY(isClosed(model.mesh));
    QVERIFY(volume(model.mesh) > 0);
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
        QVERIFY(triangleArea(model.mesh, t) > 1e-6);
        QVERIFY(model.hasTextureCoordinates(t));
    }
    QCOMPARE(model.textures.size(), std::size_t(1));
    QCOMPARE(model.textures.front().size(), QSize(2048, 2048));
}

void SamplesTest::sample_ownFilm_verdictIsPrint() {
    QFETCH(QByteArray, name);
    const JobResult& result = resultOf(name);
    QVERIFY(result.project.film.resolution == FilmResolution::Automatic);
    QVERIFY(!smallerFilm(result).has_value());
    QStringList told;
    for (const JobReason& reason : reasonsOf(result)) {
        told << reasonText(reason, result, millimetres);
    }
    QVERIFY2(adviceOf(result) == Advice::Print, qPrintable(told.join(QLatin1Char('\n'))));
}

void SamplesTest::sample_flippedSheet_differsVisibly() {
    QFETCH(QByteArray, name);
    const JobResult& result = resultOf(name);
    for (const ImmersionResult& dip : result.immersions) {
        const QImage& sheet = dip.sheet.image;
        for (const QImage& flipped : {sheet.mirrored(true, false), sheet.mirrored(false, true),
                                      sheet.mirrored(true, true)}) {
            const int difference = largestDifference(sheet, flipped, result.project.film);
            QVERIFY2(
                difference > 80,
                qPrintable(QStringLiteral(
                               "the largest difference is %1 grey levels, expected more than 80")
                               .arg(difference)));
        }
    }
}

void SamplesTest::turtle_project_hasTwoDips() {
    const Project project = sample("turtle");
    QCOMPARE(project.immersions.size(), std::size_t(2));
    QCOMPARE(project.immersions[0].rotation[2], Degrees(0));
    QCOMPARE(project.immersions[1].rotation[2], Degrees(180));
}

void SamplesTest::turtle_texture_hasNoOverlaps() {
    QCOMPARE(sharedPixels(*sample("turtle").model, 1024), 0);
}

QTEST_MAIN(SamplesTest)
#include "SamplesTest.moc"
