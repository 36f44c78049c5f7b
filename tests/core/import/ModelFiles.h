// Small model files in every format, written by the tests themselves.
#pragma once

#include "TestFiles.h"

#include <QByteArray>
#include <QImage>
#include <QString>

#include <vector>

namespace dipwright::test {

// Four colours, one a quarter: red upper left, green upper right, blue lower left, white lower
// right.
QImage quarters(int side = 16);
QByteArray png(const QImage& image);

// A cube of 10 about the origin as OBJ: eight points, each face with the full picture of its own
// (six charts) turned upright; `head` goes before the faces ("mtllib …", "usemtl …").
QByteArray cubeObj(const QByteArray& head = QByteArray());

// The square from (0, 0, 0) to (1, 1, 0), facing +Z, the picture upright on it: the colour seen at
// the upper left is the picture's upper left. In metres, as glTF is; the picture's bytes embedded.
QByteArray squareGltf(const QByteArray& pngBytes);
QByteArray squareGlb(const QByteArray& pngBytes);

// The same square as 3MF with its picture, whose coordinates stand in another order than the
// points, and as PLY that names its picture's file.
void writeSquare3mf(const QString& path, const QByteArray& pngBytes);
QByteArray squarePly(const QByteArray& pictureFile);

// The same square as binary PLY of one quad with coordinates a corner.
QByteArray squareBinaryPly(const QByteArray& pictureFile, bool littleEndian);

// A tetrahedron as assimp writes it: "collada", "3ds", or "fbxa", which is FBX as text.
QByteArray tetrahedron(const char* format);
// The same as FBX in binary, which is what modelling programs write.
QByteArray tetrahedronBinaryFbx();

// A 3MF package with these files.
void write3mf(const QString& path, const std::vector<std::pair<QString, QByteArray>>& files);

} // namespace dipwright::test
