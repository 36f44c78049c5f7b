// Tests inconsistent PLY, STL, 3MF and Collada files. If the meaning of a file is clear, it is read
// completely; otherwise it is refused with a message.
#include "ModelFiles.h"

#include "base/Error.h"
#include "import/trusted/ImportModel.h"

#include <QDataStream>
#include <QtTest>

#include <array>
#include <cmath>
#include <vector>

using namespace dipwright;
using namespace dipwright::test;

namespace {

constexpr float edge = 9; // mm; all models here are the corner of a cube

const std::vector<Eigen::Vector3f> points{{0, 0, 0}, {edge, 0, 0}, {0, edge, 0}, {0, 0, edge}};
const std::vector<std::array<int, 3>> faces{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

QByteArray plyHeader(const QByteArray& format) {
    return "ply\nformat " + format +
           " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
           "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
}

QByteArray asciiPly() {
    return plyHeader("ascii") + "0 0 0\n9 0 0\n0 9 0\n0 0 9\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
}

QByteArray binaryFace(const std::array<int, 3>& corners) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream.setByteOrder(QDataStream::LittleEndian);
    stream << quint8(3);
    for (const int corner : corners) {
        stream << qint32(corner);
    }
    return bytes;
}

QByteArray binaryPly(const QByteArray& header = plyHeader("binary_little_endian")) {
    QByteArray bytes = header;
    QDataStream stream(&bytes, QIODevice::Append);
    stream.setByteOrder(QDataStream::LittleEndian);
    stream.setFloatingPointPrecision(QDataStream::SinglePrecision);
    for (const auto& point : points) {
        stream << point.x() << point.y() << point.z();
    }
    for (const auto& corners : faces) {
        bytes += binaryFace(corners);
    }
    return bytes;
}

QByteArray binaryStl(const QByteArray& title, quint32 count = 4) {
    QByteArray bytes = title.leftJustified(80, ' ');
    QDataStream stream(&bytes, QIODevice::Append);
    stream.setByteOrder(QDataStream::LittleEndian);
    stream.setFloatingPointPrecision(QDataStream::SinglePrecision);
    stream << count;
    for (const auto& corners : faces) {
        stream << 0.0F << 0.0F << 0.0F;
        for (const int corner : corners) {
            const auto& point = points[std::size_t(corner)];
            stream << point.x() << point.y() << point.z();
        }
        stream << quint16(0);
    }
    return bytes;
}

QByteArray asciiStl() {
    QByteArray text = "solid body\n";
    for (const auto& corners : faces) {
        text += "facet normal 0 0 0\n outer loop\n";
        for (const int corner : corners) {
            const auto& point = points[std::size_t(corner)];
            text += "  vertex";
            for (const float coordinate : point) {
                text += " " + QByteArray::number(double(coordinate), 'e', 3);
            }
            text += "\n";
        }
        text += " endloop\nendfacet\n";
    }
    return text + "endsolid body\n";
}

// Returns a 3MF object with these attributes; its first triangle has the attributes `ofTriangle`.
QByteArray object(const QByteArray& attributes = QByteArray(),
                  const QByteArray& ofTriangle = QByteArray()) {
    return R"(<object id="1" )" + attributes +
           R"(><mesh><vertices><vertex x="0" y="0" z="0"/>
<vertex x="9" y="0" z="0"/><vertex x="0" y="9" z="0"/><vertex x="0" y="0" z="9"/></vertices>
<triangles><triangle v1="0" v2="2" v3="1" )" +
           ofTriangle + R"(/><triangle v1="0" v2="1" v3="3"/>
<triangle v1="0" v2="3" v3="2"/><triangle v1="1" v2="2" v3="3"/></triangles></mesh></object>)";
}

QByteArray model(const QByteArray& resources, const QByteArray& ofItem = QByteArray(),
                 const QByteArray& attributes = QByteArray()) {
    return R"(<?xml version="1.0" encoding="UTF-8"?><model )" + attributes +
           R"( xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>)" +
           resources + R"(</resources><build><item objectid="1" )" + ofItem + "/></build></model>";
}

QByteArray transform(const QByteArray& numbers) {
    return "transform=\"" + numbers + "\"";
}

// Returns the attributes of a model that requires the extension with this name.
QByteArray needing(const QByteArray& nameSpace) {
    return "requiredextensions=\"q\" xmlns:q=\"http://schemas.microsoft.com/3dmanufacturing/" +
           nameSpace + "\"";
}

