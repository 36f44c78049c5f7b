// Tests models that assimp misreads or leaves unread without an error.
#include "ModelFiles.h"

#include "base/Error.h"
#include "import/trusted/ImportModel.h"
#include "model/ModelFormats.h"

#include <QtEndian>
#include <QtTest>

Q_DECLARE_METATYPE(Eigen::Vector2f)
Q_DECLARE_METATYPE(Eigen::Matrix3f)

using namespace dipwright;
using namespace dipwright::test;

namespace {

// Returns the error's sentence if the import fails, otherwise an empty text.
QString refusal(const QString& path) {
    try {
        importModel(path, {}, {});
        return QString();
    } catch (const Error& error) {
        return error.sentence();
    }
}

QString warningsOf(const ImportedModel& imported) {
    return imported.report.warnings.join(u'|');
}

// Returns squareCollada() with another symbol and number of its set of texture coordinates.
QByteArray renamedSetCollada(const QByteArray& symbol, int set) {
    const QByteArray number = "set=\"" + QByteArray::number(set) + "\"";
    return squareCollada()
        .replace("UVMap", symbol)
        .replace(" set=\"0\"", " " + number)
        .replace("input_set=\"0\"", "input_" + number);
}

// Returns it with a second set, which its texture does not use.
QByteArray twoSetsCollada(const QByteArray& symbol, int set, int otherSet) {
    const QByteArray other = "<input semantic=\"TEXCOORD\" source=\"#other\" offset=\"0\" set=\"" +
                             QByteArray::number(otherSet) + "\"/>";
    return renamedSetCollada(symbol, set).replace("<p>", other + "<p>");
}

using Axes = std::vector<std::pair<QByteArray, int>>;

const Axes yUp{{"UpAxis", 1},        {"UpAxisSign", 1}, {"FrontAxis", 2},
               {"FrontAxisSign", 1}, {"CoordAxis", 0},  {"CoordAxisSign", 1}};
const Axes zUp{{"UpAxis", 2},         {"UpAxisSign", 1}, {"FrontAxis", 1},
               {"FrontAxisSign", -1}, {"CoordAxis", 0},  {"CoordAxisSign", 1}}; // 3ds Max

// Returns a tetrahedron with edges of length 10 as FBX text with these GlobalSettings.
QByteArray textFbx(const Axes& axes, double unit) {
    QByteArray properties =
        "P: \"UnitScaleFactor\", \"double\", \"Number\", \"\"," + QByteArray::number(unit) + "\n";
    for (const auto& [axis, value] : axes) {
        properties +=
            "P: \"" + axis + "\", \"int\", \"Integer\", \"\"," + QByteArray::number(value) + "\n";
    }
    QByteArray file = tetrahedron("fbxa");
    const qsizetype begin = file.indexOf("GlobalSettings");
    const qsizetype end = file.indexOf("Documents:", begin);
    return file.replace(begin, end - begin,
                        "GlobalSettings: {\nProperties70: {\n" + properties + "}\n}\n");
}

// Returns texturedFbx() with a property of its object.
QByteArray withModelProperty(const QByteArray& property) {
    return texturedFbx({}).replace("Version: 232",
                                   "Version: 232\n  Properties70: {\n   " + property + "\n  }");
}

// Returns a glTF text with one embedded buffer as a binary file.
QByteArray glbOf(QByteArray json) {
    const QByteArray before = R"("uri":"data:application/octet-stream;base64,)";
    const qsizetype uri = json.indexOf(before), begin = uri + before.size();
    const qsizetype end = json.indexOf('"', begin);
    const QByteArray buffer = QByteArray::fromBase64(json.mid(begin, end - begin));
    json.replace(uri, end + 1 - uri, R"("name":"buffer")");
    json.append((4 - json.size() % 4) % 4, ' ');
    QByteArray file("glTF\2\0\0\0____ ___JSON", 20), chunk("____BIN\0", 8);
    qToLittleEndian(quint32(json.size()), file.data() + 12);
    qToLittleEndian(quint32(buffer.size()), chunk.data());
    file += json + chunk + buffer;
    qToLittleEndian(quint32(file.size()), file.data() + 8);
    return file;
}

// Returns the model file of a 3MF package: a tetrahedron, with attributes of its object and its
// item.
QByteArray threeMf(const QByteArray& ofObject, const QByteArray& ofItem) {
    return R"(<model><resources><basematerials id="1"><base name="a" displaycolor="#FF0000"/>
</basematerials><object id="3" pid="1" pindex="0" )" +
           ofObject + R"(><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>
<vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices><triangles>
<triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/><triangle v1="1" v2="2" v3="3"/>
<triangle v1="2" v2="0" v3="3"/></triangles></mesh></object></resources>
<build><item objectid="3" )" +
           ofItem + "/></build></model>";
}

// Returns a row of red pixels with different alpha.
QImage fourAlphas() {
    QImage row(4, 1, QImage::Format_RGBA8888);
    for (int x = 0; x < row.width(); ++x) {
        row.setPixelColor(x, 0, QColor(255, 0, 0, QList<int>{0, 127, 128, 255}[x]));
    }
    return row;
}

QList<int> alphasOf(const QImage& row) {
    QList<int> alphas;
    for (int x = 0; x < row.width(); ++x) {
        alphas.push_back(row.pixelColor(x, 0).alpha());
    }
    return alphas;
}

} // namespace

// The material's colour in squareGltf().
const QByteArray tint = R"("baseColorFactor":[0.5,0.5,0.5,1],)";

class OddModelsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void gltf_integerCoordinates_areRefused_data();
    void gltf_integerCoordinates_areRefused();
    void gltf_integerSecondTextureCoordinates_areReadIfUnused();
    void gltf_requiredExtension_isReadOrNamed_data();
    void gltf_requiredExtension_isReadOrNamed();
    void gltf_textureInUnsupportedFormat_isAWarning();
    void gltf_scaledTexture_isAWarning();
    void gltf_hardPixels_areAWarning();
    void gltf_mirroredTexture_isALossWhereItRepeats();
    void gltf_tintedTexture_isALoss();
    void gltf_alphaMode_decidesWhatIsTransparent_data();
    void gltf_alphaMode_decidesWhatIsTransparent();
    void gltf_alphaOfTheMaterial_multipliesThePicture_data();
    void gltf_alphaOfTheMaterial_multipliesThePicture();
    void gltf_transparentMaterialWithoutTexture_isALoss();
    void gltf_alphaModesOfOnePicture_areIndependent();
    void collada_transformedTexture_isALoss_data();
    void collada_transformedTexture_isALoss();
    void collada_textureThatEnds_isALossWhereItRepeats_data();
    void collada_textureThatEnds_isALossWhereItRepeats();
    void collada_unit_givesTheTrueSize_data();
    void collada_unit_givesTheTrueSize();
    void collada_textureSet_isTheBoundOne_data();
    void collada_textureSet_isTheBoundOne();
    void collada_unclearTextureSet_isALoss();
    void collada_onlyTextureSet_isUsed();
    void threeDs_movedTexture_isALoss_data();
    void threeDs_movedTexture_isALoss();
    void threeDs_masterScale_isALoss_data();
    void threeDs_masterScale_isALoss();
    void threeDs_chunkPastItsParent_isRefusedOrALoss();
    void threeDs_mirroringMatrix_isALoss_data();
    void threeDs_mirroringMatrix_isALoss();
    void fbx_unitAndAxes_areFollowed_data();
    void fbx_unitAndAxes_areFollowed();
    void fbx_impossibleAxes_areRefused();
    void fbx_blendShapes_areALossIfTheyMovePoints();
    void fbx_swappedTexture_isALoss_data();
    void fbx_swappedTexture_isALoss();
    void fbx_embeddedPicturesOfOneName_areDistinguished();
    void fbx_textureSet_isFoundByNameInEachMesh_data();
    void fbx_textureSet_isFoundByNameInEachMesh();
    void fbx_hiddenObject_isALoss();
    void hiddenObject_otherFormats_isALoss();
    void gltf_rotation_mustNotScale();
    void collada_misreadElement_isRefused_data();
    void collada_misreadElement_isRefused();
    void threeMf_paintAndTransparency_areALoss();
    void pictureOfLightOnly_isALoss();
    void fbx_otherMaterialsOfOneMesh_areALoss();
    void fbx_layersOfATexture_areALoss();
    void fbx_unusualInheritanceOfScale_isALossIfItMatters_data();
    void fbx_unusualInheritanceOfScale_isALossIfItMatters();
    void obj_unusualButClear_isRead_data();
    void obj_unusualButClear_isRead();
    void obj_unclearPoint_isRefused_data();
    void obj_unclearPoint_isRefused();
    void obj_someCoordinatesMissing_isALoss();
    void textureCoordinates_notUsable_areALoss_data();
    void textureCoordinates_notUsable_areALoss();
    void gltf_byteOrderMark_isRead();
    void obj_byteOrderMark_isRead();
    void gltf_deeplyNested_isRefused();
    void gltf_skin_movesThePoints_data();
    void gltf_skin_movesThePoints();
    void gltf_integerWeightsInAnotherFile_areRead();
    void gltf_integerWeightsPastTheBuffer_areRefused();
    void gltf_missingSkin_isRefused_data();
    void gltf_missingSkin_isRefused();
    void gltf_morphTargets_moveThePoints_data();
    void gltf_morphTargets_moveThePoints();
    void gltf_integerMorphTarget_isRefused();
    void gltf_unclearSkin_isALoss_data();
    void gltf_unclearSkin_isALoss();
    void gltf_tooFewBindMatrices_areRefused();
    void collada_skin_movesThePoints();
    void fbx_skin_movesThePoints();
    void fbx_meshOfASkin_isPlacedByItsJoints_data();
    void fbx_meshOfASkin_isPlacedByItsJoints();
    void stl_emptyLinesFirst_isRead();
    void mtl_textureOptions_placeTheTexture_data();
    void mtl_textureOptions_placeTheTexture();
    void mtl_unsupportedTextureOptions_areAWarning_data();
    void mtl_unsupportedTextureOptions_areAWarning();
    void mtl_unusualButClear_isRead_data();
    void mtl_unusualButClear_isRead();
    void mtl_statementBeforeAnyMaterial_isRefused();
    void obj_severalMaterialFilesInOneLine_areRead();

