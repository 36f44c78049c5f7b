#include "inspection/Saddles.h"

#include "base/Units.h"

#include <QImage>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace dipwright {

namespace {

constexpr double leastStrength = 0.02;
constexpr double leastContrast = 0.02;
constexpr double saddleBlur = 2;   // pixels
constexpr int strongestWithin = 3; // pixels to each side, less than ringRadius
constexpr int ringRadius = 5;      // pixels; squares must be at least twice as large
constexpr int ringPlaces = 48;
constexpr std::size_t mostSaddles = 20'000;

// Returns −det of the second derivatives over the fourth power of the local contrast. It is 0.4 for
// an ideal corner and about 0 along an edge.
cv::Mat saddleStrength(const cv::Mat& grey) {
    cv::Mat smooth, xx, yy, xy, mean, square;
    cv::GaussianBlur(grey, smooth, {}, saddleBlur);
    cv::Sobel(smooth, xx, CV_32F, 2, 0, 1);
    cv::Sobel(smooth, yy, CV_32F, 0, 2, 1);
    cv::Sobel(smooth, xy, CV_32F, 1, 1, 3, 0.25);
    const cv::Size window(15, 15);
    cv::boxFilter(grey, mean, CV_32F, window);
    cv::boxFilter(grey.mul(grey), square, CV_32F, window);
    const cv::Mat variance = square - mean.mul(mean) + leastContrast * leastContrast;
    cv::Mat strength;
    cv::divide(xy.mul(xy) - xx.mul(yy), variance, strength, std::pow(saddleBlur, 4));
    return strength;
}

// If a corner lies on the boundary between pixels, the pixels beside it are equally strong. Returns
// whether the pixel is the first of them, in the order of rows.
bool isFirstOfEqual(const cv::Mat& strength, int row, int column) {
    const float here = strength.at<float>(row, column);
    for (int y = row - strongestWithin; y <= row; ++y) {
        const int last = y < row ? column + strongestWithin : column - 1;
        for (int x = column - strongestWithin; x <= last; ++x) {
            if (strength.at<float>(y, x) == here) {
                return false;
            }
        }
    }
    return true;
}

// Returns the place of the peak, from parabolas through the pixels beside the strongest.
Eigen::Vector2d peakNear(const cv::Mat& strength, int row, int column) {
    const auto offset = [](double before, double here, double after) {
        const double curvature = before - 2 * here + after;
        return curvature < 0 ? (before - after) / (2 * curvature) : 0;
    };
    const auto at = [&](int y, int x) { return double(strength.at<float>(y, x)); };
    const double here = at(row, column);
    return {column + 0.5 + offset(at(row, column - 1), here, at(row, column + 1)),
            row + 0.5 + offset(at(row - 1, column), here, at(row + 1, column))};
}

struct Ring {
    std::array<double, 4> changes{}; // angles where dark and light change
    double contrast = 0;
};

// Returns none unless there are exactly four changes round the place.
std::optional<Ring> ringRound(const cv::Mat& grey, const Eigen::Vector2d& place) {
    std::array<double, ringPlaces> values{};
    double mean = 0;
    for (int i = 0; i < ringPlaces; ++i) {
        const double angle = 2 * pi * i / ringPlaces;
        values[std::size_t(i)] =
            greyAt(grey, place + ringRadius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
        mean += values[std::size_t(i)] / ringPlaces;
    }
    Ring ring;
    std::size_t found = 0;
    for (std::size_t i = 0; i < ringPlaces; ++i) {
        const double here = values[i] - mean, next = values[(i + 1) % ringPlaces] - mean;
        ring.contrast += std::abs(here) / ringPlaces;
        if ((here < 0) != (next < 0)) {
            if (found == 4) {
                return std::nullopt;
            }
            ring.changes[found++] = 2 * pi * (double(i) + here / (here - next)) / ringPlaces;
        }
    }
    return found == 4 && ring.contrast > leastContrast ? std::optional(ring) : std::nullopt;
}

// Finds the two edges. Each joins two opposite changes in a straight line, and the two lines must
// cross at a clear angle.
bool findEdges(const Ring& ring, Saddle& saddle) {
    constexpr double bent = 0.6, leastAngle = 0.3; // radians
    for (std::size_t i = 0; i < 2; ++i) {
        const double turn = ring.changes[i + 2] - ring.changes[i];
        if (std::abs(turn - pi) > bent) {
            return false;
        }
        saddle.edges[i] = (ring.changes[i] + ring.changes[i + 2] - pi) / 2;
    }
    const double between = saddle.edges[1] - saddle.edges[0];
    saddle.contrast = ring.contrast;
    return between > leastAngle && between < pi - leastAngle;
}

} // namespace

cv::Mat greyOf(const QImage& picture) {
    const QImage grey = picture.convertToFormat(QImage::Format_Grayscale16);
    const cv::Mat view(grey.height(), grey.width(), CV_16UC1, const_cast<uchar*>(grey.constBits()),
                       std::size_t(grey.bytesPerLine()));
    cv::Mat values;
    view.convertTo(values, CV_32F, 1.0 / 65535);
    return values;
}

cv::Mat shortened(const cv::Mat& grey, int side) {
    const double share = double(side) / std::max(grey.cols, grey.rows);
    if (share >= 1) {
        return grey;
    }
    cv::Mat small;
    const cv::Size size(std::max(1, int(std::lround(grey.cols * share))),
                        std::max(1, int(std::lround(grey.rows * share))));
    cv::resize(grey, small, size, 0, 0, cv::INTER_AREA);
    return small;
}

GreyLevels levelsOf(const cv::Mat& grey) {
    constexpr int least = 64; // pixels of the longer side
    GreyLevels levels{grey};
    for (int side = std::max(grey.cols, grey.rows) / 2; side >= least; side /= 2) {
        levels.push_back(shortened(levels.back(), side));
    }
    return levels;
}

double greyAt(const cv::Mat& grey, const Eigen::Vector2d& place) {
    const double x = std::clamp(place.x() - 0.5, 0.0, grey.cols - 1.0);
    const double y = std::clamp(place.y() - 0.5, 0.0, grey.rows - 1.0);
    const int column = std::min(int(x), std::max(0, grey.cols - 2));
    const int row = std::min(int(y), std::max(0, grey.rows - 2));
    const int right = std::min(column + 1, grey.cols - 1), below = std::min(row + 1, grey.rows - 1);
    const double u = x - column, v = y - row;
    return (1 - v) * ((1 - u) * double(grey.at<float>(row, column)) +
                      u * double(grey.at<float>(row, right))) +
           v * ((1 - u) * double(grey.at<float>(below, column)) +
                u * double(grey.at<float>(below, right)));
}

std::vector<Saddle> findSaddles(const cv::Mat& blurred) {
    const cv::Mat strength = saddleStrength(blurred);
    cv::Mat highest;
    constexpr int side = 2 * strongestWithin + 1;
    cv::dilate(strength, highest, cv::getStructuringElement(cv::MORPH_RECT, {side, side}));
    std::vector<Saddle> saddles;
    for (int row = ringRadius; row < strength.rows - ringRadius; ++row) {
        const auto* line = strength.ptr<float>(row);
        const auto* top = highest.ptr<float>(row);
        for (int column = ringRadius; column < strength.cols - ringRadius; ++column) {
            if (line[column] > float(leastStrength) && line[column] == top[column] &&
                isFirstOfEqual(strength, row, column)) {
                saddles.push_back({peakNear(strength, row, column), double(line[column]), 0, {}});
            }
        }
    }
    std::stable_sort(saddles.begin(), saddles.end(),
                     [](const Saddle& a, const Saddle& b) { return a.strength > b.strength; });
    saddles.resize(std::min(saddles.size(), mostSaddles));
    std::erase_if(saddles, [&](Saddle& saddle) {
        const auto ring = ringRound(blurred, saddle.place);
        return !ring || !findEdges(*ring, saddle);
    });
    return saddles;
}

bool isEdge(const cv::Mat& blurred, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
            double contrast) {
    const Eigen::Vector2d along = to - from;
    const Eigen::Vector2d across =
        Eigen::Vector2d(-along.y(), along.x()) * std::max(0.13, 1.5 / along.norm());
    int side = 0;
    for (const double share : {0.3, 0.4, 0.5, 0.6, 0.7}) {
        const Eigen::Vector2d place = from + share * along;
        const double step = greyAt(blurred, place + across) - greyAt(blurred, place - across);
        const int sign = step > 0 ? 1 : -1;
        if (std::abs(step) < 0.5 * contrast || (side != 0 && sign != side)) {
            return false;
        }
        side = sign;
    }
    return true;
}

} // namespace dipwright
