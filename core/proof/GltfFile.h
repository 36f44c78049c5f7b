// Writes glTF 2 files in their binary form (Khronos Group, "glTF 2.0 Specification", 2021).
#pragma once

#include "geometry/TriangleMesh.h"

#include <QByteArray>
#include <QString>
#include <vector>

namespace dipwright {

struct GltfVertex {
    Eigen::Vector3f position, normal;
    Eigen::Vector2f texture; // 0 … 1 from the picture's upper left corner
};

struct GltfMaterial {
    QString key, name;
    QByteArray jpeg;      // its picture
    bool isUnlit = false; // shown without light (KHR_materials_unlit)
};

struct GltfModel {
    QString name;
    std::vector<GltfVertex> vertices;                    // mm
    std::vector<std::array<std::uint32_t, 3>> triangles; // of `vertices`
    std::vector<GltfMaterial> materials; // each also a variant; the first is the default
    bool isClosed = true;                // whether the back of triangles is never seen
};

// Texture coordinates are stored in 16 bits.
QByteArray glb(const GltfModel& model);

} // namespace dipwright