private:
    QString write(const QString& name, const QByteArray& bytes) {
        writeFile(folder_.filePath(name), bytes);
        return folder_.filePath(name);
    }
    QByteArray gltf(const QByteArray& before, const QByteArray& after) const {
        const QByteArray whole = squareGltf(png(quarters()));
        return whole.contains(before) ? QByteArray(whole).replace(before, after) : QByteArray();
    }
    // Returns what is lost if this file is imported.
    QString lossesOf(const QByteArray& bytes, const QString& name = QStringLiteral("losses.fbx")) {
        return importModel(write(name, bytes), {}, {}).report.losses.join(u'|');
    }
    QString lossesOf3mf(const QByteArray& model) {
        const QString path = folder_.filePath(QStringLiteral("losses.3mf"));
        write3mf(path, {{QStringLiteral("3D/3dmodel.model"), model}});
        return importModel(path, {}, {}).report.losses.join(u'|');
    }
    // Imports a cube with this material file, which must have the material "skin".
    ImportedModel cubeWith(const QByteArray& materials) {
        write(QStringLiteral("cube.mtl"), materials);
        return importModel(
            write(QStringLiteral("cube.obj"), cubeObj("mtllib cube.mtl\nusemtl skin\n")), {}, {});
    }

    QTemporaryDir folder_;
};

void OddModelsTest::initTestCase() {
    for (const char* name : {"skin.png", "my own skin.png", "two  spaces.png"}) {
        write(QString::fromLatin1(name), png(quarters()));
    }
}

void OddModelsTest::gltf_integerCoordinates_areRefused_data() {
    QTest::addColumn<QByteArray>("accessor");
    QTest::newRow("points") << QByteArray(R"({"bufferView":0,"componentType":)");
    QTest::newRow("texture coordinates") << QByteArray(R"({"bufferView":1,"componentType":)");
}

void OddModelsTest::gltf_integerCoordinates_areRefused() {
    QFETCH(QByteArray, accessor);
    const QByteArray text = gltf(accessor + "5126", accessor + "5123");
    QVERIFY(!text.isEmpty());
    const QString sentence = refusal(write(QStringLiteral("whole.gltf"), text));
    QVERIFY2(sentence.contains(QStringLiteral("float coordinates")), qPrintable(sentence));
    QByteArray binary = squareGlb(png(quarters()));
    binary.replace(accessor + "5126", accessor + "5123");
    QVERIFY(refusal(write(QStringLiteral("whole.glb"), binary))
                .contains(QStringLiteral("float coordinates")));
}

// Light maps use second texture coordinates; glTF 2.0, section 3.7.2.1.
void OddModelsTest::gltf_integerSecondTextureCoordinates_areReadIfUnused() {
    const auto square = [this](const QByteArray& texture) {
        QByteArray text = gltf(R"("TEXCOORD_0":1})", R"("TEXCOORD_0":1,"TEXCOORD_1":3})");
        text.replace(R"("type":"SCALAR"}])",
                     R"("type":"SCALAR"},{"bufferView":1,"componentType":5121,"count":4,)"
                     R"("normalized":true,"type":"VEC2"}])");
        return write(QStringLiteral("further.gltf"), text.replace(R"({"index":0})", texture));
    };
    const QString plain = write(QStringLiteral("plain.gltf"), squareGltf(png(quarters())));
    const QString further = square(R"({"index":0})");
    QCOMPARE(refusal(further), QString());
    QVERIFY(importModel(further, {}, {}).model.textureCoordinates ==
            importModel(plain, {}, {}).model.textureCoordinates);
    const QString sentence = refusal(square(R"({"index":0,"texCoord":1})"));
    QVERIFY2(sentence.contains(QStringLiteral("float coordinates")), qPrintable(sentence));
}

void OddModelsTest::gltf_requiredExtension_isReadOrNamed_data() {
    QTest::addColumn<QByteArray>("extension");
    QTest::addColumn<bool>("isRead");
    for (const char* name : {"KHR_materials_unlit", "KHR_materials_ior", "KHR_lights_punctual",
                             "KHR_texture_transform"}) {
        QTest::newRow(name) << QByteArray(name) << true;
    }
    for (const char* name : {"KHR_mesh_quantization", "EXT_meshopt_compression",
                             "KHR_texture_basisu", "EXT_texture_webp", "ACME_invented"}) {
        QTest::newRow(name) << QByteArray(name) << false;
    }
}

void OddModelsTest::gltf_requiredExtension_isReadOrNamed() {
    QFETCH(QByteArray, extension);
    QFETCH(bool, isRead);
    const QByteArray text =
        gltf(R"("asset":)", R"("extensionsUsed":[")" + extension + R"("],"extensionsRequired":[")" +
                                extension + R"("],"asset":)");
    const QString sentence = refusal(write(QStringLiteral("needs.gltf"), text));
    QCOMPARE(sentence.isEmpty(), isRead);
    QVERIFY2(isRead || sentence.contains(QString::fromLatin1(extension)), qPrintable(sentence));
}

void OddModelsTest::gltf_textureInUnsupportedFormat_isAWarning() {
    const ImportedModel imported = importModel(
        write(QStringLiteral("other.gltf"),
              gltf(R"({"source":0})", R"({"extensions":{"KHR_texture_basisu":{"source":0}}})")),
        {}, {});
    QVERIFY2(warningsOf(imported).contains(QStringLiteral("unsupported format")),
             qPrintable(warningsOf(imported)));
    QCOMPARE(imported.model.textures.size(), std::size_t(0));
}

void OddModelsTest::gltf_hardPixels_areAWarning() {
    for (const auto& [filter, warned] : {std::pair(9728, true), std::pair(9729, false)}) {
        const QByteArray samplers = R"("samplers":[{"magFilter":)" + QByteArray::number(filter);
        QByteArray text = gltf(R"({"source":0})", R"({"source":0,"sampler":0})");
        text.replace(R"("asset":)", samplers + R"(}],"asset":)");
        const ImportedModel imported =
            importModel(write(QStringLiteral("hard.gltf"), text), {}, {});
        QCOMPARE(warningsOf(imported).contains(QStringLiteral("NEAREST")), warned);
    }
}

void OddModelsTest::gltf_scaledTexture_isAWarning() {
    const auto moved = [&](const QByteArray& transform, const QByteArray& before) {
        return gltf(R"("baseColorTexture":{"index":0})",
                    R"("baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":)" +
                        transform + "}}")
            .replace(R"("asset":)",
                     R"("extensionsUsed":["KHR_texture_transform"],)" + before + R"("asset":)");
    };
    for (const char* transform :
         {R"({"scale":[2,2]})", R"({"rotation":0.5})", R"({"texCoord":1})"}) {
        const ImportedModel imported =
            importModel(write(QStringLiteral("scaled.gltf"), moved(transform, "")), {}, {});
        QVERIFY2(warningsOf(imported).contains(QStringLiteral("KHR_texture_transform")),
                 qPrintable(warningsOf(imported)));
    }
    const QByteArray required = R"("extensionsRequired":["KHR_texture_transform"],)";
    const QString sentence =
        refusal(write(QStringLiteral("required.gltf"), moved(R"({"scale":[2,2]})", required)));
    QVERIFY2(sentence.contains(QStringLiteral("KHR_texture_transform")), qPrintable(sentence));
    const ImportedModel offset = importModel(
        write(QStringLiteral("offset.gltf"), moved(R"({"offset":[0.5,0]})", required)), {}, {});
    QVERIFY2(!warningsOf(offset).contains(QStringLiteral("KHR_texture_transform")),
             qPrintable(warningsOf(offset)));
}

void OddModelsTest::gltf_mirroredTexture_isALossWhereItRepeats() {
    const auto lossesAt = [&](const QByteArray& offset) {
        QByteArray text = gltf(R"({"source":0})", R"({"source":0,"sampler":0})");
        text.replace(tint, "");
        text.replace(R"("baseColorTexture":{"index":0})",
                     R"("baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":)"
                     R"({"offset":)" +
                         offset + "}}}");
        text.replace(R"("asset":)", R"("extensionsUsed":["KHR_texture_transform"],)"
                                    R"("samplers":[{"wrapS":33648,"wrapT":33648}],"asset":)");
        return importModel(write(QStringLiteral("mirrored.gltf"), text), {}, {}).report.losses;
    };
    const QStringList none = lossesAt("[0,0]");
    QVERIFY2(none.isEmpty(), qPrintable(none.join(u'|')));
    const QStringList losses = lossesAt("[0.5,0]");
    QCOMPARE(losses.size(), 1);
    QVERIFY2(losses[0].contains(QStringLiteral("mirrors a texture")), qPrintable(losses[0]));
}

void OddModelsTest::gltf_tintedTexture_isALoss() {
    const auto losses = [&](const QByteArray& text) {
        return importModel(write(QStringLiteral("tinted.gltf"), text), {}, {}).report.losses;
    };
    QCOMPARE(losses(gltf(tint, "")), QStringList());
    const QStringList tinted = losses(squareGltf(png(quarters())));
    QCOMPARE(tinted.size(), 1);
    QVERIFY2(tinted[0].contains(QStringLiteral("tints a texture")), qPrintable(tinted[0]));
}

void OddModelsTest::gltf_alphaMode_decidesWhatIsTransparent_data() {
    QTest::addColumn<QByteArray>("mode");
    QTest::addColumn<QList<int>>("alphas"); // of pixels with alpha 0, 127, 128 and 255
    QTest::newRow("none") << QByteArray() << QList<int>{255, 255, 255, 255};
    const auto row = [](const char* mode, const QList<int>& alphas) {
        QTest::newRow(mode) << QByteArray(mode) + "," << alphas;
    };
    row(R"("alphaMode":"OPAQUE")", {255, 255, 255, 255});
    row(R"("alphaMode":"BLEND")", {0, 127, 128, 255});
    row(R"("alphaMode":"MASK")", {0, 0, 255, 255});
    row(R"("alphaMode":"MASK","alphaCutoff":0.25)", {0, 255, 255, 255});
    row(R"("alphaMode":"MASK","alphaCutoff":0)", {255, 255, 255, 255});
    row(R"("alphaMode":"MASK","alphaCutoff":2)", {0, 0, 0, 0});
}

void OddModelsTest::gltf_alphaMode_decidesWhatIsTransparent() {
    QFETCH(QByteArray, mode);
    QFETCH(QList<int>, alphas);
    const QByteArray text = squareGltf(png(fourAlphas()))
                                .replace(tint, "")
                                .replace(R"("name":"paint")", mode + R"("name":"paint")");
    const ImportedModel imported = importModel(write(QStringLiteral("alpha.gltf"), text), {}, {});
    QCOMPARE(alphasOf(imported.model.textures.at(0)), alphas);
    QCOMPARE(imported.model.textures.at(0).pixelColor(0, 0).red(), 255);
}

