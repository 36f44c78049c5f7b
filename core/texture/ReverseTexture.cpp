#include "texture/ReverseTexture.h"

#include "base/Error.h"
#include "base/ImageRows.h"
#include "base/WideGamut.h"
#include "parallel/ParallelFor.h"
#include "texture/Bleed.h"
#include "texture/BodyColours.h"
#include "texture/Ink.h"
#include "texture/InkAppearance.h"
#include "texture/ReverseMap.h"
#include "texture/StretchPlane.h"

#include <QCoreApplication>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ReverseTexture)
};

// A film pixel to paint, and its place in the current film piece.
struct Pixel {
    int column = 0;
    int row = 0;
    Eigen::Vector3f weights; // weights of the piece's corners
    float share = 1;         // share of the density that this film gives
};

// Upper limit of the path along the body between two corners of a film triangle, divided by their
// straight distance.
constexpr float alongTheBody = 2;

// Maps pixel columns (or rows) of the image to film cells.
struct CellPlaces {
    std::vector<float> share;    // per pixel: place in its cell, 0 … 1
    std::vector<int> firstPixel; // per cell: its first pixel; a last entry marks the end

    // `cellAt` is the function columnAt() or rowAt() of the film's grid.
    CellPlaces(const solver::FilmGrid& grid, int pixels, int cells,
               double (*cellAt)(const solver::FilmGrid&, double)) {
        share.reserve(std::size_t(pixels));
        for (int pixel = 0; pixel < pixels; ++pixel) {
            const double place = cellAt(grid, (pixel + 0.5) / pixels);
            const int cell = std::min(int(place), cells - 1);
            share.push_back(float(place - cell));
            firstPixel.resize(std::max(firstPixel.size(), std::size_t(cell) + 1), pixel);
        }
        firstPixel.resize(std::size_t(cells) + 1, pixels);
    }
};

// Holds each pixel's tint of white and film stretch in a picture, so that they can be continued
// past the edge like colours.
class AsidePicture {
public:
    // Makes no picture if `isWanted` is false.
    AsidePicture(QSize pixels, bool isWanted) {
        if (isWanted) {
            picture_ = blankImage(pixels, QImage::Format_RGBA8888);
            bits_ = picture_.bits();
        }
    }

    bool isMade() const { return bits_ != nullptr; }
    QImage& picture() { return picture_; }
    void write(int column, int row, float white, float stretch) const {
        unsigned char* const place = bits_ + row * picture_.bytesPerLine() + 4 * column;
        const std::uint16_t code = stretchCode(stretch);
        place[0] = std::uint8_t(std::lround(255 * white));
        place[1] = std::uint8_t(code >> 8);
        place[2] = std::uint8_t(code & 255);
        place[3] = 255;
    }

    // Returns the tints where the film image has colour.
    QImage white(const QImage& image) const {
        const PixelCode code(image);
        QImage tint = blankImage(picture_.size(), QImage::Format_Grayscale8);
        for (int y = 0; y < tint.height(); ++y) {
            const uchar* colour = image.constScanLine(y);
            for (int x = 0; x < tint.width(); ++x, colour += code.bytes()) {
                if (code.alpha(colour) != 0) {
                    tint.scanLine(y)[x] = picture_.constScanLine(y)[4 * x];
                }
            }
        }
        return tint;
    }
    QImage stretch() const {
        QImage plane = unstretched(picture_.size());
        for (int y = 0; y < plane.height(); ++y) {
            const uchar* told = picture_.constScanLine(y);
            auto* const codes = reinterpret_cast<std::uint16_t*>(plane.scanLine(y));
            for (int x = 0; x < plane.width(); ++x, told += 4) {
                codes[x] = told[3] != 0 ? std::uint16_t(told[1] << 8 | told[2]) : codes[x];
            }
        }
        return plane;
    }

private:
    QImage picture_;
    unsigned char* bits_ = nullptr;
};

// What the body shows: colours, the plate of a spot ink, or amounts of ink (InkAppearance.h).
enum class Shown { Colours, Plate, Amounts };

