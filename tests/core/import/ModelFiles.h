// Writes small model files in every format for tests.
#pragma once

#include "TestFiles.h"

#include <QByteArray>
#include <QImage>
#include <QString>

#include <vector>

namespace dipwright::test {

// A picture of four quarters: red upper left, green upper right, blue lower left, white lower
// right.
QImage quarters(int side = 16);
QByteArray png(const QImage& image);

// A cube with edges of 10 about the origin, as OBJ with eight points. Each face shows the full
// picture upright (six charts). `head` goes before the faces ("mtllib …", "usemtl …").
QByteArray cubeObj(const QByteArray& head = QByteArray());

// The square from (0, 0, 0) to (1, 1, 0) that faces +Z with the picture upright on it. Its unit is
// the metre, as glTF demands. The picture is embedded.
QByteArray squareGltf(const QByteArray& pngBytes);
QByteArray squareGlb(const QByteArray& pngBytes);

// The same square as 3MF, whose texture coordinates have another order than its points, and as PLY
// that names its picture's file.
void writeSquare3mf(const QString& path, const QByteArray& pngBytes);
QByteArray squarePly(const QByteArray& pictureFile);

// The same square as binary PLY: one quad with texture coordinates for each corner.
QByteArray squareBinaryPly(const QByteArray& pictureFile, bool littleEndian);

// A tetrahedron as assimp writes it: "collada", "3ds", or "fbxa", which is FBX as text.
QByteArray tetrahedron(const char* format);
// The same tetrahedron as binary FBX, as modelling programs write it.
QByteArray tetrahedronBinaryFbx();

// Writes a 3MF package with these files. Throws std::runtime_error if that fails.
void write3mf(const QString& path, const std::vector<std::pair<QString, QByteArray>>& files);

} // namespace dipwright::test
