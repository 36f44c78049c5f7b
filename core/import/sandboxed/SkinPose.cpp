#include "import/sandboxed/SkinPose.h"

#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <cmath>
#include <string_view>

namespace dipwright {

namespace {

// Returns an FBX node's transform that applies only to its mesh. assimp 5.2.5 puts it into nodes
// directly above.
aiMatrix4x4 geometricTransform(const aiNode& node) {
    aiMatrix4x4 transform;
    for (const aiNode* above = node.mParent; above; above = above->mParent) {
        const std::string_view name = above->mName.C_Str();
        if (name.find("_$AssimpFbx$_Geometric") == name.npos || name.ends_with("Inverse")) {
            break;
        }
        transform = above->mTransformation * transform;
    }
    return transform;
}

} // namespace

PosedMesh SkinPose::pose(const aiMesh& mesh, const std::vector<aiVector3D>& points,
                         const aiNode& node, const aiMatrix4x4& transform) const {
    const aiMatrix4x4 geometric = geometricTransform(node);
    std::vector<float> sums(mesh.mNumVertices); // of the weights
    PosedMesh posed{std::vector<aiVector3D>(mesh.mNumVertices), transform.Determinant() < 0};
    bool mustMove = movesAll_ && mesh.mNumBones > 0;
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const aiBone& bone = *mesh.mBones[b];
        const auto joint = transforms_.find(bone.mName.C_Str());
        if (joint == transforms_.end() || !joint->second) {
            mustMove = true;
            continue;
        }
        const aiMatrix4x4 move = *joint->second * bone.mOffsetMatrix * geometric;
        posed.isMirrored = move.Determinant() < 0;
        for (unsigned w = 0; w < bone.mNumWeights; ++w) {
            const auto [point, weight] = bone.mWeights[w];
            if (point < mesh.mNumVertices) {
                sums[point] += weight;
                posed.points[point] += weight * (move * points[point]);
            }
        }
    }
    constexpr float rounding = 0.02f; // of weights stored as bytes
    for (unsigned point = 0; point < mesh.mNumVertices; ++point) {
        if (std::abs(sums[point] - 1) <= rounding) {
            posed.points[point] /= sums[point];
        } else {
            posed.points[point] = transform * points[point];
            posed.unclear += mustMove || sums[point] != 0 ? 1 : 0;
        }
    }
    return posed;
}

void SkinPose::add(const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 transform = parent * node.mTransformation;
    const auto [known, isNew] = transforms_.try_emplace(node.mName.C_Str(), transform);
    if (!isNew) {
        known->second.reset();
    }
    for (unsigned child = 0; child < node.mNumChildren; ++child) {
        add(*node.mChildren[child], transform);
    }
}

} // namespace dipwright