class FilmPainter {
public:
    // `wanted` may be null.
    FilmPainter(const LaidFilm& laid, const ReverseMap& map, const BodyColours& colours,
                Shown shown, const ReverseTextureOptions& options, QImage& image, QImage& wanted,
                const AsidePicture& aside)
        : laid_(laid), grid_(laid.film().grid), map_(map), colours_(colours), ink_(options.ink),
          share_(options.share ? &*options.share : nullptr), mask_(options.mask.get()),
          columns_(grid_, image.width(), grid_.columns - 1, columnAt),
          rows_(grid_, image.height(), grid_.rows - 1, rowAt),
          pixelSize_(float(grid_.width / image.width()), float(grid_.depth / image.height())),
          code_(image), bits_(image.bits()), stride_(image.bytesPerLine()),
          white_(float(options.white)), shown_(shown), growsPlate_(options.ink.compensate),
          passes_(float(options.ink.printedPasses())),
          wantedBits_(wanted.isNull() ? nullptr : wanted.bits()), aside_(aside) {}

    // The result of painting one row of cells.
    struct PaintedRow {
        double shortfall = 0; // mm² of body that become visibly too pale
        // Pixels that stay blank: only the other film gives their colour, or they are masked.
        std::vector<unsigned char*> left;
    };
    PaintedRow paintCells(int row) const {
        PaintedRow painted;
        std::vector<Pixel> pixels;
        for (int column = 0; column + 1 < grid_.columns; ++column) {
            const auto cell =
                std::uint32_t(row) * std::uint32_t(grid_.columns - 1) + std::uint32_t(column);
            for (const std::uint32_t triangle : {2 * cell, 2 * cell + 1}) {
                if (laid_.contact().reaches(triangle)) {
                    collect(column, row, triangle % 2 == 1, pixels);
                    std::erase_if(pixels, [&](const Pixel& pixel) {
                        return !laid_.contact().reaches(triangle, pixel.weights);
                    });
                    leaveMasked(triangle, pixels, painted.left);
                    takeShare(triangle, pixels, painted.left);
                    painted.shortfall += paint(map_.whole(triangle), pixels);
                }
            }
        }
        return painted;
    }

private:
    // Collects the pixels whose centres are in one of a cell's two triangles. A centre on the
    // diagonal, or on the border of two cells, is collected only once.
    void collect(int cellColumn, int cellRow, bool second, std::vector<Pixel>& pixels) const {
        pixels.clear();
        const bool falling = (cellColumn + cellRow) % 2 == 0; // diagonal from the upper left
        const auto c = std::size_t(cellColumn);
        const auto r = std::size_t(cellRow);
        for (int row = rows_.firstPixel[r]; row < rows_.firstPixel[r + 1]; ++row) {
            const float down = rows_.share[std::size_t(row)];
            for (int column = columns_.firstPixel[c]; column < columns_.firstPixel[c + 1];
                 ++column) {
                const float right = columns_.share[std::size_t(column)];
                const bool beyondCut = falling ? down < right : right + down >= 1;
                if (beyondCut == second) {
                    pixels.push_back({column, row, weights(falling, second, right, down)});
                }
            }
        }
    }
    // Returns the weights of a place in a cell, in the corner order of filmTriangles().
    static Eigen::Vector3f weights(bool falling, bool second, float right, float down) {
        if (falling) {
            return second ? Eigen::Vector3f(1 - right, down, right - down)
                          : Eigen::Vector3f(1 - down, down - right, right);
        }
        return second ? Eigen::Vector3f(1 - down, 1 - right, right + down - 1)
                      : Eigen::Vector3f(1 - right - down, down, right);
    }