namespace {

// Returns a square whose material has an alpha, and a picture with different alphas or none.
QByteArray alphaGltf(const QByteArray& mode, const QByteArray& factor, bool hasPicture) {
    const QByteArray colour = R"("baseColorFactor":[1,1,1,)" + factor + "],";
    QByteArray text = squareGltf(png(fourAlphas()))
                          .replace(tint, colour)
                          .replace(R"("name":"paint")", mode + R"("name":"paint")");
    return hasPicture ? text
                      : text.replace(R"("baseColorTexture":{"index":0})", R"("metallicFactor":0)");
}

} // namespace

void OddModelsTest::gltf_alphaOfTheMaterial_multipliesThePicture_data() {
    QTest::addColumn<QByteArray>("mode");
    QTest::addColumn<QByteArray>("factor");
    QTest::addColumn<QList<int>>("alphas"); // of pixels with alpha 0, 127, 128 and 255
    const QByteArray blend = R"("alphaMode":"BLEND",)", mask = R"("alphaMode":"MASK",)";
    QTest::newRow("BLEND") << blend << QByteArray("0.5") << QList<int>{0, 64, 64, 128};
    QTest::newRow("BLEND, 0") << blend << QByteArray("0") << QList<int>{0, 0, 0, 0};
    QTest::newRow("MASK") << mask << QByteArray("0.8") << QList<int>{0, 0, 0, 255};
    QTest::newRow("MASK, below") << mask << QByteArray("0.4") << QList<int>{0, 0, 0, 0};
    QTest::newRow("OPAQUE") << QByteArray() << QByteArray("0.5") << QList<int>{255, 255, 255, 255};
}

void OddModelsTest::gltf_alphaOfTheMaterial_multipliesThePicture() {
    QFETCH(QByteArray, mode);
    QFETCH(QByteArray, factor);
    QFETCH(QList<int>, alphas);
    const QString path = write(QStringLiteral("factor.gltf"), alphaGltf(mode, factor, true));
    const ImportedModel imported = importModel(path, {}, {});
    QCOMPARE(alphasOf(imported.model.textures.at(0)), alphas);
    QCOMPARE(imported.report.losses, QStringList());
}

void OddModelsTest::gltf_transparentMaterialWithoutTexture_isALoss() {
    const auto losses = [&](const QByteArray& mode, const QByteArray& factor) {
        const QString path = write(QStringLiteral("bare.gltf"), alphaGltf(mode, factor, false));
        return importModel(path, {}, {}).report.losses.filter("transparent material").size();
    };
    QCOMPARE(losses(R"("alphaMode":"BLEND",)", "0.5"), 1);
    QCOMPARE(losses(R"("alphaMode":"BLEND",)", "1"), 0);
    QCOMPARE(losses(R"("alphaMode":"MASK",)", "0.4"), 1);
    QCOMPARE(losses(R"("alphaMode":"MASK",)", "0.6"), 0);
    QCOMPARE(losses("", "0.5"), 0);
}

void OddModelsTest::gltf_alphaModesOfOnePicture_areIndependent() {
    QByteArray text = squareGltf(png(fourAlphas())).replace(tint, "");
    const QByteArray primitive =
        R"({"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":1})";
    text.replace(R"("meshes":[{"primitives":[)", R"("meshes":[{"primitives":[)" + primitive + ",");
    text.replace(R"("materials":[)",
                 R"("materials":[{"name":"glass","alphaMode":"BLEND",)"
                 R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0}}},)");
    const TexturedMesh model = importModel(write(QStringLiteral("two.gltf"), text), {}, {}).model;
    const auto alphas = [&](const char* name) {
        for (const Material& material : model.materials) {
            if (material.name == QLatin1String(name)) {
                return alphasOf(model.textures.at(std::size_t(material.texture)));
            }
        }
        return QList<int>();
    };
    QCOMPARE(alphas("glass"), (QList<int>{0, 127, 128, 255}));
    QCOMPARE(alphas("paint"), (QList<int>{255, 255, 255, 255}));
}

void OddModelsTest::collada_transformedTexture_isALoss_data() {
    QTest::addColumn<QByteArray>("transform");
    QTest::addColumn<bool>("isLoss");
    QTest::newRow("none") << QByteArray() << false;
    const auto row = [](const char* element, bool isLoss) {
        QTest::newRow(element) << QByteArray(element) << isLoss;
    };
    row("<offsetU>0.5</offsetU>", false);
    row("<repeatU>1</repeatU>", false);
    row("<repeatU>2</repeatU>", true);
    row("<repeatV>0.5</repeatV>", true);
    row("<rotateUV>90</rotateUV>", true);
}

void OddModelsTest::collada_transformedTexture_isALoss() {
    QFETCH(QByteArray, transform);
    QFETCH(bool, isLoss);
    const QByteArray file =
        squareCollada().replace("</texture>", "<extra><technique profile=\"MAYA\">" + transform +
                                                  "</technique></extra></texture>");
    const ImportedModel imported = importModel(write(QStringLiteral("a.dae"), file), {}, {});
    QCOMPARE(imported.model.textures.size(), std::size_t(1));
    QVERIFY2(imported.report.losses.size() == (isLoss ? 1 : 0), qPrintable(warningsOf(imported)));
    QVERIFY(!isLoss || imported.report.losses[0].contains(QStringLiteral("scales or rotates")));
}

void OddModelsTest::collada_textureThatEnds_isALossWhereItRepeats_data() {
    QTest::addColumn<QByteArray>("wrap");
    QTest::addColumn<bool>("isLoss");
    QTest::newRow("none") << QByteArray() << false;
    QTest::newRow("WRAP") << QByteArray("<wrap_s>WRAP</wrap_s><wrap_t> WRAP </wrap_t>") << false;
    for (const char* mode : {"CLAMP", "MIRROR", "BORDER", "NONE"}) {
        QTest::addRow("%s", mode) << "<wrap_t>" + QByteArray(mode) + "</wrap_t>" << true;
    }
}

void OddModelsTest::collada_textureThatEnds_isALossWhereItRepeats() {
    QFETCH(QByteArray, wrap);
    QFETCH(bool, isLoss);
    const QByteArray file = squareCollada().replace("</sampler2D>", wrap + "</sampler2D>");
    const auto losses = [&](const QByteArray& bytes) {
        return importModel(write(QStringLiteral("wrap.dae"), bytes), {}, {}).report.losses;
    };
    QCOMPARE(losses(file), QStringList());
    const QStringList past =
        losses(QByteArray(file).replace(">0 0 1 0 1 1 0 1<", ">0 0 2 0 2 2 0 2<"));
    QCOMPARE(past.size(), isLoss ? 1 : 0);
    QVERIFY(!isLoss || past[0].contains(QStringLiteral("mirrors a texture")));
}

void OddModelsTest::collada_unit_givesTheTrueSize_data() {
    QTest::addColumn<QByteArray>("unit");
    QTest::addColumn<float>("edge"); // mm
    QTest::newRow("metre") << QByteArray(R"(<unit name="metre" meter="1"/>)") << 1000.0F;
    QTest::newRow("inch") << QByteArray(R"(<unit name="inch" meter="0.0254"/>)") << 25.4F;
    QTest::newRow("millimetre") << QByteArray(R"(<unit name="mm" meter="0.001"/>)") << 1.0F;
    QTest::newRow("none, so metre") << QByteArray() << 1000.0F;
}

void OddModelsTest::collada_unit_givesTheTrueSize() {
    QFETCH(QByteArray, unit);
    QFETCH(float, edge);
    const QByteArray file = squareCollada().replace(R"(<unit name="metre" meter="1"/>)", unit);
    const ImportedModel imported = importModel(write(QStringLiteral("unit.dae"), file), {}, {});
    const Eigen::Vector3f sizes = imported.report.box.sizes();
    QVERIFY(sizes.isApprox(Eigen::Vector3f(edge, edge, 0), 1e-4F));
    QVERIFY(namesUnit(QStringLiteral("unit.DAE")));
}

void OddModelsTest::collada_textureSet_isTheBoundOne_data() {
    QTest::addColumn<QByteArray>("symbol");
    QTest::addColumn<int>("set");      // of the coordinates that the texture uses
    QTest::addColumn<int>("otherSet"); // of the coordinates that it does not use
    for (const char* symbol : {"UVMap", "map1", "CHANNEL2", "UVMap.001", "0"}) {
        QTest::addRow("%s first", symbol) << QByteArray(symbol) << 0 << 1;
        QTest::addRow("%s second", symbol) << QByteArray(symbol) << 1 << 0;
        QTest::addRow("%s, high numbers", symbol) << QByteArray(symbol) << 5 << 3;
    }
}

void OddModelsTest::collada_textureSet_isTheBoundOne() {
    QFETCH(QByteArray, symbol);
    QFETCH(int, set);
    QFETCH(int, otherSet);
    const ImportedModel imported = importModel(
        write(QStringLiteral("two.dae"), twoSetsCollada(symbol, set, otherSet)), {}, {});
    QCOMPARE(imported.model.textureCoordinates.at(0)[2], Eigen::Vector2f(1, 1));
    QVERIFY2(imported.report.losses.isEmpty(), qPrintable(warningsOf(imported)));
}

void OddModelsTest::collada_unclearTextureSet_isALoss() {
    const QByteArray file = twoSetsCollada("UVMap", 1, 0);
    for (const QByteArray& unclear :
         {QByteArray(file).replace("input_set=", "no_set="),
          QByteArray(file).replace("bind_vertex_input", "bind"),
          QByteArray(file).replace("input_set=\"1\"", "input_set=\"7\"")}) {
        const ImportedModel imported =
            importModel(write(QStringLiteral("unclear.dae"), unclear), {}, {});
        QVERIFY2(warningsOf(imported).contains(QStringLiteral("several sets")),
                 qPrintable(warningsOf(imported)));
    }
}

// 3ds Max writes such files.
void OddModelsTest::collada_onlyTextureSet_isUsed() {
    const QByteArray file = renamedSetCollada("CHANNEL1", 1);
    const ImportedModel imported = importModel(write(QStringLiteral("one.dae"), file), {}, {});
    QCOMPARE(imported.model.textureCoordinates.at(0)[2], Eigen::Vector2f(1, 1));
    QVERIFY2(imported.report.losses.isEmpty(), qPrintable(warningsOf(imported)));
}

