// Tests the proof to share of a whole job: its layers, its figures, and that it tells no prices.
#include "pipeline/JobProof.h"
#include "TestFolders.h"
#include "geometry/Shapes.h"
#include "pipeline/Pipeline.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <QtEndian>
#include <QtTest>

using namespace dipwright;

namespace {

// A ball in two colours with an easily found name, dipped twice.
Project ballJob() {
    auto model = std::make_shared<TexturedMesh>();
    model->mesh = sphereMesh(15, 20, 40);
    const Eigen::Vector2f none = Eigen::Vector2f::Constant(std::nanf(""));
    model->textureCoordinates.assign(model->mesh.triangles.size(), {none, none, none});
    model->materials = {{QStringLiteral("red"), QColor(200, 20, 20)},
                        {QStringLiteral("blue"), QColor(20, 20, 200)}};
    for (std::uint32_t triangle = 0; triangle < model->mesh.triangles.size(); ++triangle) {
        model->material.push_back(position(model->mesh, middleOf(triangle)).y() > 0 ? 0 : 1);
    }
    model->chart = findCharts(*model);
    Project project;
    project.name = QStringLiteral("Ball & <b>name</b>");
    project.model = model;
    project.film.width = project.film.height = Millimetres(90);
    project.film.columns = project.film.rows = 41;
    project.fieldResolution = 64;
    project.sheet.resolution = DotsPerInch(72);
    project.immersions.resize(2);
    project.immersions[0].name = QStringLiteral("Below");
    project.immersions[1].name = QStringLiteral("Top");
    project.immersions[1].rotation = {Degrees(180), Degrees(0), Degrees(0)};
    return project;
}

QJsonObject jsonIn(const QByteArray& glb) {
    const auto length = qFromLittleEndian<quint32>(glb.constData() + 12);
    return QJsonDocument::fromJson(glb.mid(20, length)).object();
}

QImage pictureIn(const QByteArray& glb, int number) {
    const auto length = qFromLittleEndian<quint32>(glb.constData() + 12);
    const QJsonObject json = jsonIn(glb);
    const QJsonObject view =
        json["bufferViews"][json["images"][number]["bufferView"].toInt()].toObject();
    return QImage::fromData(
        glb.mid(20 + length + 8 + view["byteOffset"].toInt(), view["byteLength"].toInt()));
}

// Shares of the picture that are about red and about blue.
std::pair<double, double> redAndBlue(const QImage& picture) {
    int red = 0, blue = 0;
    for (int y = 0; y < picture.height(); y += 4) {
        for (int x = 0; x < picture.width(); x += 4) {
            const QColor colour(picture.pixel(x, y));
            red += colour.red() > 2 * colour.blue() && colour.red() > 100;
            blue += colour.blue() > 2 * colour.red() && colour.blue() > 100;
        }
    }
    const double all = double(picture.width()) * picture.height() / 16;
    return {red / all, blue / all};
}

} // namespace

class JobProofTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        const SolverRegistry registry(QStringList{pluginFolder()});
        JobOptions options;
        options.estimatesNumericalError = true;
        result_ = runJob(ballJob(), registry, options, nullptr, {});
        proof_ = sharedProof(result_, {});
    }

    void sharedProof_twoDips_hasALayerForEachState() {
        QStringList keys;
        for (const QJsonValue& material : jsonIn(proof_.glb)["materials"].toArray()) {
            keys << material["extras"]["key"].toString();
        }
        QCOMPARE(keys, (QStringList{"printed", "after-1", "wanted", "stretch", "error"}));
    }

    void sharedProof_layers_showPrintAndArtwork() {
        const auto [red, blue] = redAndBlue(pictureIn(proof_.glb, 0));
        QVERIFY(red > 0.3 && blue > 0.3);
        const auto [redFirst, blueFirst] = redAndBlue(pictureIn(proof_.glb, 1));
        QVERIFY(redFirst < 0.3 * red); // the upper half comes with dip 2
        QVERIFY(blueFirst > 0.3);
        const auto [redWanted, blueWanted] = redAndBlue(pictureIn(proof_.glb, 2));
        QVERIFY(std::abs(redWanted - red) < 0.1 && std::abs(blueWanted - blue) < 0.1);
    }

    void sharedProof_page_hasTheJobAndNoPrices() {
        QVERIFY(proof_.html.contains("Ball &amp; &lt;b&gt;name&lt;/b&gt;"));
        for (const ImmersionResult& dip : result_.immersions) {
            QVERIFY(proof_.html.contains(dip.sheet.job.hash.toUtf8()));
        }
        QVERIFY(proof_.html.contains(proof_.glb.toBase64()));
        QVERIFY(!proof_.html.contains("Cost"));
    }

    void sharedProof_placeWithoutError_isInTheLegend() {
        QVERIFY(!proof_.html.contains("not compared"));
        JobResult result = result_;
        NumericalErrorEstimate error = *result.immersions[0].numericalError;
        for (float& value : error.pointErrors) {
            value = std::nanf("");
        }
        result.immersions[0].numericalError =
            std::make_shared<const NumericalErrorEstimate>(std::move(error));
        QVERIFY(sharedProof(result, {}).html.contains("not compared"));
    }

    void sharedProof_equalResults_giveEqualBytes() {
        const SharedProof again = sharedProof(result_, {});
        QCOMPARE(again.glb, proof_.glb);
        QVERIFY(again.html == proof_.html);
    }

    void sharedProof_cancelled_throws() {
        Progress progress;
        progress.cancelToken.cancel();
        QVERIFY_EXCEPTION_THROWN(sharedProof(result_, progress), Cancelled);
    }

private:
    JobResult result_;
    SharedProof proof_;
};

QTEST_MAIN(JobProofTest)
#include "JobProofTest.moc"