const char* const textureOf5 = R"(<texture2dgroup id="6" texid="5"><tex2coord u="0" v="0"/>
<tex2coord u="1" v="0"/><tex2coord u="0" v="1"/></texture2dgroup>)";
const char* const texture5 =
    R"(<texture2d id="5" path="/3D/Textures/a.png" contenttype="image/png"/>)";

} // namespace

class DamagedModelsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void ply_unusualButClear_isRead_data();
    void ply_unusualButClear_isRead();
    void ply_damaged_isRefused_data();
    void ply_damaged_isRefused();
    void stl_unusualButClear_isRead_data();
    void stl_unusualButClear_isRead();
    void stl_moreTrianglesThanDeclared_isRefused();
    void stl_textCutOff_isRefused();
    void threeMf_unusualButClear_isRead_data();
    void threeMf_unusualButClear_isRead();
    void threeMf_textureAfterItsUse_isRead();
    void threeMf_mixedColours_areALoss_data();
    void threeMf_mixedColours_areALoss();
    void threeMf_hiddenItem_isALoss();
    void threeMf_damaged_isRefused_data();
    void threeMf_damaged_isRefused();
    void collada_negativeIndex_isRefused_data();
    void collada_negativeIndex_isRefused();
    void collada_negativeJoint_isRead();

private:
    QString at(const QString& name) const { return folder_.filePath(name); }
    QString write(const QString& name, const QByteArray& bytes) const {
        writeFile(at(name), bytes);
        return at(name);
    }
    QString writePackage(const QByteArray& modelXml) const {
        write3mf(at(QStringLiteral("a.3mf")),
                 {{QStringLiteral("3D/Textures/a.png"), png(quarters())},
                  {QStringLiteral("3D/3dmodel.model"), modelXml}});
        return at(QStringLiteral("a.3mf"));
    }
    static void verifyIsCorner(const QString& path, const Eigen::Vector3f& size);
    static void verifyIsRefused(const QString& path, const QString& says);

    QTemporaryDir folder_;
};

// Verifies that the file is read as a whole corner of a cube at the origin.
void DamagedModelsTest::verifyIsCorner(const QString& path, const Eigen::Vector3f& size) {
    try {
        const ImportReport report = importModel(path, ImportOptions(), Progress()).report;
        QCOMPARE(report.triangles, faces.size());
        QVERIFY(report.closed);
        QVERIFY(report.box.min().isZero());
        QVERIFY(report.box.max().isApprox(size));
        QVERIFY(std::abs(report.volume / double(size.prod() / 6) - 1) < 1e-4);
    } catch (const Error& error) {
        QFAIL(qPrintable(error.sentence()));
    }
}

void DamagedModelsTest::verifyIsRefused(const QString& path, const QString& says) {
    try {
        importModel(path, ImportOptions(), Progress());
        QFAIL("the file is read, expected a refusal");
    } catch (const Error& error) {
        QVERIFY2(error.sentence().contains(QStringLiteral("cannot be read")) &&
                     error.sentence().contains(says),
                 qPrintable(error.sentence()));
    }
}

void DamagedModelsTest::ply_unusualButClear_isRead_data() {
    QTest::addColumn<QByteArray>("bytes");
    const QByteArray binaryHeader = plyHeader("binary_little_endian");
    QTest::newRow("LF") << asciiPly();
    QTest::newRow("CR and LF") << asciiPly().replace("\n", "\r\n");
    QTest::newRow("CR") << asciiPly().replace("\n", "\r");
    QTest::newRow("last line without a line end") << asciiPly().chopped(1);
    QTest::newRow("empty lines after the last row") << asciiPly() + " \n\n\t\r\n";
    QTest::newRow("byte order mark") << "\xef\xbb\xbf" + asciiPly();
    QTest::newRow("corners as whole decimals") << asciiPly().replace("3 0 2 1", "3 0.0 2e0 1.0");
    QTest::newRow("binary") << binaryPly();
    QTest::newRow("binary, header with CR and LF")
        << binaryPly(QByteArray(binaryHeader).replace("\n", "\r\n"));
    QTest::newRow("binary, header with CR")
        << binaryPly(QByteArray(binaryHeader).replace("\n", "\r"));
    QTest::newRow("binary, line end after the last row") << binaryPly() + "\r\n";
    QTest::newRow("DOS end-of-file mark and a zero after the last row")
        << asciiPly() + QByteArray("\x1a\0", 2);
    QTest::newRow("binary, zeros after the last row") << binaryPly() + QByteArray(4, '\0');
    QTest::newRow("binary, zeros with the length of two faces after the last row")
        << binaryPly() + QByteArray(2 * binaryFace({0, 1, 2}).size(), '\0');
}

