// OBJ's material files (.mtl), made such that assimp reads them and survives. Private to this
// folder.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace dipwright {

struct MaterialFile {
    QByteArray bytes;     // for assimp
    QString fault;        // empty where it can be read
    QStringList warnings; // of what is not followed, in sentences for the user
};

// The file of this name from its first material on, without a byte-order mark, and with the words
// for colours in the case in which assimp knows them. Refused is a picture, or a value of
// physically based materials, that belongs to none, at which assimp 5.2.5 crashes or which it drops
// without a word: a picture before the first material, either where there is no material at all.
MaterialFile materialFile(const QByteArray& bytes, const QString& name);

// A text that begins with a byte-order mark as UTF-8 without it, any other as it is.
QByteArray withoutByteOrderMark(const QByteArray& text);

} // namespace dipwright
