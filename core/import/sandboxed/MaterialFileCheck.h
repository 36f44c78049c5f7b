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
using PicturePlacements = std::map<QString, PicturePlacement>; // by name of the material

struct MaterialFile {
    QByteArray bytes;     // for assimp
    QString fault;        // empty if the file can be read
    QStringList warnings; // options that are ignored, in sentences for the user
    PicturePlacements placements;
};

// Returns the file from its first material on, without a byte order mark, and with colour keywords
// in the case that assimp expects. Options before the name of a colour's picture are parsed here
// and blanked out. After -s, -o and -t the format allows one to three numbers. assimp 5.2.5 wants
// three, and then ignores them.
// Reports a fault for a picture, or a value of physically based materials, that belongs to no
// material. assimp 5.2.5 crashes at it or drops it silently. A picture is checked if it is before
// the first material. In a file without materials, such values are checked, too.
MaterialFile materialFile(const QByteArray& bytes, const QString& name);

// Converts a text with a byte order mark to UTF-8 and removes the mark. Returns other texts
// unchanged.
QByteArray withoutByteOrderMark(const QByteArray& text);

} // namespace dipwright
