// The samples: that they are what the README says, ready to dip, and to be printed.
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

// How many pixel centres of a square picture lie in more than one triangle of the texture.
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

// What comes of a sample's own job, but for the sheet's resolution.
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

// How much two pictures of a sheet differ where they differ most, in grey levels over 3 × 3 mm.
int largestDifference(const QImage& a, const QImage& b, const FilmSettings& film) {
    const QSize coarse(int(film.width.value() / 3), int(film.height.value() / 3));
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
    void haveTheirSizes_data();
    void haveTheirSizes();
    void areCleanBodies_data() { haveTheirSizes_data(); }
    void areCleanBodies();
    void filmSuitsTheBody_data() { haveTheirSizes_data(); }
    void filmSuitsTheBody();
    void aFlippedSheetIsSeen_data() { haveTheirSizes_data(); }
    void aFlippedSheetIsSeen();
    void turtleIsDippedTwice();
    void turtleHasNoPlaceTwiceInItsTexture();
};

void SamplesTest::haveTheirSizes_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QList<double>>("size"); // mm; 0: whatever it comes to
    QTest::addColumn<int>("charts");
    QTest::newRow("sphere") << QByteArray("sphere") << QList<double>{70, 70, 70} << 1;
    QTest::newRow("tetrahedron") << QByteArray("tetrahedron") << QList<double>{60, 48.990, 51.962}
                                 << 4;
    QTest::newRow("turtle") << QByteArray("turtle") << QList<double>{75, 0, 110} << 2;
}

void SamplesTest::haveTheirSizes() {
    QFETCH(QByteArray, name);
    QFETCH(QList<double>, size);
    QFETCH(int, charts);
    const Project project = sample(name);
    const Eigen::Vector3f measured = boundingBox(project.model->mesh).sizes();
    for (int axis = 0; axis < 3; ++axis) {
        QVERIFY2(size[axis] == 0 || std::abs(measured[axis] - size[axis]) < 0.01,
                 qPrintable(QStringLiteral("axis %1: %2 mm").arg(axis).arg(measured[axis])));
    }
    QCOMPARE(chartCount(*project.model), std::size_t(charts));
}

void SamplesTest::areCleanBodies() {
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

void SamplesTest::filmSuitsTheBody() {
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

void SamplesTest::aFlippedSheetIsSeen() {
    QFETCH(QByteArray, name);
    const JobResult& result = resultOf(name);
    for (const ImmersionResult& dip : result.immersions) {
        const QImage& sheet = dip.sheet.image;
        for (const QImage& flipped : {sheet.mirrored(true, false), sheet.mirrored(false, true),
                                      sheet.mirrored(true, true)}) {
            const int difference = largestDifference(sheet, flipped, result.project.film);
            QVERIFY2(difference > 40, qPrintable(QString::number(difference)));
        }
    }
}

void SamplesTest::turtleIsDippedTwice() {
    const Project project = sample("turtle");
    QCOMPARE(project.immersions.size(), std::size_t(2));
    QCOMPARE(project.immersions[0].rotation[2], Degrees(0));
    QCOMPARE(project.immersions[1].rotation[2], Degrees(180));
}

void SamplesTest::turtleHasNoPlaceTwiceInItsTexture() {
    QCOMPARE(sharedPixels(*sample("turtle").model, 1024), 0);
}

QTEST_MAIN(SamplesTest)
#include "SamplesTest.moc"
