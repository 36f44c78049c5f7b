#include "results/PaintedBody.h"

#include "base/WideGamut.h"
#include "parallel/ParallelFor.h"
#include "results/FilmPlaces.h"
#include "texture/Ink.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

const LinearColour bareBody(0.62f, 0.62f, 0.60f);

// Interpolates a film image at places of the film.
class FilmPicture {
public:
    FilmPicture(const QImage& image, const solver::FilmGrid& grid)
        : image_(isWide(image) ? image : image.convertToFormat(QImage::Format_RGBA8888)),
          code_(image_), width_(float(grid.width)), depth_(float(grid.depth)) {}

    // Converts light from the picture's own primaries to sRGB.
    LinearColour inSrgb(const LinearColour& light) const {
        return code_.isWide() ? srgbLight(light) : light;
    }

    struct Paint {
        LinearColour colour = LinearColour::Zero(); // in sums: multiplied by `cover`
        float cover = 0;                            // 0 (unprinted) … 1
    };

    Paint at(const Eigen::Vector2f& rest) const {
        const float x = (rest.x() / width_ + 0.5f) * float(image_.width()) - 0.5f;
        const float y = (rest.y() / depth_ + 0.5f) * float(image_.height()) - 0.5f;
        const int i = int(std::floor(x));
        const int j = int(std::floor(y));
        const float u = x - float(i);
        const float v = y - float(j);
        Paint sum;
        add(sum, i, j, (1 - u) * (1 - v));
        add(sum, i + 1, j, u * (1 - v));
        add(sum, i, j + 1, (1 - u) * v);
        add(sum, i + 1, j + 1, u * v);
        return sum;
    }

private:
    void add(Paint& sum, int column, int row, float weight) const {
        const int i = std::clamp(column, 0, image_.width() - 1);
        const int j = std::clamp(row, 0, image_.height() - 1);
        const uchar* pixel = image_.constScanLine(j) + qsizetype(i) * code_.bytes();
        const float cover = weight * float(code_.alpha(pixel)) / float(code_.opaque());
        sum.colour += cover * code_.light(pixel);
        sum.cover += cover;
    }

    QImage image_;
    PixelCode code_;
    float width_, depth_;
};

} // namespace

// The paint of one dip on the body.
class PaintedFilm {
public:
    PaintedFilm(const FilmAppearance& appearance, const InkSettings& ink, const RefinedMesh* fine,
                double count)
        : laid_(appearance.laid), fine_(fine),
          picture_(appearance.image, appearance.laid->film().grid), ink_(ink),
          isCompensated_(ink.compensate), passes_(float(ink.printedPasses())),
          white_(appearance.white), slip_(appearance.slip),
          highest_(float(appearance.depth + appearance.slip.deeper.value())) {
        if (fine && tablePays(*fine, count)) {
            places_.emplace(*fine, *laid_);
        }
        for (const PrintedSpot& spot : appearance.spots) {
            spots_.push_back({spot.tints, linearColour(spot.colour)});
        }
    }

    // Returns how much of the ground the white layer hides at a place, 0 … 1.
    float whiteAt(const SurfacePoint& point) const {
        const std::optional<FilmPlace> place = white_.isNull() ? std::nullopt : placeOf(point);
        if (!place) {
            return 0;
        }
        const float printed = tintAt(white_, *place);
        return isCompensated_ ? ink_.shownWhite(printed, areaStretch(*place)) : printed;
    }

    // Returns the light that the ink lets through at a place of the body, and the ink's cover.
    FilmPicture::Paint at(const SurfacePoint& point) const {
        const std::optional<FilmPlace> place = placeOf(point);
        if (!place) {
            return {};
        }
        FilmPicture::Paint paint = picture_.at(printedAt(place->rest));
        if (paint.cover > 0) {
            paint.colour /= paint.cover;
            if (isCompensated_) {
                paint.colour = ink_.shown(paint.colour, areaStretch(*place));
            }
            paint.colour = picture_.inSrgb(paint.colour);
        }
        for (const Spot& spot : spots_) {
            throughSpot(paint, spot, *place);
        }
        return paint;
    }

    // Returns the solver::PointMark bits of the film at a place; none if this dip does not paint
    // the place.
    std::optional<std::uint8_t> marks(const SurfacePoint& point) const {
        const std::optional<FilmPlace> place = placeOf(point);
        if (!place || picture_.at(printedAt(place->rest)).cover <= 0) {
            return std::nullopt;
        }
        return laid_->marks(place->triangle);
    }

private:
    struct Spot {
        QImage tints;
        LinearColour light; // light that full tint lets through
    };

