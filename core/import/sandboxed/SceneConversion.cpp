#include "import/sandboxed/SceneConversion.h"

#include "base/Budgets.h"
#include "base/WideGamut.h"
#include "import/sandboxed/SkinPose.h"
#include "settings/SurfaceMark.h"

#include <QCoreApplication>

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

int colourByte(float value, bool linear) {
    const float light = std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 0.0F;
    const float toShow = !linear               ? light
                         : light <= 0.0031308F ? 12.92F * light
                                               : 1.055F * std::pow(light, 1 / 2.4F) - 0.055F;
    return int(std::lround(255 * toShow));
}

// How a material's alpha, 0 … 1, follows from that of its picture, or from 1 if it has none.
struct AlphaRule {
    float factor = 1; // multiplies the picture's alpha
    // The alpha from which the product is opaque; below, it is transparent. Nothing: it is kept.
    std::optional<float> opaqueFrom;
    auto operator<=>(const AlphaRule&) const = default;

    float of(float alpha) const {
        const float product = alpha * factor;
        return !opaqueFrom ? product : product >= *opaqueFrom ? 1.0F : 0.0F;
    }
};

// glTF 2.0, "Alpha Coverage". Other formats keep alpha.
AlphaRule alphaRule(const aiMaterial& material) {
    aiString mode;
    if (material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) != aiReturn_SUCCESS) {
        return {};
    }
    aiColor4D factor(1, 1, 1, 1);
    material.Get(AI_MATKEY_BASE_COLOR, factor);
    const float alpha = std::isfinite(factor.a) ? std::clamp(factor.a, 0.0F, 1.0F) : 1.0F;
    if (mode == aiString("BLEND")) {
        return {alpha, std::nullopt};
    }
    float cutoff = 0.5F;
    material.Get(AI_MATKEY_GLTF_ALPHACUTOFF, cutoff);
    return mode == aiString("MASK") ? AlphaRule{alpha, cutoff} : AlphaRule{1, 0.0F};
}

// Does not touch a picture that stays the same, because PictureReader::inksOf() must recognise it.
template <typename Number>
void setAlpha(QImage& picture, const AlphaRule& rule) {
    constexpr auto opaque = float(std::numeric_limits<Number>::max());
    for (int y = 0; y < picture.height(); ++y) {
        for (int at = 3; at < 4 * picture.width(); at += 4) {
            const Number before = reinterpret_cast<const Number*>(picture.constScanLine(y))[at];
            const auto after = Number(std::lround(opaque * rule.of(float(before) / opaque)));
            if (after != before) {
                reinterpret_cast<Number*>(picture.scanLine(y))[at] = after;
            }
        }
    }
}

QImage withAlpha(QImage picture, const AlphaRule& rule) {
    if (rule != AlphaRule() && picture.hasAlphaChannel()) {
        isWide(picture) ? setAlpha<quint16>(picture, rule) : setAlpha<quint8>(picture, rule);
    }
    return picture;
}

// Converts the scene's materials and pictures on demand, so that only those in use are kept.
class MaterialReader {
public:
    MaterialReader(const aiScene& scene, const ModelSource& source, const SceneMeaning& meaning,
                   TexturedMesh& model, QStringList& warnings)
        : scene_(scene), source_(source), meaning_(meaning), model_(model), warnings_(warnings) {}

    struct Found {
        std::uint16_t material; // index into the model's materials
        unsigned channel;       // channel of texture coordinates in the scene's mesh
        PicturePlacement placement;
        // Whether the picture is mirrored or ends at its edge where texture coordinates go on.
        bool isNotRepeated = false;
    };

