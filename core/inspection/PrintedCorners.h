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
    // Steps on the body to the next corners to the right and down the sheet, as surface and film
    // run here.
    Eigen::Vector3d right, down;
    bool isDark = false; // whether the square below and to the right is dark
};

// Returns corners of the job's own chessboard (texture/Chessboard.h) with squares of `square` mm on
// a sheet of `sheet` mm, where the film carries them. Includes only corners around which film
// adheres to the body for a quarter of a square. Row by row. Any thread.
std::vector<PrintedCorner> chessboardCorners(const LaidFilm& laid, int dip, QSizeF sheet,
                                             double square);

// Returns the corners of chess squares in the model's own texture, if at least a dozen are side by
// side. They lie in places that one of `dips` paints with a sheet of size `sheet`; the first such
// dip counts. Any thread.
std::vector<PrintedCorner> textureCorners(const TexturedMesh& model,
                                          const std::vector<std::shared_ptr<const LaidFilm>>& dips,
                                          QSizeF sheet);

enum class PartPrint { Chessboard, Texture };
// Returns the corners of all dips of a job whose sheets showed the job's chessboard, or the model's
// texture with its artwork. Pictures of text need a QGuiApplication.
std::vector<PrintedCorner> printedCorners(const Project& project,
                                          const std::vector<std::shared_ptr<const LaidFilm>>& dips,
                                          PartPrint print);

} // namespace dipwright