    // Sets each pixel's share of the colour and removes pixels without a share.
    void takeShare(std::uint32_t triangle, std::vector<Pixel>& pixels,
                   std::vector<unsigned char*>& left) const {
        if (!share_ || pixels.empty()) {
            return;
        }
        const std::optional<float> all = shareOfAll(triangle);
        for (Pixel& pixel : pixels) {
            pixel.share = all ? *all : share_->at(map_.surface({triangle, pixel.weights}));
            if (!(pixel.share > 0)) {
                left.push_back(bytesOf(pixel));
            }
        }
        std::erase_if(pixels, [](const Pixel& pixel) { return !(pixel.share > 0); });
    }
    void leaveMasked(std::uint32_t triangle, std::vector<Pixel>& pixels,
                     std::vector<unsigned char*>& left) const {
        if (mask_) {
            std::erase_if(pixels, [&](const Pixel& pixel) {
                const bool isMasked = mask_->covers(map_.surface({triangle, pixel.weights}));
                if (isMasked) {
                    left.push_back(bytesOf(pixel));
                }
                return isMasked;
            });
        }
    }
    // Returns the share of a whole film triangle if its first corner determines it.
    std::optional<float> shareOfAll(std::uint32_t triangle) const {
        const SurfacePoint& corner = laid_.contact().surface[laid_.triangles()[triangle][0]];
        if (!corner.isValid()) {
            return std::nullopt;
        }
        const Eigen::Matrix3f points = map_.contactPoints(triangle);
        const float size = std::max((points.col(1) - points.col(0)).norm(),
                                    (points.col(2) - points.col(0)).norm());
        return share_->allWithin(alongTheBody * size, corner);
    }
    unsigned char* bytesOf(const Pixel& pixel) const {
        return bits_ + pixel.row * stride_ + code_.bytes() * pixel.column;
    }

    double paint(const FilmPiece& piece, std::span<Pixel> pixels) const {
        if (pixels.empty()) {
            return 0;
        }
        if (pixels.size() == 1) {
            return paintAlone(piece, pixels.front());
        }
        const std::array<SurfacePoint, 3> middles = map_.middles(piece);
        if (const auto linear = map_.linear(piece, middles)) {
            return paintLinear(piece, *linear, pixels);
        }
        const std::array<FilmPiece, 4> children = map_.halved(piece, middles);
        double shortfall = 0;
        for (std::size_t child = 0; child < children.size(); ++child) {
            const auto rest = std::partition(pixels.begin(), pixels.end(), [&](const Pixel& pixel) {
                return FilmPiece::child(pixel.weights) == child;
            });
            const std::span<Pixel> inside(pixels.begin(), rest);
            for (Pixel& pixel : inside) {
                pixel.weights = FilmPiece::childWeights(pixel.weights, child);
            }
            shortfall += paint(children[child], inside);
            pixels = {rest, pixels.end()};
        }
        return shortfall;
    }

    double paintLinear(const FilmPiece& piece, const LinearPiece& linear,
                       std::span<Pixel> pixels) const {
        const BodyTexture* texture = colours_.texture(linear.bodyTriangle);
        if (!texture) {
            return printAll(piece, pixels,
                            [&, plain = colours_.plain(linear.bodyTriangle)](
                                const Eigen::Vector3f&) { return plain; });
        }
        const TextureSteps step = steps(piece, linear);
        const std::uint32_t chart = colours_.appearance().chart[linear.bodyTriangle];
        if (texture->charts &&
            !texture->sampler.isWithin(linear.coordinates, step, *texture->charts, chart)) {
            return printAll(piece, pixels, [&](const Eigen::Vector3f& weights) {
                return texture->sampler.sampleWithin(linear.coordinate(weights), step,
                                                     *texture->charts, chart);
            });
        }
        const TextureFootprint footprint = texture->sampler.footprint(step);
        return printAll(piece, pixels, [&](const Eigen::Vector3f& weights) {
            return texture->sampler.sample(linear.coordinate(weights), footprint);
        });
    }
    // Paints each pixel with the colour that `wanted` returns for the pixel's weights in the piece.
    template <typename Colour>
    double printAll(const FilmPiece& piece, std::span<const Pixel> pixels,
                    const Colour& wanted) const {
        double shortfall = 0;
        for (const Pixel& pixel : pixels) {
            shortfall += print(piece, pixel, wanted(pixel.weights));
        }
        return shortfall;
    }
    TextureSteps steps(const FilmPiece& piece, const LinearPiece& linear) const {
        const Eigen::Vector2f a = pixelPlace(piece, 0);
        Eigen::Matrix2f onFilm;
        onFilm << pixelPlace(piece, 1) - a, pixelPlace(piece, 2) - a;
        Eigen::Matrix2f onTexture;
        onTexture << linear.coordinates[1] - linear.coordinates[0],
            linear.coordinates[2] - linear.coordinates[0];
        return onTexture * onFilm.inverse();
    }
    // Returns the place of a piece's corner on the flat film, in pixels from its middle.
    Eigen::Vector2f pixelPlace(const FilmPiece& piece, std::size_t corner) const {
        const FilmTriangle& points = laid_.triangles()[piece.triangle];
        Eigen::Vector2f place = Eigen::Vector2f::Zero();
        for (int k = 0; k < 3; ++k) {
            place += piece.corners[corner][k] *
                     restPosition(grid_, points[std::size_t(k)]).cwiseQuotient(pixelSize_);
        }
        return place;
    }

