// Tests models as users bring them: formats, textures, repairs and refusals.
#include "ModelFiles.h"
#include "WholeSample.h"

#include "base/Error.h"
#include "base/Units.h"
#include "geometry/Shapes.h"
#include "import/trusted/ImportModel.h"
#include "model/ModelFormats.h"

#include <QBuffer>
#include <QColorSpace>
#include <QRegularExpression>
#include <QtTest>

#include <cmath>
#include <random>
#include <set>

using namespace dipwright;
using namespace dipwright::test;

namespace {

ImportedModel import(const QString& path, const ImportOptions& options = {}) {
    return importModel(path, options, Progress());
}

// Returns the error's sentence if the import fails, otherwise an empty text.
QString refusal(const QString& path, const ImportOptions& options = {}) {
    try {
        import(path, options);
        return QString();
    } catch (const Error& error) {
        return error.sentence();
    }
}

// Returns the colour of a model at a place of its surface, without interpolation between texels.
QColor colourAt(const TexturedMesh& model, std::uint32_t triangle, const Eigen::Vector2f& uv) {
    const Material& material = model.materials[model.material[triangle]];
    if (material.texture < 0) {
        return material.colour;
    }
    const QImage& image = model.textures[std::size_t(material.texture)];
    return image.pixelColor(int(uv.x() * float(image.width())),
                            int((1 - uv.y()) * float(image.height())));
}

// Returns the colour of a flat model in the plane z = 0 at (x, y).
QColor colourAtPlace(const TexturedMesh& model, float x, float y) {
    for (std::uint32_t t = 0; t < model.mesh.triangles.size(); ++t) {
        const auto& corners = model.mesh.triangles[t];
        Eigen::Matrix3f places;
        for (int corner = 0; corner < 3; ++corner) {
            places.col(corner) = model.mesh.positions[corners[std::size_t(corner)]];
            places(2, corner) = 1;
        }
        const Eigen::Vector3f weights = places.inverse() * Eigen::Vector3f(x, y, 1);
        if (weights.minCoeff() >= 0) {
            return colourAt(model, t, model.textureCoordinate({t, weights}));
        }
    }
    return QColor();
}

bool showsQuarters(const TexturedMesh& model) {
    return colourAtPlace(model, 0.25F, 0.75F) == QColor(Qt::red) &&
           colourAtPlace(model, 0.75F, 0.75F) == QColor(Qt::green) &&
           colourAtPlace(model, 0.25F, 0.25F) == QColor(Qt::blue) &&
           colourAtPlace(model, 0.75F, 0.25F) == QColor(Qt::white);
}

std::size_t chartCount(const TexturedMesh& model) {
    return std::set<std::uint32_t>(model.chart.begin(), model.chart.end()).size();
}

// Returns a mesh as ASCII STL. Every triangle has its own corners; normals are zero.
QByteArray stl(const TriangleMesh& mesh) {
    QByteArray text = "solid body\n";
    for (const auto& triangle : mesh.triangles) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const auto corner : triangle) {
            const auto& place = mesh.positions[corner];
            text += "vertex";
            for (const float coordinate : place) {
                text += " " + QByteArray::number(double(coordinate), 'g', 9);
            }
            text += "\n";
        }
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid body\n";
}

// Returns a prism of height 2 over an outline as ASCII PLY. The corners of its faces have their
// place in x and y as texture coordinates.
QByteArray prismPly(const QList<QPoint>& outline) {
    QByteArray points, faces, floor, roof, floorPlaces, roofPlaces;
    const auto number = [](qsizetype value) { return " " + QByteArray::number(value); };
    const qsizetype count = outline.size();
    for (const int height : {0, 2}) {
        for (const QPoint& point : outline) {
            points += number(point.x()) + number(point.y()) + number(height) + "\n";
        }
    }
    const auto place = [&](qsizetype corner) {
        return number(outline[corner].x()) + number(outline[corner].y());
    };
    for (qsizetype corner = 0; corner < count; ++corner) {
        const qsizetype next = (corner + 1) % count;
        floor += number(count - 1 - corner);
        floorPlaces += place(count - 1 - corner);
        roof += number(count + corner);
        roofPlaces += place(corner);
        faces += "4" + number(corner) + number(next) + number(count + next) +
                 number(count + corner) + " 8" + place(corner) + place(next) + place(next) +
                 place(corner) + "\n";
    }
    return "ply\nformat ascii 1.0\nelement vertex" + number(2 * count) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face" +
           number(count + 2) +
           "\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
           "end_header\n" +
           points + faces + number(count) + floor + number(2 * count) + floorPlaces + "\n" +
           number(count) + roof + number(2 * count) + roofPlaces + "\n";
}

// Returns one STL solid of several bodies. The first `turned` bodies are inside out.
QByteArray stl(std::vector<TriangleMesh> bodies, std::size_t turned) {
    QByteArray text;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (auto& triangle : bodies[i].triangles) {
            if (i < turned) {
                std::swap(triangle[0], triangle[1]);
            }
        }
        text += stl(bodies[i]);
    }
    return text.replace("endsolid body\nsolid body\n", "");
}

// Returns nested boxes, smallest first: `half` boxes with edges from 10 to 15 mm, and `half` with
// edges from 20 to 25 mm.
std::vector<TriangleMesh> nestedBoxes(int half) {
    std::vector<TriangleMesh> boxes;
    for (const double least : {10.0, 20.0}) {
        for (int i = 0; i < half; ++i) {
            const double edge = least + 5.0 * i / half;
            boxes.push_back(boxMesh({edge, edge, edge}));
        }
    }
    return boxes;
}

// Returns a sphere as OBJ whose texture is cut along one meridian. It has one chart, with two
// texture coordinates for each point of the seam.
QByteArray sphereWithSeamObj(int rings, int segments) {
    QByteArray text;
    const TriangleMesh sphere = sphereMesh(35, rings, segments);
    for (const auto& place : sphere.positions) {
        text +=
            QStringLiteral("v %1 %2 %3\n").arg(place.x()).arg(place.y()).arg(place.z()).toUtf8();
    }
    for (int ring = 0; ring <= rings; ++ring) {
        for (int segment = 0; segment <= segments; ++segment) {
            text += QStringLiteral("vt %1 %2\n")
                        .arg(double(segment) / segments)
                        .arg(1 - double(ring) / rings)
                        .toUtf8();
        }
    }
    const auto point = [&](int ring, int segment) {
        return ring == 0       ? 1
               : ring == rings ? int(sphere.positions.size())
                               : 2 + (ring - 1) * segments + segment % segments;
    };
    const auto corner = [&](int ring, int segment) {
        const int coordinate = 1 + ring * (segments + 1) + segment;
        return " " + QByteArray::number(point(ring, segment)) + "/" +
               QByteArray::number(coordinate);
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int s = 0; s < segments; ++s) {
            if (ring < rings - 1) {
                text +=
                    "f" + corner(ring, s) + corner(ring + 1, s) + corner(ring + 1, s + 1) + "\n";
            }
            if (ring > 0) {
                text +=
                    "f" + corner(ring, s) + corner(ring + 1, s + 1) + corner(ring, s + 1) + "\n";
            }
        }
    }
    return text;
}

// Adds rows with a tetrahedron in each format that only assimp reads.
void addOtherFormats() {
    QTest::newRow("collada") << QStringLiteral("tetrahedron.dae") << tetrahedron("collada");
    QTest::newRow("3ds") << QStringLiteral("tetrahedron.3ds") << tetrahedron("3ds");
    QTest::newRow("fbx, text") << QStringLiteral("text.fbx") << tetrahedron("fbxa");
    QTest::newRow("fbx, binary") << QStringLiteral("binary.fbx") << tetrahedronBinaryFbx();
}

} // namespace

class ImportModelTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void guessedUnit_givesASizeThatCanBeDipped();
    void obj_materialFile_isRead();
    void obj_twoMaterials_areRead();
    void obj_facesOverlapInOnePlane_isAWarning();
    void obj_missingMaterialFile_isAWarning();
    void ply_picture_isRead();
    void ply_binaryWithCoordinatesPerCorner_isRead();
    void ply_coordinatesAndPicturePerFace_areRead();
    void plyAndStl_withoutCoordinates_areRead();
    void ply_triangleStrips_areRead();
    void ply_concaveFace_isFilled_data();
    void ply_concaveFace_isFilled();
    void ply_faceWhoseEdgesCross_isALoss();
    void gltf_picture_isUpright();
    void glb_picture_isUpright();
    void gltf_textureTransform_movesThePicture();
    void threeMf_picture_isUpright();
    void threeMf_components_arePlacedInMillimetres();
    void modelFilePatterns_listEveryFormatOnce();

    void pictureFile_otherCaseOrForeignPath_isFound_data();
    void pictureFile_otherCaseOrForeignPath_isFound();
    void pictureFile_missing_isAWarning();
    void chosenTexture_replacesAllOthers();
    void chosenTexture_withoutCoordinates_isAWarning();
    void texture_16BitOrGrey_becomesRgba8();

    void charts_cube_areSix();
    void charts_sphereWithSeam_isOneClosedChart();

    void importOptions_longestEdgeAndUnit_setTheSize();
    void stl_separateTriangles_areWeldedAndClosed();
    void repair_degenerateTriangles_areRemoved();
    void repair_strayPoints_areRefused_data();
    void repair_strayPoints_areRefused();
    void repair_strayTriangleWithoutArea_leavesNoPoints();
    void repair_insideOutBody_isFlipped();
    void repair_insideOutBodyWithOpenSeam_isFlipped();
    void repair_duplicateFaces_areMerged();
    void repair_insideOutPart_isFlippedButCavityIsRemoved();
    void repair_manyNestedParts_areDistinguished();
    void repair_cancelled_throws();
    void repair_flippedNeighbours_areFlippedBack();
    void openMesh_isAWarning();
    void gltf_mirroredNode_keepsItsOutside();
    void stl_millionTriangles_isClosed();

    void modelPath_anyLanguage_isRead();
    void model_unreadable_isRefused_data();
    void model_unreadable_isRefused();
    void texture_unreadable_isRefused_data();
    void texture_unreadable_isRefused();
    void texture_colourProfile_isApplied();
    void importOptions_outOfRange_areRefused();
    void threeMf_hostile_isRefused_data();
    void threeMf_hostile_isRefused();
    void model_truncated_neverCrashes_data();
    void model_truncated_neverCrashes();
    void colladaFbxAnd3ds_areRead_data();
    void colladaFbxAnd3ds_areRead();
    void model_damaged_neverCrashes_data();
    void model_damaged_neverCrashes();
    void collada_absurdCounts_areRefused_data();
    void collada_absurdCounts_areRefused();
    void importModel_cancelled_throws();
    void pictureFile_outsideTheFolder_isReadOnlyIfAllowed_data();
    void pictureFile_outsideTheFolder_isReadOnlyIfAllowed();
    void pictureFile_insideTheFolder_needsNoPermission();
    void model_unlistedFormat_isRefused_data();
    void model_unlistedFormat_isRefused();
    void pictureFile_formatIsKnownByContent();
    void mtl_statementBeforeAnyMaterial_isRefused();
    void obj_faceWithTooManyCorners_isRefused();
    void smallFile_hugeContent_isRefused_data();
    void smallFile_hugeContent_isRefused();

private:
    QString at(const QString& name) const { return folder_.filePath(name); }
    QString write(const QString& name, const QByteArray& bytes) const {
        writeFile(at(name), bytes);
        return at(name);
    }
    QTemporaryDir folder_;
};

void ImportModelTest::guessedUnit_givesASizeThatCanBeDipped() {
    QCOMPARE(guessedUnit(90), 1.0);
    QCOMPARE(guessedUnit(0.09), 1000.0);
    QCOMPARE(guessedUnit(1.72), 10.0);
    QCOMPARE(guessedUnit(5000), 1.0); // no unit fits
}

void ImportModelTest::obj_materialFile_isRead() {
    write(QStringLiteral("paint.png"), png(quarters()));
    write(QStringLiteral("cube.mtl"), "newmtl skin\nKd 0.2 0.4 0.6\nmap_Kd paint.png\n");
    const auto [model, report, cad] =
        import(write(QStringLiteral("cube.obj"), cubeObj("mtllib cube.mtl\nusemtl skin\n")));
    QCOMPARE(report.triangles, std::size_t(12));
    QVERIFY(report.closed);
    QVERIFY(std::abs(report.volume - 1000) < 1e-3);
    QVERIFY(report.box.max().isApprox(Eigen::Vector3f(5, 5, 5)));
    QVERIFY2(report.warnings.isEmpty(), qPrintable(report.warnings.join(u'|')));
    QVERIFY(report.repairs.isEmpty());
    QCOMPARE(model.mesh.positions.size(), std::size_t(8));
    QCOMPARE(model.materials.size(), std::size_t(1));
    QCOMPARE(model.materials[0].name, QStringLiteral("skin"));
    QCOMPARE(model.materials[0].colour, QColor(51, 102, 153));
    QCOMPARE(model.textures.size(), std::size_t(1));
    QCOMPARE(model.textures[0].format(), QImage::Format_RGBA8888);
    QCOMPARE(model.textures[0], quarters());
    QVERIFY(model.hasTextureCoordinates(0));
}

void ImportModelTest::obj_twoMaterials_areRead() {
    write(QStringLiteral("two.mtl"), "newmtl a\nKd 1 0 0\nnewmtl unused\nKd 0 1 0\n"
                                     "newmtl b\nKd 0 0 1\nmap_Kd paint.png\n");
    write(QStringLiteral("paint.png"), png(quarters()));
    QByteArray text = cubeObj("mtllib two.mtl\nusemtl a\n");
    const auto middle = text.indexOf("f 1/1 5/2");
    const auto [model, report, cad] =
        import(write(QStringLiteral("two.obj"), text.insert(middle, "usemtl b\n")));
    QCOMPARE(model.materials.size(), std::size_t(2));
    QVERIFY(report.closed);
    QCOMPARE(std::count(model.material.begin(), model.material.end(), 0), 6);
    QCOMPARE(std::count(model.material.begin(), model.material.end(), 1), 6);
    QCOMPARE(model.materials[0].colour, QColor(Qt::red));
    QCOMPARE(model.materials[0].texture, -1);
    QCOMPARE(model.materials[1].texture, 0);
}

// The second box sticks out of the cube, and both end in the plane y = −5: on 5 mm × 8 mm.
void ImportModelTest::obj_facesOverlapInOnePlane_isAWarning() {
    write(QStringLiteral("plane.mtl"), "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 0 1\n");
    const auto warned = [&](const QByteArray& material, float lowest) {
        QByteArray text = cubeObj("mtllib plane.mtl\nusemtl a\n") + "usemtl " + material + '\n';
        for (const float z : {-3.F, 8.F}) {
            for (const float y : {lowest, 2.F}) {
                for (const float x : {-2.F, 3.F}) {
                    text += "v " + QByteArray::number(double(x)) + ' ' +
                            QByteArray::number(double(y)) + ' ' + QByteArray::number(double(z)) +
                            '\n';
                }
            }
        }
        text += "f 13 14 16 15\nf 14 10 12 16\nf 10 9 11 12\nf 9 13 15 11\nf 15 16 12 11\n"
                "f 9 10 14 13\n";
        return import(write(QStringLiteral("plane.obj"), text)).report.warnings.join('|');
    };
    const QString warning = warned("b", -5);
    const QRegularExpression area(QStringLiteral("overlap in one plane, on about (\\d+) mm²"));
    const double found = area.match(warning).captured(1).toDouble();
    QVERIFY2(std::abs(found - 40) < 2, qPrintable(warning));
    QVERIFY(!warned("a", -5).contains(QStringLiteral("plane")));
    QVERIFY(!warned("b", -5.1F).contains(QStringLiteral("plane")));
}

void ImportModelTest::obj_missingMaterialFile_isAWarning() {
    const auto [model, report, cad] =
        import(write(QStringLiteral("lone.obj"), cubeObj("mtllib lost.mtl\nusemtl skin\n")));
    QCOMPARE(report.warnings.size(), 1);
    QVERIFY(report.warnings[0].contains(QStringLiteral("lost.mtl")));
    QCOMPARE(model.materials.size(), std::size_t(1));
    QVERIFY(model.textures.empty());
}

void ImportModelTest::ply_picture_isRead() {
    write(QStringLiteral("ply.png"), png(quarters()));
    const auto [model, report, cad] =
        import(write(QStringLiteral("square.ply"), squarePly("ply.png")));
    QCOMPARE(report.triangles, std::size_t(2));
    QVERIFY(showsQuarters(model));
    QCOMPARE(chartCount(model), std::size_t(1));
}

void ImportModelTest::ply_binaryWithCoordinatesPerCorner_isRead() {
    write(QStringLiteral("ply.png"), png(quarters()));
    for (const bool littleEndian : {true, false}) {
        const auto [model, report, cad] =
            import(write(QStringLiteral("binary.ply"), squareBinaryPly("ply.png", littleEndian)));
        QCOMPARE(report.triangles, std::size_t(2));
        QVERIFY(showsQuarters(model));
    }
}

