#include "import/sandboxed/GltfPose.h"

#include <QJsonArray>
#include <QSet>
#include <QtEndian>

#include <algorithm>
#include <map>
#include <vector>

namespace dipwright {

namespace {

constexpr int unsignedBytes = 5121, unsignedShorts = 5123, floats = 5126; // componentType

// Appends an element to one of the document's arrays. Returns its index.
qsizetype append(QJsonObject& model, const QString& array, const QJsonObject& element) {
    QJsonArray elements = model[array].toArray();
    elements.append(element);
    model.insert(array, elements);
    return elements.size() - 1;
}

// Adds numbers to the document. Returns an accessor to them.
QJsonObject addFloats(QJsonObject& model, const std::vector<float>& numbers, qsizetype count,
                      const QString& type) {
    QByteArray content(qsizetype(numbers.size() * sizeof(float)), '\0');
    qToLittleEndian<float>(numbers.data(), qsizetype(numbers.size()), content.data());
    const QString uri = QStringLiteral("data:application/octet-stream;base64,") +
                        QString::fromLatin1(content.toBase64());
    const qsizetype buffer =
        append(model, QStringLiteral("buffers"),
               {{QStringLiteral("byteLength"), content.size()}, {QStringLiteral("uri"), uri}});
    const qsizetype view = append(
        model, QStringLiteral("bufferViews"),
        {{QStringLiteral("buffer"), buffer}, {QStringLiteral("byteLength"), content.size()}});
    return {{QStringLiteral("bufferView"), view},
            {QStringLiteral("componentType"), floats},
            {QStringLiteral("count"), count},
            {QStringLiteral("type"), type}};
}

// Adds an accessor of identity matrices to the document. Returns its index.
qsizetype addIdentities(QJsonObject& model, qsizetype count) {
    std::vector<float> numbers(std::size_t(16 * count));
    for (std::size_t entry = 0; entry < numbers.size(); ++entry) {
        numbers[entry] = entry % 16 % 5 == 0 ? 1 : 0;
    }
    const QJsonObject accessor = addFloats(model, numbers, count, QStringLiteral("MAT4"));
    return append(model, QStringLiteral("accessors"), accessor);
}

// Gives bind matrices to the skins that have none.
void bindSkins(QJsonObject& model) {
    const QJsonArray skins = model[u"skins"].toArray();
    qsizetype most = 1; // joints of a skin
    for (const QJsonValue& skin : skins) {
        most = std::max(most, skin[u"joints"].toArray().size());
    }
    const qsizetype matrices = addIdentities(model, most);
    QJsonArray bound;
    for (const QJsonValue& skin : skins) {
        QJsonObject changed = skin.toObject();
        if (!changed.contains(u"inverseBindMatrices")) {
            changed.insert(u"inverseBindMatrices", matrices);
        }
        bound.append(changed);
    }
    model.insert(u"skins", bound);
}

// Reads the weights of skins that are stored as normalized integers.
class IntegerWeights {
public:
    IntegerWeights(const QByteArray& binary, const ModelSource& source)
        : binary_(binary), source_(source) {}

    // Makes them floats. Weights that cannot be read stay as they are, and are then unclear.
    void replace(QJsonObject& model) {
        QJsonArray accessors = model[u"accessors"].toArray();
        for (const int index : weightsOf(model)) {
            const QJsonObject accessor = accessors.at(index).toObject();
            const std::vector<float> weights = read(accessor, model);
            if (!weights.empty()) {
                accessors[index] = addFloats(model, weights, qsizetype(weights.size()) / 4,
                                             QStringLiteral("VEC4"));
            }
        }
        model.insert(u"accessors", accessors);
    }

private:
    // Returns the accessors of all weights of skins.
    static QSet<int> weightsOf(const QJsonObject& model) {
        QSet<int> found;
        for (const QJsonValue& mesh : model[u"meshes"].toArray()) {
            for (const QJsonValue& primitive : mesh[u"primitives"].toArray()) {
                const QJsonObject attributes = primitive[u"attributes"].toObject();
                for (auto each = attributes.begin(); each != attributes.end(); ++each) {
                    if (each.key().startsWith(QStringLiteral("WEIGHTS_"))) {
                        found.insert(each.value().toInt(-1));
                    }
                }
            }
        }
        return found;
    }

