#include "workbench/widgets/HeatScale.h"

#include "film/DippedFilm.h"
#include "results/ColourMap.h"
#include "results/Results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dipwright {

namespace {

constexpr int tableSize = 256;

std::vector<QRgb> colourTable(const QString& map) {
    std::vector<QRgb> table(tableSize);
    for (int entry = 0; entry < tableSize; ++entry) {
        table[std::size_t(entry)] = mapColour(map, double(entry) / (tableSize - 1)).rgb();
    }
    return table;
}

// The place of a pixel in a row or column of values: the index of the value before the pixel, and
// the fraction of the way to the next value.
struct Place {
    int before;
    float past;
};

// `lineAt`: columnAt() or rowAt() of the film's grid, which has `count` lines.
std::vector<Place> placesOf(const solver::FilmGrid& film, int pixels, int count,
                            double (*lineAt)(const solver::FilmGrid&, double)) {
    std::vector<Place> places;
    for (int pixel = 0; pixel < pixels; ++pixel) {
        const double along = lineAt(film, (pixel + 0.5) / pixels);
        const int before = std::min(int(along), count - 2);
        places.push_back({before, float(along - before)});
    }
    return places;
}

} // namespace

QRgb HeatScale::colour(double value) const {
    if (limit && value > *limit) {
        return colourAbove(map).rgb();
    }
    return mapColour(map, std::clamp((value - low) / std::max(1e-9, high - low), 0.0, 1.0)).rgb();
}

HeatScale automaticScale(const HeatScale& scale, const std::vector<float>& values) {
    HeatScale automatic = scale;
    if (values.empty()) {
        return automatic;
    }
    std::vector<float> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const double low = sorted[sorted.size() / 100];
    const double high = sorted[sorted.size() - 1 - sorted.size() / 100];
    automatic.low = std::floor(low * 100) / 100;
    automatic.high = std::max(automatic.low + 0.02, std::ceil(high * 100) / 100);
    return automatic;
}

QImage heatPicture(const std::vector<float>& values, const solver::FilmGrid& film, QSize pixels,
                   const HeatScale& scale) {
    const std::vector<QRgb> table = colourTable(scale.map);
    const float low = float(scale.low);
    const float perValue = float((tableSize - 1) / std::max(1e-9, scale.high - scale.low));
    const QRgb warningColour = colourAbove(scale.map).rgb();
    const float limit = scale.limit ? float(*scale.limit) : std::numeric_limits<float>::infinity();
    const std::vector<Place> across = placesOf(film, pixels.width(), film.columns, columnAt);
    const std::vector<Place> down = placesOf(film, pixels.height(), film.rows, rowAt);
    QImage picture(pixels, QImage::Format_RGB32);
    for (int y = 0; y < pixels.height(); ++y) {
        const auto [row, v] = down[std::size_t(y)];
        const float* upper = &values[std::size_t(row) * std::size_t(film.columns)];
        const float* lower = upper + film.columns;
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (const auto& [column, u] : across) {
            const float above = std::lerp(upper[column], upper[column + 1], u);
            const float below = std::lerp(lower[column], lower[column + 1], u);
            const float value = std::lerp(above, below, v);
            const float entry = std::clamp((value - low) * perValue, 0.0f, float(tableSize - 1));
            *line++ = value > limit ? warningColour : table[std::size_t(entry + 0.5f)];
        }
    }
    return picture;
}

QList<QLineF> isolines(const std::vector<float>& values, const solver::FilmGrid& film,
                       double step) {
    QList<QLineF> lines;
    const int columns = film.columns, rows = film.rows;
    for (int row = 0; row + 1 < rows; ++row) {
        const double top = film.restZ(row) + film.depth / 2, height = film.spacingZ(row);
        for (int column = 0; column + 1 < columns; ++column) {
            const double left = film.restX(column) + film.width / 2, width = film.spacingX(column);
            const std::size_t first = std::size_t(row) * std::size_t(columns) + std::size_t(column);
            // Around the cell: upper left, upper right, lower right, lower left.
            const std::array<double, 4> corner{values[first], values[first + 1],
                                               values[first + std::size_t(columns) + 1],
                                               values[first + std::size_t(columns)]};
            const auto [least, most] = std::minmax_element(corner.begin(), corner.end());
            for (double level = std::ceil(*least / step) * step; level < *most; level += step) {
                std::array<QPointF, 4> crossings;
                std::size_t count = 0;
                constexpr std::array<std::array<double, 2>, 4> place{
                    {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
                for (std::size_t side = 0; side < 4; ++side) {
                    const std::size_t next = (side + 1) % 4;
                    const double from = corner[side] - level, to = corner[next] - level;
                    if ((from < 0) != (to < 0)) {
                        const double share = from / (from - to);
                        crossings[count++] = {
                            left + std::lerp(place[side][0], place[next][0], share) * width,
                            top + std::lerp(place[side][1], place[next][1], share) * height};
                    }
                }
                for (std::size_t pair = 0; pair + 1 < count; pair += 2) {
                    lines.append({crossings[pair], crossings[pair + 1]});
                }
            }
        }
    }
    return lines;
}

} // namespace dipwright