// Tests two triangles that share two points. They show two places of one picture, or of two
// pictures.
void ImportModelTest::ply_coordinatesAndPicturePerFace_areRead() {
    write(QStringLiteral("ply.png"), png(quarters()));
    QImage plain(16, 16, QImage::Format_RGB32);
    plain.fill(Qt::blue);
    write(QStringLiteral("plain.png"), png(plain));
    const QByteArray ply = "ply\nformat ascii 1.0\ncomment TextureFile ply.png\n"
                           "comment TextureFile plain.png\nelement vertex 4\nproperty float x\n"
                           "property float y\nproperty float z\nelement face 2\n"
                           "property list uchar int vertex_indices\n"
                           "property list uchar float texcoord\nproperty int texnumber\n"
                           "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                           "3 0 1 2 6 0.6 0.6 0.9 0.6 0.9 0.9 0\n"
                           "3 0 2 3 6 0.1 0.6 0.4 0.9 0.1 0.9 ";
    for (const auto& [picture, colour] : {std::pair("0\n", Qt::red), std::pair("1\n", Qt::blue)}) {
        const auto [model, report, cad] = import(write(QStringLiteral("faces.ply"), ply + picture));
        QCOMPARE(colourAtPlace(model, 0.75F, 0.25F), QColor(Qt::green));
        QCOMPARE(colourAtPlace(model, 0.25F, 0.75F), QColor(colour));
    }
}

void ImportModelTest::plyAndStl_withoutCoordinates_areRead() {
    const QByteArray ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                           "property float y\nproperty float z\nelement face 4\n"
                           "property list uchar int vertex_index\nend_header\n"
                           "0 0 0\n9 0 0\n0 9 0\n0 0 9\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
    for (const auto& path : {write(QStringLiteral("bare.ply"), ply),
                             write(QStringLiteral("bare.stl"), stl(tetrahedronMesh(9)))}) {
        const auto [model, report, cad] = import(path);
        QCOMPARE(report.triangles, std::size_t(4));
        QVERIFY(report.closed);
        QVERIFY(report.volume > 0);
        QVERIFY(!model.hasTextureCoordinates(0));
        QVERIFY(model.textureCoordinate({0, Eigen::Vector3f(1, 0, 0)}).array().isNaN().all());
        QCOMPARE(model.materials.size(), std::size_t(1));
        QCOMPARE(chartCount(model), std::size_t(1));
    }
}

// Tests two strips in one list, as scanners store them. A repeated corner makes the strip continue
// elsewhere.
void ImportModelTest::ply_triangleStrips_areRead() {
    const QByteArray head = "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\n"
                            "property float y\nproperty float z\nelement tristrips 1\n"
                            "property list int int vertex_indices\nend_header\n"
                            "0 0 0\n9 0 0\n9 9 0\n0 9 0\n0 0 9\n9 0 9\n9 9 9\n0 9 9\n";
    const auto parts = import(write(QStringLiteral("strips.ply"),
                                    head + "21 3 2 7 6 6 2 2 2 1 6 5 -1 7 4 3 0 0 0 1 -1 -1\n"))
                           .report;
    QCOMPARE(parts.triangles, std::size_t(6));
    const auto whole =
        import(write(QStringLiteral("whole.ply"), head + "14 3 2 6 7 4 2 0 3 1 6 5 4 1 0\n"))
            .report;
    QCOMPARE(whole.triangles, std::size_t(12));
    QVERIFY(whole.closed);
    QVERIFY2(whole.repairs.isEmpty(), qPrintable(whole.repairs.join(u'|')));
    QVERIFY(refusal(write(QStringLiteral("bad.ply"), head + "3 0 1 8\n"))
                .contains(QStringLiteral("does not exist")));
}

void ImportModelTest::ply_concaveFace_isFilled_data() {
    QTest::addColumn<QList<QPoint>>("outline"); // counter-clockwise
    QTest::addColumn<double>("area");
    const auto row = [](const char* name, const QList<QPoint>& outline, double area) {
        for (qsizetype first = 0; first < outline.size(); ++first) {
            QTest::addRow("%s from corner %d", name, int(first))
                << outline.mid(first) + outline.first(first) << area;
        }
    };
    row("square", {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 16);
    row("dart", {{0, 0}, {4, 0}, {1, 1}, {0, 4}}, 4);
    row("L with a corner on a straight edge",
        {{0, 0}, {2, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}, 7);
    row("comb",
        {{0, 0},
         {5, 0},
         {5, 4},
         {4, 4},
         {4, 1},
         {3, 1},
         {3, 4},
         {2, 4},
         {2, 1},
         {1, 1},
         {1, 4},
         {0, 4}},
        14);
    row("spiral",
        {{0, 0},
         {7, 0},
         {7, 7},
         {2, 7},
         {2, 4},
         {4, 4},
         {4, 5},
         {3, 5},
         {3, 6},
         {6, 6},
         {6, 1},
         {1, 1},
         {1, 7},
         {0, 7}},
        26);
}

void ImportModelTest::ply_concaveFace_isFilled() {
    QFETCH(QList<QPoint>, outline);
    QFETCH(double, area);
    const auto [model, report, cad] = import(write(QStringLiteral("prism.ply"), prismPly(outline)));
    QVERIFY2(report.warnings.isEmpty(), qPrintable(report.warnings.join(u'|')));
    QVERIFY(report.closed);
    QVERIFY(std::abs(report.volume - 2 * area) < 1e-3);
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Eigen::Vector3f& point = model.mesh.positions[model.mesh.triangles[t][corner]];
            QCOMPARE(model.textureCoordinates[t][corner], Eigen::Vector2f(point.head<2>()));
        }
    }
}

void ImportModelTest::ply_faceWhoseEdgesCross_isALoss() {
    const auto [model, report, cad] =
        import(write(QStringLiteral("cross.ply"), prismPly({{0, 0}, {4, 0}, {4, 4}, {3, -2}})));
    QCOMPARE(report.losses.size(), 1);
    QVERIFY2(report.losses[0].contains(QStringLiteral("edges cross each other: 2")),
             qPrintable(report.losses[0]));
}

void ImportModelTest::gltf_picture_isUpright() {
    const auto [model, report, cad] =
        import(write(QStringLiteral("square.gltf"), squareGltf(png(quarters()))));
    QVERIFY(showsQuarters(model));
    QCOMPARE(model.materials[0].name, QStringLiteral("paint"));
    QCOMPARE(model.materials[0].colour, QColor(188, 188, 188)); // half of the light, in sRGB
}

void ImportModelTest::glb_picture_isUpright() {
    const auto [model, report, cad] =
        import(write(QStringLiteral("square.glb"), squareGlb(png(quarters()))));
    QVERIFY(showsQuarters(model));
}

void ImportModelTest::gltf_textureTransform_movesThePicture() {
    QByteArray text = squareGltf(png(quarters()));
    text.replace(R"("baseColorTexture":{"index":0})",
                 R"("baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":
                 {"offset":[0.5,0],"scale":[0.5,0.5]}}})");
    text.replace(R"("asset":)", R"("extensionsUsed":["KHR_texture_transform"],"asset":)");
    const auto imported = import(write(QStringLiteral("moved.gltf"), text));
    QCOMPARE(colourAtPlace(imported.model, 0.1F, 0.1F),
             QColor(Qt::green)); // the upper right quarter alone
    QCOMPARE(colourAtPlace(imported.model, 0.9F, 0.9F), QColor(Qt::green));
}

void ImportModelTest::threeMf_picture_isUpright() {
    writeSquare3mf(at(QStringLiteral("square.3mf")), png(quarters()));
    const auto [model, report, cad] = import(at(QStringLiteral("square.3mf")));
    QCOMPARE(report.triangles, std::size_t(2));
    QVERIFY(showsQuarters(model));
}

void ImportModelTest::threeMf_components_arePlacedInMillimetres() {
    const QByteArray part = R"(<model unit="inch"><resources>
<object id="1" pid="9" pindex="1"><mesh><vertices><vertex x="0" y="0" z="0"/>
<vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices>
<triangles><triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/>
<triangle v1="1" v2="2" v3="3"/><triangle v1="2" v2="0" v3="3" pid="9" p1="0"/></triangles>
</mesh></object></resources><build/></model>)";
    const QByteArray root = R"(<model unit="centimeter" xmlns:p="production"><resources>
