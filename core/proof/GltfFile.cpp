#include "proof/GltfFile.h"

#include "base/ProgramName.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtEndian>
#include <algorithm>
#include <bit>
#include <cmath>

namespace dipwright {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF stores numbers in this order");

// Numbers of the specification.
constexpr int unsignedShort = 5123, unsignedInt = 5125, floatType = 5126;
constexpr int arrayBuffer = 34962, elementBuffer = 34963;
constexpr int linear = 9729, linearMipmaps = 9987, clampToEdge = 33071;

QByteArray padded(QByteArray bytes, char with) {
    return bytes.append((4 - bytes.size() % 4) % 4, with);
}

template <typename Value>
QByteArray bytesOf(const std::vector<Value>& values) {
    return {reinterpret_cast<const char*>(values.data()), qsizetype(values.size() * sizeof(Value))};
}

QJsonArray jsonOf(const Eigen::Vector3f& vector) {
    return {double(vector.x()), double(vector.y()), double(vector.z())};
}

// The binary part of the file, and what the JSON part says about it.
class Buffer {
public:
    // Returns the index of the new view.
    int add(const QByteArray& bytes, int target = 0) {
        QJsonObject view{
            {"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}};
        if (target != 0) {
            view["target"] = target;
        }
        views_.append(view);
        bytes_ = padded(bytes_ + bytes, 0);
        return int(views_.size()) - 1;
    }
    // Returns the index of the new accessor. `more` are its other properties.
    int addNumbers(const QByteArray& bytes, int target, int component, const char* type,
                   std::size_t count, const QJsonObject& more = {}) {
        QJsonObject accessor = more;
        accessor["bufferView"] = add(bytes, target);
        accessor["componentType"] = component;
        accessor["type"] = QLatin1String(type);
        accessor["count"] = qint64(count);
        accessors_.append(accessor);
        return int(accessors_.size()) - 1;
    }
    void describe(QJsonObject& json) const {
        json["buffers"] = QJsonArray{QJsonObject{{"byteLength", bytes_.size()}}};
        json["bufferViews"] = views_;
        json["accessors"] = accessors_;
    }
    const QByteArray& bytes() const { return bytes_; }

private:
    QByteArray bytes_;
    QJsonArray views_, accessors_;
};

QJsonObject attributesOf(const std::vector<GltfVertex>& vertices, Buffer& buffer) {
    std::vector<Eigen::Vector3f> positions, normals;
    std::vector<std::array<std::uint16_t, 2>> places;
    BoundingBox box;
    for (const GltfVertex& vertex : vertices) {
        positions.push_back(vertex.position);
        normals.push_back(vertex.normal);
        box.extend(vertex.position);
        const auto code = [](float share) {
            return std::uint16_t(std::lround(std::clamp(share, 0.0F, 1.0F) * 65535));
        };
        places.push_back({code(vertex.texture.x()), code(vertex.texture.y())});
    }
    const std::size_t count = vertices.size();
    return {
        {"POSITION", buffer.addNumbers(bytesOf(positions), arrayBuffer, floatType, "VEC3", count,
                                       {{"min", jsonOf(box.min())}, {"max", jsonOf(box.max())}})},
        {"NORMAL", buffer.addNumbers(bytesOf(normals), arrayBuffer, floatType, "VEC3", count)},
        {"TEXCOORD_0", buffer.addNumbers(bytesOf(places), arrayBuffer, unsignedShort, "VEC2", count,
                                         {{"normalized", true}})}};
}

int indicesOf(const GltfModel& model, Buffer& buffer) {
    const std::size_t count = 3 * model.triangles.size();
    if (model.vertices.size() > 0xffff) {
        return buffer.addNumbers(bytesOf(model.triangles), elementBuffer, unsignedInt, "SCALAR",
                                 count);
    }
    std::vector<std::uint16_t> indices;
    for (const auto& triangle : model.triangles) {
        indices.insert(indices.end(), triangle.begin(), triangle.end());
    }
    return buffer.addNumbers(bytesOf(indices), elementBuffer, unsignedShort, "SCALAR", count);
}

QJsonObject materialJson(const GltfMaterial& material, int texture, bool isClosed) {
    QJsonObject json{
        {"name", material.name},
        {"doubleSided", !isClosed},
        {"extras", QJsonObject{{"key", material.key}}},
        {"pbrMetallicRoughness", QJsonObject{{"baseColorTexture", QJsonObject{{"index", texture}}},
                                             {"metallicFactor", 0},
                                             {"roughnessFactor", 0.5}}}};
    if (material.isUnlit) {
        json["extensions"] = QJsonObject{{"KHR_materials_unlit", QJsonObject()}};
    }
    return json;
}

void addMaterials(QJsonObject& json, const GltfModel& model, Buffer& buffer) {
    QJsonArray materials, textures, images;
    bool isAnyUnlit = false;
    for (const GltfMaterial& material : model.materials) {
        const int number = int(materials.size());
        images.append(QJsonObject{{"bufferView", buffer.add(material.jpeg)},
                                  {"mimeType", "image/jpeg"},
                                  {"name", material.name}});
        textures.append(QJsonObject{{"source", number}, {"sampler", 0}});
        materials.append(materialJson(material, number, model.isClosed));
        isAnyUnlit = isAnyUnlit || material.isUnlit;
    }
    json["materials"] = materials;
    json["textures"] = textures;
    json["images"] = images;
    json["samplers"] = QJsonArray{QJsonObject{{"magFilter", linear},
                                              {"minFilter", linearMipmaps},
                                              {"wrapS", clampToEdge},
                                              {"wrapT", clampToEdge}}};
    QJsonArray used{"KHR_materials_variants"};
    if (isAnyUnlit) {
        used.append("KHR_materials_unlit");
    }
    json["extensionsUsed"] = used;
}

QJsonObject variants(const char* key, const QJsonArray& values) {
    return {{"KHR_materials_variants", QJsonObject{{QLatin1String(key), values}}}};
}

QJsonObject meshJson(const GltfModel& model, Buffer& buffer) {
    QJsonArray mappings;
    for (int number = 0; number < int(model.materials.size()); ++number) {
        mappings.append(QJsonObject{{"material", number}, {"variants", QJsonArray{number}}});
    }
    const QJsonObject attributes = attributesOf(model.vertices, buffer);
    return {
        {"name", model.name},
        {"primitives", QJsonArray{QJsonObject{{"attributes", attributes},
                                              {"indices", indicesOf(model, buffer)},
                                              {"material", 0},
                                              {"extensions", variants("mappings", mappings)}}}}};
}

QByteArray number32(qsizetype number) {
    const quint32 bytes = qToLittleEndian(quint32(number));
    return {reinterpret_cast<const char*>(&bytes), sizeof(bytes)};
}

QByteArray chunk(const char* type, const QByteArray& bytes) {
    return number32(bytes.size()) + QByteArray(type, 4) + bytes;
}

} // namespace

QByteArray glb(const GltfModel& model) {
    constexpr double metres = 0.001; // per mm
    constexpr int headerBytes = 12;
    Buffer buffer;
    QJsonArray names;
    for (const GltfMaterial& material : model.materials) {
        names.append(QJsonObject{{"name", material.name}});
    }
    QJsonObject json{
        {"asset", QJsonObject{{"version", "2.0"},
                              {"generator", QStringLiteral("Dipwright ") + programVersion()}}},
        {"scene", 0},
        {"scenes", QJsonArray{QJsonObject{{"name", model.name}, {"nodes", QJsonArray{0}}}}},
        {"nodes",
         QJsonArray{QJsonObject{
             {"name", model.name}, {"mesh", 0}, {"scale", QJsonArray{metres, metres, metres}}}}},
        {"meshes", QJsonArray{meshJson(model, buffer)}},
        {"extensions", variants("variants", names)}};
    addMaterials(json, model, buffer);
    buffer.describe(json);
    const QByteArray chunks =
        chunk("JSON", padded(QJsonDocument(json).toJson(QJsonDocument::Compact), ' ')) +
        chunk("BIN\0", buffer.bytes());
    return "glTF" + number32(2) + number32(headerBytes + chunks.size()) + chunks;
}

} // namespace dipwright
