#include "inspection/PrintedCorners.h"

#include "artwork/PaintArtwork.h"
#include "base/WideGamut.h"
#include "inspection/CornerGrid.h"
#include "inspection/RefineCorner.h"
#include "project/Project.h"
#include "texture/Chessboard.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace dipwright {

namespace {

constexpr double reach = 0.25; // squares to each side, for the directions of the film

// Tells where the places of a film's sheet lie at the end of the dip.
class SheetOnBody {
public:
    SheetOnBody(const LaidFilm& laid, QSizeF sheet) : laid_(laid), sheet_(sheet) {}

    // Returns where the film adheres to the body, in its pose frame; none if it does not adhere.
    std::optional<SurfacePoint> at(const Eigen::Vector2d& place) const {
        const solver::FilmGrid& grid = laid_.film().grid;
        const Eigen::Vector2d share(place.x() / sheet_.width() + 0.5,
                                    place.y() / sheet_.height() + 0.5);
        if (share.minCoeff() < 0 || share.maxCoeff() > 1) {
            return std::nullopt;
        }
        const double columns = columnAt(grid, share.x()), rows = rowAt(grid, share.y());
        const int column = std::min(int(columns), grid.columns - 2);
        const int row = std::min(int(rows), grid.rows - 2);
        const auto first = std::uint32_t(2 * (row * (grid.columns - 1) + column));
        const Eigen::Vector2f rest(
            float(grid.restX(column) + (columns - column) * grid.spacingX(column)),
            float(grid.restZ(row) + (rows - row) * grid.spacingZ(row)));
        const Eigen::Vector3f one = laid_.weights({rest, first});
        const Eigen::Vector3f other = laid_.weights({rest, first + 1});
        const bool isFirst = one.minCoeff() >= other.minCoeff();
        return onBody(isFirst ? first : first + 1, isFirst ? one : other);
    }

private:
    std::optional<SurfacePoint> onBody(std::uint32_t triangle,
                                       const Eigen::Vector3f& weights) const {
        const FilmContact& contact = laid_.contact();
        if (!contact.reaches(triangle, weights)) {
            return std::nullopt;
        }
        Eigen::Vector3f place = Eigen::Vector3f::Zero();
        for (std::size_t corner = 0; corner < 3; ++corner) {
            place +=
                weights[Eigen::Index(corner)] * contact.places[laid_.triangles()[triangle][corner]];
        }
        const SurfacePoint point = laid_.body().query.closest(place).point;
        return point.isValid() ? std::optional(point) : std::nullopt;
    }

    const LaidFilm& laid_;
    QSizeF sheet_;
};

// Converts from the pose frame to model coordinates.
struct ToModel {
    const PosedBody& body;
    Eigen::Isometry3d back = body.modelToPose.inverse();

    Eigen::Vector3d place(const SurfacePoint& point) const {
        return back * position(body.mesh, point).cast<double>();
    }
    Eigen::Vector3d outward(const SurfacePoint& point) const {
        return back.linear() * triangleNormal(body.mesh, point.triangle).cast<double>();
    }
};

bool isEven(int number) {
    return number % 2 == 0;
}

// A corner between squares in a texture, in pixels of the texture.
struct TextureCorner {
    Eigen::Vector2d place, right, down;
    bool isDark = false; // whether the square below and to the right is dark
};

// Tells whether the square between `right` and `down` is dark, by comparing the squares at the
// corner.
bool isDarkBetween(const cv::Mat& grey, const TextureCorner& corner) {
    double opposite = 0;
    for (const double right : {-0.25, 0.25}) {
        for (const double down : {-0.25, 0.25}) {
            opposite += (right == down ? 1 : -1) *
                        greyAt(grey, corner.place + right * corner.right + down * corner.down);
        }
    }
    return opposite < 0;
}

std::vector<TextureCorner> cornersIn(const QImage& texture) {
    constexpr int longest = 4096; // texels of the longer side; more do not improve the corners
    const cv::Mat full = greyOf(texture);
    const cv::Mat grey = shortened(full, longest);
    const Eigen::Vector2d scale(double(full.cols) / grey.cols, double(full.rows) / grey.rows);
    cv::Mat blurred;
    cv::GaussianBlur(grey, blurred, {}, 1);
    // The edges of a generated picture are too sharp to be refined; blur does not move corners.
    const GreyLevels levels = levelsOf(blurred);
    std::vector<TextureCorner> corners;
    for (const CornerGrid& grid : findGrids(blurred, findSaddles(blurred))) {
        for (const auto& [at, place] : grid.corners) {
            if (!grid.hasSteps(at)) {
                continue;
            }
            const GridSteps steps = grid.steps(at);
            if (const auto exact =
                    refinedCorner(levels, place, steps.right, steps.down, BoardShape::Flat)) {
                TextureCorner corner{*exact, steps.right, steps.down, false};
                corner.isDark = isDarkBetween(grey, corner);
                for (Eigen::Vector2d* texels : {&corner.place, &corner.right, &corner.down}) {
                    *texels = texels->cwiseProduct(scale);
                }
                corners.push_back(corner);
            }
        }
    }
    return corners;
}

// Finds the places of the model that show a corner of the texture.
class ModelCorners {
public:
    ModelCorners(const TexturedMesh& model, int texture, std::vector<TextureCorner> corners)
        : model_(model), corners_(std::move(corners)), texture_(texture),
          size_(model.textures[std::size_t(texture)].width(),
                model.textures[std::size_t(texture)].height()) {}

