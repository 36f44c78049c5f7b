#include "ModelFiles.h"

#include <QBuffer>
#include <QDataStream>
#include <QPainter>
#include <QtEndian>

#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <quazip.h>
#include <quazipfile.h>

#include <bit>
#include <cmath>
#include <stdexcept>

namespace dipwright::test {

namespace {

QByteArray squareBuffer() {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream.setByteOrder(QDataStream::LittleEndian);
    stream.setFloatingPointPrecision(QDataStream::SinglePrecision);
    for (const float coordinate : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) {
        stream << coordinate;
    }
    for (const float coordinate : {0, 1, 1, 1, 1, 0, 0, 0}) { // glTF's v points down
        stream << coordinate;
    }
    for (const quint16 corner : {0, 1, 2, 0, 2, 3}) {
        stream << corner;
    }
    return bytes;
}

QByteArray gltfJson(const QByteArray& buffers, const QByteArray& image, qsizetype imageBytes) {
    QByteArray views = R"({"buffer":0,"byteOffset":0,"byteLength":48},
        {"buffer":0,"byteOffset":48,"byteLength":32},{"buffer":0,"byteOffset":80,"byteLength":12})";
    if (imageBytes > 0) {
        views +=
            R"(,{"buffer":0,"byteOffset":92,"byteLength":)" + QByteArray::number(imageBytes) + "}";
    }
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
        "nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},
        "indices":2,"material":0}]}],
        "materials":[{"name":"paint","pbrMetallicRoughness":{"baseColorFactor":[0.5,0.5,0.5,1],
        "baseColorTexture":{"index":0}}}],
        "textures":[{"source":0}],"images":[)" +
           image + R"(],"accessors":[
        {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
        {"bufferView":1,"componentType":5126,"count":4,"type":"VEC2"},
        {"bufferView":2,"componentType":5123,"count":6,"type":"SCALAR"}],
        "bufferViews":[)" +
           views + R"(],"buffers":[)" + buffers + "]}";
}

void addEntry(QuaZip& zip, const QString& name, const QByteArray& bytes) {
    QuaZipFile entry(&zip);
    if (!entry.open(QIODevice::WriteOnly, QuaZipNewInfo(name)) ||
        entry.write(bytes) != bytes.size()) {
        throw std::runtime_error("cannot write a zip entry");
    }
}

template <typename Number>
void appendNumber(QByteArray& bytes, Number number) {
    number = qToLittleEndian(number);
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

// Returns a model in another format, as assimp writes it.
QByteArray converted(const QByteArray& model, const char* from, const char* to) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(model.constData(), std::size_t(model.size()),
                                                       aiProcess_Triangulate, from);
    Assimp::Exporter exporter;
    const aiExportDataBlob* blob = scene ? exporter.ExportToBlob(scene, to) : nullptr;
    if (!blob) {
        throw std::runtime_error("assimp cannot write a test model");
    }
    return {static_cast<const char*>(blob->data), qsizetype(blob->size)};
}

// A node of a binary FBX file of version 7.4.
struct FbxNode {
    explicit FbxNode(const QByteArray& called) : name(called) {}

    QByteArray name;
    QByteArray properties;
    quint32 propertyCount = 0;
    std::vector<FbxNode> children;

    FbxNode& add(qint32 number) {
        properties += 'I';
        appendNumber(properties, number);
        ++propertyCount;
        return *this;
    }
    FbxNode& add(double number) {
        properties += 'D';
        appendNumber(properties, std::bit_cast<quint64>(number));
        ++propertyCount;
        return *this;
    }
    FbxNode& add(qint64 number) {
        properties += 'L';
        appendNumber(properties, number);
        ++propertyCount;
        return *this;
    }
    FbxNode& add(const QByteArray& text) {
        properties += 'S';
        appendNumber(properties, quint32(text.size()));
        properties += text;
        ++propertyCount;
        return *this;
    }
    template <typename Number>
    void add(char type, const std::vector<Number>& numbers) {
        properties += type;
        for (const std::size_t value :
             {numbers.size(), std::size_t(0), sizeof(Number) * numbers.size()}) {
            appendNumber(properties, quint32(value));
        }
        for (const Number number : numbers) {
            appendNumber(properties, number);
        }
        ++propertyCount;
    }
    void writeTo(QByteArray& file) const {
        QByteArray node = name + properties;
        const qsizetype begin = file.size();
        file.append(4, '\0'); // replaced below by the position of the node's end
        appendNumber(file, propertyCount);
        appendNumber(file, quint32(properties.size()));
        file += char(name.size());
        file += node;
        for (const FbxNode& child : children) {
            child.writeTo(file);
        }
        if (!children.empty()) {
            file.append(13, '\0');
        }
        const quint32 end = qToLittleEndian(quint32(file.size()));
        file.replace(begin, 4, reinterpret_cast<const char*>(&end), 4);
    }
};

} // namespace

