#include "HostileFiles.h"

#include "TestFiles.h"

#include <QDir>
#include <QtEndian>

#include <quazip.h>
#include <quazipfile.h>

#include <cmath>

namespace dipwright::test {
namespace {

QByteArray repeated(const QByteArray& text, int times) {
    return text.repeated(times);
}

// Joins made(i) for i = 0 … count − 1.
template <typename Made>
QByteArray sequence(int count, const Made& made) {
    QByteArray text;
    for (int i = 0; i < count; ++i) {
        text += made(i);
    }
    return text;
}

QByteArray number(int value) {
    return QByteArray::number(value);
}

template <typename Number>
QByteArray littleEndian(Number value) {
    QByteArray bytes(sizeof value, '\0');
    qToLittleEndian(value, bytes.data());
    return bytes;
}

void writeZip(const QString& path, const std::vector<std::pair<QString, QByteArray>>& files) {
    QuaZip zip(path);
    zip.open(QuaZip::mdCreate);
    for (const auto& [name, bytes] : files) {
        QuaZipFile file(&zip);
        file.open(QIODevice::WriteOnly, QuaZipNewInfo(name));
        file.write(bytes);
    }
}

QByteArray star(int corners) {
    return sequence(corners, [&](int i) {
        const double angle = 2 * M_PI * i / corners, radius = i % 2 == 0 ? 10 : 9;
        return QStringLiteral("v %1 %2 0\n")
            .arg(radius * std::cos(angle))
            .arg(radius * std::sin(angle))
            .toUtf8();
    });
}

QByteArray face(int corners) {
    return "f" + sequence(corners, [](int i) { return ' ' + number(i + 1); }) + "\n";
}

void writeObj(const QDir& folder) {
    const QByteArray triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    writeFile(folder.filePath("corners.obj"), star(60'000) + face(60'000));
#if defined(DIPWRIGHT_SANITIZED)
    constexpr int stars = 600; // reading is allowed three times as long
#else
    constexpr int stars = 120;
#endif
    writeFile(folder.filePath("stars.obj"), star(4000) + repeated(face(4000), stars));
    writeFile(folder.filePath("materials.obj"), triangle + sequence(70'000, [](int i) {
                                                    return "usemtl m" + number(i) + "\nf 1 2 3\n";
                                                }));
    writeFile(folder.filePath("long.obj"), "v " + repeated("1", 20'000'000));
    writeFile(folder.filePath("slashes.obj"), triangle + "f " + repeated("1/", 1'000'000));
    writeFile(folder.filePath("early.mtl"), "map_Kd t.png\n");
    writeFile(folder.filePath("early.obj"), "mtllib early.mtl\n" + triangle + "f 1 2 3\n");
    writeFile(folder.filePath("line.obj"), "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0.5 0 0\n"
                                           "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    writeFile(folder.filePath("far.obj"), "v 500000 4200000 100\nv 500001 4200000 100\n"
                                          "v 500000 4200001 100\nf 1 2 3\n");
    writeFile(folder.filePath("\x1b[31mred.obj"), "nothing");
}

void writeGltf(const QDir& folder) {
    const QByteArray head = R"({"asset":{"version":"2.0"},)";
    const QByteArray scene = R"("scene":0,"scenes":[{"nodes":[0]}],)";
    writeFile(folder.filePath("deep.gltf"), head + "\"x\":" + repeated("[", 200'000));
    writeFile(folder.filePath("nodes.gltf"),
              head + scene + "\"nodes\":[" + sequence(20'000, [](int i) {
                  return "{\"children\":[" + number(i + 1) + "]},";
              }) + "{}]}");
    writeFile(folder.filePath("cycle.gltf"), head + scene + R"("nodes":[{"children":[0]}]})");
    writeFile(folder.filePath("fan.gltf"),
              head + scene + "\"nodes\":[" + sequence(30, [](int i) {
                  return "{\"children\":[" + (number(i + 1) + ',').repeated(10).chopped(1) + "]},";
              }) + "{}]}");
    writeFile(folder.filePath("sparse.gltf"),
              head + scene +
                  R"("accessors":[{"componentType":5126,"count":400000000,"type":"VEC3"}],)"
                  R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
                  R"("nodes":[{"mesh":0}]})");
    writeFile(folder.filePath("buffer.gltf"),
              head + scene +
                  R"("buffers":[{"byteLength":36,"uri":"../../../../etc/passwd"}],)"
                  R"("bufferViews":[{"buffer":0,"byteLength":36}],)"
                  R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,)"
                  R"("type":"VEC3"}],"meshes":[{"primitives":[{"attributes":)"
                  R"({"POSITION":0}}]}],"nodes":[{"mesh":0}]})");
}

void writeXml(const QDir& folder) {
    const QByteArray head = R"(<?xml version="1.0"?>)";
    const QByteArray collada =
        R"(<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset/>)";
    writeFile(folder.filePath("laughs.dae"),
              head + "<!DOCTYPE COLLADA [<!ENTITY a0 \"aaaaaaaaaa\">" +
                  sequence(9,
                           [](int i) {
                               return "<!ENTITY a" + number(i + 1) + " \"" +
                                      ("&a" + number(i) + ";").repeated(10) + "\">";
                           }) +
                  "]>" + "<COLLADA>&a9;</COLLADA>");
    writeFile(folder.filePath("entity.dae"),
              head + R"(<!DOCTYPE COLLADA [<!ENTITY a SYSTEM "file:///etc/passwd">]>)"
                     R"(<COLLADA version="1.4.1">&a;</COLLADA>)");
    writeFile(folder.filePath("itself.dae"),
              head + collada +
                  R"(<library_nodes><node id="a"><instance_node url="#a"/></node></library_nodes>)"
                  R"(<library_visual_scenes><visual_scene id="s"><node id="b">)"
                  R"(<instance_node url="#a"/></node></visual_scene></library_visual_scenes>)"
                  R"(<scene><instance_visual_scene url="#s"/></scene></COLLADA>)");
    writeFile(folder.filePath("deep.dae"),
              head + collada + R"(<library_visual_scenes><visual_scene id="s">)" +
                  repeated("<node>", 50'000) + repeated("</node>", 50'000) +
                  R"(</visual_scene></library_visual_scenes>)"
                  R"(<scene><instance_visual_scene url="#s"/></scene></COLLADA>)");
    const QByteArray package = head + R"(<model unit="millimeter"><resources>)";
    const auto writeModel = [&](const char* name, const QByteArray& content) {
        writeZip(folder.filePath(name), {{"3D/3dmodel.model", package + content}});
    };
    writeModel("spaces.3mf", repeated(" ", 400 << 20));
    writeModel("objects.3mf",
               sequence(400'000, [](int i) { return "<object id=\"" + number(i) + "\"/>"; }));
    writeModel("doubling.3mf",
               R"(<object id="1"><mesh><vertices><vertex x="0" y="0" z="0"/>)"
               R"(<vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/></vertices><triangles>)"
               R"(<triangle v1="0" v2="1" v3="2"/></triangles></mesh></object>)" +
                   sequence(50,
                            [](int i) {
                                const QByteArray one =
                                    "<component objectid=\"" + number(i + 1) + "\"/>";
                                return "<object id=\"" + number(i + 2) + "\"><components>" + one +
                                       one + "</components></object>";
                            }) +
                   R"(</resources><build><item objectid="51"/></build></model>)");
}

void writeOthers(const QDir& folder) {
    writeFile(folder.filePath("count.stl"),
              QByteArray(80, 'x') + littleEndian(0xffffffffu) + QByteArray(500, '\0'));
    writeFile(folder.filePath("count.ply"),
              "ply\nformat ascii 1.0\nelement vertex 999999999999\nproperty float x\n"
              "property float y\nproperty float z\nend_header\n0 0 0\n");
    writeFile(folder.filePath("list.ply"), "ply\nformat binary_little_endian 1.0\nelement face 1\n"
                                           "property list uint uchar vertex_indices\nend_header\n" +
                                               littleEndian(20'000'000u) +
                                               QByteArray(20'000'000, '\0'));
    writeFile(
        folder.filePath("pictures.ply"),
        "ply\nformat ascii 1.0\n" +
            sequence(60'000, [](int i) { return "comment TextureFile t" + number(i) + ".png\n"; }) +
            "element vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 0\nproperty list uchar int vertex_indices\nend_header\n");
    writeFile(folder.filePath("chunks.3ds"), sequence(100'000, [](int i) {
                  return littleEndian(quint16(i == 0 ? 0x4d4d : 0x3d3d)) +
                         littleEndian(quint32(600'000 - 6 * i));
              }));
    writeFile(folder.filePath("deep.fbx"),
              "; FBX 7.4.0 project file\n" + repeated("A: {\n", 200'000));
    writeFile(folder.filePath("a.off"), "OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0\n");
    writeFile(folder.filePath("a.md5mesh"), "MD5Version 10\nnumJoints 1\njoints {\n}\n");
    writeFile(folder.filePath("deep.dipw"), QByteArray());
    writeZip(folder.filePath("deep.dipw"), {{"project.json", repeated("[", 1'000'000)}});
    writeZip(
        folder.filePath("levels.dipw"),
        {{"project.json",
          "{\"zz\":[" + repeated(repeated("[", 900) + repeated("]", 900) + ",", 300) + "0]}"}});
    writeZip(folder.filePath("values.dipw"),
             {{"project.json", "{\"zz\":[" + repeated("[0],", 4'000'000) + "0]}"}});
    std::vector<std::pair<QString, QByteArray>> entries{{"project.json", "{}"}};
    for (int i = 0; i < 500; ++i) {
        entries.emplace_back(QStringLiteral("x/%1").arg(i), QByteArray(1 << 20, '\0'));
    }
    writeZip(folder.filePath("entries.dipw"), entries);
}

} // namespace

void writeHostileFiles(const QString& folder) {
    const QDir place(folder);
    writeObj(place);
    writeGltf(place);
    writeXml(place);
    writeOthers(place);
}

} // namespace dipwright::test