void OddModelsTest::threeDs_movedTexture_isALoss_data() {
    QTest::addColumn<QByteArray>("options");
    QTest::addColumn<bool>("isLoss");
    QTest::newRow("none") << QByteArray() << false;
    QTest::newRow("as usual") << chunk3ds(0xa354, 1) + chunk3ds(0xa356, 1) +
                                     chunk3ds(0xa358, 0.0F) + chunk3ds(0xa35a, 0.0F) +
                                     chunk3ds(0xa35c, 0.0F)
                              << false;
    QTest::newRow("scaled along u") << chunk3ds(0xa354, 2) << true;
    QTest::newRow("scaled along v") << chunk3ds(0xa356, 0.5F) << true;
    QTest::newRow("moved along u") << chunk3ds(0xa358, 0.25F) << true;
    QTest::newRow("moved along v") << chunk3ds(0xa35a, 0.25F) << true;
    QTest::newRow("rotated") << chunk3ds(0xa35c, 90) << true;
}

void OddModelsTest::threeDs_movedTexture_isALoss() {
    QFETCH(QByteArray, options);
    QFETCH(bool, isLoss);
    const QString path = write(QStringLiteral("moved.3ds"), textured3ds({.texture = options}));
    const ImportedModel imported = importModel(path, {}, {});
    QCOMPARE(imported.model.textures.size(), std::size_t(1));
    QVERIFY(imported.report.closed);
    QVERIFY2(imported.report.losses.size() == (isLoss ? 1 : 0), qPrintable(warningsOf(imported)));
    QVERIFY(!isLoss || imported.report.losses[0].contains(QStringLiteral("moves, scales")));
}

void OddModelsTest::threeDs_masterScale_isALoss_data() {
    QTest::addColumn<float>("scale");
    QTest::addColumn<bool>("isLoss");
    QTest::newRow("as usual") << 1.0F << false;
    QTest::newRow("unset") << 0.0F << false;
    QTest::newRow("twice") << 2.0F << true;
    QTest::newRow("negative") << -1.0F << true;
    QTest::newRow("tiny") << std::numeric_limits<float>::denorm_min() << true;
    QTest::newRow("not a number") << std::numeric_limits<float>::quiet_NaN() << true;
}

void OddModelsTest::threeDs_masterScale_isALoss() {
    QFETCH(float, scale);
    QFETCH(bool, isLoss);
    const QByteArray file = textured3ds({.scene = chunk3ds(0x0100, scale)});
    const ImportedModel imported = importModel(write(QStringLiteral("scaled.3ds"), file), {}, {});
    QVERIFY2(imported.report.losses.size() == (isLoss ? 1 : 0), qPrintable(warningsOf(imported)));
    QVERIFY(!isLoss || imported.report.losses[0].contains(QStringLiteral("master scale")));
    QVERIFY(imported.report.box.sizes().isApprox(Eigen::Vector3f(10, 10, 10), 1e-5F));
}

// assimp 5.2.5 refuses all of these files.
void OddModelsTest::threeDs_chunkPastItsParent_isRefusedOrALoss() {
    const QByteArray last = chunk3ds(0x4160, QByteArray(48, '\0')); // of its mesh and object
    const QByteArray file =
        textured3ds({.mesh = last, .scene = chunk3ds(0x7001, QByteArray(300, '\0'))});
    for (const quint32 more : {1, 6, 20, 200}) {
        QByteArray past = file;
        qToLittleEndian(quint32(last.size()) + more, past.data() + file.indexOf(last) + 2);
        const QString path = write(QStringLiteral("past.3ds"), past);
        QVERIFY(!refusal(path).isEmpty() ||
                warningsOf(importModel(path, {}, {})).contains(QStringLiteral("do not fit")));
    }
}

void OddModelsTest::threeDs_mirroringMatrix_isALoss_data() {
    QTest::addColumn<float>("x"); // length of the first axis
    QTest::addColumn<bool>("isLoss");
    QTest::newRow("the unit matrix") << 1.0F << false;
    QTest::newRow("larger") << 2.0F << false;
    QTest::newRow("mirrored") << -1.0F << true;
}

void OddModelsTest::threeDs_mirroringMatrix_isALoss() {
    QFETCH(float, x);
    QFETCH(bool, isLoss);
    QByteArray matrix;
    for (const float number :
         {x, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 5.0F, 0.0F, 0.0F}) {
        matrix += chunk3ds(0, number).right(4);
    }
    const QByteArray file = textured3ds({.mesh = chunk3ds(0x4160, matrix)});
    const ImportedModel imported = importModel(write(QStringLiteral("mirror.3ds"), file), {}, {});
    QVERIFY2(imported.report.losses.size() == (isLoss ? 1 : 0), qPrintable(warningsOf(imported)));
    QVERIFY(!isLoss ||
            imported.report.losses[0].contains(QStringLiteral("mirrors: 1, first part")));
    // The faces point outwards as stored, and keep their texture coordinates.
    const ImportedModel plain =
        importModel(write(QStringLiteral("plain.3ds"), textured3ds({})), {}, {});
    QVERIFY2(imported.report.repairs.isEmpty(), qPrintable(imported.report.repairs.join(u' ')));
    QCOMPARE(imported.report.volume, plain.report.volume);
    QVERIFY(imported.model.textureCoordinates == plain.model.textureCoordinates);
}