QImage quarters(int side) {
    QImage image(side, side, QImage::Format_RGBA8888);
    image.fill(Qt::white);
    QPainter painter(&image);
    const int half = side / 2;
    painter.fillRect(0, 0, half, half, Qt::red);
    painter.fillRect(half, 0, half, half, Qt::green);
    painter.fillRect(0, half, half, half, Qt::blue);
    painter.fillRect(half, half, half, half, Qt::white);
    return image;
}

QByteArray png(const QImage& image) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

QByteArray cubeObj(const QByteArray& head) {
    return "# a cube\n" + head + R"(
v -5 -5 -5
v 5 -5 -5
v -5 5 -5
v 5 5 -5
v -5 -5 5
v 5 -5 5
v -5 5 5
v 5 5 5
vt 0 0
vt 1 0
vt 1 1
vt 0 1
f 5/1 6/2 8/3 7/4
f 6/1 2/2 4/3 8/4
f 2/1 1/2 3/3 4/4
f 1/1 5/2 7/3 3/4
f 7/1 8/2 4/3 3/4
f 1/1 2/2 6/3 5/4
)";
}

QByteArray squareGltf(const QByteArray& pngBytes) {
    const QByteArray buffer = squareBuffer();
    return gltfJson(R"({"byteLength":)" + QByteArray::number(buffer.size()) +
                        R"(,"uri":"data:application/octet-stream;base64,)" + buffer.toBase64() +
                        R"("})",
                    R"({"uri":"data:image/png;base64,)" + pngBytes.toBase64() + R"("})", 0);
}

QByteArray skinnedGltf(const TestSkin& skin) {
    QByteArray bytes = squareBuffer().left(48) + squareBuffer().mid(80) + QByteArray(4, '\0');
    for (int point = 0; point < 4; ++point) {
        bytes += QByteArray("\0\1\0\0", 4); // joints
    }
    for (int point = 0; point < 4; ++point) {
        for (const float weight : {skin.weights[0], skin.weights[1], 0.0F, 0.0F}) {
            if (skin.weightType == 5121) {
                appendNumber(bytes, quint8(std::lround(255 * weight)));
            } else if (skin.weightType == 5123) {
                appendNumber(bytes, quint16(std::lround(65535 * weight)));
            } else {
                appendNumber(bytes, weight);
            }
        }
    }
    bytes += QByteArray(144 - bytes.size(), '\0');
    for (int entry = 0; entry < 32; ++entry) { // bind matrices
        const float scale = skin.bindScale.value_or(1);
        appendNumber(bytes, entry % 16 == 15 ? 1.0F : entry % 5 == entry / 16 ? scale : 0.0F);
    }
    const QByteArray weights = R"("componentType":)" + QByteArray::number(skin.weightType) +
                               (skin.weightType == 5126 ? "" : R"(,"normalized":true)");
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":)" + skin.scene +
           R"(}],"nodes":)" + skin.nodes +
           R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3},
        "indices":1}]}],"skins":[{"joints":[1,2])" +
           (skin.bindScale ? R"(,"inverseBindMatrices":4)" : "") + R"(}],"accessors":[
        {"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
        {"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"},
        {"bufferView":2,"componentType":5121,"count":4,"type":"VEC4"},
        {"bufferView":3,)" +
           weights + R"(,"count":4,"type":"VEC4"},
        {"bufferView":4,"componentType":5126,"count":2,"type":"MAT4"}],"bufferViews":[
        {"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12},
        {"buffer":0,"byteOffset":64,"byteLength":16},{"buffer":0,"byteOffset":80,"byteLength":64},
        {"buffer":0,"byteOffset":144,"byteLength":128}],"buffers":[{"byteLength":272,
        "uri":"data:application/octet-stream;base64,)" +
           bytes.toBase64() + R"("}]})";
}