<basematerials id="9"><base name="clear" displaycolor="#11223344"/></basematerials>
<object id="3" type="support"><mesh><vertices><vertex x="90" y="0" z="0"/></vertices></mesh></object>
<object id="2"><components><component p:path="/3D/part.model" objectid="1"/>
<component p:path="/3D/part.model" objectid="1" transform="-1 0 0 0 1 0 0 0 1 -5 0 0"/>
</components></object></resources>
<build><item objectid="2" transform="0 2 0 -2 0 0 0 0 2 0 0 7"/><item objectid="3"/></build></model>)";
    const QByteArray materials = R"(<resources><basematerials id="9">
<base name="red" displaycolor="#FF0000"/><base name="blue" displaycolor="#0000FFFF"/>
</basematerials>)";
    write3mf(
        at(QStringLiteral("parts.3mf")),
        {{QStringLiteral("3D/3dmodel.model"), root},
         {QStringLiteral("3D/part.model"), QByteArray(part).replace("<resources>", materials)}});
    const auto [model, report, cad] = import(at(QStringLiteral("parts.3mf")));
    QCOMPARE(report.triangles, std::size_t(8));
    QVERIFY(report.closed);
    // Two parts of 1/6 cm³, scaled by 2, turned by 90° about Z and lifted by 7 cm.
    QVERIFY(std::abs(report.volume - 2 * 8 * 1000 / 6.0) < 0.1);
    QVERIFY(report.box.min().isApprox(Eigen::Vector3f(-20, -120, 70), 1e-4F));
    QVERIFY(report.box.max().isApprox(Eigen::Vector3f(0, 20, 90), 1e-4F));
    QCOMPARE(model.materials.size(), std::size_t(2));
    QCOMPARE(model.materials[0].colour, QColor(Qt::blue));
    QCOMPARE(model.materials[1].colour, QColor(Qt::red));
    QCOMPARE(std::count(model.material.begin(), model.material.end(), 1), 2);
}

void ImportModelTest::modelFilePatterns_listEveryFormatOnce() {
    const QStringList patterns = modelFilePatterns();
    QString expected = QStringLiteral("*.obj *.ply *.stl *.gltf *.glb *.3mf *.dae *.fbx *.3ds");
#ifdef DIPWRIGHT_HAS_CAD
    expected += QStringLiteral(" *.step *.stp *.iges *.igs");
#endif
    QCOMPARE(patterns.join(u' '), expected);
    QCOMPARE(QSet<QString>(patterns.begin(), patterns.end()).size(), patterns.size());
}

void ImportModelTest::pictureFile_otherCaseOrForeignPath_isFound_data() {
    QTest::addColumn<QByteArray>("name");
    for (const char* name :
         {"Maps/Skin One.png", "maps/SKIN one.PNG", "maps\\skin one.png", "./Maps/Skin One.png",
          "Maps/Skin%20One.png", "beside.png", "C:\\Users\\me\\beside.png", "/home/me/BESIDE.png",
          "../sub/beside.png"}) {
        QTest::newRow(name) << QByteArray(name);
    }
}

void ImportModelTest::pictureFile_otherCaseOrForeignPath_isFound() {
    QFETCH(QByteArray, name);
    QDir(folder_.path()).mkpath(QStringLiteral("sub/Maps"));
    write(QStringLiteral("sub/Maps/Skin One.png"), png(quarters()));
    write(QStringLiteral("sub/beside.png"), png(quarters()));
    write(QStringLiteral("sub/Found.MTL"), "newmtl skin\nmap_Kd " + name + "\n");
    const auto [model, report, cad] =
        import(write(QStringLiteral("sub/found.obj"), cubeObj("mtllib found.mtl\nusemtl skin\n")));
    QVERIFY2(report.warnings.isEmpty(), qPrintable(report.warnings.join(u'|')));
    QCOMPARE(model.textures.size(), std::size_t(1));
    QCOMPARE(model.textures[0], quarters());
}

void ImportModelTest::pictureFile_missing_isAWarning() {
    write(QStringLiteral("miss.mtl"), "newmtl skin\nKd 1 0 0\nmap_Kd lost.png\n");
    const auto [model, report, cad] =
        import(write(QStringLiteral("miss.obj"), cubeObj("mtllib miss.mtl\nusemtl skin\n")));
    QCOMPARE(report.warnings.size(), 1);
    QVERIFY(report.warnings[0].contains(QStringLiteral("lost.png")));
    QCOMPARE(model.materials[0].texture, -1);
    QCOMPARE(model.materials[0].colour, QColor(Qt::red));
}

void ImportModelTest::chosenTexture_replacesAllOthers() {
    ImportOptions options;
    options.texture = write(QStringLiteral("chosen.png"), png(quarters(32)));
    write(QStringLiteral("many.mtl"), "newmtl a\nmap_Kd lost.png\nnewmtl b\nKd 0 0 1\n");
    QByteArray text = cubeObj("mtllib many.mtl\nusemtl a\n");
    text.insert(text.indexOf("f 1/1 5/2"), "usemtl b\n");
    const auto [model, report, cad] = import(write(QStringLiteral("many.obj"), text), options);
    QVERIFY(report.warnings.isEmpty());
    QCOMPARE(model.textures.size(), std::size_t(1));
    QCOMPARE(model.textures[0], quarters(32));
    for (const Material& material : model.materials) {
        QCOMPARE(material.texture, 0);
    }
}

void ImportModelTest::chosenTexture_withoutCoordinates_isAWarning() {
    ImportOptions options;
    options.texture = write(QStringLiteral("chosen.png"), png(quarters()));
    const auto [model, report, cad] =
        import(write(QStringLiteral("plain.stl"), stl(tetrahedronMesh(9))), options);
    QCOMPARE(report.warnings.size(), 1);
    QVERIFY(model.textures.empty());
    QCOMPARE(model.materials[0].texture, -1);
}

void ImportModelTest::texture_16BitOrGrey_becomesRgba8() {
    ImportOptions options;
    QImage deep = quarters().convertToFormat(QImage::Format_RGBA64);
    for (const QImage& picture : {deep, quarters().convertToFormat(QImage::Format_Grayscale8),
                                  quarters().convertToFormat(QImage::Format_Indexed8)}) {
        options.texture = write(QStringLiteral("chosen.png"), png(picture));
        const auto imported = import(write(QStringLiteral("deep.obj"), cubeObj()), options);
        QCOMPARE(imported.model.textures[0].format(), QImage::Format_RGBA8888);
        QCOMPARE(imported.model.textures[0].size(), QSize(16, 16));
    }
}

void ImportModelTest::charts_cube_areSix() {
    const auto imported = import(write(QStringLiteral("six.obj"), cubeObj()));
    QCOMPARE(chartCount(imported.model), std::size_t(6));
    for (std::size_t t = 0; t < 12; t += 2) { // a face's two triangles
        QCOMPARE(imported.model.chart[t], imported.model.chart[t + 1]);
    }
}

void ImportModelTest::charts_sphereWithSeam_isOneClosedChart() {
    const auto [model, report, cad] =
        import(write(QStringLiteral("seam.obj"), sphereWithSeamObj(12, 24)));
    QVERIFY(report.closed);
    QCOMPARE(model.mesh.positions.size(), std::size_t(2 + 11 * 24));
    QCOMPARE(chartCount(model), std::size_t(1));
    // The seam is still there: some edge has different texture coordinates on its two sides.
    const auto opposite = oppositeEdges(model.mesh);
    int seamEdges = 0;
    for (std::uint32_t edge = 0; edge < opposite.size(); ++edge) {
        const auto& here = model.textureCoordinates[edge / 3];
        const auto& there = model.textureCoordinates[opposite[edge] / 3];
        seamEdges += here[edge % 3] != there[(opposite[edge] + 1) % 3] ||
                     here[(edge + 1) % 3] != there[opposite[edge] % 3];
    }
    QVERIFY(seamEdges >= 2 * 12);
}

void ImportModelTest::importOptions_longestEdgeAndUnit_setTheSize() {
    const QString path = write(QStringLiteral("size.obj"), cubeObj());
    ImportOptions options;
    options.longestEdge = Millimetres(90);
    QVERIFY(std::abs(import(path, options).report.box.sizes().x() - 90) < 1e-4F);
    QVERIFY(std::abs(import(path, options).report.volume - 729000) < 1);
    options = {};
    options.unitMillimetres = 25.4;
    QVERIFY(std::abs(import(path, options).report.box.sizes().x() - 254) < 1e-3F);
}

void ImportModelTest::stl_separateTriangles_areWeldedAndClosed() {
    const auto [model, report, cad] =
        import(write(QStringLiteral("weld.stl"), stl(sphereMesh(35, 20, 40))));
    QCOMPARE(model.mesh.positions.size(), std::size_t(2 + 19 * 40));
    QVERIFY(report.closed);
    QVERIFY(report.warnings.isEmpty());
}

