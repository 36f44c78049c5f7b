// Prepares OBJ material files (.mtl) so that assimp reads them correctly and does not crash.
// Private to this folder.
#pragma once

#include <Eigen/Core>
#include <QByteArray>
#include <QString>
#include <QStringList>
#include <map>

namespace dipwright {

// Placement of a material's picture: texture coordinates are scaled, then shifted.
struct PicturePlacement {
    Eigen::Vector2f scale = Eigen::Vector2f::Ones();
    Eigen::Vector2f offset = Eigen::Vector2f::Zero();
    Eigen::Vector2f of(const Eigen::Vector2f& coordinate) const {
        return coordinate.cwiseProduct(scale) + offset;
    }
};
using PicturePlacements = std::map<QString, PicturePlacement>; // keyed by the material's name

struct MaterialFile {
    QByteArray bytes;     // the prepared file, for assimp
    QString fault;        // empty if the file can be read
    QStringList warnings; // options that are ignored, in sentences for the user
    PicturePlacements placements;
};

// Returns the file from its first material on, without a byte order mark, and with colour keywords
// in the capitals that assimp expects. Options before the name of a colour's picture are parsed
// here and overwritten with blanks. After -s, -o and -t the format allows one to three numbers;
// assimp 5.2.5 expects three, and then ignores them.
// A picture before the first material is always a fault. A value of a physically based material
// (Pr, Pm, …) before the first material is a fault only if the file has no material; otherwise it
// is dropped. assimp 5.2.5 crashes at these lines, or drops them silently.
MaterialFile materialFile(const QByteArray& bytes, const QString& name);

// Converts a text with a byte order mark to UTF-8 and removes the mark. Returns other texts
// unchanged.
QByteArray withoutByteOrderMark(const QByteArray& text);

} // namespace dipwright
