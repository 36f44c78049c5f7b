#include "artwork/LayerPicture.h"

#include "artwork/Patterns.h"
#include "base/WideGamut.h"
#include "parallel/ParallelFor.h"

#include <QFont>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

constexpr float full = 65535;
constexpr int mostPatternPixels = 1024, mostTextPixels = 8192, leastPixels = 64;
constexpr double finer = 2;            // pixels per side of a texel in text and patterns
constexpr double lettersHeight = 1000; // font size at which the outline of a text is made

QPainterPath outlineOf(const ArtworkLayer& layer) {
    QFont font(layer.font);
    font.setPixelSize(int(lettersHeight));
    font.setHintingPreference(QFont::PreferNoHinting);
    QPainterPath path;
    path.setFillRule(Qt::WindingFill); // overlapping letters, as in Arabic, have no gaps
    double line = 0;
    for (const QString& words : layer.text.split(QLatin1Char('\n'))) {
        path.addText(0, line, font, words);
        line += 1.2 * lettersHeight;
    }
    return path;
}

QImage textPicture(const ArtworkLayer& layer, double width, double texel) {
    const QPainterPath path = outlineOf(layer);
    const QRectF box = path.boundingRect();
    if (box.isEmpty()) {
        QImage nothing(1, 1, QImage::Format_RGBA8888);
        nothing.fill(Qt::transparent);
        return nothing;
    }
    const double most = mostTextPixels / std::max(1.0, box.height() / box.width());
    const int across = int(std::clamp(std::ceil(finer * width / texel), double(leastPixels), most));
    const double scale = across / box.width();
    QImage picture(across, std::max(1, int(std::ceil(scale * box.height()))),
                   QImage::Format_RGBA8888);
    QColor clear = layer.colour;
    clear.setAlpha(0);
    picture.fill(clear);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(scale, scale);
    painter.translate(-box.topLeft());
    painter.fillPath(path, layer.colour);
    return picture;
}

QImage pictureOf(const ArtworkLayer& layer, double width, double texel) {
    if (layer.kind == LayerKind::Text) {
        return textPicture(layer, width, texel);
    }
    if (layer.kind == LayerKind::Picture) {
        return layer.picture.image;
    }
    const double pixels = std::ceil(finer * width / texel);
    return patternRepeat(layer,
                         int(std::clamp(pixels, double(leastPixels), double(mostPatternPixels))));
}

// The source pixels that one result pixel covers, and the weight of each.
struct Cover {
    int first = 0;
    std::vector<float> weights; // sum is 1
};

std::vector<Cover> coversOf(int pixels, int fewer) {
    std::vector<Cover> covers(static_cast<std::size_t>(fewer));
    for (int k = 0; k < fewer; ++k) {
        const double begin = double(k) * pixels / fewer, end = double(k + 1) * pixels / fewer;
        Cover& cover = covers[std::size_t(k)];
        cover.first = int(begin);
        for (int pixel = cover.first; pixel < std::min(pixels, int(std::ceil(end))); ++pixel) {
            const double part = std::min(end, pixel + 1.0) - std::max(begin, double(pixel));
            cover.weights.push_back(float(part * fewer / pixels));
        }
    }
    return covers;
}

} // namespace

double proportionsOf(const ArtworkLayer& layer) {
    if (layer.kind == LayerKind::Text) {
        const QRectF box = outlineOf(layer).boundingRect();
        return box.isEmpty() ? 1 : box.width() / box.height();
    }
    if (layer.kind == LayerKind::Picture && !layer.picture.image.isNull()) {
        return double(layer.picture.image.width()) / layer.picture.image.height();
    }
    return 1;
}