void ImportModelTest::repair_degenerateTriangles_areRemoved() {
    const QByteArray text = cubeObj() + "f 1/1 1/1 2/2\nf 1/1 2/2 1/1\nf 3/1 3/2 3/3\n";
    const auto [model, report, cad] = import(write(QStringLiteral("degenerate.obj"), text));
    QCOMPARE(report.triangles, std::size_t(12));
    QVERIFY(report.closed);
    QCOMPARE(report.repairs,
             QStringList(QStringLiteral("Triangles without area that were removed: 3")));
    QCOMPARE(model.textureCoordinates.size(), std::size_t(12));
    QCOMPARE(model.material.size(), std::size_t(12));
}

void ImportModelTest::repair_strayPoints_areRefused_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("says");
    const QByteArray box = stl(boxMesh({40, 6, 40}));
    for (const char* far : {"1e7", "1e9", "1e20", "3e38"}) {
        QByteArray text = box;
        const qsizetype at = text.indexOf("vertex -20") + 7;
        QTest::newRow(far) << text.replace(at, 3, far) << "(1) lie more than";
    }
    QTest::newRow("all") << QByteArray(box).replace("20 ", "20e20 ").replace("20\n", "20e20\n")
                         << "coordinates are too large";
}

void ImportModelTest::repair_strayPoints_areRefused() {
    QFETCH(QByteArray, text);
    QFETCH(QString, says);
    const QString path = write(QStringLiteral("stray.stl"), text);
    ImportOptions scaled;
    scaled.longestEdge = Millimetres(40);
    for (const ImportOptions& options : {ImportOptions(), scaled}) {
        try {
            import(path, options);
            QFAIL("a model with a stray point was imported, expected a refusal");
        } catch (const Error& error) {
            QVERIFY2(error.sentence().contains(says), qPrintable(error.sentence()));
        }
    }
}

void ImportModelTest::repair_strayTriangleWithoutArea_leavesNoPoints() {
    const QByteArray stray = "facet normal 0 0 0\nouter loop\nvertex 1e20 0 0\nvertex 1e20 0 0\n"
                             "vertex 1e20 0 0\nendloop\nendfacet\n";
    QByteArray text = stl(boxMesh({40, 6, 40}));
    const auto [model, report, cad] =
        import(write(QStringLiteral("stray.stl"), text.insert(text.indexOf("facet"), stray)));
    QCOMPARE(report.repaired.removedTriangles, 1);
    QCOMPARE(model.mesh.positions.size(), std::size_t(8));
    QVERIFY(report.closed);
    QVERIFY(std::abs(report.volume - 9600) < 0.01);
}

void ImportModelTest::repair_insideOutBody_isFlipped() {
    TriangleMesh sphere = sphereMesh(35, 20, 40);
    for (auto& triangle : sphere.triangles) {
        std::swap(triangle[0], triangle[1]);
    }
    const auto report = import(write(QStringLiteral("inside.stl"), stl(sphere))).report;
    QVERIFY(report.volume > 0);
    QCOMPARE(report.repairs.size(), 1);
}

void ImportModelTest::repair_insideOutBodyWithOpenSeam_isFlipped() {
    TriangleMesh sphere = sphereMesh(35, 20, 40);
    const double whole = volume(sphere);
    for (auto& triangle : sphere.triangles) {
        std::swap(triangle[0], triangle[1]);
    }
    QByteArray text = stl(sphere);
    text.replace("vertex 35 ", "vertex 35.0001 "); // a rounding error in some corners
    text.replace(text.indexOf("vertex 35.0001 "), 15, "vertex 35 ");
    const auto joined = import(write(QStringLiteral("seam.stl"), text)).report;
    QVERIFY(joined.closed);
    QVERIFY(std::abs(joined.volume - whole) < 1);
    QCOMPARE(joined.repairs.size(), 2);

    sphere.triangles.resize(sphere.triangles.size() - 60); // a hole, too
    const auto open = import(write(QStringLiteral("hole.stl"), stl(sphere))).report;
    QVERIFY(!open.closed);
    QVERIFY(open.volume > 0.9 * whole);
    QCOMPARE(open.repaired.turnedParts, 1);
    QCOMPARE(open.repairs.size(), 1);
}

void ImportModelTest::repair_duplicateFaces_areMerged() {
    const TriangleMesh box = boxMesh({10, 10, 10});
    const auto report = import(write(QStringLiteral("twice.stl"), stl({box, box}, 0))).report;
    QVERIFY(report.closed);
    QVERIFY(std::abs(report.volume - 1000) < 0.01);
    QCOMPARE(report.repaired.mergedTriangles, 12);
    QCOMPARE(report.repairs.size(), 1);
}

void ImportModelTest::repair_insideOutPart_isFlippedButCavityIsRemoved() {
    const auto importBoth = [&](const TriangleMesh& outer, const TriangleMesh& inner) {
        return import(write(QStringLiteral("parts.stl"), stl({inner, outer}, 1))).report;
    };
    const auto cavity = importBoth(boxMesh({20, 20, 20}), boxMesh({10, 10, 10}));
    QVERIFY(std::abs(cavity.volume - 8000) < 0.1);
    QCOMPARE(cavity.repaired.turnedParts, 0);
    QCOMPARE(cavity.repaired.enclosedTriangles, 12);
    const auto crossing = importBoth(boxMesh({20, 20, 20}), boxMesh({10, 10, 40}));
    QVERIFY(std::abs(crossing.volume - 12000) < 0.1);
    QCOMPARE(crossing.repairs.size(), 1);
}

void ImportModelTest::repair_manyNestedParts_areDistinguished() {
    constexpr int half = 200;
    auto boxes = nestedBoxes(half);
    const auto cavities = import(write(QStringLiteral("nested.stl"), stl(boxes, half))).report;
    QCOMPARE(cavities.repaired.turnedParts, 0);
    QCOMPARE(cavities.repaired.enclosedTriangles, 12 * (2 * half - 1)); // all but one
    QVERIFY(cavities.closed);
    const auto allTurned = import(write(QStringLiteral("all.stl"), stl(boxes, 2 * half))).report;
    QCOMPARE(allTurned.repairs.size(), 2); // turned, and removed
    QVERIFY2(allTurned.repairs[0].contains(QString::number(2 * half)),
             qPrintable(allTurned.repairs[0]));
}

void ImportModelTest::repair_cancelled_throws() {
    const QString path = write(QStringLiteral("nested.stl"), stl(nestedBoxes(200), 200));
    Progress progress;
    progress.report = [&](double share, const QString& /*text*/) {
        if (share >= 0.7) { // the reader has finished
            progress.cancelToken.cancel();
        }
    };
    QVERIFY_EXCEPTION_THROWN(importModel(path, {}, progress), Cancelled);
}

void ImportModelTest::repair_flippedNeighbours_areFlippedBack() {
    TriangleMesh sphere = sphereMesh(35, 20, 40);
    for (std::size_t t = 0; t < sphere.triangles.size(); t += 5) {
        std::swap(sphere.triangles[t][0], sphere.triangles[t][1]);
    }
    const auto report = import(write(QStringLiteral("turned.stl"), stl(sphere))).report;
    QVERIFY(report.closed);
    QVERIFY(std::abs(report.volume - volume(sphereMesh(35, 20, 40))) < 0.1);
    QCOMPARE(report.repairs.size(), 1);
}

void ImportModelTest::openMesh_isAWarning() {
    TriangleMesh box = boxMesh({10, 10, 10});
    box.triangles.pop_back();
    const auto report = import(write(QStringLiteral("open.stl"), stl(box))).report;
    QVERIFY(!report.closed);
    QCOMPARE(report.warnings.size(), 1);
}

void ImportModelTest::gltf_mirroredNode_keepsItsOutside() {
    QByteArray text = squareGltf(png(quarters()));
    text.replace(R"("nodes":[{"mesh":0}])", R"("nodes":[{"mesh":0,"scale":[-1,1,1]}])");
    const auto imported = import(write(QStringLiteral("mirror.gltf"), text));
    QVERIFY(triangleNormal(imported.model.mesh, 0).z() > 0.99F);
    QCOMPARE(boundingBox(imported.model.mesh).min().x(), -1.0F);
}

void ImportModelTest::stl_millionTriangles_isClosed() {
    const TriangleMesh sphere = sphereMesh(35, 708, 708);
    QByteArray bytes(84 + 50 * qsizetype(sphere.triangles.size()), '\0');
    const auto count = quint32(sphere.triangles.size());
    memcpy(bytes.data() + 80, &count, 4);
    char* next = bytes.data() + 84;
    for (const auto& triangle : sphere.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            const auto& place = sphere.positions[triangle[std::size_t(corner)]];
            memcpy(next + 12 + 12 * corner, place.data(), 12);
        }
        next += 50;
    }
    const auto [model, report, cad] = import(write(QStringLiteral("million.stl"), bytes));
    QVERIFY(report.triangles > 1'000'000);
    QVERIFY(report.closed);
    QCOMPARE(model.mesh.positions.size(), sphere.positions.size());
}

