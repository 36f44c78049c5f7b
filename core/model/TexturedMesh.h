// A body with its texture, as imported. The mesh and its appearance are separate values, so that
// one mesh and everything computed for it serves every appearance.
#pragma once

#include "geometry/TriangleMesh.h"

#include <QColor>
#include <QImage>
#include <QString>

namespace dipwright {

struct Material {
    QString name;
    QColor colour = QColor(200, 200, 200); // colour where the material has no texture
    int texture = -1;                      // index into TexturedMesh::textures; −1: none
};

// The appearance of a mesh's triangles, independent of their positions. Texture coordinates follow
// OBJ: u to the right, v upwards, (0, 0) at the picture's lower left corner; they repeat outside
// [0, 1]. A corner without coordinates holds NaN.
struct SurfaceAppearance {
    std::vector<std::array<Eigen::Vector2f, 3>> textureCoordinates; // for each triangle
    std::vector<std::uint16_t> material;                            // for each triangle
    // The texture chart of each triangle. A chart is a set of triangles connected by shared edges.
    // Across each of these edges the material and the texture coordinates are the same.
    std::vector<std::uint32_t> chart;
    std::vector<Material> materials; // at least one
    std::vector<QImage> textures;    // Format_RGBA8888 in sRGB, or wide (base/WideGamut.h)
    // The amounts of ink of textures whose files are in CMYK (base/InkPicture.h), in the order of
    // the textures; null for others. Empty: no texture has any.
    std::vector<QImage> inks = {};

    bool hasTextureCoordinates(std::size_t triangle) const;
    Eigen::Vector2f textureCoordinate(const SurfacePoint& point) const; // NaN if there is none
};

struct TexturedMesh : SurfaceAppearance {
    TriangleMesh mesh; // welded by position, mm
};

// Computes TexturedMesh::chart from the mesh's own topology.
std::vector<std::uint32_t> findCharts(const TexturedMesh& mesh);

} // namespace dipwright