    Found find(unsigned sceneMaterial) {
        const auto known = found_.find(sceneMaterial);
        if (known != found_.end()) {
            return known->second;
        }
        requireWithin(Budget::Materials, qint64(model_.materials.size()) + 1, source_.path);
        Found found{std::uint16_t(model_.materials.size()), 0, {}};
        read(sceneMaterial, found);
        const auto placed = meaning_.placements.find(model_.materials.back().name);
        if (placed != meaning_.placements.end()) {
            found.placement = placed->second;
        }
        return found_.emplace(sceneMaterial, found).first->second;
    }

private:
    // Adds the material to the model, and sets what is read from it.
    void read(unsigned sceneMaterial, Found& found) {
        Material& material = model_.materials.emplace_back();
        if (sceneMaterial >= scene_.mNumMaterials) {
            return;
        }
        const aiMaterial& source = *scene_.mMaterials[sceneMaterial];
        material.name = QString::fromUtf8(source.GetName().C_Str()).left(longestMaterialName);
        aiColor4D colour;
        if (source.Get(AI_MATKEY_BASE_COLOR, colour) == aiReturn_SUCCESS ||
            source.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == aiReturn_SUCCESS) {
            material.colour =
                QColor(colourByte(colour.r, meaning_.isGltf), colourByte(colour.g, meaning_.isGltf),
                       colourByte(colour.b, meaning_.isGltf));
        }
        for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
            aiString name;
            std::array<aiTextureMapMode, 3> modes{}; // U, V, and one that pictures do not have
            if (source.GetTexture(type, 0, &name, nullptr, &found.channel, nullptr, nullptr,
                                  modes.data()) == aiReturn_SUCCESS) {
                material.texture =
                    source_.withTextures ? textureIndex(name, alphaRule(source)) : -1;
                found.isNotRepeated = material.texture >= 0 && (meaning_.hasTextureThatEnds ||
                                                                modes[0] != aiTextureMapMode_Wrap ||
                                                                modes[1] != aiTextureMapMode_Wrap);
                noteTint(material);
                return;
            }
        }
        if (alphaRule(source).of(1) < 1 && !isTransparencyNoted_) {
            isTransparencyNoted_ = true;
            warnings_.push_back(transparentMaterialWarning());
        }
        if (source_.withTextures && source.GetTextureCount(aiTextureType_EMISSIVE) > 0 &&
            !isLightNoted_) {
            isLightNoted_ = true;
            warnings_.push_back(Text::tr(
                "The model has a material with a picture of its light (emission), but none of its "
                "colour, and the picture is not shown; use it for the colour in a modelling "
                "program"));
        }
    }

    // In glTF, the material's colour multiplies its picture.
    void noteTint(const Material& material) {
        if (meaning_.isGltf && material.texture >= 0 && material.colour != Qt::white &&
            !isTintNoted_) {
            isTintNoted_ = true;
            warnings_.push_back(Text::tr(
                "The model tints a texture with its material's colour, which is not shown; apply "
                "the colour to the picture"));
        }
    }

    int textureIndex(const aiString& name, const AlphaRule& alpha) {
        const auto key = std::pair(std::string(name.C_Str()), alpha);
        const auto known = textures_.find(key);
        if (known != textures_.end()) {
            return known->second;
        }
        int index = -1;
        if (QImage image = readPicture(name); !image.isNull()) {
            index = int(model_.textures.size());
            model_.textures.push_back(withAlpha(std::move(image), alpha));
        }
        return textures_.emplace(key, index).first->second;
    }

    QImage readPicture(const aiString& name) {
        const QString shownName = QString::fromUtf8(name.C_Str());
        if (const aiTexture* embedded = embeddedPicture(name)) {
            return readEmbedded(*embedded,
                                Text::tr("texture %1 in %2").arg(shownName, source_.path));
        }
        return source_.readPicture(shownName, warnings_);
    }

    // Returns an embedded picture by its number ("*0") or its full name; null if there is none.
    // assimp's own search ignores folders, so it may find another picture.
    const aiTexture* embeddedPicture(const aiString& name) const {
        if (name.C_Str()[0] == '*') {
            return scene_.GetEmbeddedTexture(name.C_Str());
        }
        const auto end = scene_.mTextures + scene_.mNumTextures;
        const auto found = std::find_if(
            scene_.mTextures, end, [&](const aiTexture* each) { return each->mFilename == name; });
        return found == end ? nullptr : *found;
    }

    QImage readEmbedded(const aiTexture& texture, const QString& where) {
        if (texture.mHeight == 0) {
            return source_.pictures.read(
                QByteArray::fromRawData(reinterpret_cast<const char*>(texture.pcData),
                                        texture.mWidth),
                where);
        }
        requireWithin(Budget::PictureSide, std::max(texture.mWidth, texture.mHeight), where);
        QImage image(int(texture.mWidth), int(texture.mHeight), QImage::Format_ARGB32);
        const aiTexel* texel = texture.pcData;
        for (int y = 0; y < image.height(); ++y) {
            auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
            for (int x = 0; x < image.width(); ++x, ++texel) {
                line[x] = qRgba(texel->r, texel->g, texel->b, texel->a);
            }
        }
        return source_.pictures.take(std::move(image), where);
    }

    const aiScene& scene_;
    const ModelSource& source_;
    const SceneMeaning& meaning_;
    TexturedMesh& model_;
    QStringList& warnings_;
    std::map<unsigned, Found> found_;
    std::map<std::pair<std::string, AlphaRule>, int> textures_;
    bool isTintNoted_ = false, isTransparencyNoted_ = false, isLightNoted_ = false;
};

