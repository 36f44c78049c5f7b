// Writes small model files in every format for tests.
#pragma once

#include "TestFiles.h"

#include <QByteArray>
#include <QImage>
#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace dipwright::test {

// Returns a picture of four quarters: red at the upper left, green at the upper right, blue at the
// lower left and white at the lower right.
QImage quarters(int side = 16);
QByteArray png(const QImage& image);

// Returns a cube with edges of length 10 about the origin, as OBJ with eight points. Each face
// shows the full picture upright (six charts). `head` goes before the faces ("mtllib …", "usemtl
// …").
QByteArray cubeObj(const QByteArray& head = QByteArray());

// Returns the square from (0, 0, 0) to (1, 1, 0) as glTF text. It faces +Z, with the embedded
// picture upright on it. Its unit is the metre, as glTF demands.
QByteArray squareGltf(const QByteArray& pngBytes);
// Returns the same square as binary glTF.
QByteArray squareGlb(const QByteArray& pngBytes);

// How skinnedGltf() binds the square to its joints.
struct TestSkin {
    // All nodes, as JSON: first that of the square, then two joints, then others. All are roots.
    QByteArray nodes = R"([{"mesh":0,"skin":0},{},{}])";
    std::array<float, 2> weights{1, 0}; // of the two joints, at each point
    std::optional<float> bindScale = 1; // of both bind matrices; nothing: there are none
    QByteArray scene = "[0,1,2]";       // roots of the scene
    int weightType = 5126;              // componentType of the weights: float
};
// Returns the square as glTF text without a material, with a skin.
QByteArray skinnedGltf(const TestSkin& skin);

// Writes the same square as 3MF. Its texture coordinates are in another order than its points.
void writeSquare3mf(const QString& path, const QByteArray& pngBytes);
// Returns the same square as PLY that names its picture's file.
QByteArray squarePly(const QByteArray& pictureFile);

// Returns the same square as binary PLY: one quad with texture coordinates for each corner.
QByteArray squareBinaryPly(const QByteArray& pictureFile, bool littleEndian);

// Returns a square of 1 m × 1 m as Collada, on which the picture skin.png is upright. The set of
// texture coordinates has the symbol "UVMap". Nothing uses the source "other", whose coordinates
// are all 0.5.
QByteArray squareCollada();
// Returns a plane of 1 × 2 (x, y) as FBX, with the picture skin.png. `property` is one of the
// texture's properties, as a line of the file.
QByteArray texturedFbx(const QByteArray& property);

// Returns a glTF model in another format, as assimp writes it.
QByteArray convertedGltf(const QByteArray& gltf, const char* format);
// Returns a tetrahedron as assimp writes it: as "collada", "3ds", or "fbxa", which is FBX as text.
QByteArray tetrahedron(const char* format);
// Further chunks of a 3DS file; see chunk3ds().
struct Chunks3ds {
    QByteArray texture{}, mesh{}, scene{}, object{};
};
// Returns the same tetrahedron as 3DS with the picture skin.png.
QByteArray textured3ds(const Chunks3ds& further);
// Returns a chunk of a 3DS file.
QByteArray chunk3ds(quint16 kind, const QByteArray& content);
// Returns a chunk that contains one number.
QByteArray chunk3ds(quint16 kind, float number);
// Returns the same tetrahedron as binary FBX, as modelling programs write it. `axes` and `unit`, in
// cm, are stored in its GlobalSettings. `deformPercent` is the weight of a blend shape, and
// `visibility` is 0 for a hidden object.
QByteArray tetrahedronBinaryFbx(const std::vector<std::pair<QByteArray, int>>& axes = {},
                                double unit = 1, double deformPercent = 0, double visibility = 1);

// Writes a 3MF package with these files. Throws std::runtime_error if that fails.
void write3mf(const QString& path, const std::vector<std::pair<QString, QByteArray>>& files);

} // namespace dipwright::test
