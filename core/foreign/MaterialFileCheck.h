// Damage to OBJ's material files (.mtl) that assimp does not survive. Private to this folder.
#pragma once

#include <QByteArray>
#include <QString>

namespace dipwright {

// What is wrong with the file of this name, empty where nothing is: assimp 5.2.5 ends the program
// at a picture, or a value of physically based materials, that belongs to none, because none was
// begun.
QString faultOfMaterials(const QByteArray& bytes, const QString& name);

} // namespace dipwright