QByteArray squareGlb(const QByteArray& pngBytes) {
    QByteArray binary = squareBuffer() + pngBytes;
    binary.append((4 - binary.size() % 4) % 4, '\0');
    QByteArray json = gltfJson(R"({"byteLength":)" + QByteArray::number(binary.size()) + "}",
                               R"({"bufferView":3,"mimeType":"image/png"})", pngBytes.size());
    json.append((4 - json.size() % 4) % 4, ' ');
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream.setByteOrder(QDataStream::LittleEndian);
    stream.writeRawData("glTF", 4);
    stream << quint32(2) << quint32(12 + 8 + json.size() + 8 + binary.size());
    stream << quint32(json.size());
    stream.writeRawData("JSON", 4);
    stream.writeRawData(json.constData(), int(json.size()));
    stream << quint32(binary.size());
    stream.writeRawData("BIN\0", 4);
    stream.writeRawData(binary.constData(), int(binary.size()));
    return bytes;
}

void write3mf(const QString& path, const std::vector<std::pair<QString, QByteArray>>& files) {
    QuaZip zip(path);
    if (!zip.open(QuaZip::mdCreate)) {
        throw std::runtime_error("cannot write a zip");
    }
    for (const auto& [name, bytes] : files) {
        addEntry(zip, name, bytes);
    }
    zip.close();
    if (zip.getZipError() != 0) {
        throw std::runtime_error("cannot close a zip");
    }
}

void writeSquare3mf(const QString& path, const QByteArray& pngBytes) {
    write3mf(
        path,
        {{QStringLiteral("[Content_Types].xml"), R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
<Default Extension="png" ContentType="image/png"/>
</Types>)"},
         {QStringLiteral("_rels/.rels"), R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0"
 Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>)"},
         {QStringLiteral("3D/_rels/3dmodel.model.rels"), R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/Textures/picture.png" Id="rel1"
 Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dtexture"/>
</Relationships>)"},
         {QStringLiteral("3D/Textures/picture.png"), pngBytes},
         {QStringLiteral("3D/3dmodel.model"), R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US"
 xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
 xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02">
<resources>
<m:texture2d id="1" path="/3D/Textures/picture.png" contenttype="image/png"/>
<m:texture2dgroup id="2" texid="1">
<m:tex2coord u="1" v="1"/><m:tex2coord u="0" v="1"/>
<m:tex2coord u="0" v="0"/><m:tex2coord u="1" v="0"/>
</m:texture2dgroup>
<object id="3" type="model"><mesh>
<vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>
<vertex x="1" y="1" z="0"/><vertex x="0" y="1" z="0"/></vertices>
<triangles><triangle v1="0" v2="1" v3="2" pid="2" p1="2" p2="3" p3="0"/>
<triangle v1="0" v2="2" v3="3" pid="2" p1="2" p2="0" p3="1"/></triangles>
</mesh></object>
</resources>
<build><item objectid="3"/></build>
</model>)"}});
}

QByteArray squarePly(const QByteArray& pictureFile) {
    return "ply\nformat ascii 1.0\ncomment TextureFile " + pictureFile + R"(
element vertex 4
property float x
property float y
property float z
property float s
property float t
element face 2
property list uchar int vertex_indices
end_header
0 0 0 0 0
1 0 0 1 0
1 1 0 1 1
0 1 0 0 1
3 0 1 2
3 0 2 3
)";
}

QByteArray squareBinaryPly(const QByteArray& pictureFile, bool littleEndian) {
    QByteArray bytes = QByteArray("ply\nformat binary_") + (littleEndian ? "little" : "big") +
                       "_endian 1.0\ncomment TextureFile " + pictureFile +
                       "\nelement vertex 4\nproperty double x\nproperty float y\n"
                       "property float z\nproperty uchar quality\nelement face 1\n"
                       "property list uchar int vertex_indices\n"
                       "property list uchar float texcoord\nelement edge 1\n"
                       "property int vertex1\nend_header\n";
    QDataStream stream(&bytes, QIODevice::Append);
    stream.setByteOrder(littleEndian ? QDataStream::LittleEndian : QDataStream::BigEndian);
    const std::pair<int, int> corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const auto writeFloat = [&](int value) {
        stream.setFloatingPointPrecision(QDataStream::SinglePrecision);
        stream << float(value);
    };
    for (const auto& [x, y] : corners) {
        stream.setFloatingPointPrecision(QDataStream::DoublePrecision);
        stream << double(x);
        writeFloat(y);
        writeFloat(0);
        stream << quint8(7);
    }
    stream << quint8(4) << qint32(0) << qint32(1) << qint32(2) << qint32(3) << quint8(8);
    for (const auto& [x, y] : corners) {
        writeFloat(x);
        writeFloat(y);
    }
    stream << qint32(0);
    return bytes;
}

QByteArray squareCollada() {
    return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="metre" meter="1"/><up_axis>Y_UP</up_axis></asset>
<library_images><image id="picture"><init_from>skin.png</init_from></image></library_images>
<library_effects><effect id="effect"><profile_COMMON>
<newparam sid="surface"><surface type="2D"><init_from>picture</init_from></surface></newparam>
<newparam sid="sampler"><sampler2D><source>surface</source></sampler2D></newparam>
<technique sid="t"><lambert><diffuse><texture texture="sampler" texcoord="UVMap"></texture></diffuse>
</lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="skin" name="skin"><instance_effect url="#effect"/></material>
</library_materials>
<library_geometries><geometry id="square"><mesh>
<source id="places"><float_array id="p" count="12">0 0 0 1 0 0 1 1 0 0 1 0</float_array>
<technique_common><accessor source="#p" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<source id="map"><float_array id="m" count="8">0 0 1 0 1 1 0 1</float_array>
<technique_common><accessor source="#m" count="4" stride="2"><param name="S" type="float"/>
<param name="T" type="float"/></accessor></technique_common></source>
<source id="other"><float_array id="o" count="8">.5 .5 .5 .5 .5 .5 .5 .5</float_array>
<technique_common><accessor source="#o" count="4" stride="2"><param name="S" type="float"/>
<param name="T" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#places"/></vertices>
<triangles material="m" count="2"><input semantic="VERTEX" source="#v" offset="0"/>
<input semantic="TEXCOORD" source="#map" offset="0" set="0"/>
<p>0 1 2 0 2 3</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="scene"><node id="n"><instance_geometry url="#square">
<bind_material><technique_common><instance_material symbol="m" target="#skin">
<bind_vertex_input semantic="UVMap" input_semantic="TEXCOORD" input_set="0"/>
</instance_material></technique_common></bind_material></instance_geometry></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#scene"/></scene></COLLADA>
)";
}

