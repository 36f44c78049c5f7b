// Where the corners between the squares of a printed chessboard are meant to lie on the body.
#pragma once

#include "dip/LaidFilm.h"
#include "model/TexturedMesh.h"

#include <QSizeF>
#include <vector>

namespace dipwright {

struct Project;

// Model places and directions are mm, as the project has the model.
struct PrintedCorner {
    int dip = 0;           // index of the immersion
    Eigen::Vector2d sheet; // mm, as PrintedPlace has it
    Eigen::Vector3d model;
    Eigen::Vector3d outward; // unit normal of the body
    // On the body, to the next corners to the right and down the sheet, as its surface and the film
    // run here.
    Eigen::Vector3d right, down;
    bool isDark = false; // the square right of it and below
};

// Of the job's own chessboard (texture/Chessboard.h) with squares of `square` mm on a sheet of
// `sheet` mm, carried forward by the film as it lies: those corners round which film is on the body
// for a quarter of a square. By rows. Any thread.
std::vector<PrintedCorner> chessboardCorners(const LaidFilm& laid, int dip, QSizeF sheet,
                                             double square);

// The corners of chess squares in the model's own texture, a dozen and more beside each other, in
// places that one of `dips` paints, with sheets of that size: the first that does. Any thread.
std::vector<PrintedCorner> textureCorners(const TexturedMesh& model,
                                          const std::vector<std::shared_ptr<const LaidFilm>>& dips,
                                          QSizeF sheet);

enum class PartPrint { Chessboard, Texture };
// Of all dips of a job, which had the job's chessboard or the model's texture on their sheets, the
// artwork on it. Pictures of text need a QGuiApplication.
std::vector<PrintedCorner> printedCorners(const Project& project,
                                          const std::vector<std::shared_ptr<const LaidFilm>>& dips,
                                          PartPrint print);

} // namespace dipwright