void ImportModelTest::modelPath_anyLanguage_isRead() {
    const QString folder = QStringLiteral("Schildkröte 亀 №1");
    QDir(folder_.path()).mkpath(folder);
    write(folder + QStringLiteral("/häute.png"), png(quarters()));
    write(folder + QStringLiteral("/ö.mtl"), "newmtl skin\r\nmap_Kd häute.png\r\n");
    const auto [model, report, cad] = import(
        write(folder + QStringLiteral("/亀.obj"), cubeObj("mtllib ö.mtl\r\nusemtl skin\r\n")));
    QVERIFY2(report.warnings.isEmpty(), qPrintable(report.warnings.join(u'|')));
    QCOMPARE(model.textures.size(), std::size_t(1));
}

void ImportModelTest::model_unreadable_isRefused_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, const char* file, const QByteArray& bytes,
                        const char* says) {
        QTest::newRow(name) << QString::fromLatin1(file) << bytes << QString::fromLatin1(says);
    };
    row("empty", "empty.obj", "", "empty");
    row("a picture named obj", "picture.obj", png(quarters()), "triangles");
    row("unknown type", "notes.txt", "hello", "cannot be read");
    row("no extension", "noextension", "hello", "cannot be read");
    row("garbage stl", "garbage.stl", QByteArray(1000, '\x9c'), "cannot be read");
    row("garbage glb", "garbage.glb", QByteArray(1000, '\x9c'), "cannot be read");
    row("garbage 3mf", "garbage.3mf", QByteArray(1000, '\x9c'), "cannot be read");
    row("garbage ply", "garbage.ply", QByteArray(1000, '\x9c'), "cannot be read");
    row("no triangles", "points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "triangles");
    row("lines only", "lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n", "triangles");
    row("not a number", "nan.obj", QByteArray(cubeObj()).replace("v 5 5 5", "v nan 5 5"), "NaN");
    row("infinite", "inf.obj", QByteArray(cubeObj()).replace("v 5 5 5", "v 5 inf 5"), "NaN");
    row("all corners in one place", "dot.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "area");
    row("all corners on one line", "line.obj", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n", "area");
    row("huge coordinate", "huge.obj", QByteArray(cubeObj()).replace("v 5 5 5", "v 1e30 5 5"),
        "delete them");
    row("truncated glb", "cut.glb", squareGlb(png(quarters())).chopped(200), "cannot be read");
    row("truncated ply header", "cut.ply", squarePly("x.png").left(100), "cannot be read");
    row("truncated ply", "cut.ply", squarePly("x.png").chopped(6), "cannot be read");
    row("unknown point", "point.ply", squarePly("x").replace("3 0 2 3", "3 0 2 4"),
        "cannot be read");
    row("a ply named obj", "ply.obj", squarePly("x.png").left(100), "cannot be read");
    TriangleMesh sphere = sphereMesh(1, 4, 8);
    row("truncated stl", "cut.stl", stl(sphere).left(25), "cannot be read");
}

void ImportModelTest::model_unreadable_isRefused() {
    QFETCH(QString, file);
    QFETCH(QByteArray, bytes);
    QFETCH(QString, says);
    const QString sentence = refusal(write(file, bytes));
    QVERIFY2(sentence.contains(says), qPrintable(sentence));
    QVERIFY(sentence.contains(file));
    QVERIFY(!sentence.contains(u'\n'));
}

void ImportModelTest::texture_unreadable_isRefused_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("says");
    const QByteArray good = png(quarters(64));
    const auto withSize = [&](quint32 width, quint32 height) {
        QByteArray header; // type and fields of the IHDR chunk
        QDataStream stream(&header, QIODevice::WriteOnly);
        stream.writeRawData("IHDR", 4);
        stream << width << height << quint8(8) << quint8(6) << quint8(0) << quint8(0) << quint8(0);
        quint32 sum = 0xffffffffu;
        for (const char byte : header) {
            sum ^= quint8(byte);
            for (int bit = 0; bit < 8; ++bit) {
                sum = sum & 1 ? sum >> 1 ^ 0xedb88320u : sum >> 1;
            }
        }
        stream << ~sum;
        return QByteArray(good).replace(12, header.size(), header);
    };
    QTest::newRow("empty") << QByteArray() << QStringLiteral("picture");
    QTest::newRow("text") << QByteArray("hello") << QStringLiteral("picture");
    QTest::newRow("truncated") << good.left(60) << QStringLiteral("picture");
    QTest::newRow("no pixels") << withSize(0, 0) << QStringLiteral("picture");
    QTest::newRow("100,000 pixels a side") << withSize(100000, 100000) << QStringLiteral("100000");
    QTest::newRow("a long strip") << withSize(40000, 1) << QStringLiteral("40000");
    QTest::newRow("PPM with 100,000 pixels a side")
        << QByteArray("P6\n100000 100000\n255\nabc") << QStringLiteral("picture");
    QTest::newRow("PPM without pixels")
        << QByteArray("P6\n0 0\n255\n") << QStringLiteral("picture");
}

void ImportModelTest::texture_unreadable_isRefused() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, says);
    ImportOptions options;
    options.texture = write(QStringLiteral("bad.png"), bytes);
    const QString chosen = refusal(write(QStringLiteral("tex.obj"), cubeObj()), options);
    QVERIFY2(chosen.contains(says), qPrintable(chosen));
    QVERIFY(chosen.contains(QStringLiteral("bad.png")));
    // The same picture, as a texture that the model names.
    write(QStringLiteral("tex.mtl"), "newmtl skin\nmap_Kd bad.png\n");
    const QString own =
        refusal(write(QStringLiteral("tex.obj"), cubeObj("mtllib tex.mtl\nusemtl skin\n")));
    QVERIFY2(own.contains(says), qPrintable(own));
}

void ImportModelTest::texture_colourProfile_isApplied() {
    // The same brown, stored in sRGB and in Adobe RGB.
    QImage picture(8, 8, QImage::Format_RGB32);
    picture.fill(QColor(146, 93, 43));
    picture.setColorSpace(QColorSpace::SRgb);
    QImage wide = picture.convertedToColorSpace(QColorSpace::AdobeRgb);
    QVERIFY(std::abs(qRed(wide.pixel(3, 3)) - 146) > 5);
    const auto imported = [&](const QImage& texture) {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        texture.save(&buffer, "PNG");
        ImportOptions options;
        options.texture = write(QStringLiteral("skin.png"), bytes);
        const QString path = write(QStringLiteral("skin.obj"), cubeObj());
        return importModel(path, options, {}).model.textures.front().pixelColor(3, 3);
    };
    const auto apart = [](const QColor& a, const QColor& b) {
        return std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()),
                         std::abs(a.blue() - b.blue())});
    };
    QVERIFY(apart(imported(picture), QColor(146, 93, 43)) <= 1);
    QVERIFY(apart(imported(wide), QColor(146, 93, 43)) <= 1);
    wide.setColorSpace(QColorSpace()); // without its profile the values count as sRGB
    QVERIFY(apart(imported(wide), QColor(146, 93, 43)) > 5);
}

void ImportModelTest::importOptions_outOfRange_areRefused() {
    const QString path = write(QStringLiteral("range.obj"), cubeObj());
    QVERIFY(refusal(at(QStringLiteral("nowhere.obj"))).contains(QStringLiteral("exist")));
    QVERIFY(refusal(folder_.path()).contains(QStringLiteral("folder")));
    for (const double edge : {0.0, -1.0, std::nan(""), double(INFINITY), 1e9}) {
        ImportOptions options;
        options.longestEdge = Millimetres(edge);
        QVERIFY(!refusal(path, options).isEmpty());
        options = {};
        options.unitMillimetres = edge;
        QVERIFY(!refusal(path, options).isEmpty());
    }
    ImportOptions options;
    options.texture = at(QStringLiteral("nowhere.png"));
    QVERIFY(refusal(path, options).contains(QStringLiteral("nowhere.png")));
}