    // Returns four weights for each point; none if they are not integers or not all in the buffer.
    std::vector<float> read(const QJsonObject& accessor, const QJsonObject& model) {
        const int type = accessor[u"componentType"].toInt();
        if ((type != unsignedBytes && type != unsignedShorts) ||
            accessor[u"type"] != QStringLiteral("VEC4") || accessor.contains(u"sparse")) {
            return {};
        }
        const QJsonObject view =
            model[u"bufferViews"].toArray().at(accessor[u"bufferView"].toInt(-1)).toObject();
        const QByteArray& buffer = content(view[u"buffer"].toInt(-1), model);
        const qint64 size = type == unsignedBytes ? 4 : 8; // of the weights of a point
        const qint64 viewBegin = view[u"byteOffset"].toInteger();
        const qint64 begin = accessor[u"byteOffset"].toInteger();
        const qint64 stride = view[u"byteStride"].toInteger(size);
        const qint64 count = accessor[u"count"].toInteger();
        if (std::min({viewBegin, begin, stride - size, count - 1}) < 0 ||
            std::max({viewBegin, begin, stride, count}) > buffer.size() ||
            viewBegin + begin + (count - 1) * stride + size > buffer.size()) {
            return {};
        }
        std::vector<float> weights;
        weights.reserve(std::size_t(4 * count));
        for (qint64 point = 0; point < count; ++point) {
            const char* first = buffer.constData() + viewBegin + begin + point * stride;
            for (int influence = 0; influence < 4; ++influence) {
                weights.push_back(type == unsignedBytes ? float(quint8(first[influence])) / 255
                                                        : shortAt(first + 2 * influence) / 65535);
            }
        }
        return weights;
    }

    static float shortAt(const char* place) { return qFromLittleEndian<quint16>(place); }

    // Returns the content of a buffer; empty if it cannot be read.
    const QByteArray& content(int index, const QJsonObject& model) {
        const auto [known, isNew] = contents_.try_emplace(index);
        if (isNew) {
            const QJsonValue uri = model[u"buffers"].toArray().at(index)[u"uri"];
            known->second =
                uri.isString() ? contentAt(uri.toString()) : (index == 0 ? binary_ : QByteArray());
        }
        return known->second;
    }

    QByteArray contentAt(const QString& uri) const {
        if (uri.startsWith(QStringLiteral("data:"))) {
            return QByteArray::fromBase64(uri.mid(uri.indexOf(u',') + 1).toLatin1());
        }
        return source_.files.read(uri).value_or(QByteArray());
    }

    const QByteArray& binary_;
    const ModelSource& source_;
    std::map<int, QByteArray> contents_; // by index of the buffer
};

bool hasOwnPose(const QJsonObject& node) {
    return node.contains(u"skin") || node.contains(u"weights");
}

// Gives each node its own name. Gives each node that uses the mesh of a node with its own pose its
// own copy.
void separateNodes(QJsonObject& model) {
    const QJsonArray nodes = model[u"nodes"].toArray(), shared = model[u"meshes"].toArray();
    QJsonArray meshes = shared;
    QSet<int> posed, used; // meshes
    for (const QJsonValue& node : nodes) {
        if (hasOwnPose(node.toObject())) {
            posed.insert(node[u"mesh"].toInt(-1));
        }
    }
    QJsonArray separate;
    for (const QJsonValue& node : nodes) {
        QJsonObject own = node.toObject();
        own.insert(u"name", QString::number(separate.size()));
        const int mesh = node[u"mesh"].toInt(-1);
        if (posed.contains(mesh) && shared.at(mesh).isObject()) {
            QJsonObject ownMesh = shared.at(mesh).toObject();
            if (own.contains(u"weights")) {
                ownMesh.insert(u"weights", own[u"weights"]);
            }
            if (used.contains(mesh)) {
                own.insert(u"mesh", meshes.size());
                meshes.append(ownMesh);
            } else {
                meshes[mesh] = ownMesh;
            }
            used.insert(mesh);
        }
        separate.append(own);
    }
    model.insert(u"meshes", meshes);
    model.insert(u"nodes", separate);
}

} // namespace

QJsonObject gltfPoseForAssimp(const QJsonObject& document, const QByteArray& binary,
                              const ModelSource& source) {
    const QJsonArray nodes = document[u"nodes"].toArray();
    QJsonObject model = document;
    if (!document[u"skins"].toArray().isEmpty()) {
        IntegerWeights(binary, source).replace(model);
        bindSkins(model);
    }
    if (std::any_of(nodes.begin(), nodes.end(),
                    [](const QJsonValue& node) { return hasOwnPose(node.toObject()); })) {
        separateNodes(model);
    }
    return model;
}

} // namespace dipwright
