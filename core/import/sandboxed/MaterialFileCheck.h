// OBJ's material files (.mtl), made such that assimp reads them and survives. Private to this
// folder.
#pragma once

#include <Eigen/Core>
#include <QByteArray>
#include <QString>
#include <QStringList>
#include <map>

namespace dipwright {

// Where a material's picture lies: at the model's texture coordinates, scaled and then moved.
struct PicturePlacement {
    Eigen::Vector2f scale = Eigen::Vector2f::Ones();
    Eigen::Vector2f offset = Eigen::Vector2f::Zero();
    Eigen::Vector2f of(const Eigen::Vector2f& coordinate) const {
        return coordinate.cwiseProduct(scale) + offset;
    }
};
using PicturePlacements = std::map<QString, PicturePlacement>; // by the material's name

struct MaterialFile {
    QByteArray bytes;     // for assimp
    QString fault;        // empty where it can be read
    QStringList warnings; // of what is not followed, in sentences for the user
    PicturePlacements placements;
};

// The file of this name from its first material on, without a byte-order mark, and with the words
// for colours in the case in which assimp knows them. The options before the name of a colour's
// picture are read here and blanked out, as assimp 5.2.5 wants three numbers after -s, -o and -t,
// where the format asks for one to three, and takes none of them. Refused is a picture, or a value
// of physically based materials, that belongs to none, at which assimp 5.2.5 crashes or which it
// drops without a word: a picture before the first material, either where there is no material at
// all.
MaterialFile materialFile(const QByteArray& bytes, const QString& name);

// A text that begins with a byte-order mark as UTF-8 without it, any other as it is.
QByteArray withoutByteOrderMark(const QByteArray& text);

} // namespace dipwright
