// The input of the format readers. Private to this folder.
#pragma once

#include "import/sandboxed/PictureReader.h"
#include "import/trusted/UntrustedFiles.h"
#include "model/TexturedMesh.h"

#include <QByteArrayView>
#include <QStringList>

#include <vector>

namespace dipwright {

// A reader fills a TexturedMesh with all triangles in the file's units, or in mm if the format
// states its unit (namesUnit()), and with the materials in use. The mesh is not welded or checked,
// but its indices are valid. Readers do not fill the charts.
struct ModelSource {
    QString path;            // path of the model file as the user gave it; for messages
    QByteArray bytes;        // content of the model file
    UntrustedFiles& files;   // the files that the model names
    PictureReader& pictures; // decodes all pictures of the model
    bool withTextures;       // false if another picture will replace the model's own

    // Returns a picture that the model names. If it is missing, returns a null image and adds a
    // warning.
    QImage readPicture(const QString& name, QStringList& warnings) const;

    // Throws Error with a sentence that says why the model cannot be read.
    [[noreturn]] void throwDamaged(const QString& reason) const;
    // Throws Error if Budgets.h does not allow this many triangles.
    void checkTriangleCount(std::size_t count) const;
};

// Whether the bytes after the last row of a binary file may be further rows that its header does
// not count. Bytes without meaning are common there. Zero bytes never count as rows.
bool mayBeFurtherRows(QByteArrayView left, qsizetype rowBytes);

// Whether a triangle reaches past the edge of its picture, where the picture repeats. Rounding does
// not count.
bool isPastPicture(const std::array<Eigen::Vector2f, 3>& coordinates);
// The warning for such triangles whose picture should not repeat.
QString notRepeatedWarning();
// The warning for a texture whose set of texture coordinates is not clear.
QString unclearTextureSetWarning();

// Whether a vector, such as a rotation's axis or quaternion, has length 1, but for rounding. With
// another length, assimp's rotations also change the shape.
bool isUnit(const std::vector<double>& numbers);

// Objects with the same fault, reported together.
struct FaultyObjects {
    int count = 0;
    QString first; // name of the first

    void add(const QString& name) { first = count++ == 0 ? name : first; }
    // Adds a sentence whose %1 is the number and %2 the first, unless there are none.
    void warn(QStringList& warnings, const QString& sentence) const;
};
// The warning for transparent materials without a picture.
QString transparentMaterialWarning();
// The sentence for hidden objects: they are read like all others.
QString hiddenObjectsWarning();

// Texture coordinates of a triangle that has none.
inline std::array<Eigen::Vector2f, 3> noCoordinates() {
    std::array<Eigen::Vector2f, 3> corners;
    corners.fill(Eigen::Vector2f::Constant(std::numeric_limits<float>::quiet_NaN()));
    return corners;
}
// Texture coordinates as a file states them. NaN becomes infinite, because NaN means that there are
// none; ImportModel.h reports both infinite and too large ones.
Eigen::Vector2f statedCoordinates(float u, float v);

} // namespace dipwright
