// Tells where the corners between the squares of a printed chessboard should lie on the body.
#pragma once

#include "dip/LaidFilm.h"
#include "model/TexturedMesh.h"

#include <QSizeF>
#include <vector>

namespace dipwright {

struct Project;

// Model places and directions are in mm, in the project's model coordinates.
struct PrintedCorner {
    int dip = 0;           // index of the dip
    Eigen::Vector2d sheet; // mm, like PrintedPlace::sheet
    Eigen::Vector3d model;
    Eigen::Vector3d outward; // unit normal of the body
    // Steps on the body to the next corners on the sheet, rightwards and downwards.
    Eigen::Vector3d right, down;
    bool isDark = false; // whether the square below and to the right is dark
};

// Returns corners of the job's own chessboard (texture/Chessboard.h) with squares of `square` mm on
// a sheet of `sheet` mm, row by row. Includes a corner only if film adheres to the body within 0.25
// squares around it. May be called from any thread.
std::vector<PrintedCorner> chessboardCorners(const LaidFilm& laid, int dip, QSizeF sheet,
                                             double square);

// Returns the corners of chess squares in the model's own texture; empty if fewer than twelve are
// side by side. Includes a corner only if one of `dips` paints it; the first such dip is its `dip`.
// `sheet` is the size of the sheets. May be called from any thread.
std::vector<PrintedCorner> textureCorners(const TexturedMesh& model,
                                          const std::vector<std::shared_ptr<const LaidFilm>>& dips,
                                          QSizeF sheet);

enum class PartPrint { Chessboard, Texture };
// Returns the corners of all dips of a job. `print` says what its sheets show: the chessboard, or
// the model's texture with its artwork. If the artwork contains text, a QGuiApplication is needed.
std::vector<PrintedCorner> printedCorners(const Project& project,
                                          const std::vector<std::shared_ptr<const LaidFilm>>& dips,
                                          PartPrint print);

} // namespace dipwright
