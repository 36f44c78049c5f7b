#include "import/sandboxed/GltfCheck.h"

#include "base/Budgets.h"
#include "import/sandboxed/GltfPose.h"
#include "import/sandboxed/MaterialFileCheck.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtEndian>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

const QString draco = QStringLiteral("KHR_draco_mesh_compression");
const QString instancing = QStringLiteral("EXT_mesh_gpu_instancing");
const QString textureTransform = QStringLiteral("KHR_texture_transform");

// A binary file (glTF 2.0, "Binary glTF Layout") begins with three numbers. Then comes the JSON
// chunk, with its length and kind.
constexpr qsizetype fileHead = 12, chunkHead = 8; // bytes

QByteArray jsonOf(const QByteArray& file) {
    if (!file.startsWith("glTF") || file.size() < fileHead + chunkHead) {
        return file;
    }
    return file.mid(fileHead + chunkHead, qFromLittleEndian<quint32>(file.constData() + fileHead));
}

// Returns the content of the chunk after the JSON chunk: the first buffer of a binary file.
QByteArray binaryOf(const QByteArray& file) {
    return file.startsWith("glTF") ? file.mid(fileHead + 2 * chunkHead + jsonOf(file).size())
                                   : QByteArray();
}

// Returns the file with its JSON document replaced.
QByteArray withDocument(const QByteArray& file, const QJsonObject& document) {
    QByteArray json = QJsonDocument(document).toJson(QJsonDocument::Compact);
    if (!file.startsWith("glTF") || file.size() < fileHead + chunkHead) {
        return json;
    }
    json.append((4 - json.size() % 4) % 4, ' '); // chunks are padded to 4 bytes
    const QByteArray further = file.mid(fileHead + chunkHead + jsonOf(file).size());
    QByteArray whole = file.left(fileHead + chunkHead) + json + further;
    qToLittleEndian(quint32(whole.size()), whole.data() + fileHead - 4);
    qToLittleEndian(quint32(json.size()), whole.data() + fileHead);
    return whole;
}

QJsonObject documentOf(const ModelSource& source) {
    QJsonParseError fault;
    const QJsonDocument document =
        QJsonDocument::fromJson(withoutByteOrderMark(jsonOf(source.bytes)), &fault);
    if (fault.error == QJsonParseError::DeepNesting) {
        requireWithin(Budget::Nesting, budgetLimit(Budget::Nesting) + 1, source.path);
    }
    return document.object();
}

// Whether models that require this extension can be read. Material extensions add light and gloss;
// colours and texture coordinates can be read without them.
bool isRead(const QString& extension) {
    return extension.startsWith(QStringLiteral("KHR_materials_")) ||
           extension == QStringLiteral("KHR_lights_punctual") || extension == textureTransform ||
           extension == draco;
}

[[noreturn]] void throwNotRead(const ModelSource& source, const QString& extension) {
    source.throwDamaged(Text::tr("it needs the glTF extension %1, which is not supported (export "
                                 "it without that extension)")
                            .arg(extension));
}

QJsonObject accessor(const QJsonObject& model, const QJsonValue& index) {
    return model[u"accessors"].toArray().at(index.toInt(-1)).toObject();
}

// Returns the texture of a material's colour; empty if there is none.
QJsonObject textureOf(const QJsonObject& material) {
    const QJsonObject usual = material[u"pbrMetallicRoughness"].toObject();
    const QJsonObject older =
        material[u"extensions"].toObject()[u"KHR_materials_pbrSpecularGlossiness"].toObject();
    const QJsonValue texture = usual[u"baseColorTexture"];
    return texture.isObject() ? texture.toObject() : older[u"diffuseTexture"].toObject();
}

// Returns the attributes of a primitive that are used: its points, normals and the texture
// coordinates of its colour. Others may serve light or gloss.
QStringList placesOf(const QJsonObject& primitive, const QJsonObject& model) {
    const QJsonValue material = model[u"materials"].toArray().at(primitive[u"material"].toInt(-1));
    const int set = textureOf(material.toObject())[u"texCoord"].toInt();
    return {QStringLiteral("POSITION"), QStringLiteral("NORMAL"),
            QStringLiteral("TEXCOORD_%1").arg(set)};
}

constexpr int wideIndices = 5125, floats = 5126; // componentType

void requireFloats(const QJsonValue& index, const QJsonObject& model, const ModelSource& source) {
    if (accessor(model, index)[u"componentType"].toInt(floats) != floats) {
        source.throwDamaged(
            Text::tr("its points or texture coordinates are stored as integers, which is not "
                     "supported (export it with float coordinates, without quantization)"));
    }
}

void checkPrimitive(const QJsonObject& primitive, const QJsonObject& model,
                    const ModelSource& source) {
    const QJsonObject attributes = primitive[u"attributes"].toObject();
    for (const QString& place : placesOf(primitive, model)) {
        requireFloats(attributes[place], model, source);
    }
    for (const QJsonValue& target : primitive[u"targets"].toArray()) {
        requireFloats(target[u"POSITION"], model, source);
    }
    // assimp 5.2 decodes these indices and then drops them.
    if (primitive[u"extensions"].toObject().contains(draco) &&
        accessor(model, primitive[u"indices"])[u"componentType"].toInt() == wideIndices) {
        throwNotRead(source, draco);
    }
}

bool lacksPicture(const QJsonObject& texture, const QJsonObject& model) {
    const QJsonValue named = model[u"textures"].toArray().at(texture[u"index"].toInt(-1));
    return named.isObject() && !named.toObject().contains(u"source");
}