void ImportModelTest::threeMf_hostile_isRefused_data() {
    QTest::addColumn<QByteArray>("model");
    const QByteArray mesh =
        R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>
<vertex x="0" y="1" z="0"/></vertices><triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh>)";
    QByteArray doubling = R"(<object id="0">)" + mesh + "</object>";
    for (int i = 1; i < 31; ++i) {
        const QByteArray child = R"(<component objectid=")" + QByteArray::number(i - 1) + R"("/>)";
        doubling += R"(<object id=")" + QByteArray::number(i) + R"("><components>)" + child +
                    child + "</components></object>";
    }
    QTest::newRow("an object that contains itself") << QByteArray(
        R"(<object id="30"><components><component objectid="30"/></components></object>)");
    QTest::newRow("a thousand million triangles") << doubling;
    QTest::newRow("an object that does not exist") << QByteArray();
    QTest::newRow("a point that does not exist")
        << QByteArray(R"(<object id="30">)" + mesh + "</object>").replace(R"(v3="2")", R"(v3="3")");
    QTest::newRow("no number")
        << QByteArray(R"(<object id="30">)" + mesh + "</object>").replace(R"(x="1")", R"(x="one")");
    QTest::newRow("a triangle outside an object")
        << QByteArray(R"(<triangle v1="0" v2="1" v3="2"/>)");
    QTest::newRow("not well-formed") << QByteArray(R"(<object id="30"><mesh>)");
}

void ImportModelTest::threeMf_hostile_isRefused() {
    QFETCH(QByteArray, model);
    write3mf(at(QStringLiteral("hostile.3mf")),
             {{QStringLiteral("3D/3dmodel.model"),
               "<model><resources>" + model +
                   R"(</resources><build><item objectid="30"/></build></model>)"}});
    const QString sentence = refusal(at(QStringLiteral("hostile.3mf")));
    QVERIFY2(sentence.contains(QStringLiteral("cannot be read")) ||
                 sentence.contains(QStringLiteral("million")),
             qPrintable(sentence));
}

void ImportModelTest::model_truncated_neverCrashes_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("bytes");
    const QByteArray picture = png(quarters());
    writeSquare3mf(at(QStringLiteral("whole.3mf")), picture);
    QFile threeMf(at(QStringLiteral("whole.3mf")));
    QVERIFY(threeMf.open(QIODevice::ReadOnly));
    QTest::newRow("obj") << QStringLiteral("cut.obj") << cubeObj();
    QTest::newRow("ply") << QStringLiteral("cut.ply") << squarePly("lost.png");
    QTest::newRow("stl") << QStringLiteral("cut.stl") << stl(tetrahedronMesh(9));
    QTest::newRow("gltf") << QStringLiteral("cut.gltf") << squareGltf(picture);
    QTest::newRow("glb") << QStringLiteral("cut.glb") << squareGlb(picture);
    QTest::newRow("3mf") << QStringLiteral("cut.3mf") << threeMf.readAll();
    addOtherFormats();
}

void ImportModelTest::model_truncated_neverCrashes() {
    QFETCH(QString, file);
    QFETCH(QByteArray, bytes);
    for (qsizetype length = 0; length < bytes.size(); length += 1 + bytes.size() / 97) {
        const QString path = write(file, bytes.left(length));
        const QString sentence = refusal(path); // what remains may be a model
        QVERIFY(sentence.isEmpty() || sentence.contains(file));
    }
}

void ImportModelTest::colladaFbxAnd3ds_areRead_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("bytes");
    addOtherFormats();
}

void ImportModelTest::colladaFbxAnd3ds_areRead() {
    QFETCH(QString, file);
    QFETCH(QByteArray, bytes);
    const QString path = write(file, bytes);
    QCOMPARE(refusal(path), QString());
    const ImportedModel model = import(path);
    QCOMPARE(model.report.triangles, std::size_t(4));
    QVERIFY(model.report.closed);
    const float edge = file.endsWith(QStringLiteral(".dae"))   ? 10'000 // its unit is a metre
                       : file.endsWith(QStringLiteral(".fbx")) ? 100    // a centimetre
                                                               : 10;
    QVERIFY(model.report.box.sizes().isApprox(Eigen::Vector3f::Constant(edge), 1e-5F));
}

void ImportModelTest::model_damaged_neverCrashes_data() {
    colladaFbxAnd3ds_areRead_data();
}

void ImportModelTest::model_damaged_neverCrashes() {
    QFETCH(QString, file);
    QFETCH(QByteArray, bytes);
    const int damagedFiles = sampleOf(60, 400);
    std::mt19937 random(1);
    const auto below = [&](qsizetype limit) { return qsizetype(random() % quint32(limit)); };
    int refused = 0;
    for (int turn = 0; turn < damagedFiles; ++turn) {
        QByteArray damaged = bytes;
        for (qsizetype faults = 1 + below(4); faults > 0; --faults) {
            const qsizetype place = below(damaged.size() - 4);
            switch (below(3)) {
            case 0:
                damaged[place] = char(damaged[place] ^ (1 << below(8)));
                break;
            case 1:
                damaged[place] = char(random());
                break;
            default: // may turn a count into thousands of millions
                damaged.replace(place, 4, "\xff\xff\xff\x7f");
            }
        }
        const QString sentence = refusal(write(file, damaged)); // it may still be a model
        QVERIFY(sentence.isEmpty() || sentence.contains(file));
        refused += sentence.isEmpty() ? 0 : 1;
    }
    QVERIFY(refused > damagedFiles / 4);
}

void ImportModelTest::collada_absurdCounts_areRefused_data() {
    QTest::addColumn<QByteArray>("good");
    QTest::addColumn<QByteArray>("bad");
    QTest::addColumn<QString>("reason");
    const QString fewer = QStringLiteral("fewer values than an accessor reads");
    const QString more = QStringLiteral("more values than the file can hold");
    const QByteArray count = "count=\"36\"";
    QTest::newRow("an empty array") << count << QByteArray("count=\"0\"") << fewer;
    QTest::newRow("an array that is too short") << count << QByteArray("count=\"33\"") << fewer;
    QTest::newRow("an offset beyond the array")
        << QByteArray("offset=\"0\" source") << QByteArray("offset=\"30\" source") << fewer;
    QTest::newRow("a missing count") << count << QByteArray() << fewer;
    QTest::newRow("a count that is no number") << count << QByteArray("count=\"many\"") << fewer;
    QTest::newRow("too wide a stride")
        << QByteArray("stride=\"3\"") << QByteArray("stride=\"2000000000\"") << fewer;
    QTest::newRow("too many values") << QByteArray("accessor count=\"12\"")
                                     << QByteArray("accessor count=\"4294967295\"") << more;
    QTest::newRow("too many triangles") << QByteArray("polylist count=\"4\"")
                                        << QByteArray("polylist count=\"2000000000\"") << more;
    QTest::newRow("another number of polygons")
        << QByteArray("polylist") << QByteArray("polygons") << QStringLiteral("declared count");
    QTest::newRow("an index that is no number")
        << QByteArray("<p>0 1") << QByteArray("<p>0 n") << QStringLiteral("no number");
}

void ImportModelTest::collada_absurdCounts_areRefused() {
    QFETCH(QByteArray, good);
    QFETCH(QByteArray, bad);
    QFETCH(QString, reason);
    QByteArray bytes = tetrahedron("collada");
    QVERIFY(bytes.contains(good));
    const QString sentence = refusal(write(QStringLiteral("absurd.dae"), bytes.replace(good, bad)));
    QVERIFY2(sentence.contains(reason), qPrintable(sentence));
}

void ImportModelTest::importModel_cancelled_throws() {
    Progress progress;
    progress.report = [&](double, const QString&) { progress.cancelToken.cancel(); };
    QVERIFY_EXCEPTION_THROWN(
        importModel(write(QStringLiteral("cancel.obj"), cubeObj()), ImportOptions(), progress),
        Cancelled);
}

void ImportModelTest::pictureFile_outsideTheFolder_isReadOnlyIfAllowed_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("folder above") << QStringLiteral("../secret/key.png");
    QTest::newRow("folder above, in percent codes") << QStringLiteral("%2e%2e/secret/key.png");
    QTest::newRow("folder above, by a detour") << QStringLiteral("maps/../../secret/key.png");
    QTest::newRow("folder above, with backslashes") << QStringLiteral("..\\secret\\key.png");
    QTest::newRow("folder above, in another case") << QStringLiteral("../SECRET/Key.PNG");
    QTest::newRow("absolute path") << at(QStringLiteral("secret/key.png"));
    QTest::newRow("file URL") << QStringLiteral("file://") + at(QStringLiteral("secret/key.png"));
    QTest::newRow("a link to a file") << QStringLiteral("link.png");
    QTest::newRow("a link to a folder") << QStringLiteral("folder/key.png");
    QTest::newRow("hidden folder") << QStringLiteral(".hidden/key.png");
}