void OddModelsTest::fbx_unitAndAxes_areFollowed_data() {
    QTest::addColumn<Axes>("axes");
    QTest::addColumn<double>("unit");        // cm
    QTest::addColumn<Eigen::Matrix3f>("to"); // from the file's coordinates to mm
    const auto row = [](const char* name, const Axes& axes, double unit, const Eigen::Vector3f& x,
                        const Eigen::Vector3f& y, const Eigen::Vector3f& z) {
        Eigen::Matrix3f to;
        to << x, y, z;
        QTest::newRow(name) << axes << unit << to;
    };
    row("centimetre", {}, 1, {10, 0, 0}, {0, 10, 0}, {0, 0, 10});
    row("millimetre", yUp, 0.1, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    row("inch, Z up", zUp, 2.54, {25.4F, 0, 0}, {0, 0, -25.4F}, {0, 25.4F, 0});
    row("metre, X up, front Z, right -Y",
        {{"UpAxis", 0}, {"FrontAxis", 2}, {"CoordAxis", 1}, {"CoordAxisSign", -1}}, 100,
        {0, 1000, 0}, {-1000, 0, 0}, {0, 0, 1000});
    row("left-handed", {{"FrontAxisSign", -1}}, 1, {10, 0, 0}, {0, 10, 0}, {0, 0, -10});
}

void OddModelsTest::fbx_unitAndAxes_areFollowed() {
    QFETCH(Axes, axes);
    QFETCH(double, unit);
    QFETCH(Eigen::Matrix3f, to);
    const Eigen::AlignedBox3f box(Eigen::Vector3f::Zero(), Eigen::Vector3f::Constant(10));
    const Eigen::AlignedBox3f expected = box.transformed(Eigen::Affine3f(to));
    for (const QByteArray& file : {tetrahedronBinaryFbx(axes, unit), textFbx(axes, unit)}) {
        const QString path = write(QStringLiteral("axes.fbx"), file);
        const ImportedModel imported = importModel(path, {}, {});
        QVERIFY2(imported.report.losses.isEmpty(), qPrintable(warningsOf(imported)));
        QVERIFY(imported.report.box.isApprox(expected, 1e-3F));
        QVERIFY(imported.report.volume > 0);
        QVERIFY2(imported.report.repairs.isEmpty(), qPrintable(imported.report.repairs.join(u'|')));
        QVERIFY(namesUnit(path));
    }
}

void OddModelsTest::fbx_impossibleAxes_areRefused() {
    for (const QByteArray& file :
         {textFbx({{"UpAxis", 2}}, 1), textFbx({{"UpAxis", 7}}, 1), tetrahedronBinaryFbx(zUp, -1),
          tetrahedronBinaryFbx(zUp, qQNaN())}) {
        const QString sentence = refusal(write(QStringLiteral("axes.fbx"), file));
        QVERIFY2(sentence.contains(QStringLiteral("GlobalSettings")), qPrintable(sentence));
    }
}

void OddModelsTest::fbx_blendShapes_areALossIfTheyMovePoints() {
    const auto text = [](const QByteArray& property) {
        return texturedFbx({}).replace("Objects: {",
                                       "Objects: {\n Deformer: 7000, \"SubDeformer::c\", "
                                       "\"BlendShapeChannel\" {\n" +
                                           property + "\n }");
    };
    const auto losses = [&](const QByteArray& file) {
        return importModel(write(QStringLiteral("shapes.fbx"), file), {}, {}).report.losses;
    };
    QCOMPARE(losses(text("DeformPercent: 0")), QStringList());
    QCOMPARE(losses(text("P: \"d|DeformPercent\", \"Number\", \"\", \"A\",50")), QStringList());
    QCOMPARE(losses(tetrahedronBinaryFbx()), QStringList());
    for (const QByteArray& file :
         {text("DeformPercent: 50"), text("P: \"DeformPercent\", \"Number\", \"\", \"A\",0.5"),
          tetrahedronBinaryFbx({}, 1, -20)}) {
        const QString found = losses(file).join(u'|');
        QVERIFY2(found.contains(QStringLiteral("blend shapes")), qPrintable(found));
    }
}

void OddModelsTest::fbx_swappedTexture_isALoss_data() {
    QTest::addColumn<QByteArray>("swap");
    QTest::addColumn<bool>("isLoss");
    QTest::newRow("off") << QByteArray(R"(P: "UVSwap", "bool", "", "",0)") << false;
    QTest::newRow("on") << QByteArray(R"(P: "UVSwap", "bool", "", "",1)") << true;
}

void OddModelsTest::fbx_swappedTexture_isALoss() {
    QFETCH(QByteArray, swap);
    QFETCH(bool, isLoss);
    const QString path = write(QStringLiteral("a.fbx"), texturedFbx(swap));
    const ImportedModel imported = importModel(path, {}, {});
    QCOMPARE(imported.model.textures.size(), std::size_t(1));
    QCOMPARE(warningsOf(imported).contains(QStringLiteral("scales or rotates")), isLoss);
}

void OddModelsTest::fbx_embeddedPicturesOfOneName_areDistinguished() {
    const auto embedded = [](const QByteArray& number, const QByteArray& folder, int side) {
        const QByteArray name = '"' + folder + "/skin.png\"\n";
        return " Video: " + number +
               ", \"Video::v\", \"Clip\" {\n  Type: \"Clip\"\n  Filename: " + name +
               "  RelativeFilename: " + name + "  Content: ,\n \"" +
               png(quarters(side)).toBase64() + "\"\n }\n";
    };
    const QByteArray file = texturedFbx({})
                                .replace("\"skin.png\"", "\"b/skin.png\"")
                                .replace("Objects: {", "Objects: {\n" + embedded("6000", "a", 8) +
                                                           embedded("6001", "b", 4))
                                .replace("Connections: {", "Connections: {\n C: \"OO\",6001,4000");
    QVERIFY(file.contains("6000"));
    const auto shown = [&](const QByteArray& text) {
        return importModel(write(QStringLiteral("embedded.fbx"), text), {}, {}).model.textures;
    };
    const auto connected = shown(file);
    QCOMPARE(connected.size(), std::size_t(1));
    QCOMPARE(connected[0], quarters(4));
    QByteArray other = file;
    other.replace("C: \"OO\",6001,4000", "C: \"OO\",6000,4001"); // of no texture
    other.replace("b/skin.png", "c/skin.png");                   // beside the model
    const auto beside = shown(other);
    QCOMPARE(beside.size(), std::size_t(1));
    QCOMPARE(beside[0], quarters());
}

void OddModelsTest::fbx_textureSet_isFoundByNameInEachMesh_data() {
    QTest::addColumn<QByteArray>("named");
    QTest::addColumn<QByteArray>("second"); // set of the second mesh
    QTest::addColumn<float>("expected");    // texture coordinate of both meshes
    QTest::addColumn<bool>("isLoss");
    const auto row = [](const char* name, const char* named, const char* second, float expected,
                        bool isLoss) {
        QTest::newRow(name) << QByteArray(named) << QByteArray(second) << expected << isLoss;
    };
    row("first set", "map", "map", 1, false);
    row("second set", "half", "half", 0.5F, false);
    row("in another order", "half", "map", 0.5F, false);
    row("default", "default", "half", 1, false);
    row("in one mesh only", "half", "lost", 1, true);
    row("in no mesh", "lost", "half", 1, true);
}

// Two meshes with the sets "map" and "half", which the second may have in another order.
void OddModelsTest::fbx_textureSet_isFoundByNameInEachMesh() {
    QFETCH(QByteArray, named);
    QFETCH(QByteArray, second);
    QFETCH(float, expected);
    QFETCH(bool, isLoss);
    QByteArray file = texturedFbx(R"(P: "UVSet", "KString", "", "", ")" + named + '"');
    const QByteArray all = "0,0,1,0,1,1,0,1", half = "0,0,0.5,0,0.5,0.5,0,0.5";
    const qsizetype set = file.indexOf("LayerElementUV"), next = file.indexOf("LayerElementMat");
    QByteArray further = file.mid(set, next - set);
    further.replace("UV: 0", "UV: 1").replace("\"map\"", "\"half\"").replace(all, half);
    file.insert(next, further);
    file.replace("  Layer: 0 {", "  Layer: 1 {\n LayerElement: {\n Type: \"LayerElementUV\"\n "
                                 "TypedIndex: 1\n }\n }\n  Layer: 0 {");
    const qsizetype begin = file.indexOf(" Geometry:"), end = file.indexOf(" Model:");
    QByteArray geometry = file.mid(begin, end - begin);
    geometry.replace("1000", "1001").replace("0,0,0,1,0,0,1,2,0,0,2,0", "5,0,0,6,0,0,6,2,0,5,2,0");
    if (second == "map") { // exchanges the sets
        geometry.replace("\"map\"", "\"?\"").replace("\"half\"", "\"map\"").replace("?", "half");
        geometry.replace(all, "?").replace(half, all).replace("?", half);
    }
    geometry.replace("\"half\"", second == "lost" ? "\"lost\"" : "\"half\"");
    file.insert(end, geometry + " Model: 2001, \"Model::n\", \"Mesh\" {\n  Version: 232\n }\n");
    file.replace("Connections: {", "Connections: {\n C: \"OO\",2001,0\n C: \"OO\",1001,2001\n C: "
                                   "\"OO\",3000,2001");
    const ImportedModel imported = importModel(write(QStringLiteral("sets.fbx"), file), {}, {});
    QCOMPARE(imported.report.triangles, std::size_t(4));
    QCOMPARE(warningsOf(imported).contains(QStringLiteral("several sets")), isLoss);
    for (std::size_t t = 0; t < (isLoss ? 2 : 4); ++t) {
        float largest = 0;
        for (const Eigen::Vector2f& corner : imported.model.textureCoordinates[t]) {
            largest = std::max(largest, corner.maxCoeff());
        }
        QCOMPARE(largest, expected);
    }
}

void OddModelsTest::hiddenObject_otherFormats_isALoss() {
    const auto losses = [&](const QString& file, const QByteArray& bytes) {
        return importModel(write(file, bytes), {}, {}).report.losses.join(u' ');
    };
    const QString gltfLoss = losses(
        QStringLiteral("hidden.gltf"),
        gltf(R"({"mesh":0})",
             R"({"mesh":0,"name":"n","extensions":{"KHR_node_visibility":{"visible":false}}})"));
    QVERIFY2(gltfLoss.startsWith(QStringLiteral("Hidden objects: 1, first n.")),
             qPrintable(gltfLoss));
    const QByteArray model = textured3ds({.object = chunk3ds(0x4010, QByteArray())});
    const QString loss = losses(QStringLiteral("hidden.3ds"), model);
    QVERIFY2(loss.startsWith(QStringLiteral("Hidden objects: 1, first part.")), qPrintable(loss));
    QCOMPARE(lossesOf3mf(threeMf(R"(type="model")", R"(printable="1")")), QString());
    const QString hidden = QStringLiteral("Hidden objects: 1, first 3.");
    QVERIFY(lossesOf3mf(threeMf({}, R"(printable="0")")).startsWith(hidden));
    QVERIFY(lossesOf3mf(threeMf(R"(type="other")", {})).startsWith(hidden));
}

void OddModelsTest::gltf_rotation_mustNotScale() {
    const auto refused = [&](const QByteArray& rotation) {
        return refusal(write(QStringLiteral("turned.gltf"),
                             gltf(R"({"mesh":0})", R"({"mesh":0,"rotation":)" + rotation + "}")));
    };
    QCOMPARE(refused("[0, 0, 0.7071, 0.7071]"), QString()); // rounded
    QVERIFY(refused("[0, 0, 0.7, 0.7]").contains(QStringLiteral("quaternion of length 1")));
    QVERIFY(refused("[0, 0, 0, 0]").contains(QStringLiteral("quaternion of length 1")));
}

void OddModelsTest::collada_misreadElement_isRefused_data() {
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("after");
    QTest::addColumn<QString>("says"); // empty if it is read
    const QByteArray node = R"(<node id="n">)";
    const auto turned = [&](const char* turn) { return node + "<rotate>" + turn + "</rotate>"; };
    QTest::newRow("axis") << node << turned("0 0 1 90") << QString();
    QTest::newRow("longer axis") << node << turned("0 0 2 90") << QStringLiteral("length is not 1");
    QTest::newRow("no axis") << node << turned("0 0 0 90") << QStringLiteral("length is not 1");
    QTest::newRow("no turn") << node << turned("0 0 0 0") << QString();
    QTest::newRow("skew") << node << node + "<skew>30 1 0 0 0 1 0</skew>"
                          << QStringLiteral("skews a node");
    QTest::newRow("fans") << QByteArray("triangles") << QByteArray("trifans")
                          << QStringLiteral("fans of triangles");
    for (const char* name : {"<ref>skin.png</ref>", "", "\n"}) {
        QTest::addRow("image: %s", name) << QByteArray("skin.png") << QByteArray(name)
                                         << QStringLiteral("the image in line 4 has no file name");
    }
}

void OddModelsTest::collada_misreadElement_isRefused() {
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    QFETCH(QString, says);
    const QString sentence =
        refusal(write(QStringLiteral("odd.dae"), squareCollada().replace(before, after)));
    QVERIFY2(says.isEmpty() ? sentence.isEmpty() : sentence.contains(says), qPrintable(sentence));
}

void OddModelsTest::fbx_hiddenObject_isALoss() {
    const auto text = [](const char* visibility) {
        const QByteArray property = R"(P: "Visibility", "Visibility", "", "A",)";
        return withModelProperty(property + visibility);
    };
    QCOMPARE(lossesOf(text("1")), QString());
    QCOMPARE(lossesOf(tetrahedronBinaryFbx()), QString());
    QByteArray layer = text("1"); // an object after the model is hidden, not the model
    layer.insert(layer.lastIndexOf('}', layer.indexOf("Connections: {")),
                 " CollectionExclusive: 77, \"DisplayLayer::l\", \"DisplayLayer\" {\n"
                 "  Properties70: {\n   P: \"Visibility\", \"bool\", \"\", \"\",0\n  }\n }\n");
    QCOMPARE(lossesOf(layer), QString());
    QVERIFY(lossesOf(text("0")).startsWith(QStringLiteral("Hidden objects: 1, first m.")));
    QVERIFY(lossesOf(tetrahedronBinaryFbx({}, 1, 0, 0))
                .startsWith(QStringLiteral("Hidden objects: 1, first part.")));
}

void OddModelsTest::threeMf_paintAndTransparency_areALoss() {
    const auto losses = [&](const QByteArray& before, const QByteArray& after) {
        return lossesOf3mf(threeMf({}, {}).replace(before, after));
    };
    QCOMPARE(losses("#FF0000", "#FF0000ff"), QString());
    QVERIFY(losses("#FF0000", "#FF000080").contains(QStringLiteral("transparent material")));
    const QString painted = QStringLiteral("painted in a slicer");
    QVERIFY(losses("<triangle ", "<triangle paint_color=\"4\" ").contains(painted));
    QVERIFY(losses("<triangle ", "<triangle s:mmu_segmentation=\"4\" xmlns:s=\"s\" ")
                .contains(painted));
    // A transparent material that no triangle uses is not reported.
    QCOMPARE(losses("</base", "<base name=\"b\" displaycolor=\"#00FF0080\"/></base"), QString());
}

void OddModelsTest::pictureOfLightOnly_isALoss() {
    const QString expected = QStringLiteral("picture of its light (emission)");
    const QByteArray collada = squareCollada().replace("diffuse>", "emission>");
    QVERIFY(lossesOf(collada, QStringLiteral("light.dae")).contains(expected));
    QByteArray both = squareCollada();
    const qsizetype begin = both.indexOf("<diffuse>");
    QByteArray light = both.mid(begin, both.indexOf("</lambert>") - begin);
    both.insert(begin, light.replace("diffuse>", "emission>"));
    QCOMPARE(lossesOf(both, QStringLiteral("light.dae")), QString());
    const QByteArray texture = R"("baseColorTexture":{"index":0}})";
    QVERIFY(lossesOf(gltf(texture, R"("roughnessFactor":1},"emissiveTexture":{"index":0})"),
                     QStringLiteral("light.gltf"))
                .contains(expected));
}

void OddModelsTest::fbx_otherMaterialsOfOneMesh_areALoss() {
    const auto shared = [](const QByteArray& material) {
        return texturedFbx({})
            .replace("Connections: {", "Connections: {\n C: \"OO\",2001,0\n C: \"OO\",1000,2001\n"
                                       " C: \"OO\"," +
                                           material + ",2001")
            .replace("Objects: {", "Objects: {\n Model: 2001, \"Model::second\", \"Mesh\" {\n }\n"
                                   " Material: 3001, \"Material::bare\", \"\" {\n }");
    };
    QCOMPARE(lossesOf(shared("3000")), QString());
    const QString losses = lossesOf(shared("3001"));
    QVERIFY2(losses.contains(QStringLiteral("not its materials: 1, first ")), qPrintable(losses));
}

void OddModelsTest::fbx_layersOfATexture_areALoss() {
    const auto layered = [](const QByteArray& property) {
        const QByteArray file = texturedFbx({}).replace(
            "Connections: {", "Connections: {\n C: \"OP\",5000,3000, \"" + property + "\"");
        return QByteArray(file).replace(
            "Objects: {", "Objects: {\n LayeredTexture: 5000, \"LayeredTexture::l\", \"\" {\n"
                          "  LayeredTexture: 100\n }");
    };
    QCOMPARE(lossesOf(layered("Bump")), QString());
    const QString losses = lossesOf(layered("DiffuseColor"));
    QVERIFY2(losses.contains(QStringLiteral("several layers")), qPrintable(losses));
}

void OddModelsTest::fbx_unusualInheritanceOfScale_isALossIfItMatters_data() {
    QTest::addColumn<QByteArray>("type");
    QTest::addColumn<QByteArray>("scale"); // of the parent's parent
    QTest::addColumn<bool>("isLoss");
    const auto row = [](const char* name, const char* type, const char* scale, bool isLoss) {
        QTest::newRow(name) << QByteArray(type) << QByteArray(scale) << isLoss;
    };
    row("usual", "1", "1,2,3", false);
    row("scale of the parent moved", "0", "1,2,3", true);
    row("the same in all directions", "0", "2,2,2", false);
    row("scale of the parent left out", "2", "2,2,2", true);
    row("the parent is not scaled", "2", "1,1,1", false);
}

void OddModelsTest::fbx_unusualInheritanceOfScale_isALossIfItMatters() {
    QFETCH(QByteArray, type);
    QFETCH(QByteArray, scale);
    QFETCH(bool, isLoss);
    const QByteArray file =
        withModelProperty(R"(P: "InheritType", "enum", "", "",)" + type)
            .replace("C: \"OO\",2000,0", "C: \"OO\",2000,2001\n C: \"OO\",2001,2002\n C: "
                                         "\"OO\",2002,0")
            .replace("Objects: {",
                     "Objects: {\n Model: 2001, \"Model::p\", \"Null\" {\n }\n Model: 2002, "
                     "\"Model::q\", \"Null\" {\n Properties70: {\n P: \"Lcl Scaling\", \"Lcl "
                     "Scaling\", \"\", \"A\"," +
                         scale + "\n }\n }");
    const QString losses = lossesOf(file);
    QCOMPARE(losses.contains(QStringLiteral("(InheritType): 1, first m.")), isLoss);
    QCOMPARE(losses.isEmpty(), !isLoss);
}

// assimp would leave these lines out, and the faces would then name other points.
void OddModelsTest::obj_unusualButClear_isRead_data() {
    QTest::addColumn<QByteArray>("before"); // in cubeObj()
    QTest::addColumn<QByteArray>("after");
    const QByteArray second = "v 5 -5 -5";
    const auto point = [&](const char* name, const QByteArray& line) {
        QTest::newRow(name) << second << line;
    };
    point("no digit before the decimal point", "v .5e1 -5 -5");
    point("signs before the decimal point", "v +.5e1 -.5e1 -5");
    point("a comment with digits", second + " # 1 2");
    point("a comment with a number of three digits", second + " #123 4 5");
    point("indented", " \t" + second + " ");
    point("continued", "v 5 \\\n-5\\\r\n -5");
    point("colour", "v 5 -5 -5 1 1 1");
    point("colour without digits before the decimal point", "v 5 -5 -5 1 1.0 1.");
    point("weight 1", "v 5 -5 -5 1.0");
    point("comment that ends like a continued line", "# from C:\\\n" + second);
    QTest::newRow("comment after a face") << QByteArray("f 1/1") << QByteArray("#\n  f 1/1");
    QTest::newRow("comments after all lines") << QByteArray("\n") << QByteArray(" # 1 2 3\n");
    QTest::newRow("carriage returns") << QByteArray("\n") << QByteArray("\r");
    QTest::newRow("texture coordinates") << QByteArray("vt 0 0") << QByteArray("vt .0 .0 # 1");
}

void OddModelsTest::obj_unusualButClear_isRead() {
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, after);
    QVERIFY(cubeObj().contains(before));
    const QByteArray text = cubeObj().replace(before, after);
    const ImportedModel imported = importModel(write(QStringLiteral("odd.obj"), text), {}, {});
    const ImportedModel plain = importModel(write(QStringLiteral("odd.obj"), cubeObj()), {}, {});
    QVERIFY(imported.model.mesh.positions == plain.model.mesh.positions);
    QVERIFY(imported.model.mesh.triangles == plain.model.mesh.triangles);
    QVERIFY(imported.model.textureCoordinates == plain.model.textureCoordinates);
    const bool hasColour = after.contains("-5 1 1");
    QCOMPARE(imported.report.losses.size(), hasColour ? 1 : 0);
}