    // Adds a spot colour to the paint. Film without ink counts as clear.
    void throughSpot(FilmPicture::Paint& paint, const Spot& spot, const FilmPlace& place) const {
        float tint = tintAt(spot.tints, place);
        if (tint > 0) {
            tint = isCompensated_ ? std::min(1.0f, passes_ * tint / areaStretch(place)) : tint;
            paint.colour = paint.cover * paint.colour + (1 - paint.cover);
            paint.colour *= 1 - tint * (1 - spot.light);
            paint.cover = 1;
        }
    }

    // Returns the printed tint, 0 … 1.
    float tintAt(const QImage& tints, const FilmPlace& place) const {
        const solver::FilmGrid& grid = laid_->film().grid;
        const Eigen::Vector2f at = printedAt(place.rest);
        const auto pixel = [](float share, int count) {
            return std::clamp(int(std::floor(share * float(count))), 0, count - 1);
        };
        const int column = pixel(at.x() / float(grid.width) + 0.5f, tints.width());
        const int row = pixel(at.y() / float(grid.depth) + 0.5f, tints.height());
        return float(tints.constScanLine(row)[column]) / 255;
    }

    // Returns the film on a place of the body; none above the water's highest level.
    std::optional<FilmPlace> placeOf(const SurfacePoint& point) const {
        const SurfacePoint onBody = fine_ ? fine_->onCoarse(point) : point;
        if (position(laid_->body().mesh, onBody).y() > highest_) {
            return std::nullopt;
        }
        return places_ ? places_->at(point) : laid_->place(onBody);
    }
    // Returns the place of the picture that lies at `rest` after the film has slipped.
    Eigen::Vector2f printedAt(const Eigen::Vector2f& rest) const {
        const Eigen::Rotation2Df back(-float(radians(slip_.turn)));
        const Eigen::Vector2f shift(float(slip_.shift[0].value()), float(slip_.shift[1].value()));
        return back * (rest - shift) / float(slip_.swell);
    }
    float areaStretch(const FilmPlace& place) const { return laid_->areaStretch(place); }

    std::shared_ptr<const LaidFilm> laid_;
    const RefinedMesh* fine_;
    std::optional<FilmPlaces> places_;
    FilmPicture picture_;
    InkCompensation ink_;
    bool isCompensated_;
    float passes_;
    QImage white_;
    std::vector<Spot> spots_;
    FilmPlacementError slip_;
    float highest_; // y of the highest wet place, pose frame, mm
};

PaintedBody::PaintedBody(const std::vector<FilmAppearance>& films, const InkSettings& ink,
                         const Ground& ground, const RefinedMesh* fine, double count)
    : whiteOutside_(ground.whiteOutside) {
    if (ground.base) {
        base_ = linearColour(*ground.base);
    }
    for (const FilmAppearance& appearance : films) {
        films_.push_back(std::make_shared<const PaintedFilm>(appearance, ink, fine, count));
    }
}

LinearColour PaintedBody::onBase(const SurfacePoint& point) const {
    LinearColour light = *base_;
    for (const auto& film : films_) {
        const FilmPicture::Paint paint = film->at(point);
        const float white = paint.cover > 0 ? film->whiteAt(point) : 0;
        const auto hidden = [white](const LinearColour& below) -> LinearColour {
            return below + white * (1 - below);
        };
        const LinearColour seen = whiteOutside_ ? hidden(light * paint.colour)
                                                : LinearColour(hidden(light) * paint.colour);
        light = (1 - paint.cover) * light + paint.cover * seen;
    }
    return light;
}

LinearColour PaintedBody::colour(const SurfacePoint& point) const {
    if (base_) {
        return onBase(point);
    }
    LinearColour colour = bareBody;
    LinearColour ink = LinearColour::Ones();
    for (const auto& film : films_) {
        const FilmPicture::Paint paint = film->at(point);
        const LinearColour both = ink * paint.colour;
        colour = (1 - paint.cover) * colour + paint.cover * both;
        ink = (1 - paint.cover) * ink + paint.cover * both;
    }
    return colour;
}

std::optional<std::uint8_t> PaintedBody::marks(const SurfacePoint& point) const {
    for (auto film = films_.rbegin(); film != films_.rend(); ++film) {
        if (const auto marks = (*film)->marks(point)) {
            return marks;
        }
    }
    return std::nullopt;
}

std::vector<QRgb> printedColours(const RefinedMesh& body, const std::vector<FilmAppearance>& films,
                                 const InkSettings& ink, const Ground& ground) {
    const PaintedBody painted(films, ink, ground);
    std::vector<QRgb> colours(body.mesh().triangles.size());
    parallelFor(std::size_t(0), colours.size(), [&](std::size_t triangle) {
        colours[triangle] = encodedPixel(painted.colour(body.middle(triangle)));
    });
    return colours;
}

} // namespace dipwright
