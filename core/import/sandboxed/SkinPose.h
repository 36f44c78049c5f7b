// Moves the points of a scene's meshes by their skins, to the pose that the file stores. Private to
// this folder.
#pragma once

#include <assimp/matrix4x4.h>
#include <assimp/vector3.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

struct aiMesh;
struct aiNode;

namespace dipwright {

struct PosedMesh {
    std::vector<aiVector3D> points; // as many as the mesh has
    bool isMirrored = false;        // its triangles face the other way
    std::size_t unclear = 0;        // points with a skin whose weights make no sense, left unmoved
};

class SkinPose {
public:
    // `frame` is the transform of the root's coordinates. `movesAll`: a skin moves all points of
    // its mesh, so a point without weights is unclear.
    SkinPose(const aiNode& root, const aiMatrix4x4& frame, bool movesAll) : movesAll_(movesAll) {
        add(root, frame);
    }

    // Returns the mesh's points after linear blend skinning: Σ weight · joint · offset · geometric
    // transform · point (glTF 2.0, "Skins"; FBX SDK, FbxCluster; only FBX has geometric
    // transforms). `transform` belongs to the mesh's node and applies to points without a skin.
    PosedMesh pose(const aiMesh& mesh, const std::vector<aiVector3D>& points, const aiNode& node,
                   const aiMatrix4x4& transform) const;

private:
    void add(const aiNode& node, const aiMatrix4x4& parent);

    bool movesAll_;
    // Keyed by the node's name, by which meshes refer to joints; nothing if several nodes have it.
    std::map<std::string, std::optional<aiMatrix4x4>> transforms_;
};

} // namespace dipwright