void OddModelsTest::obj_unclearPoint_isRefused_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QString>("reason");
    const auto row = [](const QByteArray& line, const char* reason) {
        QTest::newRow(line) << line << QString::fromLatin1(reason);
    };
    row("v 5 -5", "line 4 gives a point by 2 numbers");
    row("v 5 -5 zero", "line 4 gives a point by 2 numbers");
    row("v 5 -5 -5 .2 .3", "line 4 gives a point by 5 numbers");
    row("v 5 -5 -5 1 .2 .3 .4", "line 4 gives a point by 7 numbers");
    row("v 5 -5 -5 .5", "line 4 gives a point the weight 0.5");
    row("v 5 -5 1.#IND", "not numbers");
}

void OddModelsTest::obj_unclearPoint_isRefused() {
    QFETCH(QByteArray, line);
    QFETCH(QString, reason);
    const QByteArray text = cubeObj().replace("v 5 -5 -5", line);
    const QString sentence = refusal(write(QStringLiteral("unclear.obj"), text));
    QVERIFY2(sentence.contains(reason), qPrintable(sentence));
}

// Two sides of a tetrahedron name texture coordinates, and two do not.
void OddModelsTest::obj_someCoordinatesMissing_isALoss() {
    write(QStringLiteral("some.mtl"), "newmtl skin\nmap_Kd skin.png\n");
    const QByteArray some = "mtllib some.mtl\nusemtl skin\nv 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\n"
                            "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 3/2 2/3\nf 1/1 2/2 4/3\n";
    const auto losses = [&](const QByteArray& others) {
        const QString file = write(QStringLiteral("some.obj"), some + others);
        return importModel(file, {}, {}).report.losses;
    };
    QCOMPARE(losses("f 2/1 3/2 4/3\nf 3/1 1/2 4/3\n"), QStringList());
    const QStringList found = losses("f 2 3 4\nf 3 1 4\n");
    QCOMPARE(found.size(), 1);
    QVERIFY2(found[0].contains(QStringLiteral("triangles (2)")), qPrintable(found[0]));
}

void OddModelsTest::textureCoordinates_notUsable_areALoss_data() {
    QTest::addColumn<QByteArray>("first"); // of the square's four corners
    QTest::addColumn<QByteArray>("others");
    QTest::newRow("one is NaN") << QByteArray("nan nan") << QByteArray("0.2 0.3");
    QTest::newRow("half of one is NaN") << QByteArray("nan 0.5") << QByteArray("0.2 0.3");
    QTest::newRow("one is infinite") << QByteArray("inf 0") << QByteArray("0.2 0.3");
    QTest::newRow("one is too large") << QByteArray("1e30 0") << QByteArray("0.2 0.3");
    QTest::newRow("one has too many digits")
        << QByteArray(QByteArray("-1") + QByteArray(30, '0') + ".0 0") << QByteArray("0.2 0.3");
    QTest::newRow("all are NaN") << QByteArray("nan nan") << QByteArray("nan nan");
}

void OddModelsTest::textureCoordinates_notUsable_areALoss() {
    QFETCH(QByteArray, first);
    QFETCH(QByteArray, others);
    const QByteArray vt = "vt " + others + "\n";
    const QByteArray text = "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\nvt " + first + "\n" + vt + vt +
                            vt + "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\nf 1/5 3/6 4/7\n";
    for (const char* keyword : {"vt ", "vt\t"}) {
        const ImportedModel imported = importModel(
            write(QStringLiteral("nan.obj"), QByteArray(text).replace("vt ", keyword)), {}, {});
        QVERIFY2(warningsOf(imported).contains(
                     QStringLiteral("The texture coordinates of 1 triangles are not numbers")),
                 qPrintable(warningsOf(imported)));
        QVERIFY(!imported.model.hasTextureCoordinates(0));
        QVERIFY(imported.model.hasTextureCoordinates(1));
    }
}

void OddModelsTest::gltf_byteOrderMark_isRead() {
    const ImportedModel imported = importModel(
        write(QStringLiteral("marked.gltf"), "\xef\xbb\xbf" + squareGltf(png(quarters()))), {}, {});
    QCOMPARE(imported.model.textures.size(), std::size_t(1));
}

void OddModelsTest::obj_byteOrderMark_isRead() {
    write(QStringLiteral("b.mtl"), "newmtl skin\nmap_Kd skin.png");
    const ImportedModel imported =
        importModel(write(QStringLiteral("marked.obj"),
                          "\xef\xbb\xbf" + cubeObj("mtllib b.mtl\nusemtl skin\n")),
                    {}, {});
    QCOMPARE(imported.model.textures.size(), std::size_t(1));
}