void DamagedModelsTest::ply_unusualButClear_isRead() {
    QFETCH(QByteArray, bytes);
    verifyIsCorner(write(QStringLiteral("clear.ply"), bytes), {edge, edge, edge});
}

void DamagedModelsTest::ply_damaged_isRefused_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, const QByteArray& bytes, const char* says) {
        QTest::newRow(name) << bytes << QString::fromLatin1(says);
    };
    const char* const more = "more data than its header declares";
    const char* const header = "header is not understood";
    const QByteArray points = "element vertex 1\nproperty float x\nproperty float y\n"
                              "property float z\n";
    const QByteArray others = "element vertex 3\nproperty float x\nproperty float y\n"
                              "property float z\nproperty float s\nproperty float t\n";
    row("two lists of points",
        "ply\nformat ascii 1.0\n" + points + others +
            "element face 4\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n"
            "9 0 0 1 1\n0 9 0 1 1\n0 0 9 1 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n",
        header);
    row("a number of points that is a word", asciiPly().replace("vertex 4", "vertex four"), header);
    row("a negative number of points", asciiPly().replace("vertex 4", "vertex -4"), header);
    row("header declares too few faces", asciiPly().replace("face 4", "face 3"), more);
    row("header declares too many points", asciiPly().replace("vertex 4", "vertex 5"), more);
    row("a word after the last row", asciiPly() + "end\n", more);
    row("binary, header declares too few faces", binaryPly() + binaryFace({0, 1, 2}), more);
    row("a corner that is no whole number", asciiPly().replace("3 0 2 1", "3 0.7 2 1"),
        "a point that does not exist");
    row("a number of corners that is no whole number", asciiPly().replace("3 0 2 1", "3.5 0 2 1"),
        "length of a list is not a whole number");
}

void DamagedModelsTest::ply_damaged_isRefused() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, says);
    verifyIsRefused(write(QStringLiteral("damaged.ply"), bytes), says);
}

void DamagedModelsTest::stl_unusualButClear_isRead_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("ASCII") << asciiStl();
    QTest::newRow("ASCII in capitals") << asciiStl().toUpper();
    QTest::newRow("ASCII, some words in capitals")
        << asciiStl().replace("facet", "FACET").replace("vertex", "VERTEX");
    QTest::newRow("ASCII, capital initials") << asciiStl()
                                                    .replace("solid", "Solid")
                                                    .replace("facet", "Facet")
                                                    .replace("vertex", "Vertex");
    QTest::newRow("ASCII, comment and zeros after the end")
        << asciiStl() + "; made by a test\n" + QByteArray(512, '\0');
    QTest::newRow("binary") << binaryStl("made by a test");
    QTest::newRow("binary that begins like ASCII") << binaryStl("solid body");
    QTest::newRow("binary that begins like ASCII in capitals") << binaryStl("SOLID FACET");
    QTest::newRow("binary, line end after the last triangle")
        << binaryStl("made by a test") + "\r\n";
    QTest::newRow("binary that begins like ASCII, zeros after the last triangle")
        << binaryStl("solid body") + QByteArray(60, '\0');
    QTest::newRow("binary, zeros with the length of a triangle")
        << binaryStl("made by a test") + QByteArray(50, '\0');
}

void DamagedModelsTest::stl_unusualButClear_isRead() {
    QFETCH(QByteArray, bytes);
    verifyIsCorner(write(QStringLiteral("clear.stl"), bytes), {edge, edge, edge});
}

void DamagedModelsTest::stl_moreTrianglesThanDeclared_isRefused() {
    for (const quint32 count : {0, 3}) {
        verifyIsRefused(write(QStringLiteral("few.stl"), binaryStl("made by a test", count)),
                        QStringLiteral("more data than its header declares"));
    }
}