QByteArray texturedFbx(const QByteArray& property) {
    return R"(; FBX 7.4.0 project file
FBXHeaderExtension: {
 FBXHeaderVersion: 1003
 FBXVersion: 7400
}
Objects: {
 Geometry: 1000, "Geometry::g", "Mesh" {
  Vertices: *12 { a: 0,0,0,1,0,0,1,2,0,0,2,0 }
  PolygonVertexIndex: *4 { a: 0,1,2,-4 }
  LayerElementUV: 0 {
   Name: "map"
   MappingInformationType: "ByPolygonVertex"
   ReferenceInformationType: "IndexToDirect"
   UV: *8 { a: 0,0,1,0,1,1,0,1 }
   UVIndex: *4 { a: 0,1,2,3 }
  }
  LayerElementMaterial: 0 {
   MappingInformationType: "AllSame"
   ReferenceInformationType: "IndexToDirect"
   Materials: *1 { a: 0 }
  }
  Layer: 0 {
   LayerElement: {
    Type: "LayerElementMaterial"
    TypedIndex: 0
   }
   LayerElement: {
    Type: "LayerElementUV"
    TypedIndex: 0
   }
  }
 }
 Model: 2000, "Model::m", "Mesh" {
  Version: 232
 }
 Material: 3000, "Material::skin", "" {
  ShadingModel: "lambert"
 }
 Texture: 4000, "Texture::t", "" {
  Type: "TextureVideoClip"
  Properties70: {
   )" + property +
           R"(
  }
  FileName: "skin.png"
  RelativeFilename: "skin.png"
 }
}
Connections: {
 C: "OO",2000,0
 C: "OO",1000,2000
 C: "OO",3000,2000
 C: "OP",4000,3000, "DiffuseColor"
}
)";
}

QByteArray convertedGltf(const QByteArray& gltf, const char* format) {
    return converted(gltf, "gltf", format);
}

QByteArray tetrahedron(const char* format) {
    return converted("v 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\nvt 0 0\nvt 1 0\nvt 0 1\n"
                     "f 1/1 3/2 2/3\nf 1/1 2/2 4/3\nf 2/1 3/2 4/3\nf 1/1 4/2 3/3\n",
                     "obj", format);
}

QByteArray chunk3ds(quint16 kind, const QByteArray& content) {
    constexpr quint32 head = 6; // bytes
    QByteArray chunk;
    appendNumber(chunk, kind);
    appendNumber(chunk, head + quint32(content.size()));
    return chunk + content;
}