void OddModelsTest::gltf_deeplyNested_isRefused() {
    constexpr int depth = 5000;
    const QString sentence =
        refusal(write(QStringLiteral("deep.gltf"),
                      gltf(R"("asset":)", R"("extras":)" + QByteArray(depth, '[') +
                                              QByteArray(depth, ']') + R"(,"asset":)")));
    QVERIFY2(sentence.contains(QStringLiteral("deep")), qPrintable(sentence));
}

void OddModelsTest::gltf_skin_movesThePoints_data() {
    QTest::addColumn<TestSkin>("skin");
    QTest::addColumn<Eigen::Vector3f>("sizes");
    const auto row = [](const char* name, const TestSkin& skin, float x, float y) {
        QTest::newRow(name) << skin << Eigen::Vector3f(x, y, 0);
    };
    const QByteArray scaled = R"([{"mesh":0,"skin":0},{"scale":[2,2,2]},{"scale":[4,4,4]}])";
    row("at rest", {}, 1, 1);
    row("first joint", {.nodes = scaled}, 2, 2);
    row("both joints", {.nodes = scaled, .weights = {0.5F, 0.5F}}, 3, 3);
    row("bind matrices cancel the joint", {.nodes = scaled, .bindScale = 0.5F}, 1, 1);
    // Blender writes such skins if the bones have never been moved.
    row("no bind matrices", {.nodes = scaled, .bindScale = {}}, 2, 2);
    row("the mesh's node does not count",
        {.nodes = R"([{"mesh":0,"skin":0,"scale":[3,3,3]},{},{}])"}, 1, 1);
    row("a joint under another",
        {.nodes = R"([{"mesh":0,"skin":0},{"scale":[2,1,1],"children":[2]},{"scale":[2,3,1]}])",
         .weights = {0, 1},
         .scene = "[0,1]"},
        4, 3);
    row("equal names",
        {.nodes = R"([{"mesh":0,"skin":0,"name":"a"},{"scale":[2,2,2],"name":"a"},{"name":"a"}])"},
        2, 2);
    row("weights as bytes", {.nodes = scaled, .weights = {0.5F, 0.5F}, .weightType = 5121}, 3, 3);
    row("weights as shorts", {.nodes = scaled, .weights = {0.25F, 0.75F}, .weightType = 5123}, 3.5F,
        3.5F);
    row("the mesh is also there without a skin",
        {.nodes = R"([{"mesh":0,"translation":[5,0,0]},{"scale":[2,2,2]},{},{"mesh":0,"skin":0}])",
         .scene = "[0,1,2,3]"},
        6, 2);
}

void OddModelsTest::gltf_skin_movesThePoints() {
    QFETCH(TestSkin, skin);
    QFETCH(Eigen::Vector3f, sizes);
    const QByteArray text = skinnedGltf(skin);
    for (const char* name : {"skin.gltf", "skin.glb"}) {
        const bool isBinary = QByteArrayView(name).endsWith("glb");
        const QString path = write(QString::fromLatin1(name), isBinary ? glbOf(text) : text);
        QCOMPARE(refusal(path), QString());
        const ImportedModel imported = importModel(path, {}, {});
        QVERIFY2(imported.report.losses.isEmpty(), qPrintable(warningsOf(imported)));
        QVERIFY(imported.report.box.sizes().isApprox(sizes, 1e-5F));
    }
}

void OddModelsTest::gltf_integerWeightsInAnotherFile_areRead() {
    const QByteArray scaled = R"([{"mesh":0,"skin":0},{"scale":[2,2,2]},{}])";
    QByteArray text = skinnedGltf({.nodes = scaled, .weightType = 5121});
    const QByteArray before = "data:application/octet-stream;base64,";
    const qsizetype uri = text.indexOf(before), end = text.indexOf('"', uri);
    const QByteArray encoded = text.mid(uri, end - uri);
    write(QStringLiteral("my weights.bin"), QByteArray::fromBase64(encoded.mid(before.size())));
    text.replace(encoded, "my%20weights.bin");
    const ImportedModel imported = importModel(write(QStringLiteral("two.gltf"), text), {}, {});
    QVERIFY2(imported.report.losses.isEmpty(), qPrintable(warningsOf(imported)));
    QVERIFY(imported.report.box.sizes().isApprox(Eigen::Vector3f(2, 2, 0), 1e-5F));
}

void OddModelsTest::gltf_integerWeightsPastTheBuffer_areRefused() {
    const QByteArray good = skinnedGltf({.weightType = 5121});
    for (const char* place : {"257", "1000000000000"}) {
        const QByteArray text =
            QByteArray(good).replace(R"("byteOffset":80)", QByteArray(R"("byteOffset":)") + place);
        QVERIFY(text != good);
        const QString sentence = refusal(write(QStringLiteral("past.gltf"), text));
        QVERIFY2(sentence.contains(QStringLiteral("out of range")), qPrintable(sentence));
    }
}

// assimp 5.2.5 reads any number as the index of a skin.
void OddModelsTest::gltf_missingSkin_isRefused_data() {
    QTest::addColumn<QByteArray>("skin");
    for (const char* skin : {"1", "4000000", "-1", "0.5", "\"0\""}) {
        QTest::newRow(skin) << QByteArray(skin);
    }
}

void OddModelsTest::gltf_missingSkin_isRefused() {
    QFETCH(QByteArray, skin);
    const QByteArray text = skinnedGltf({.nodes = R"([{"mesh":0,"skin":)" + skin + "},{},{}]"});
    const QString sentence = refusal(write(QStringLiteral("missing.gltf"), text));
    QVERIFY2(sentence.contains(QStringLiteral("skin that does not exist")), qPrintable(sentence));
}

void OddModelsTest::gltf_morphTargets_moveThePoints_data() {
    QTest::addColumn<QByteArray>("nodes");
    QTest::addColumn<QByteArray>("mesh"); // targets and weights
    QTest::addColumn<Eigen::Vector3f>("sizes");
    const auto row = [](const char* name, const QByteArray& nodes, const QByteArray& targets,
                        const QByteArray& weights, float x, float y) {
        QTest::newRow(name) << nodes << R"(,"targets":[)" + targets + "]}]" + weights
                            << Eigen::Vector3f(x, y, 0);
    };
    const QByteArray plain = R"([{"mesh":0},{},{}])";
    const QByteArray itself = R"({"POSITION":0})"; // moves each point by itself
    const QByteArray half = R"(,"weights":[0.5])";
    row("no weights", plain, itself, "", 1, 1);
    row("weight of the mesh", plain, itself, half, 1.5F, 1.5F);
    row("two targets", plain, itself + "," + itself, R"(,"weights":[0.5,-0.25])", 1.25F, 1.25F);
    row("no points", plain, R"({"NORMAL":0})", half, 1, 1);
    row("a sparse target", plain, R"({"POSITION":5})", half, 1.5F, 1);
    row("weight of the node", R"([{"mesh":0,"weights":[2]},{},{}])", itself, half, 3, 3);
    row("nodes with the same mesh",
        R"([{"mesh":0,"weights":[1]},{"mesh":0,"translation":[5,0,0]},{}])", itself, half, 6.5F, 2);
    row("a skin", R"([{"mesh":0,"skin":0,"weights":[2]},{"scale":[2,2,2]},{}])", itself, half, 6,
        6);
}

void OddModelsTest::gltf_morphTargets_moveThePoints() {
    QFETCH(QByteArray, nodes);
    QFETCH(QByteArray, mesh);
    QFETCH(Eigen::Vector3f, sizes);
    const QByteArray sparse = R"(,{"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1,
        "indices":{"bufferView":1,"byteOffset":2,"componentType":5123},
        "values":{"bufferView":0,"byteOffset":12}}}],"bufferViews")";
    const QByteArray text = skinnedGltf({.nodes = nodes})
                                .replace(R"("indices":1}])", R"("indices":1)" + mesh)
                                .replace(R"(],"bufferViews")", sparse);
    const ImportedModel imported = importModel(write(QStringLiteral("m.gltf"), text), {}, {});
    QVERIFY2(imported.report.losses.isEmpty(), qPrintable(warningsOf(imported)));
    QVERIFY(imported.report.box.sizes().isApprox(sizes, 1e-5F));
}

void OddModelsTest::gltf_integerMorphTarget_isRefused() {
    const QByteArray text =
        skinnedGltf({}).replace(R"("indices":1})", R"("indices":1,"targets":[{"POSITION":2}]})");
    const QString sentence = refusal(write(QStringLiteral("whole.gltf"), text));
    QVERIFY2(sentence.contains(QStringLiteral("float coordinates")), qPrintable(sentence));
}

void OddModelsTest::gltf_unclearSkin_isALoss_data() {
    QTest::addColumn<TestSkin>("skin");
    QTest::newRow("weights of 0.3") << TestSkin{.weights = {0.3F, 0}};
    QTest::newRow("weights of 0") << TestSkin{.weights = {0, 0}};
    QTest::newRow("weights that are not numbers")
        << TestSkin{.weights = {std::numeric_limits<float>::quiet_NaN(), 0}};
    QTest::newRow("joints outside the scene") << TestSkin{.scene = "[0]"};
}

void OddModelsTest::gltf_unclearSkin_isALoss() {
    QFETCH(TestSkin, skin);
    const ImportedModel imported =
        importModel(write(QStringLiteral("unclear.gltf"), skinnedGltf(skin)), {}, {});
    QCOMPARE(imported.report.losses.size(), 1);
    QVERIFY2(imported.report.losses[0].contains(QStringLiteral("joints move 4 of its points")),
             qPrintable(warningsOf(imported)));
    QVERIFY(imported.report.box.sizes().isApprox(Eigen::Vector3f(1, 1, 0), 1e-5F));
}

void OddModelsTest::gltf_tooFewBindMatrices_areRefused() {
    const QByteArray file =
        skinnedGltf({}).replace(R"("count":2,"type":"MAT4")", R"("count":1,"type":"MAT4")");
    const QString sentence = refusal(write(QStringLiteral("few.gltf"), file));
    QVERIFY2(sentence.contains(QStringLiteral("lacks bind matrices")), qPrintable(sentence));
}

void OddModelsTest::collada_skin_movesThePoints() {
    const QByteArray skinned =
        skinnedGltf({.nodes = R"([{"mesh":0,"skin":0},{"scale":[2,2,2]},{}])"});
    const ImportedModel imported =
        importModel(write(QStringLiteral("skin.dae"), convertedGltf(skinned, "collada")), {}, {});
    QVERIFY(imported.report.box.sizes().isApprox(Eigen::Vector3f(2000, 2000, 0), 1e-5F));
}

