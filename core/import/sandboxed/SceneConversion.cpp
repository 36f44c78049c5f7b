#include "import/sandboxed/SceneConversion.h"

#include "base/Budgets.h"
#include "settings/SurfaceMark.h"

#include <QCoreApplication>

#include <assimp/material.h>
#include <assimp/scene.h>

#include <cmath>
#include <map>

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
    };

    Found find(unsigned sceneMaterial) {
        const auto known = found_.find(sceneMaterial);
        if (known != found_.end()) {
            return known->second;
        }
        requireWithin(Budget::Materials, qint64(model_.materials.size()) + 1, source_.path);
        Found found{std::uint16_t(model_.materials.size()), read(sceneMaterial), {}};
        const auto placed = meaning_.placements.find(model_.materials.back().name);
        if (placed != meaning_.placements.end()) {
            found.placement = placed->second;
        }
        return found_.emplace(sceneMaterial, found).first->second;
    }

private:
    // Adds the material to the model. Returns the channel of its texture coordinates.
    unsigned read(unsigned sceneMaterial) {
        Material& material = model_.materials.emplace_back();
        if (sceneMaterial >= scene_.mNumMaterials) {
            return 0;
        }
        const aiMaterial& source = *scene_.mMaterials[sceneMaterial];
        material.name = QString::fromUtf8(source.GetName().C_Str()).left(longestMaterialName);
        aiColor4D colour;
        if (source.Get(AI_MATKEY_BASE_COLOR, colour) == aiReturn_SUCCESS ||
            source.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == aiReturn_SUCCESS) {
            material.colour = QColor(colourByte(colour.r, meaning_.linearColours),
                                     colourByte(colour.g, meaning_.linearColours),
                                     colourByte(colour.b, meaning_.linearColours));
        }
        for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
            aiString name;
            unsigned channel = 0;
            if (source.GetTexture(type, 0, &name, nullptr, &channel) == aiReturn_SUCCESS) {
                material.texture = source_.withTextures ? textureIndex(name) : -1;
                return channel;
            }
        }
        return 0;
    }

    int textureIndex(const aiString& name) {
        const std::string key = name.C_Str();
        const auto known = textures_.find(key);
        if (known != textures_.end()) {
            return known->second;
        }
        int index = -1;
        if (QImage image = readPicture(name); !image.isNull()) {
            index = int(model_.textures.size());
            model_.textures.push_back(std::move(image));
        }
        return textures_.emplace(key, index).first->second;
    }

    QImage readPicture(const aiString& name) {
        const QString shownName = QString::fromUtf8(name.C_Str());
        if (const aiTexture* embedded = scene_.GetEmbeddedTexture(name.C_Str())) {
            return readEmbedded(*embedded,
                                Text::tr("texture %1 in %2").arg(shownName, source_.path));
        }
        return source_.readPicture(shownName, warnings_);
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
    std::map<std::string, int> textures_;
};

class TriangleReader {
public:
    TriangleReader(const aiScene& scene, const ModelSource& source, const SceneMeaning& meaning,
                   TexturedMesh& model, QStringList& warnings, const Progress& progress)
        : scene_(scene), source_(source), model_(model), warnings_(warnings), progress_(progress),
          materials_(scene, source, meaning, model, warnings) {}

    void readAll() {
        if (!scene_.mRootNode) {
            return;
        }
        count(*scene_.mRootNode);
        model_.mesh.triangles.reserve(total_);
        model_.textureCoordinates.reserve(total_);
        model_.material.reserve(total_);
        readNode(*scene_.mRootNode, aiMatrix4x4());
        if (hasColours_) {
            warnings_.push_back(Text::tr(
                "The model's vertex colours are not used; bake them into a texture to print them"));
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

    void readNode(const aiNode& node, const aiMatrix4x4& parent) {
        const aiMatrix4x4 transform = parent * node.mTransformation;
        for (unsigned m = 0; m < node.mNumMeshes; ++m) {
            progress_(double(model_.mesh.triangles.size()) / double(total_ + 1),
                      Text::tr("Reading triangles"));
            readMesh(*scene_.mMeshes[node.mMeshes[m]], transform);
        }
        for (unsigned child = 0; child < node.mNumChildren; ++child) {
            readNode(*node.mChildren[child], transform);
        }
    }

    void readMesh(const aiMesh& mesh, const aiMatrix4x4& transform) {
        const auto firstPosition = std::uint32_t(model_.mesh.positions.size());
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const aiVector3D position = transform * mesh.mVertices[v];
            model_.mesh.positions.emplace_back(position.x, position.y, position.z);
        }
        const auto [material, channel, placement] = materials_.find(mesh.mMaterialIndex);
        const bool isMirrored = transform.Determinant() < 0;
        const bool hasCoordinates =
            channel < AI_MAX_NUMBER_OF_TEXTURECOORDS && mesh.HasTextureCoords(channel);
        hasColours_ |= mesh.HasVertexColors(0) && model_.materials[material].texture < 0;
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices != 3) { // skip points and lines
                continue;
            }
            std::array<std::uint32_t, 3> corners{face.mIndices[0], face.mIndices[1],
                                                 face.mIndices[2]};
            if (isMirrored) {
                std::swap(corners[1], corners[2]);
            }
            addTriangle(mesh, corners, firstPosition,
                        hasCoordinates ? mesh.mTextureCoords[channel] : nullptr, placement);
            model_.material.push_back(material);
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
                uv[corner] = placement.of(Eigen::Vector2f(coordinate.x, coordinate.y));
            }
        }
    }

    const aiScene& scene_;
    const ModelSource& source_;
    TexturedMesh& model_;
    QStringList& warnings_;
    const Progress& progress_;
    MaterialReader materials_;
    std::size_t total_ = 0;
    bool hasColours_ = false;
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
