#include "import/sandboxed/FbxTextureSets.h"

#include "import/sandboxed/FbxNodes.h"

#include <QHash>
#include <QSet>

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace dipwright {

namespace {

// Returns the number of the set that a material's texture names; nothing if it names none.
std::optional<unsigned> namedSet(const aiMaterial& material) {
    for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
        if (material.GetTextureCount(type) > 0) {
            int set = 0;
            const bool isNamed = material.Get(AI_MATKEY_UVWSRC(type, 0), set) == aiReturn_SUCCESS;
            return isNamed && set >= 0 && set < AI_MAX_NUMBER_OF_TEXTURECOORDS
                       ? std::optional(unsigned(set))
                       : std::nullopt;
        }
    }
    return std::nullopt;
}

QByteArray nameOf(const aiMesh& mesh, unsigned set) {
    const aiString* name = mesh.GetTextureCoordsName(set);
    return name ? QByteArray(name->C_Str(), qsizetype(name->length)) : QByteArray();
}

// Returns the names of the sets that textures name. "default" is the first set.
QSet<QByteArray> namedSets(const FbxNodes& file) {
    constexpr int whole = 5; // the property's name, two types, flags, and the set's name
    QSet<QByteArray> names;
    file.forEach("P", whole, [&](const FbxValues& values, qsizetype) {
        const QByteArray name = values.size() == whole ? values[4] : QByteArray();
        if (values.value(0) == "UVSet" && !name.isEmpty() && name != "default") {
            names.insert(name);
        }
    });
    return names;
}

// Whether each of these sets has the same number in all meshes that have it, and one has it.
bool haveOneNumber(const QSet<QByteArray>& sets, const FbxNodes& file) {
    constexpr qsizetype longest = 256; // bytes up to the end of a set's name
    QHash<QByteArray, QSet<QByteArray>> numbers;
    file.forEach("LayerElementUV", 1, [&](const FbxValues& number, qsizetype at) {
        const FbxNodes set = file.part(at, at + longest);
        bool isFirst = true; // another element may follow
        set.forEach("Name", 1, [&](const FbxValues& name, qsizetype) {
            if (std::exchange(isFirst, false)) {
                numbers[name.value(0)].insert(number.value(0));
            }
        });
    });
    return std::all_of(sets.begin(), sets.end(),
                       [&](const QByteArray& set) { return numbers.value(set).size() == 1; });
}

void exchange(aiMesh& mesh, unsigned set, unsigned other) {
    std::swap(mesh.mTextureCoords[set], mesh.mTextureCoords[other]);
    std::swap(mesh.mNumUVComponents[set], mesh.mNumUVComponents[other]);
    std::swap(mesh.mTextureCoordsNames[set], mesh.mTextureCoordsNames[other]);
}

// Moves the set of this name to this number. Returns whether that was possible.
bool align(aiMesh& mesh, unsigned set, const QByteArray& name) {
    const unsigned count = mesh.GetNumUVChannels();
    for (unsigned each = 0; each < count && set < count; ++each) {
        if (nameOf(mesh, each) == name) {
            if (each != set) {
                exchange(mesh, set, each);
            }
            return true;
        }
    }
    return false;
}

} // namespace

void alignFbxTextureSets(const aiScene& scene, const ModelSource& source, QStringList& warnings) {
    const FbxNodes file(source.bytes);
    const QSet<QByteArray> sets = namedSets(file);
    std::map<unsigned, QByteArray> names; // of the set of each material; empty if it is not clear
    const bool isOneNumber = haveOneNumber(sets, file);
    bool isClear = true;
    for (unsigned m = 0; m < scene.mNumMeshes && !sets.isEmpty(); ++m) {
        aiMesh& mesh = *scene.mMeshes[m];
        const unsigned material = mesh.mMaterialIndex;
        const auto set =
            material < scene.mNumMaterials ? namedSet(*scene.mMaterials[material]) : std::nullopt;
        if (!set) {
            continue;
        }
        QByteArray& name = names[material];
        if (name.isEmpty() && sets.contains(nameOf(mesh, *set))) {
            name = nameOf(mesh, *set);
        }
        if (mesh.GetNumUVChannels() > 1 && (name.isEmpty() || !align(mesh, *set, name))) {
            // assimp does not pass on the names of a mesh with several materials.
            isClear &= !mesh.HasTextureCoordsName(0) && isOneNumber;
        }
    }
    if (!isClear) {
        warnings.push_back(unclearTextureSetWarning());
    }
}

} // namespace dipwright
