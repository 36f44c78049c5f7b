#include "inspection/RefineCorner.h"

#include "inspection/LeastSquares.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dipwright {

namespace {

constexpr double reach = 0.36;    // share of the steps that is used; does not reach the dots
constexpr double farthest = 15;   // pixels to each side that are used
constexpr double mostMoved = 0.7; // how far a corner may move, as a share of `reach` and `farthest`
constexpr std::size_t leastPixels = 30;
constexpr double mostMisfit = 0.2; // root mean square misfit, as a share of the contrast
constexpr Eigen::Index bends = 7;  // index of the first of the two bends
constexpr double bendUnit = 100;   // pixels: a bend of 1 is half the inverse of this radius

struct Window {
    Eigen::Matrix2d inverse;             // maps the window's ellipse to a unit circle
    std::vector<Eigen::Vector2d> places; // relative to the corner's first place
    std::vector<double> values;
};

// Returns the pixels around a corner whose middles lie in the picture of a circle on the board.
Window windowRound(const cv::Mat& grey, const Eigen::Vector2d& place, const Eigen::Vector2d& right,
                   const Eigen::Vector2d& down) {
    Eigen::Matrix2d steps;
    const auto cut = [](const Eigen::Vector2d& step) {
        return Eigen::Vector2d(step * std::min(reach, farthest / step.norm()));
    };
    steps << cut(right), cut(down);
    const Eigen::Vector2d box = steps.cwiseAbs().rowwise().sum();
    Window window{steps.inverse(), {}, {}};
    for (int row = int(place.y() - box.y()); row <= int(place.y() + box.y()); ++row) {
        for (int column = int(place.x() - box.x()); column <= int(place.x() + box.x()); ++column) {
            const Eigen::Vector2d from = Eigen::Vector2d(column + 0.5, row + 0.5) - place;
            const bool isIn = (window.inverse * from).squaredNorm() <= 1;
            if (isIn && row >= 0 && column >= 0 && row < grey.rows && column < grey.cols) {
                window.places.push_back(from);
                window.values.push_back(double(grey.at<float>(row, column)));
            }
        }
    }
    return window;
}

// A corner's model by its parameters: place (2), directions (2), mean, contrast, blur and, on a
// bent board, the bends of the two edges.
class ModelledCorner {
public:
    explicit ModelledCorner(const Eigen::VectorXd& p)
        : place_(p.head<2>()), mean_(p[4]), contrast_(p[5]),
          blur_(p[6]), edges_{edge(p, 0), edge(p, 1)} {}

    double at(const Eigen::Vector2d& place) const {
        const Eigen::Vector2d from = place - place_;
        return mean_ + contrast_ * across(edges_[0], from) * across(edges_[1], from);
    }

private:
    struct Edge {
        double x, y, bend;
    };
    static Edge edge(const Eigen::VectorXd& p, Eigen::Index which) {
        return {std::cos(p[2 + which]), std::sin(p[2 + which]),
                p.size() > bends ? p[bends + which] / bendUnit : 0};
    }
    // Returns a value that changes from −1 on one side of the edge to 1 on the other.
    double across(const Edge& line, const Eigen::Vector2d& from) const {
        const double along = line.x * from.x() + line.y * from.y();
        return std::erf((line.x * from.y() - line.y * from.x() - line.bend * along * along) /
                        blur_);
    }

    Eigen::Vector2d place_;
    double mean_, contrast_, blur_;
    std::array<Edge, 2> edges_;
};

// Returns the first contrast: half the difference between the two light and the two dark quarters,
// with the model's sign.
double firstContrast(const Window& window, const Eigen::VectorXd& start) {
    double sum = 0, weight = 1e-9;
    Eigen::VectorXd one = start;
    one[4] = 0;
    one[5] = 1;
    const ModelledCorner corner(one);
    for (std::size_t i = 0; i < window.values.size(); ++i) {
        const double shape = corner.at(window.places[i]);
        sum += shape * (window.values[i] - start[4]);
        weight += shape * shape;
    }
    return sum / weight;
}

std::optional<Eigen::Vector2d> fittedCorner(const cv::Mat& grey, const Eigen::Vector2d& place,
                                            const Eigen::Vector2d& right,
                                            const Eigen::Vector2d& down, BoardShape shape) {
    const Window window = windowRound(grey, place, right, down);
    if (window.values.size() < leastPixels) {
        return std::nullopt;
    }
    Eigen::VectorXd start(bends);
    double mean = 0;
    for (const double value : window.values) {
        mean += value / double(window.values.size());
    }
    start << 0, 0, std::atan2(right.y(), right.x()), std::atan2(down.y(), down.x()), mean, 0, 1.5;
    start[5] = firstContrast(window, start);
    const Residuals residuals = [&](const Eigen::VectorXd& p, Eigen::VectorXd& values) {
        const ModelledCorner corner(p);
        for (std::size_t i = 0; i < window.values.size(); ++i) {
            values[Eigen::Index(i)] = corner.at(window.places[i]) - window.values[i];
        }
    };
    LeastSquaresFit fit = leastSquares(residuals, int(window.values.size()), start);
    if (shape == BoardShape::Bent) { // starts from the fitted straight edges
        Eigen::VectorXd bent = Eigen::VectorXd::Zero(bends + 2);
        bent.head<bends>() = fit.parameters;
        fit = leastSquares(residuals, int(window.values.size()), bent);
    }
    const Eigen::Vector2d moved = fit.parameters.head<2>();
    const double misfit = std::sqrt(fit.residuals.squaredNorm() / double(window.values.size()));
    const bool isCorner = fit.residuals.allFinite() && fit.determined &&
                          (window.inverse * moved).norm() < mostMoved &&
                          misfit < mostMisfit * std::abs(fit.parameters[5]);
    return isCorner ? std::optional<Eigen::Vector2d>(place + moved) : std::nullopt;
}

} // namespace

std::optional<Eigen::Vector2d> refinedCorner(const GreyLevels& levels, Eigen::Vector2d place,
                                             const Eigen::Vector2d& right,
                                             const Eigen::Vector2d& down, BoardShape shape) {
    std::size_t level = 0;
    for (double step = std::max(right.norm(), down.norm());
         reach * step > farthest && level + 1 < levels.size(); step /= 2) {
        ++level;
    }
    for (;; --level) {
        const cv::Mat& grey = levels[level];
        const Eigen::Vector2d scale(double(grey.cols) / levels.front().cols,
                                    double(grey.rows) / levels.front().rows);
        const auto found = fittedCorner(grey, place.cwiseProduct(scale), right.cwiseProduct(scale),
                                        down.cwiseProduct(scale), shape);
        if (level == 0) {
            return found;
        }
        if (found) { // if not, the next larger picture may succeed: its window shows less around
                     // the corner
            place = found->cwiseQuotient(scale);
        }
    }
}

} // namespace dipwright