// Whether vertex colours would change a picture that they multiply.
bool isTinted(const aiMesh& mesh) {
    const aiColor4D white(1, 1, 1, 1);
    return std::any_of(mesh.mColors[0], mesh.mColors[0] + mesh.mNumVertices,
                       [&](const aiColor4D& colour) { return colour != white; });
}

aiMatrix4x4 matrixOf(const Eigen::Matrix3f& from) {
    aiMatrix4x4 matrix;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            matrix[unsigned(row)][column] = from(row, column);
        }
    }
    return matrix;
}

// Moves a mesh's points by its morph targets: point + Σ weight · (target − point).
void morph(std::vector<aiVector3D>& points, const aiMesh& mesh) {
    for (unsigned t = 0; t < mesh.mNumAnimMeshes; ++t) {
        const aiAnimMesh& target = *mesh.mAnimMeshes[t];
        if (target.mWeight == 0 || !target.mVertices || target.mNumVertices != points.size()) {
            continue;
        }
        for (std::size_t point = 0; point < points.size(); ++point) {
            points[point] += target.mWeight * (target.mVertices[point] - mesh.mVertices[point]);
        }
    }
}

class TriangleReader {
public:
    TriangleReader(const aiScene& scene, const ModelSource& source, const SceneMeaning& meaning,
                   TexturedMesh& model, QStringList& warnings, const Progress& progress)
        : scene_(scene), source_(source), frame_(matrixOf(meaning.frame)), isGltf_(meaning.isGltf),
          model_(model), warnings_(warnings), progress_(progress),
          materials_(scene, source, meaning, model, warnings) {}

    void readAll() {
        if (!scene_.mRootNode) {
            return;
        }
        count(*scene_.mRootNode);
        const SkinPose skins(*scene_.mRootNode, frame_, isGltf_);
        model_.mesh.triangles.reserve(total_);
        model_.textureCoordinates.reserve(total_);
        model_.material.reserve(total_);
        readNode(*scene_.mRootNode, frame_, skins);
        if (hasColours_) {
            warnings_.push_back(Text::tr(
                "The model's vertex colours are not used; bake them into a texture to print them"));
        }
        if (isPastPicture_) {
            warnings_.push_back(notRepeatedWarning());
        }
        if (unclear_ > 0) {
            warnings_.push_back(
                Text::tr("The skin of the model does not say clearly how joints move %1 of its "
                         "points, so these stay as stored; apply the armature in a modelling "
                         "program")
                    .arg(unclear_));
        }
        if (bare_ > 0 && bare_ < model_.mesh.triangles.size()) {
            warnings_.push_back(
                Text::tr("Some triangles (%1) have no place on the model's texture; they show one "
                         "colour, which is mixed from its corners")
                    .arg(bare_));
        }
    }

private:
    // Counts first, because a small file can show one mesh many times.
    void count(const aiNode& node) {
        for (unsigned m = 0; m < node.mNumMeshes; ++m) {
            const aiMesh& mesh = *scene_.mMeshes[node.mMeshes[m]];
            // Some vertices may be in no face.
            total_ += std::max(mesh.mNumFaces, mesh.mNumVertices / 3);
        }
        source_.checkTriangleCount(total_);
        for (unsigned child = 0; child < node.mNumChildren; ++child) {
            count(*node.mChildren[child]);
        }
    }

    void readNode(const aiNode& node, const aiMatrix4x4& parent, const SkinPose& skins) {
        const aiMatrix4x4 transform = parent * node.mTransformation;
        for (unsigned m = 0; m < node.mNumMeshes; ++m) {
            progress_(double(model_.mesh.triangles.size()) / double(total_ + 1),
                      Text::tr("Reading triangles"));
            readMesh(*scene_.mMeshes[node.mMeshes[m]], node, transform, skins);
        }
        for (unsigned child = 0; child < node.mNumChildren; ++child) {
            readNode(*node.mChildren[child], transform, skins);
        }
    }