    void add(std::uint32_t triangle,
             std::vector<std::pair<SurfacePoint, PrintedCorner>>& to) const {
        if (model_.materials[model_.material[triangle]].texture != texture_ ||
            !model_.hasTextureCoordinates(triangle)) {
            return;
        }
        std::array<Eigen::Vector2d, 3> texels;
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector2d at = model_.textureCoordinates[triangle][i].cast<double>();
            texels[i] = Eigen::Vector2d(at.x(), 1 - at.y()).cwiseProduct(size_);
        }
        Eigen::Matrix2d sides;
        sides << texels[1] - texels[0], texels[2] - texels[0];
        const double area = sides.determinant();
        if (std::abs(area) < 1e-9) {
            return;
        }
        const Eigen::Matrix2d inverse = sides.inverse();
        for (const TextureCorner& corner : corners_) {
            const Eigen::Vector2d weights = inverse * (corner.place - texels[0]);
            if (weights.minCoeff() >= 0 && weights.sum() <= 1) {
                to.emplace_back(placed(triangle, weights), onModel(triangle, corner, inverse));
            }
        }
    }

private:
    static SurfacePoint placed(std::uint32_t triangle, const Eigen::Vector2d& weights) {
        return {triangle,
                Eigen::Vector3d(1 - weights.sum(), weights.x(), weights.y()).cast<float>()};
    }

    PrintedCorner onModel(std::uint32_t triangle, const TextureCorner& corner,
                          const Eigen::Matrix2d& inverse) const {
        const auto& points = model_.mesh.triangles[triangle];
        const auto place = [&](std::size_t i) {
            return model_.mesh.positions[points[i]].cast<double>().eval();
        };
        Eigen::Matrix<double, 3, 2> sides;
        sides << place(1) - place(0), place(2) - place(0);
        PrintedCorner found;
        found.outward = triangleNormal(model_.mesh, triangle).cast<double>();
        found.right = sides * inverse * corner.right;
        found.down = sides * inverse * corner.down;
        found.isDark = corner.isDark;
        return found;
    }

    const TexturedMesh& model_;
    std::vector<TextureCorner> corners_;
    int texture_;
    Eigen::Vector2d size_;
};

} // namespace

std::vector<PrintedCorner> chessboardCorners(const LaidFilm& laid, int dip, QSizeF sheet,
                                             double square) {
    const SheetOnBody film(laid, sheet);
    const ToModel toModel{laid.body()};
    const int columns = int(sheet.width() / 2 / square), rows = int(sheet.height() / 2 / square);
    std::vector<PrintedCorner> corners;
    for (int row = -rows; row <= rows; ++row) {
        for (int column = -columns; column <= columns; ++column) {
            const Eigen::Vector2d place = square * Eigen::Vector2d(column, row);
            const Eigen::Vector2d across(reach * square, 0), along(0, reach * square);
            const auto middle = film.at(place);
            const auto left = film.at(place - across), right = film.at(place + across);
            const auto above = film.at(place - along), below = film.at(place + along);
            if (middle && left && right && above && below) {
                PrintedCorner corner;
                corner.dip = dip;
                corner.sheet = place;
                corner.model = toModel.place(*middle);
                corner.outward = toModel.outward(*middle);
                corner.right = (toModel.place(*right) - toModel.place(*left)) / (2 * reach);
                corner.down = (toModel.place(*below) - toModel.place(*above)) / (2 * reach);
                corner.isDark = isEven(column) == isEven(row);
                corners.push_back(corner);
            }
        }
    }
    return corners;
}

std::vector<PrintedCorner> textureCorners(const TexturedMesh& model,
                                          const std::vector<std::shared_ptr<const LaidFilm>>& dips,
                                          QSizeF sheet) {
    std::vector<std::pair<SurfacePoint, PrintedCorner>> found;
    for (std::size_t texture = 0; texture < model.textures.size(); ++texture) {
        const ModelCorners corners(model, int(texture), cornersIn(inSrgb(model.textures[texture])));
        for (std::uint32_t triangle = 0; triangle < model.mesh.triangles.size(); ++triangle) {
            corners.add(triangle, found);
        }
    }
    std::vector<PrintedCorner> painted;
    for (auto& [point, corner] : found) {
        corner.model = position(model.mesh, point).cast<double>();
        for (std::size_t dip = 0; dip < dips.size(); ++dip) {
            if (const auto place = dips[dip]->place(point)) {
                const solver::FilmGrid& grid = dips[dip]->film().grid;
                corner.dip = int(dip);
                corner.sheet = {double(place->rest.x()) * sheet.width() / grid.width,
                                double(place->rest.y()) * sheet.height() / grid.depth};
                painted.push_back(corner);
                break;
            }
        }
    }
    return painted;
}

std::vector<PrintedCorner> printedCorners(const Project& project,
                                          const std::vector<std::shared_ptr<const LaidFilm>>& dips,
                                          PartPrint print) {
    const QSizeF sheet(project.film.width.value(), project.film.height.value());
    if (print == PartPrint::Texture) {
        const auto model = painted(project.model, project.artwork.inColours(),
                                   texelFor(project.sheet.resolution), {});
        return textureCorners(*model, dips, sheet);
    }
    std::vector<PrintedCorner> corners;
    for (std::size_t dip = 0; dip < dips.size(); ++dip) {
        const auto own = chessboardCorners(*dips[dip], int(dip), sheet, chessSquare);
        corners.insert(corners.end(), own.begin(), own.end());
    }
    return corners;
}

} // namespace dipwright