// Whether the model wants hard edges between the pixels of the texture's picture.
bool hasHardPixels(const QJsonObject& texture, const QJsonObject& model) {
    constexpr int nearest = 9728; // glTF 2.0, sampler.magFilter
    const QJsonValue named = model[u"textures"].toArray().at(texture[u"index"].toInt(-1));
    const QJsonValue sampler = model[u"samplers"].toArray().at(named[u"sampler"].toInt(-1));
    return sampler[u"magFilter"].toInt() == nearest;
}

// Whether assimp 5.2 would misplace a texture. It applies an offset correctly. But it rotates and
// scales about the wrong point, and ignores a change of texture coordinates.
bool isMovedOtherwise(const QJsonObject& texture) {
    const QJsonObject transform = texture[u"extensions"].toObject()[textureTransform].toObject();
    const QJsonArray scale = transform[u"scale"].toArray();
    return transform[u"rotation"].toDouble() != 0 || scale.at(0).toDouble(1) != 1 ||
           scale.at(1).toDouble(1) != 1 ||
           (transform.contains(u"texCoord") &&
            transform[u"texCoord"].toInt() != texture[u"texCoord"].toInt());
}

void checkTextures(const QJsonObject& model, const ModelSource& source, QStringList& warnings) {
    bool lacks = false, isMoved = false, isHard = false;
    for (const QJsonValue& material : model[u"materials"].toArray()) {
        const QJsonObject texture = textureOf(material.toObject());
        lacks |= lacksPicture(texture, model);
        isMoved |= isMovedOtherwise(texture);
        isHard |= hasHardPixels(texture, model);
    }
    if (isMoved && model[u"extensionsRequired"].toArray().contains(textureTransform)) {
        throwNotRead(source, textureTransform);
    }
    if (isMoved) {
        warnings.push_back(Text::tr(
            "The model scales or rotates a texture (KHR_texture_transform), which is not shown "
            "correctly; apply the transform to the texture coordinates in a modelling program"));
    }
    if (isHard) {
        warnings.push_back(Text::tr(
            "The model wants hard edges between the pixels of a picture (magFilter NEAREST), "
            "but the sheet shows smooth changes of colour; enlarge the picture without "
            "smoothing in an image program"));
    }
    if (lacks) {
        warnings.push_back(
            Text::tr("A texture of the model has no picture or is in an unsupported format, so its "
                     "material's colour is used instead; export the texture as PNG or JPEG"));
    }
}

// Refuses bind matrices that assimp 5.2.5 would read from elsewhere in memory.
void checkSkin(const QJsonObject& skin, const QJsonObject& model, const ModelSource& source) {
    const QJsonObject matrices = accessor(model, skin[u"inverseBindMatrices"]);
    if (skin.contains(u"inverseBindMatrices") &&
        (matrices[u"count"].toInteger() < skin[u"joints"].toArray().size() ||
         matrices[u"componentType"].toInt() != floats ||
         matrices[u"type"] != QStringLiteral("MAT4"))) {
        source.throwDamaged(Text::tr("a skin lacks bind matrices for some of its joints"));
    }
}

// Refuses a skin that assimp 5.2.5 would read from elsewhere in memory, and a rotation that would
// scale the node.
void checkNode(const QJsonObject& node, const QJsonObject& model, const ModelSource& source) {
    const QJsonValue skin = model[u"skins"].toArray().at(node[u"skin"].toInt(-1));
    if (node.contains(u"skin") && !skin.isObject()) {
        source.throwDamaged(Text::tr("a node uses a skin that does not exist"));
    }
    std::vector<double> quaternion;
    for (const QJsonValue& number : node[u"rotation"].toArray()) {
        quaternion.push_back(number.toDouble());
    }
    if (node.contains(u"rotation") && !isUnit(quaternion)) {
        source.throwDamaged(
            Text::tr("the rotation of a node is not a quaternion of length 1, so it "
                     "would change the size (export the model again)"));
    }
}

} // namespace

QByteArray gltfForAssimp(const ModelSource& source, QStringList& warnings) {
    const QJsonObject model = documentOf(source);
    for (const QJsonValue& extension : model[u"extensionsRequired"].toArray()) {
        if (!isRead(extension.toString())) {
            throwNotRead(source, extension.toString());
        }
    }
    if (model[u"extensionsUsed"].toArray().contains(instancing)) { // without it, parts are missing
        throwNotRead(source, instancing);
    }
    for (const QJsonValue& mesh : model[u"meshes"].toArray()) {
        for (const QJsonValue& primitive : mesh.toObject()[u"primitives"].toArray()) {
            checkPrimitive(primitive.toObject(), model, source);
        }
    }
    for (const QJsonValue& skin : model[u"skins"].toArray()) {
        checkSkin(skin.toObject(), model, source);
    }
    FaultyObjects hidden;
    const QJsonArray nodes = model[u"nodes"].toArray();
    for (qsizetype index = 0; index < nodes.size(); ++index) {
        const QJsonValue node = nodes[index];
        checkNode(node.toObject(), model, source);
        if (!node[u"extensions"][u"KHR_node_visibility"][u"visible"].toBool(true)) {
            hidden.add(node[u"name"].toString(QString::number(index)));
        }
    }
    hidden.warn(warnings, hiddenObjectsWarning());
    if (source.withTextures) {
        checkTextures(model, source, warnings);
    }
    const QJsonObject changed = gltfPoseForAssimp(model, binaryOf(source.bytes), source);
    return changed == model ? withoutByteOrderMark(source.bytes)
                            : withDocument(source.bytes, changed);
}

} // namespace dipwright