    void readMesh(const aiMesh& mesh, const aiNode& node, const aiMatrix4x4& transform,
                  const SkinPose& skins) {
        const auto firstPosition = std::uint32_t(model_.mesh.positions.size());
        std::vector<aiVector3D> points(mesh.mVertices, mesh.mVertices + mesh.mNumVertices);
        if (isGltf_) { // assimp 5.2.5 does not pass on most weights of FBX files
            morph(points, mesh);
        }
        const PosedMesh posed = skins.pose(mesh, points, node, transform);
        for (const aiVector3D& point : posed.points) {
            model_.mesh.positions.emplace_back(point.x, point.y, point.z);
        }
        unclear_ += posed.unclear;
        const auto [material, namedChannel, placement, isNotRepeated] =
            materials_.find(mesh.mMaterialIndex);
        // Collada names a set by any number, even if it is the only one.
        const unsigned channel = mesh.GetNumUVChannels() == 1 ? 0 : namedChannel;
        const bool hasPicture = model_.materials[material].texture >= 0;
        const bool hasCoordinates =
            channel < AI_MAX_NUMBER_OF_TEXTURECOORDS && mesh.HasTextureCoords(channel);
        hasColours_ |= mesh.HasVertexColors(0) && (!hasPicture || isTinted(mesh));
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices != 3) { // skip points and lines
                continue;
            }
            std::array<std::uint32_t, 3> corners{face.mIndices[0], face.mIndices[1],
                                                 face.mIndices[2]};
            if (posed.isMirrored) {
                std::swap(corners[1], corners[2]);
            }
            addTriangle(mesh, corners, firstPosition,
                        hasCoordinates ? mesh.mTextureCoords[channel] : nullptr, placement);
            model_.material.push_back(material);
            if (hasPicture && hasCoordinates) {
                const auto& uv = model_.textureCoordinates.back();
                isPastPicture_ |= isNotRepeated && isPastPicture(uv);
                // Readers fill missing coordinates with zeros.
                const auto isZero = [](const Eigen::Vector2f& each) { return each.isZero(0); };
                bare_ += std::all_of(uv.begin(), uv.end(), isZero) ? 1 : 0;
            }
        }
    }

    void addTriangle(const aiMesh& mesh, const std::array<std::uint32_t, 3>& corners,
                     std::uint32_t firstPosition, const aiVector3D* coordinates,
                     const PicturePlacement& placement) {
        auto& triangle = model_.mesh.triangles.emplace_back();
        auto& uv = model_.textureCoordinates.emplace_back(noCoordinates());
        for (int corner = 0; corner < 3; ++corner) {
            if (corners[corner] >= mesh.mNumVertices) {
                source_.throwDamaged(Text::tr("a triangle refers to a point that does not exist"));
            }
            triangle[corner] = firstPosition + corners[corner];
            if (coordinates) {
                const aiVector3D& coordinate = coordinates[corners[corner]];
                const Eigen::Vector2f placed =
                    placement.of(Eigen::Vector2f(coordinate.x, coordinate.y));
                uv[corner] = statedCoordinates(placed.x(), placed.y());
            }
        }
    }

    const aiScene& scene_;
    const ModelSource& source_;
    const aiMatrix4x4 frame_; // SceneMeaning::frame
    const bool isGltf_;       // SceneMeaning::isGltf
    TexturedMesh& model_;
    QStringList& warnings_;
    const Progress& progress_;
    MaterialReader materials_;
    std::size_t total_ = 0;
    bool hasColours_ = false, isPastPicture_ = false;
    std::size_t unclear_ = 0; // PosedMesh::unclear of all meshes
    std::size_t bare_ = 0;    // triangles with a picture, all of whose coordinates are 0
};

} // namespace

TexturedMesh convertScene(const aiScene& scene, const ModelSource& source,
                          const SceneMeaning& meaning, QStringList& warnings,
                          const Progress& progress) {
    TexturedMesh model;
    TriangleReader(scene, source, meaning, model, warnings, progress).readAll();
    return model;
}

} // namespace dipwright
