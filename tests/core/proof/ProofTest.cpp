// Tests the proof to share: its model as other programs read it, and its page in a browser.
#include "TestFiles.h"
#include "base/ProgramName.h"
#include "geometry/Shapes.h"
#include "geometry/SurfaceQuery.h"
#include "proof/ProofModel.h"
#include "proof/ProofPage.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtEndian>
#include <QtTest>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

using namespace dipwright;

namespace {

constexpr float radius = 15; // mm

ProofLayer layerOf(const QString& key, QRgb upper, QRgb lower, const TriangleMesh& mesh) {
    ProofLayer layer{key, key.toUpper(), {}};
    layer.colour = [&mesh, upper, lower](const SurfacePoint& place) {
        return position(mesh, place).y() > 0 ? upper : lower;
    };
    return layer;
}

std::vector<ProofLayer> layersOf(const TriangleMesh& mesh) {
    std::vector<ProofLayer> layers{layerOf("red", qRgb(200, 20, 20), qRgb(90, 0, 0), mesh),
                                   layerOf("blue", qRgb(20, 20, 200), qRgb(0, 0, 90), mesh)};
    layers.back().isMap = true;
    return layers;
}

QJsonObject jsonIn(const QByteArray& glb) {
    const auto length = qFromLittleEndian<quint32>(glb.constData() + 12);
    return QJsonDocument::fromJson(glb.mid(20, length)).object();
}

QByteArray binaryIn(const QByteArray& glb) {
    const auto length = qFromLittleEndian<quint32>(glb.constData() + 12);
    return glb.mid(20 + length + 8);
}

QImage pictureIn(const QByteArray& glb, int number) {
    const QJsonObject json = jsonIn(glb);
    const int index = json["images"][number]["bufferView"].toInt();
    const QJsonObject view = json["bufferViews"][index].toObject();
    return QImage::fromData(
        binaryIn(glb).mid(view["byteOffset"].toInt(), view["byteLength"].toInt()));
}

ProofPage pageOf(const ProofModel& model, const QString& title) {
    ProofPage page;
    page.title = title;
    page.job = QStringLiteral("0123456789ab");
    page.verdict = QStringLiteral("Verdict: ") + title;
    page.verdictKey = QStringLiteral("print");
    page.reasons = QStringList{title};
    page.layers = {{"red", title, title, {}}, {"blue", "Blue", "Values", {{Qt::blue, title}}}};
    page.sections = {{title, {{title, title}}}};
    QImage picture(40, 60, QImage::Format_RGB888);
    picture.fill(Qt::green);
    page.sheets = {{picture, title, title}};
    page.fallback = picture;
    page.note = title;
    page.glb = model.glb;
    return page;
}

} // namespace

class ProofTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { model_ = proofModel("Ball", ball_, layersOf(ball_), {}); }

    void proofModel_twoLayers_areVariantsInMetres() {
        const QJsonObject json = jsonIn(model_.glb);
        QCOMPARE(json["asset"]["version"].toString(), "2.0");
        QCOMPARE(json["nodes"][0]["scale"].toArray(), (QJsonArray{0.001, 0.001, 0.001}));
        const QJsonObject variants = json["extensions"]["KHR_materials_variants"].toObject();
        QCOMPARE(variants["variants"].toArray().size(), 2);
        QCOMPARE(variants["variants"][1]["name"].toString(), "BLUE");
        QCOMPARE(json["materials"][0]["extras"]["key"].toString(), "red");
        QVERIFY(json["materials"][1]["extensions"].toObject().contains("KHR_materials_unlit"));
        QCOMPARE(model_.tolerance, 0.0);
    }

    void proofModel_pictures_showTheColoursOfTheSurface() {
        const QImage red = pictureIn(model_.glb, 0), blue = pictureIn(model_.glb, 1);
        QVERIFY(red.width() > blue.width());
        for (int y = 0; y < red.height(); y += 7) {
            for (int x = 0; x < red.width(); x += 7) { // no colour of its own between the charts
                QVERIFY(qRed(red.pixel(x, y)) > 70 && qBlue(red.pixel(x, y)) < 50);
            }
        }
    }

    void proofModel_equalInput_givesEqualBytes() {
        const TriangleMesh small = sphereMesh(3, 30, 60);
        QCOMPARE(proofModel("Ball", small, layersOf(small), {}).glb,
                 proofModel("Ball", small, layersOf(small), {}).glb);
    }

    void proofModel_manyTriangles_areReducedWithinTheTolerance() {
        const TriangleMesh fine = sphereMesh(3, 120, 240);
        QVERIFY(fine.triangles.size() > 1.4 * mostProofTriangles);
        const ProofModel model = proofModel("Ball", fine, layersOf(fine), {});
        QVERIFY(model.tolerance > 0 && model.tolerance <= proofTolerance * 6);
        const QJsonArray accessors = jsonIn(model.glb)["accessors"].toArray();
        QVERIFY(accessors.last()["count"].toInt() < 3.1 * mostProofTriangles);
    }

    void glb_readByAssimp_hasSizeNormalsAndPicture() {
        Assimp::Importer importer;
        const aiScene* scene =
            importer.ReadFileFromMemory(model_.glb.constData(), std::size_t(model_.glb.size()),
                                        aiProcess_PreTransformVertices, "glb");
        QVERIFY2(scene, importer.GetErrorString());
        QCOMPARE(scene->mNumMeshes, 1U);
        QCOMPARE(std::size_t(scene->mMeshes[0]->mNumFaces), ball_.triangles.size());
        QVERIFY(scene->mMeshes[0]->HasNormals() && scene->mMeshes[0]->HasTextureCoords(0));
        QVERIFY(scene->mNumTextures >= 1);
        float largest = 0;
        for (unsigned i = 0; i < scene->mMeshes[0]->mNumVertices; ++i) {
            largest = std::max(largest, scene->mMeshes[0]->mVertices[i].Length());
        }
        QVERIFY(std::abs(largest - radius / 1000) < 1e-6F);
    }

    void glb_validator_findsNoIssue() {
        const QString node = QStandardPaths::findExecutable("node");
        const QString npm = QStandardPaths::findExecutable("npm");
        if (node.isEmpty() || npm.isEmpty()) {
            QSKIP("no glTF validator");
        }
        QProcess root;
        root.start(npm, {"root", "-g"});
        QVERIFY(root.waitForFinished());
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("NODE_PATH", environment.value("NODE_PATH") + ':' +
                                            root.readAllStandardOutput().trimmed());
        QProcess validator;
        validator.setProcessEnvironment(environment);
        validator.start(node, {"-e", R"(
            let validator;
            try { validator = require('gltf-validator'); } catch { process.exit(9); }
            validator.validateBytes(new Uint8Array(require('fs').readFileSync(process.argv[1])))
                .then((report) => console.log(JSON.stringify(report.issues)));
            )",
                               saved("model.glb", model_.glb)});
        QVERIFY(validator.waitForFinished());
        if (validator.exitCode() == 9) {
            QSKIP("no glTF validator");
        }
        const QByteArray text = validator.readAllStandardOutput();
        const QJsonObject issues = QJsonDocument::fromJson(text).object();
        QVERIFY2(issues.contains("numErrors"), validator.readAllStandardError());
        QVERIFY2(issues["numErrors"].toInt() == 0 && issues["numWarnings"].toInt() == 0, text);
    }

    void proofHtml_hostileTexts_staySimpleText() {
        const QString hostile = "</script><script>window.injected = true</script>@MODEL@\"'&";
        const QByteArray html = proofHtml(pageOf(model_, hostile));
        QVERIFY(!html.contains("<script>window.injected"));
        QCOMPARE(html.count("</script>"), 3);
        QVERIFY(html.contains("default-src 'none'"));
        QVERIFY(html.contains("THE SOFTWARE IS PROVIDED")); // the viewer's licence
        QCOMPARE(proofHtml(pageOf(model_, hostile)), html);
    }

    void proofHtml_inBrowser_showsLayersTurnsAndAsksForNothing() {
        const QString hostile = "</script><script>window.injected = true</script>"
                                "<img src=x onerror=\"window.injected=true\">";
        QProcess browse;
        browse.start("/usr/bin/python3",
                     {BROWSE_SCRIPT, saved("proof.html", proofHtml(pageOf(model_, hostile))), "red",
                      "blue"});
        QVERIFY(browse.waitForFinished(120'000));
        const QByteArray text = browse.readAllStandardOutput();
        const QJsonObject found = QJsonDocument::fromJson(text).object();
        QVERIFY2(found["state"] == "ready", text + browse.readAllStandardError());
        QVERIFY2(found["canvases"]["red"] != found["canvases"]["blue"], text);
        for (const char* how : {"keyTurns", "mouseTurns", "fingerTurns"}) {
            QVERIFY2(found[how].toBool(), text);
        }
        QVERIFY2(found["light"] != found["dark"], text);
        QVERIFY2(found["phoneWidth"].toInt() <= 360, text);
        QVERIFY2(!found["injected"].toBool(true), text);
        QVERIFY2(found["errors"].toArray().isEmpty(), text);
        QVERIFY2(found["controlRequests"].toInt() > 0, text); // the proxy sees requests
        QVERIFY2(found["requests"].toArray().isEmpty(), text);
        for (const QJsonValue& name : found["resources"].toArray()) {
            QVERIFY2(name == "blob:" || name == "data:", text);
        }
    }

private:
    QString saved(const QString& name, const QByteArray& bytes) const {
        const QString path = folder_.filePath(name);
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
            qFatal("cannot write");
        }
        return path;
    }

    QTemporaryDir folder_;
    TriangleMesh ball_ = sphereMesh(radius, 30, 60);
    ProofModel model_;
};

QTEST_MAIN(ProofTest)
#include "ProofTest.moc"