    // Paints a single pixel on a texture seam or where the texture is not linear. Uses the mean of
    // four places in the pixel, each mapped to the body.
    double paintAlone(const FilmPiece& piece, const Pixel& pixel) const {
        LinearColour sum = LinearColour::Zero();
        const Eigen::Vector3f centre = filmWeights(piece, pixel.weights);
        const Eigen::Matrix<float, 3, 2> gradient = weightSteps(piece.triangle);
        for (const float down : {-0.25f, 0.25f}) {
            for (const float right : {-0.25f, 0.25f}) {
                Eigen::Vector3f weights = centre + gradient * Eigen::Vector2f(right, down);
                weights = weights.cwiseMax(0);
                weights /= weights.sum();
                sum += colourAt({piece.triangle, weights}, gradient) / 4;
            }
        }
        return print(piece, pixel, sum);
    }
    LinearColour colourAt(const FilmWeights& place,
                          const Eigen::Matrix<float, 3, 2>& gradient) const {
        const SurfacePoint onBody = map_.surface(place);
        const BodyTexture* texture = colours_.texture(onBody.triangle);
        if (!texture) {
            return colours_.plain(onBody.triangle);
        }
        const Eigen::Vector2f coordinate = colours_.appearance().textureCoordinate(onBody);
        const TextureSteps step =
            map_.textureSteps(onBody.triangle, map_.contactPoints(place.triangle) * gradient / 2);
        if (texture->charts) {
            return texture->sampler.sampleWithin(coordinate, step, *texture->charts,
                                                 colours_.appearance().chart[onBody.triangle]);
        }
        return texture->sampler.sample(coordinate, texture->sampler.footprint(step));
    }
    static Eigen::Vector3f filmWeights(const FilmPiece& piece, const Eigen::Vector3f& weights) {
        return weights[0] * piece.corners[0] + weights[1] * piece.corners[1] +
               weights[2] * piece.corners[2];
    }
    // Returns the change of the corner weights of a film triangle for one pixel to the right and
    // one pixel down, as columns.
    Eigen::Matrix<float, 3, 2> weightSteps(std::uint32_t triangle) const {
        const FilmPiece piece = map_.whole(triangle);
        const Eigen::Vector2f a = pixelPlace(piece, 0);
        Eigen::Matrix2f onFilm;
        onFilm << pixelPlace(piece, 1) - a, pixelPlace(piece, 2) - a;
        const Eigen::Matrix2f inverse = onFilm.inverse();
        Eigen::Matrix<float, 3, 2> steps;
        steps << -inverse.colwise().sum(), inverse;
        return steps;
    }

    double print(const FilmPiece& piece, const Pixel& pixel, const LinearColour& wanted) const {
        const float stretch = laid_.areaStretch(piece.triangle, filmWeights(piece, pixel.weights));
        if (shown_ == Shown::Amounts) { // not compensated; alpha is the share of the density
            const long share = std::lround(float(code_.opaque()) * pixel.share);
            code_.write(bytesOf(pixel), wanted, std::max(int(share), 1));
            return 0;
        }
        if (shown_ == Shown::Plate) {
            const float tint =
                (1 - wanted[0]) * pixel.share * (growsPlate_ ? stretch : 1) / passes_;
            code_.write(bytesOf(pixel), LinearColour::Constant(1 - std::min(tint, 1.0f)),
                        code_.opaque());
            return 0;
        }
        const LinearColour shown = ink_.faded(ink_.toned(wanted), pixel.share);
        const InkCompensation::Ink ink = ink_.print(shown, stretch);
        unsigned char* const bytes = bytesOf(pixel);
        code_.write(bytes, ink.colour, code_.opaque());
        if (wantedBits_) {
            code_.write(wantedBits_ + (bytes - bits_), shown, code_.opaque());
        }
        if (aside_.isMade()) {
            aside_.write(pixel.column, pixel.row, ink_.printWhite(white_ * pixel.share, stretch),
                         stretch);
        }
        return ink.fallsShort ? double(pixelSize_.prod() * stretch) : 0;
    }

