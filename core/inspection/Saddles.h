// Places in a grey picture where four squares meet. OpenCV's pictures end here and in RefineCorner.
// Private to this folder.
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <array>
#include <vector>

class QImage;

namespace dipwright {

// Grey values 0 … 1, as the file has them (not in linear light: a corner between four squares looks
// the same from opposite sides, so that no curve of brightness moves it).
cv::Mat greyOf(const QImage& picture);
// The same with its longer side shortened to `side` pixels, each the mean of those it stands for.
cv::Mat shortened(const cv::Mat& grey, int side);
// The picture itself, and on and on the one before at half its size.
using GreyLevels = std::vector<cv::Mat>;
GreyLevels levelsOf(const cv::Mat& grey);
// Between the pixels' middles, at a place counted from the picture's corner; the edge goes on
// outside.
double greyAt(const cv::Mat& grey, const Eigen::Vector2d& place);

struct Saddle {
    Eigen::Vector2d place; // to about a pixel
    double strength = 0;   // 0 … about 0.4 for a sharp corner, whatever its contrast
    double contrast = 0;   // half of black to white round it
    // Directions of the two edges that cross there, radians, the second to the left of the first.
    std::array<double, 2> edges{};
};

// The strongest first. `blurred`: a grey picture that has been blurred by about a pixel.
std::vector<Saddle> findSaddles(const cv::Mat& blurred);

// Whether an edge of a square runs from one place to the other: dark all along on one side.
bool isEdge(const cv::Mat& blurred, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
            double contrast);

} // namespace dipwright
