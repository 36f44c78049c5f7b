// A body with its texture, as imported: the first value of the line that ends at the printer.
// Where its triangles lie and what they look like are values of their own: one mesh, and all that
// is computed for it, serves every appearance.
#pragma once

#include "geometry/TriangleMesh.h"

#include <QColor>
#include <QImage>
#include <QString>

namespace dipwright {

struct Material {
    QString name;
    QColor colour = QColor(200, 200, 200); // where there is no texture
    int texture = -1;                      // index into TexturedMesh::textures, −1: none
};

// What the triangles of a mesh look like, wherever they lie.
// Texture coordinates follow OBJ: u to the right, v upwards, (0, 0) the picture's lower left
// corner; they repeat outside [0, 1]. A corner without coordinates holds NaN.
struct SurfaceAppearance {
    std::vector<std::array<Eigen::Vector2f, 3>> textureCoordinates; // a triangle each
    std::vector<std::uint16_t> material;                            // a triangle each
    // The texture chart of each triangle: triangles share a chart when a chain of shared edges,
    // with the same texture coordinates on both sides of each and the same material, joins them.
    std::vector<std::uint32_t> chart;
    std::vector<Material> materials; // at least one
    std::vector<QImage> textures;    // Format_RGBA8888 in sRGB, or wide (base/WideGamut.h)

    bool hasTextureCoordinates(std::size_t triangle) const;
    Eigen::Vector2f textureCoordinate(const SurfacePoint& point) const; // NaN where none
};

struct TexturedMesh : SurfaceAppearance {
    TriangleMesh mesh; // welded by position, mm
};

// Computes TexturedMesh::chart from the mesh's own topology.
std::vector<std::uint32_t> findCharts(const TexturedMesh& mesh);

} // namespace dipwright