    const LaidFilm& laid_;
    const solver::FilmGrid& grid_;
    const ReverseMap& map_;
    const BodyColours& colours_;
    InkCompensation ink_;
    const PaintShare* share_; // may be null
    const SurfaceMask* mask_; // may be null
    CellPlaces columns_;
    CellPlaces rows_;
    Eigen::Vector2f pixelSize_; // mm
    PixelCode code_;
    unsigned char* bits_;
    std::ptrdiff_t stride_;
    float white_; // tint of white on the body, 0 … 1
    Shown shown_;
    bool growsPlate_;           // whether plates are printed denser where the film stretches
    float passes_;              // of ink
    unsigned char* wantedBits_; // picture of the wanted colours; null: none
    const AsidePicture& aside_;
};

// Clears the pixels of `picture` that are blank in the film image.
void blankAs(const QImage& image, QImage& picture) {
    const PixelCode code(image);
    for (int y = 0; y < image.height(); ++y) {
        const uchar* from = image.constScanLine(y);
        uchar* to = picture.scanLine(y);
        for (int x = 0; x < image.width(); ++x, from += code.bytes(), to += code.bytes()) {
            if (code.alpha(from) == 0 && code.alpha(to) != 0) {
                std::fill_n(to, code.bytes(), std::uint8_t(0));
            }
        }
    }
}

// Returns the tints of a plate's image, Grayscale8.
QImage tintsOf(const QImage& plate) {
    const PixelCode code(plate);
    QImage tints = blankImage(plate.size(), QImage::Format_Grayscale8);
    for (int y = 0; y < plate.height(); ++y) {
        const uchar* pixel = plate.constScanLine(y);
        for (int x = 0; x < plate.width(); ++x, pixel += code.bytes()) {
            if (code.alpha(pixel) != 0) {
                tints.scanLine(y)[x] = std::uint8_t(std::lround(255 * (1 - code.light(pixel)[0])));
            }
        }
    }
    return tints;
}

// Converts one plane of amounts, as painted, to a plane of InkPlanes.
QImage amountsOf(const QImage& painted, InkPlane plane) {
    const PixelCode code(painted);
    QImage amounts = blankImage(painted.size(), QImage::Format_RGBA8888);
    uchar* const bits = amounts.bits();
    parallelFor(0, painted.height(), [&, stride = amounts.bytesPerLine()](int y) {
        const uchar* from = painted.constScanLine(y);
        uchar* to = bits + y * stride;
        for (int x = 0; x < painted.width(); ++x, from += code.bytes(), to += 4) {
            const int alpha = code.alpha(from);
            if (alpha == 0) {
                continue;
            }
            const LinearColour tint = 1 - code.light(from);
            for (int channel = 0; channel < 3; ++channel) {
                to[channel] = std::uint8_t(std::lround(255 * tint[channel]));
            }
            if (plane == InkPlane::Black) { // pixels with more of other textures have colours
                const int share = (255 * alpha + code.opaque() / 2) / code.opaque();
                to[1] = std::uint8_t(tint[1] < 0.5F ? 0 : std::max(share, 1));
                to[2] = 0;
            }
            to[3] = 255;
        }
    });
    return amounts;
}

// Makes a blank film image.
QImage unprinted(QSize pixels, bool isWide) {
    QImage image = blankImage(pixels, isWide ? QImage::Format_RGBA64 : QImage::Format_RGBA8888);
    if (image.isNull()) {
        throw Error(Text::tr("The film image is too large for this computer's memory; choose a "
                             "lower resolution"),
                    QStringLiteral("%1 × %2").arg(pixels.width()).arg(pixels.height()));
    }
    if (isWide) {
        image.setColorSpace(wideSpace());
    }
    return image;
}