LayerPicture::LayerPicture(const ArtworkLayer& layer, double texel, bool wide)
    : repeats_(layer.repeat.value() > 0), texel_(texel),
      area_(layer.size[0].value(), layer.size[1].value()) {
    const double proportions = proportionsOf(layer);
    const double width =
        repeats_ ? layer.repeat.value() : std::min(area_.x(), area_.y() * proportions);
    size_ = {width, width / proportions};
    QImage picture = pictureOf(layer, width, texel);
    if (wide) {
        picture = inWide(picture);
    }
    const auto pixelsFor = [texel](int pixels, double length) {
        return std::clamp(int(std::lround(length / texel)), 1, std::max(pixels, 1));
    };
    columns_ = pixelsFor(picture.width(), size_.x());
    rows_ = pixelsFor(picture.height(), size_.y());
    pixels_.resize(std::size_t(columns_) * std::size_t(rows_));
    const std::vector<Cover> across = coversOf(picture.width(), columns_);
    const std::vector<Cover> down = coversOf(picture.height(), rows_);
    const PixelCode code(picture);
    const QImage& read = picture;
    parallelFor(0, rows_, [&](int row) {
        const Cover& below = down[std::size_t(row)];
        for (int column = 0; column < columns_; ++column) {
            const Cover& beside = across[std::size_t(column)];
            CoveringLight sum = CoveringLight::Zero();
            for (std::size_t r = 0; r < below.weights.size(); ++r) {
                const unsigned char* line = read.constScanLine(below.first + int(r));
                for (std::size_t c = 0; c < beside.weights.size(); ++c) {
                    const unsigned char* at = line + code.bytes() * (beside.first + int(c));
                    const float hidden = float(code.alpha(at)) / float(code.opaque());
                    const LinearColour own = hidden * code.light(at);
                    const CoveringLight light(own[0], own[1], own[2], hidden);
                    sum += below.weights[r] * beside.weights[c] * light;
                }
            }
            auto& pixel = pixels_[std::size_t(row) * std::size_t(columns_) + std::size_t(column)];
            for (std::size_t k = 0; k < 4; ++k) {
                pixel[k] =
                    std::uint16_t(std::lround(std::clamp(sum[Eigen::Index(k)], 0.0f, 1.0f) * full));
            }
        }
    });
}

CoveringLight LayerPicture::pixel(int column, int row) const {
    if (repeats_) {
        column = (column % columns_ + columns_) % columns_;
        row = (row % rows_ + rows_) % rows_;
    } else {
        column = std::clamp(column, 0, columns_ - 1);
        row = std::clamp(row, 0, rows_ - 1);
    }
    const auto& light = pixels_[std::size_t(row) * std::size_t(columns_) + std::size_t(column)];
    return CoveringLight(light[0], light[1], light[2], light[3]) / full;
}

CoveringLight LayerPicture::at(const Eigen::Vector2d& place, bool isEndless) const {
    if (repeats_ && !isEndless &&
        (std::abs(place.x()) > area_.x() / 2 || std::abs(place.y()) > area_.y() / 2)) {
        return CoveringLight::Zero();
    }
    // The edge fades over one texel, however large the picture's own pixels are.
    const Eigen::Array2d inside = (size_ / 2 - place.cwiseAbs()).array() / texel_ + 0.5;
    const double covered = repeats_ ? 1 : inside.max(0).min(1).prod();
    if (covered == 0) {
        return CoveringLight::Zero();
    }
    double u = place.x() / size_.x() + 0.5, v = 0.5 - place.y() / size_.y();
    if (repeats_) {
        u -= std::floor(u);
        v -= std::floor(v);
    }
    const double x = u * columns_ - 0.5, y = v * rows_ - 0.5;
    const int column = int(std::floor(x)), row = int(std::floor(y));
    const auto right = float(x - column), down = float(y - row);
    const CoveringLight above = (1 - right) * pixel(column, row) + right * pixel(column + 1, row);
    const CoveringLight below =
        (1 - right) * pixel(column, row + 1) + right * pixel(column + 1, row + 1);
    return float(covered) * ((1 - down) * above + down * below);
}

} // namespace dipwright