void DamagedModelsTest::stl_textCutOff_isRefused() {
    const QByteArray whole = asciiStl();
    for (const qsizetype length : {whole.lastIndexOf("facet"), whole.indexOf("endsolid")}) {
        verifyIsRefused(write(QStringLiteral("cut.stl"), whole.first(length)),
                        QStringLiteral("ends too early"));
    }
}

void DamagedModelsTest::threeMf_unusualButClear_isRead_data() {
    QTest::addColumn<QByteArray>("xml");
    QTest::addColumn<float>("scale");
    const QByteArray colours = R"(<basematerials id="7"><base name="a" displaycolor="#FF0000"/>
</basematerials>)";
    QTest::newRow("no unit") << model(object()) << 1.0F;
    QTest::newRow("inches") << model(object(), QByteArray(), R"(unit="inch")") << 25.4F;
    QTest::newRow("a transform over several lines")
        << model(object(), transform("2 0  0&#10;0 2 0&#13;&#10;0 0 2&#9;0 0 0 ")) << 2.0F;
    QTest::newRow("a material after the object that uses it")
        << model(object(R"(pid="7" pindex="0")") + colours) << 1.0F;
    QTest::newRow("a material with the same ID as the object")
        << model(QByteArray(colours).replace("7", "1") + object(R"(pid="1" pindex="0")")) << 1.0F;
    QTest::newRow("a property group of a kind that is not read")
        << model(R"(<multiproperties id="8" pids="7"/>)" + object(R"(pid="8" pindex="0")")) << 1.0F;
    for (const char* known :
         {"core/2015/02", "material/2015/02", "production/2015/06", "trianglesets/2021/07"}) {
        QTest::newRow(known) << model(object(), QByteArray(), needing(known)) << 1.0F;
    }
    QTest::newRow("an extension that is not required")
        << model(object(), QByteArray(), R"(xmlns:q="a")") << 1.0F;
}

void DamagedModelsTest::threeMf_unusualButClear_isRead() {
    QFETCH(QByteArray, xml);
    QFETCH(float, scale);
    verifyIsCorner(writePackage(xml), Eigen::Vector3f::Constant(edge * scale));
}

void DamagedModelsTest::threeMf_textureAfterItsUse_isRead() {
    const QByteArray shown = object(QByteArray(), R"(pid="6" p1="0" p2="1" p3="2")");
    const QString path = writePackage(model(shown + textureOf5 + texture5));
    const TexturedMesh mesh = importModel(path, ImportOptions(), Progress()).model;
    QCOMPARE(mesh.textures.size(), std::size_t(1));
    QCOMPARE(mesh.textures[0], quarters());
}

void DamagedModelsTest::threeMf_mixedColours_areALoss_data() {
    QTest::addColumn<QByteArray>("resources");
    QTest::addColumn<QByteArray>("triangle"); // its attributes
    QTest::addColumn<bool>("isLoss");
    const QByteArray colours = R"(<colorgroup id="3"><color color="#FF0000"/>)"
                               R"(<color color="#0000FF"/><color color="#FF0000"/></colorgroup>)";
    const QByteArray mixed = R"(<basematerials id="4"><base name="a" displaycolor="#FF0000"/>)"
                             R"(</basematerials><compositematerials id="5" matid="4" )"
                             R"(matindices="0"><composite values="1"/></compositematerials>)"
                             R"(<multiproperties id="6" pids="4 3"><multi pindices="0 1"/>)"
                             R"(</multiproperties>)";
    const auto row = [](const char* name, const QByteArray& resources, const char* triangle,
                        bool isLoss) {
        QTest::newRow(name) << resources << QByteArray(triangle) << isLoss;
    };
    row("one colour", colours, R"(pid="3" p1="1")", false);
    row("equal colours", colours, R"(pid="3" p1="0" p2="2" p3="0")", false);
    row("a gradient", colours, R"(pid="3" p1="0" p2="1" p3="0")", true);
    row("a composite", colours + mixed, R"(pid="5" p1="0")", true);
    row("multiproperties", colours + mixed, R"(pid="6" p1="0")", true);
    row("a texture", QByteArray(textureOf5) + texture5, R"(pid="6" p1="0" p2="1" p3="2")", false);
}