QByteArray chunk3ds(quint16 kind, float number) {
    QByteArray content;
    appendNumber(content, number);
    return chunk3ds(kind, content);
}

QByteArray textured3ds(const Chunks3ds& further) {
    const auto list = [](quint16 count, const auto& numbers) {
        QByteArray bytes;
        appendNumber(bytes, count);
        for (const auto number : numbers) {
            appendNumber(bytes, number);
        }
        return bytes;
    };
    constexpr quint16 unused = 0;
    const QByteArray name("skin\0", 5);
    const QByteArray texture = chunk3ds(0xa300, QByteArray("skin.png\0", 9)) + further.texture;
    const QByteArray material = chunk3ds(0xa000, name) + chunk3ds(0xa200, texture);
    const std::vector<float> points{0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10};
    const std::vector<float> coordinates{0, 0, 1, 0, 0, 1, 1, 1};
    const std::vector<quint16> faces{0, 2, 1, unused, 0, 1, 3, unused,
                                     1, 2, 3, unused, 0, 3, 2, unused};
    const QByteArray usedBy = name + list(4, std::vector<quint16>{0, 1, 2, 3});
    const QByteArray mesh =
        chunk3ds(0x4110, list(4, points)) + chunk3ds(0x4140, list(4, coordinates)) +
        chunk3ds(0x4120, list(4, faces) + chunk3ds(0x4130, usedBy)) + further.mesh;
    const QByteArray object = QByteArray("part\0", 5) + further.object + chunk3ds(0x4100, mesh);
    return chunk3ds(0x4d4d, chunk3ds(0x3d3d, chunk3ds(0xafff, material) + chunk3ds(0x4000, object) +
                                                 further.scene));
}

QByteArray tetrahedronBinaryFbx(const std::vector<std::pair<QByteArray, int>>& axes, double unit,
                                double deformPercent, double visibility) {
    constexpr qint32 version = 7400;
    FbxNode fileVersion{"FBXVersion"};
    fileVersion.add(version);
    FbxNode header{"FBXHeaderExtension"};
    header.children = {fileVersion};
    FbxNode unitSetting{"P"};
    unitSetting.add("UnitScaleFactor").add("double").add("Number").add("").add(unit);
    FbxNode settings{"Properties70"};
    settings.children = {unitSetting};
    for (const auto& [axis, value] : axes) {
        FbxNode& node = settings.children.emplace_back("P");
        node.add(axis).add("int").add("Integer").add("").add(qint32(value));
    }
    FbxNode globalSettings{"GlobalSettings"};
    globalSettings.children = {settings};
    FbxNode vertices{"Vertices"};
    vertices.add<double>('d', {0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10});
    FbxNode corners{"PolygonVertexIndex"};
    // The last corner of a polygon is stored as its complement.
    corners.add<qint32>('i', {0, 2, ~1, 0, 1, ~3, 1, 2, ~3, 0, 3, ~2});
    FbxNode geometry{"Geometry"};
    geometry.add(qint64(100)).add(QByteArray("\0\1Geometry", 10)).add("Mesh");
    geometry.children = {vertices, corners};
    FbxNode model{"Model"};
    model.add(qint64(200)).add(QByteArray("part\0\1Model", 11)).add("Mesh");
    FbxNode modelVersion{"Version"};
    modelVersion.add(qint32(232));
    FbxNode visible{"P"}, properties{"Properties70"};
    visible.add("Visibility").add("Visibility").add("").add("A").add(visibility);
    properties.children = {visible};
    model.children = {modelVersion, properties};
    FbxNode objects{"Objects"};
    FbxNode weight{"DeformPercent"};
    weight.add(deformPercent);
    FbxNode shape{"Deformer"};
    shape.add(qint64(300)).add(QByteArray("\0\1SubDeformer", 13)).add("BlendShapeChannel");
    shape.children = {weight};
    objects.children = {geometry, model, shape};
    FbxNode toModel{"C"}, toRoot{"C"};
    toModel.add("OO").add(qint64(100)).add(qint64(200));
    toRoot.add("OO").add(qint64(200)).add(qint64(0));
    FbxNode connections{"Connections"};
    connections.children = {toModel, toRoot};
    QByteArray file("Kaydara FBX Binary  \0\x1a\0", 23);
    appendNumber(file, quint32(version));
    for (const FbxNode& node : {header, globalSettings, objects, connections}) {
        node.writeTo(file);
    }
    return file + QByteArray(13, '\0');
}

} // namespace dipwright::test
