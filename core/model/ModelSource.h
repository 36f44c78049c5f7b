// What the readers of the formats are given. Private to this folder.
#pragma once

#include "model/ModelFolder.h"
#include "model/TexturedMesh.h"

#include <QStringList>

namespace dipwright {

// More would fill the memory of any computer that dips are planned on.
inline constexpr std::size_t maximumModelTriangles = 50'000'000;

// A reader fills a TexturedMesh with all triangles in the file's units, unwelded and unchecked but
// with indices that exist, and only the materials in use; it leaves the charts to others.
struct ModelSource {
    QString path;             // of the model file, as the user named it, for messages
    ModelFolder folder;       // where its pictures are
    bool withTextures = true; // false: another picture will replace the model's own

    // A picture that the model names; null, and a warning, where it is not there.
    QImage readPicture(const QString& name, QStringList& warnings) const;

    // Throws Error.
    [[noreturn]] void throwDamaged(const QString& reason) const;
    void checkTriangleCount(std::size_t count) const;
};

// Texture coordinates of a triangle that has none.
inline std::array<Eigen::Vector2f, 3> noCoordinates() {
    std::array<Eigen::Vector2f, 3> corners;
    corners.fill(Eigen::Vector2f::Constant(std::numeric_limits<float>::quiet_NaN()));
    return corners;
}

} // namespace dipwright
