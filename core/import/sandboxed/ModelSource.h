// What the readers of the formats are given. Private to this folder.
#pragma once

#include "import/sandboxed/PictureReader.h"
#include "import/trusted/UntrustedFiles.h"
#include "model/TexturedMesh.h"

#include <QByteArrayView>
#include <QStringList>

namespace dipwright {

// A reader fills a TexturedMesh with all triangles in the file's units, unwelded and unchecked but
// with indices that exist, and only the materials in use; it leaves the charts to others.
struct ModelSource {
    QString path;            // of the model file, as the user named it, for messages
    QByteArray bytes;        // what is in it
    UntrustedFiles& files;   // those that it names
    PictureReader& pictures; // of all its pictures
    bool withTextures;       // false: another picture will replace the model's own

    // A picture that the model names; null, and a warning, where it is not there.
    QImage readPicture(const QString& name, QStringList& warnings) const;

    // Throws Error.
    [[noreturn]] void throwDamaged(const QString& reason) const;
    void checkTriangleCount(std::size_t count) const;
};

// Whether what is left behind the last row of a binary file may be further rows, each of so many
// bytes, which its header does not count. Bytes of no meaning are common there; zeros are no row.
bool areFurtherRows(QByteArrayView left, qsizetype rowBytes);

// Texture coordinates of a triangle that has none.
inline std::array<Eigen::Vector2f, 3> noCoordinates() {
    std::array<Eigen::Vector2f, 3> corners;
    corners.fill(Eigen::Vector2f::Constant(std::numeric_limits<float>::quiet_NaN()));
    return corners;
}

} // namespace dipwright