std::vector<FilmPainter::PaintedRow> paintRows(const FilmPainter& painter, int rows,
                                               const Progress& progress) {
    std::vector<FilmPainter::PaintedRow> painted(static_cast<std::size_t>(rows));
    parallelFor(0, rows, [&](int row) {
        progress.cancelToken.throwIfCancelled();
        painted[std::size_t(row)] = painter.paintCells(row);
    });
    return painted;
}

void blankPixels(const std::vector<FilmPainter::PaintedRow>& painted, std::ptrdiff_t bytes) {
    for (const FilmPainter::PaintedRow& row : painted) {
        for (unsigned char* pixel : row.left) {
            std::fill_n(pixel, bytes, std::uint8_t(0));
        }
    }
}

// Reverses everything except the spot inks.
ReverseTexture reversed(const LaidFilm& laid, const BodyColours& colours, Shown shown,
                        const ReverseTextureOptions& options, const Progress& progress) {
    progress(0, Text::tr("Reversing the texture"));
    ReverseTexture result;
    result.image = unprinted(options.pixels, colours.isWide());
    if (options.returnsWanted) {
        result.wanted = unprinted(options.pixels, colours.isWide());
    }
    AsidePicture aside(options.pixels, options.white > 0 || options.returnsWanted);
    const ReverseMap map(laid, colours.appearance(), float(options.tolerance));
    result.seamTriangles = map.seamCount();
    progress(0.1, Text::tr("Reversing the texture"));

    const FilmPainter painter(laid, map, colours, shown, options, result.image, result.wanted,
                              aside);
    const solver::FilmGrid& grid = laid.film().grid;
    const std::vector<FilmPainter::PaintedRow> painted =
        paintRows(painter, grid.rows - 1, progress);
    for (const FilmPainter::PaintedRow& row : painted) {
        result.shortfallArea += row.shortfall;
    }

    progress(0.9, Text::tr("Adding bleed at the edges"));
    const double bleed = options.bleed / (grid.width / options.pixels.width());
    continueColour(result.image, bleed);
    blankPixels(painted, PixelCode(result.image).bytes());
    if (aside.isMade()) {
        continueColour(aside.picture(), bleed);
    }
    if (options.white > 0) {
        result.white = aside.white(result.image);
    }
    if (options.returnsWanted) {
        continueColour(result.wanted, bleed);
        blankAs(result.image, result.wanted);
        result.stretch = aside.stretch();
    }
    progress(1, Text::tr("Reversing the texture"));
    return result;
}

} // namespace

std::shared_ptr<const BodyColours> bodyColours(const SurfaceAppearance& appearance) {
    return std::make_shared<const BodyColours>(appearance);
}

ReverseTexture reverseTexture(const LaidFilm& laid, const SurfaceAppearance& appearance,
                              const ReverseTextureOptions& options, const Progress& progress) {
    return reverseTexture(laid, BodyColours(appearance), options, progress);
}

ReverseTexture reverseTexture(const LaidFilm& laid, const BodyColours& colours,
                              const ReverseTextureOptions& options, const Progress& progress) {
    ReverseTexture result = reversed(laid, colours, Shown::Colours, options, progress);
    ReverseTextureOptions tints = options;
    tints.white = 0;
    tints.returnsWanted = false;
    const SurfaceAppearance& appearance = colours.appearance();
    if (options.returnsWanted && !inkSpaceOf(appearance).isEmpty()) {
        const auto planeOf = [&](InkPlane plane) {
            const SurfaceAppearance shown = inkAppearance(appearance, plane);
            return amountsOf(
                reversed(laid, BodyColours(shown), Shown::Amounts, tints, progress).image, plane);
        };
        result.inks = {planeOf(InkPlane::Colours), planeOf(InkPlane::Black),
                       inkSpaceOf(appearance)};
    }
    for (const SpotAppearance& spot : options.spots) {
        const SurfaceAppearance plate = spot();
        result.spots.push_back(
            tintsOf(reversed(laid, BodyColours(plate), Shown::Plate, tints, progress).image));
    }
    return result;
}

} // namespace dipwright