void ImportModelTest::pictureFile_outsideTheFolder_isReadOnlyIfAllowed() {
    QFETCH(QString, name);
    QDir(folder_.path()).mkpath(QStringLiteral("secret"));
    QDir(folder_.path()).mkpath(QStringLiteral("in/maps"));
    QDir(folder_.path()).mkpath(QStringLiteral("in/.hidden"));
    const QString key = write(QStringLiteral("secret/key.png"), png(quarters()));
    write(QStringLiteral("in/.hidden/key.png"), png(quarters()));
    QFile::link(key, at(QStringLiteral("in/link.png")));
    QFile::link(at(QStringLiteral("secret")), at(QStringLiteral("in/folder")));
    write(QStringLiteral("in/names.mtl"), "newmtl skin\nmap_Kd " + name.toUtf8() + "\n");
    const QString obj =
        write(QStringLiteral("in/names.obj"), cubeObj("mtllib names.mtl\nusemtl skin\n"));
    const QString ply = write(QStringLiteral("in/names.ply"), squarePly(name.toUtf8()));
    for (const QString& path : {obj, ply}) {
        QStringList outside;
        try {
            import(path);
        } catch (const OutsideFiles& refused) {
            outside = refused.files();
            QVERIFY(refused.sentence().contains(QStringLiteral("--allow-outside")));
        }
        QCOMPARE(outside.size(), 1);
        ImportOptions allowed;
        allowed.outsideFiles = outside;
        QCOMPARE(import(path, allowed).model.textures.front(), quarters());
        allowed.outsideFiles = QStringList{at(QStringLiteral("another.png"))};
        QVERIFY(!refusal(path, allowed).isEmpty());
        allowed.allowOutside = true;
        QCOMPARE(import(path, allowed).model.textures.front(), quarters());
    }
}

// Tests links and detours that stay within the folder: they are treated like plain names.
void ImportModelTest::pictureFile_insideTheFolder_needsNoPermission() {
    QDir(folder_.path()).mkpath(QStringLiteral("own/maps"));
    write(QStringLiteral("own/maps/skin.png"), png(quarters()));
    QFile::link(at(QStringLiteral("own/maps/skin.png")), at(QStringLiteral("own/link.png")));
    for (const char* name : {"link.png", "maps/../maps/skin.png", "../own/maps/skin.png"}) {
        const QString path = write(QStringLiteral("own/square.ply"), squarePly(name));
        QCOMPARE(import(path).model.textures.front(), quarters());
    }
    // A buffer that does not exist is missing, not outside.
    const QString lost = write(QStringLiteral("own/lost.gltf"),
                               squareGltf(png(quarters())).replace("data:application", "../x"));
    QVERIFY(refusal(lost).contains(QStringLiteral("cannot be read")));
}

void ImportModelTest::model_unlistedFormat_isRefused_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("off") << QStringLiteral("a.off")
                         << QByteArray("OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0\n");
    QTest::newRow("csm") << QStringLiteral("a.csm") << QByteArray("$order\na\n$points\n0 0 0\n");
    QTest::newRow("ogex") << QStringLiteral("a.ogex")
                          << QByteArray("Metric (key=\"up\") {string {\"z\"}}\n");
    QTest::newRow("an off named txt") << QStringLiteral("a.txt") << QByteArray("OFF\n4 1 0\n");
    QTest::newRow("an off named stl")
        << QStringLiteral("b.stl") << QByteArray("OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n");
    QTest::newRow("packed collada") << QStringLiteral("a.zae") << QByteArray("PK\3\4");
}

void ImportModelTest::model_unlistedFormat_isRefused() {
    QFETCH(QString, file);
    QFETCH(QByteArray, bytes);
    const QString sentence = refusal(write(file, bytes));
    QVERIFY2(sentence.contains(QStringLiteral("cannot be read")), qPrintable(sentence));
    QVERIFY(sentence.contains(QStringLiteral("OBJ, PLY, STL, glTF, 3MF")));
}

void ImportModelTest::pictureFile_formatIsKnownByContent() {
    ImportOptions options;
    const QString cube = write(QStringLiteral("content.obj"), cubeObj());
    QByteArray bitmap;
    QBuffer buffer(&bitmap);
    QVERIFY(quarters().convertToFormat(QImage::Format_RGB32).save(&buffer, "BMP"));
    options.texture = write(QStringLiteral("bitmap.png"), bitmap);
    QCOMPARE(import(cube, options).model.textures.front(), quarters());
    const std::pair<const char*, QByteArray> others[] = {
        {"drawing.png", "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'></svg>"},
        {"icon.png", QByteArray("\0\0\1\0\1\0\1\1\0\0", 10)},
        {"pixels.png", "/* XPM */\nstatic char* a[] = {\"1 1 1 1\", \"a c red\", \"a\"};"},
        {"text.png", "P3 1 1 255 9 9 9"}};
    for (const auto& [name, bytes] : others) {
        options.texture = write(QString::fromLatin1(name), bytes);
        const QString sentence = refusal(cube, options);
        QVERIFY2(sentence.contains(QStringLiteral("not a picture")), qPrintable(sentence));
    }
}

void ImportModelTest::mtl_statementBeforeAnyMaterial_isRefused() {
    write(QStringLiteral("early.mtl"), "# nothing\r\n  map_Kd t.png\nnewmtl skin\n");
    const QString sentence =
        refusal(write(QStringLiteral("early.obj"), cubeObj("mtllib early.mtl\nusemtl skin\n")));
    QVERIFY2(sentence.contains(QStringLiteral("early.mtl")), qPrintable(sentence));
    // Material files may have any name, and statements other than pictures are checked, too.
    write(QStringLiteral("early.m"), "# nothing\n aniso 0.5\n");
    const QString other =
        refusal(write(QStringLiteral("other.OBJ"), cubeObj("mtllib early.m\nusemtl skin\n")));
    QVERIFY2(other.contains(QStringLiteral("early.m sets")), qPrintable(other));
    // A model may name itself as its material file.
    const QString itself = refusal(
        write(QStringLiteral("itself.obj"), "mtllib itself.obj\nmap_Kd t.png\n" + cubeObj()));
    QVERIFY2(itself.contains(QStringLiteral("itself.obj sets")), qPrintable(itself));
    // A heading is not a statement.
    write(QStringLiteral("headed.mtl"), "Alias OBJ Material File\nPaint\nnewmtl skin\nKd 1 0 0\n");
    const auto [headed, report, cad] =
        import(write(QStringLiteral("headed.obj"), cubeObj("mtllib headed.mtl\nusemtl skin\n")));
    QVERIFY2(report.warnings.isEmpty(), qPrintable(report.warnings.join(u'|')));
    QCOMPARE(headed.materials[0].colour, QColor(Qt::red));
}

void ImportModelTest::obj_faceWithTooManyCorners_isRefused() {
    QByteArray text, face = "f";
    constexpr int corners = 60000;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * M_PI * i / corners, radius = i % 2 == 0 ? 10 : 9;
        text += QStringLiteral("v %1 %2 0\n")
                    .arg(radius * std::cos(angle))
                    .arg(radius * std::sin(angle))
                    .toUtf8();
        face += ' ' + QByteArray::number(i + 1);
    }
    const QString sentence = refusal(write(QStringLiteral("star.obj"), text + face + "\n"));
    QVERIFY2(sentence.contains(QStringLiteral("corners")), qPrintable(sentence));
}

void ImportModelTest::smallFile_hugeContent_isRefused_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("says");
    QImage black(16000, 9000, QImage::Format_Mono);
    black.fill(0);
    QTest::newRow("a picture") << QStringLiteral("black.png") << png(black)
                               << QStringLiteral("million pixels");
    const QByteArray head = R"(<?xml version="1.0"?><model unit="millimeter"><resources>)";
    write3mf(at(QStringLiteral("vast.3mf")),
             {{QStringLiteral("3D/3dmodel.model"), head + QByteArray(200 << 20, ' ')}});
    QTest::newRow("a package") << QStringLiteral("vast.3mf") << QByteArray()
                               << QStringLiteral("unpack");
}

void ImportModelTest::smallFile_hugeContent_isRefused() {
    QFETCH(QString, file);
    QFETCH(QByteArray, bytes);
    QFETCH(QString, says);
    QString path = bytes.isEmpty() ? at(file) : write(file, bytes);
    ImportOptions options;
    if (!bytes.isEmpty()) {
        options.texture = path;
        path = write(QStringLiteral("small.obj"), cubeObj());
    }
    const QString sentence = refusal(path, options);
    QVERIFY2(sentence.contains(says), qPrintable(sentence));
}

QTEST_GUILESS_MAIN(ImportModelTest)
#include "ImportModelTest.moc"