void DamagedModelsTest::threeMf_mixedColours_areALoss() {
    QFETCH(QByteArray, resources);
    QFETCH(QByteArray, triangle);
    QFETCH(bool, isLoss);
    const QString path = writePackage(model(resources + object(QByteArray(), triangle)));
    const QStringList losses = importModel(path, ImportOptions(), Progress()).report.losses;
    QCOMPARE(losses.size(), isLoss ? 1 : 0);
    QVERIFY(!isLoss || losses[0].contains(QStringLiteral("mixes colours")));
}

void DamagedModelsTest::threeMf_hiddenItem_isALoss() {
    const QString path = writePackage(model(object(), "printable=\"0\""));
    const QStringList losses = importModel(path, ImportOptions(), Progress()).report.losses;
    QCOMPARE(losses.size(), 1);
    QVERIFY(losses[0].startsWith(QStringLiteral("Hidden objects: 1, first 1.")));
}

void DamagedModelsTest::threeMf_damaged_isRefused_data() {
    QTest::addColumn<QByteArray>("xml");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, const QByteArray& xml, const char* says) {
        QTest::newRow(name) << xml << QString::fromLatin1(says);
    };
    const auto moved = [](const QByteArray& numbers) {
        return model(object(), transform(numbers));
    };
    const char* const notTwelve = "not have twelve numbers";
    const char* const notThere = "material or texture that does not exist";
    row("a word in a transform", moved("1 0 0 0 x 0 0 0 1 0 0 0"), notTwelve);
    row("an infinite transform", moved("1 0 0 0 inf 0 0 0 1 0 0 0"), notTwelve);
    row("a transform of eleven numbers", moved("2 0 0 0 1 0 0 0 1 0 0"), notTwelve);
    row("a transform of thirteen numbers", moved("2 0 0 0 1 0 0 0 1 0 0 0 0"), notTwelve);
    row("a transform without numbers", moved(""), notTwelve);
    row("a transform with commas", moved("2,0,0,0,1,0,0,0,1,0,0,0"), notTwelve);
    row("a transform with a no-break space", moved("2 0 0 0 1 0 0 0 1 0 0&#160;0"), notTwelve);
    row("two objects with one ID", model(object() + object()), "ID 1");
    row("an object's material does not exist", model(object(R"(pid="77" pindex="0")")), notThere);
    row("a triangle's material does not exist", model(object("", R"(pid="77" p1="0")")), notThere);
    row("a material ID that is no number", model(object(R"(pid="a" pindex="0")")), "no number");
    row("a texture that does not exist", model(textureOf5 + object()), notThere);
    row("a texture instead of its coordinates", model(texture5 + object(R"(pid="5" pindex="0")")),
        notThere);
    row("an unknown unit", model(object(), "", R"(unit="parsec")"), "parsec");
    row("an unknown extension", model(object(), "", needing("beamlattice/2017/02")), "beamlattice");
    row("an extension without a namespace", model(object(), "", R"(requiredextensions="q")"),
        "extension q");
}

void DamagedModelsTest::threeMf_damaged_isRefused() {
    QFETCH(QByteArray, xml);
    QFETCH(QString, says);
    verifyIsRefused(writePackage(xml), says);
}

void DamagedModelsTest::collada_negativeIndex_isRefused_data() {
    QTest::addColumn<QByteArray>("list");
    QTest::newRow("corners") << QByteArray("<p>");
    QTest::newRow("corners of a polygon") << QByteArray("<vcount>");
}

void DamagedModelsTest::collada_negativeIndex_isRefused() {
    QFETCH(QByteArray, list);
    QByteArray bytes = tetrahedron("collada");
    QVERIFY(bytes.contains(list));
    verifyIsRefused(write(QStringLiteral("negative.dae"), bytes.replace(list, list + "-1 ")),
                    QStringLiteral("no number"));
}

// A weight that moves nothing names the joint −1.
void DamagedModelsTest::collada_negativeJoint_isRead() {
    const QByteArray weights = "<extra><technique profile=\"a\"><v>-1 0</v></technique></extra>";
    QByteArray bytes = tetrahedron("collada");
    QVERIFY(bytes.contains("</COLLADA>"));
    bytes.replace("</COLLADA>", weights + "</COLLADA>");
    verifyIsCorner(write(QStringLiteral("joints.dae"), bytes), {10000, 10000, 10000});
}

QTEST_GUILESS_MAIN(DamagedModelsTest)
#include "DamagedModelsTest.moc"
