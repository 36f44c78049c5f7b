// Finds places in a grey picture where four squares meet. Only this file and RefineCorner use
// OpenCV's pictures. Private to this folder.
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <array>
#include <vector>

class QImage;

namespace dipwright {

// Returns the file's own grey values, 0 … 1. They need not be in linear light: a corner of four
// squares is symmetric, so a brightness curve does not move it.
cv::Mat greyOf(const QImage& picture);
// Returns the picture reduced so that its longer side has `side` pixels. Each new pixel is the mean
// of the pixels that it replaces.
cv::Mat shortened(const cv::Mat& grey, int side);
// The picture itself, then pictures that each have half the size of the previous one.
using GreyLevels = std::vector<cv::Mat>;
GreyLevels levelsOf(const cv::Mat& grey);
// Returns the grey value at a place, interpolated between the pixels' middles. Places are measured
// from the picture's corner. Outside the picture, the value at its edge applies.
double greyAt(const cv::Mat& grey, const Eigen::Vector2d& place);

struct Saddle {
    Eigen::Vector2d place; // to about a pixel
    double strength = 0;   // from 0 to about 0.4 for a sharp corner, at any contrast
    double contrast = 0;   // half the difference between black and white around the place
    // Directions of the two edges that cross there, radians, the second to the left of the first.
    std::array<double, 2> edges{};
};

// Returns the saddles, the strongest first. `blurred` is a grey picture blurred by about a pixel.
std::vector<Saddle> findSaddles(const cv::Mat& blurred);

// Tells whether an edge of a square runs between two places: one side must be dark over the whole
// length.
bool isEdge(const cv::Mat& blurred, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
            double contrast);

} // namespace dipwright