void OddModelsTest::fbx_skin_movesThePoints() {
    const QByteArray skinned =
        skinnedGltf({.nodes = R"([{"mesh":0,"skin":0},{"scale":[2,2,2]},{}])"});
    const QByteArray bound = convertedGltf(skinned, "fbxa"); // assimp binds joints as they are
    const QByteArray moved = QByteArray(bound).replace(R"("A", 2, 2, 2)", R"("A", 8, 8, 8)");
    QVERIFY(moved != bound);
    for (const auto& [file, edge] : {std::pair(bound, 10.0F), std::pair(moved, 40.0F)}) {
        const ImportedModel imported = importModel(write(QStringLiteral("skin.fbx"), file), {}, {});
        QVERIFY2(imported.report.losses.isEmpty(), qPrintable(warningsOf(imported)));
        QVERIFY(imported.report.box.sizes().isApprox(Eigen::Vector3f(edge, edge, 0), 1e-5F));
    }
}

// FBX SDK: present joint · bound joint⁻¹ · bound mesh · geometric transform.
void OddModelsTest::fbx_meshOfASkin_isPlacedByItsJoints_data() {
    QTest::addColumn<QByteArray>("properties"); // of the mesh's node
    QTest::addColumn<float>("left");            // of the square, in mm
    QTest::addColumn<float>("edge");            // mm
    const auto row = [](const char* name, const char* property, const char* numbers, float left,
                        float edge) {
        QTest::newRow(name) << "P: \"" + QByteArray(property) + "\", \"Vector3D\", \"\", \"A\", " +
                                   numbers
                            << left << edge;
    };
    row("as bound", "Lcl Translation", "0, 0, 0", 0, 10);
    row("moved after binding", "Lcl Translation", "5, 0, 0", 0, 10);
    row("scaled after binding", "Lcl Scaling", "3, 3, 3", 0, 10);
    row("geometric translation", "GeometricTranslation", "1, 0, 0", 10, 10);
    row("geometric rotation", "GeometricRotation", "0, 0, 180", -10, 10);
    row("geometric scale", "GeometricScaling", "3, 3, 3", 0, 30);
}

void OddModelsTest::fbx_meshOfASkin_isPlacedByItsJoints() {
    QFETCH(QByteArray, properties);
    QFETCH(float, left);
    QFETCH(float, edge);
    QByteArray file = convertedGltf(
        skinnedGltf({.nodes = R"([{"mesh":0,"skin":0},{"scale":[2,2,2]},{}])"}), "fbxa");
    const QByteArray type = R"(P: "InheritType", "enum", "", "", 1)";
    file.insert(file.indexOf(type), properties + "\n");
    const ImportedModel imported = importModel(write(QStringLiteral("mesh.fbx"), file), {}, {});
    QVERIFY2(imported.report.losses.isEmpty(), qPrintable(warningsOf(imported)));
    QVERIFY(imported.report.box.sizes().isApprox(Eigen::Vector3f(edge, edge, 0), 1e-5F));
    QVERIFY(std::abs(imported.report.box.min().x() - left) < 1e-4F);
}

void OddModelsTest::stl_emptyLinesFirst_isRead() {
    const QByteArray triangle = "solid one\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\n"
                                "vertex 9 0 0\nvertex 0 9 0\nendloop\nendfacet\nendsolid one\n";
    for (const QByteArray& text : {"\n\r\n  " + triangle, "\n" + triangle.toUpper()}) {
        const ImportedModel imported = importModel(write(QStringLiteral("late.stl"), text), {}, {});
        QCOMPARE(imported.report.triangles, std::size_t(1));
    }
}

void OddModelsTest::mtl_textureOptions_placeTheTexture_data() {
    QTest::addColumn<QByteArray>("options");
    QTest::addColumn<Eigen::Vector2f>("scale");
    QTest::addColumn<Eigen::Vector2f>("offset");
    const auto row = [](const char* options, float su, float sv, float ou, float ov) {
        QTest::newRow(options) << QByteArray(options) << Eigen::Vector2f(su, sv)
                               << Eigen::Vector2f(ou, ov);
    };
    row("", 1, 1, 0, 0);
    row("-s 1 1 1 -o 0 0 0 -bm 1 ", 1, 1, 0, 0);
    row("-s 2 2 1 ", 2, 2, 0, 0);
    row("-s 2 3 ", 2, 3, 0, 0);
    row("-s 2 ", 2, 1, 0, 0);
    row("-o 0.25 ", 1, 1, 0.25F, 0);
    row("-S 1 1 1 -O 0 .25 0 ", 1, 1, 0, 0.25F);
    row("-o 0.5 0.25 -s -1 2 ", -1, 2, 0.5F, 0.25F);
    row("-t 0 0 -mm 0 1 -clamp off -blendu on -blendv on -cc off -boost 2 -texres 512 -imfchan l ",
        1, 1, 0, 0);
    row("-type sphere -s 2 2 ", 2, 2, 0, 0);
}

void OddModelsTest::mtl_textureOptions_placeTheTexture() {
    QFETCH(QByteArray, options);
    QFETCH(Eigen::Vector2f, scale);
    QFETCH(Eigen::Vector2f, offset);
    const ImportedModel plain = cubeWith("newmtl skin\nmap_Kd skin.png\n");
    const ImportedModel placed = cubeWith("newmtl skin\nmap_Kd " + options + "skin.png\n");
    QCOMPARE(placed.model.textures.size(), std::size_t(1));
    QVERIFY2(warningsOf(placed).isEmpty(), qPrintable(warningsOf(placed)));
    for (std::size_t t = 0; t < plain.model.textureCoordinates.size(); ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Eigen::Vector2f& uv = plain.model.textureCoordinates[t][corner];
            const Eigen::Vector2f expected = uv.cwiseProduct(scale) + offset;
            QVERIFY(placed.model.textureCoordinates[t][corner].isApprox(expected));
        }
    }
}

void OddModelsTest::mtl_unsupportedTextureOptions_areAWarning_data() {
    QTest::addColumn<QByteArray>("options");
    for (const char* options :
         {"-t 1", "-t 0.5 0.5", "-t 1 1 1", "-mm 0.2 0.8", "-clamp on", "-s 0"}) {
        QTest::newRow(options) << QByteArray(options);
    }
}

void OddModelsTest::mtl_unsupportedTextureOptions_areAWarning() {
    QFETCH(QByteArray, options);
    const ImportedModel imported = cubeWith("newmtl skin\nmap_Kd " + options + " skin.png\n");
    QCOMPARE(imported.model.textures.size(), std::size_t(1));
    QVERIFY(warningsOf(imported).contains(QStringLiteral("cube.mtl")));
    QVERIFY(warningsOf(imported).contains(QString::fromLatin1(options.split(' ').first())));
}

void OddModelsTest::mtl_unusualButClear_isRead_data() {
    QTest::addColumn<QByteArray>("bytes");
    const QByteArray plain = "newmtl skin\nKd 1 0 0\nmap_Kd skin.png\n";
    QTest::newRow("a byte-order mark") << "\xef\xbb\xbf" + plain;
    QTest::newRow("UTF-16") << QByteArray(QStringEncoder(
        QStringEncoder::Utf16LE, QStringEncoder::Flag::WriteBom)(QString::fromLatin1(plain)));
    QTest::newRow("capitals") << QByteArray("NEWMTL skin\nKD 1 0 0\n\tMAP_KD skin.png\n");
    QTest::newRow("spaces first") << "  " + plain;
    const auto named = [&](const char* name) {
        return QByteArray(plain).replace("skin.png", name);
    };
    QTest::newRow("a quoted name") << named("\"skin.png\"");
    QTest::newRow("a name with spaces") << named("my own skin.png");
    QTest::newRow("a name with two spaces, then blanks") << named("two  spaces.png \t\r");
    QTest::newRow("a quoted name with spaces") << named("-s 1 1 \"my own skin.png\" ");
    QTest::newRow("a quoted name in a folder") << named("\"my folder\\two  spaces.png\"");
    for (const char* heading : {"Produced by X", "Ps export", "author me", "Normal maps: none",
                                "# nothing", "aniso 0.5"}) {
        QTest::newRow(heading) << heading + QByteArray("\n") + plain;
    }
}

void OddModelsTest::mtl_unusualButClear_isRead() {
    QFETCH(QByteArray, bytes);
    const ImportedModel imported = cubeWith(bytes);
    QVERIFY2(warningsOf(imported).isEmpty(), qPrintable(warningsOf(imported)));
    QCOMPARE(imported.model.textures.size(), std::size_t(1));
    QCOMPARE(imported.model.materials[0].colour, QColor(Qt::red));
}

void OddModelsTest::mtl_statementBeforeAnyMaterial_isRefused() {
    for (const char* before : {"map_Kd skin.png\nnewmtl skin\n", "bump skin.png\nnewmtl skin\n",
                               "Pr 0.5\n", "a\n", "refl skin.png"}) {
        write(QStringLiteral("early.mtl"), before);
        const QString sentence =
            refusal(write(QStringLiteral("early.obj"), cubeObj("mtllib early.mtl\nusemtl skin\n")));
        QVERIFY2(sentence.contains(QStringLiteral("early.mtl sets")), before);
    }
}

void OddModelsTest::obj_severalMaterialFilesInOneLine_areRead() {
    write(QStringLiteral("my own.mtl"), "newmtl other\nKd 0 1 0\n");
    write(QStringLiteral("b.mtl"), "newmtl skin\nmap_Kd skin.png");
    const auto imported = [&](const QByteArray& line) {
        return importModel(
            write(QStringLiteral("several.obj"), cubeObj("mtllib " + line + "\nusemtl skin\n")), {},
            {});
    };
    const ImportedModel both = imported("my own.mtl b.mtl");
    QVERIFY2(warningsOf(both).isEmpty(), qPrintable(warningsOf(both)));
    QCOMPARE(both.model.textures.size(), std::size_t(1));
    const ImportedModel quoted = imported("\"my own.mtl\" \"b.mtl\"");
    QVERIFY2(warningsOf(quoted).isEmpty(), qPrintable(warningsOf(quoted)));
    QCOMPARE(quoted.model.textures.size(), std::size_t(1));
    const ImportedModel one = imported("lost.mtl b.mtl");
    QVERIFY2(warningsOf(one).contains(QStringLiteral("The file lost.mtl,")),
             qPrintable(warningsOf(one)));
    QCOMPARE(one.model.textures.size(), std::size_t(1));
}

QTEST_GUILESS_MAIN(OddModelsTest)
#include "OddModelsTest.moc"
