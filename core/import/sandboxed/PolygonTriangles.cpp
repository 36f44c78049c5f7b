#include "import/sandboxed/PolygonTriangles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace dipwright {

namespace {

using Points = std::vector<Eigen::Vector3f>;

// Returns twice the area of a triangle of the fan, as a vector along its normal.
Eigen::Vector3d fanArea(const Points& polygon, std::size_t last) {
    const Eigen::Vector3d first = polygon[0].cast<double>();
    return (polygon[last - 1].cast<double>() - first).cross(polygon[last].cast<double>() - first);
}

// Returns twice the polygon's area, as a vector along its normal.
Eigen::Vector3d polygonArea(const Points& polygon) {
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    for (std::size_t last = 2; last < polygon.size(); ++last) {
        area += fanArea(polygon, last);
    }
    return area;
}

// Returns how much rounded coordinates may change an area of the polygon.
double roundingOf(const Points& polygon) {
    constexpr double rounding = 1.0 / (1 << 22); // a few units of a float's last place
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3f& point : polygon) {
        box.extend(point.cast<double>());
    }
    return rounding * box.diagonal().norm() *
           std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

// Cuts off ears: corners whose triangle contains no other corner.
class EarCutter {
public:
    explicit EarCutter(const Points& polygon)
        : rounding_(roundingOf(polygon)), before_(polygon.size()), after_(polygon.size()),
          isEar_(polygon.size()), left_(polygon.size()) {
        const Eigen::Vector3d normal = polygonArea(polygon).normalized();
        const Eigen::Vector3d x = normal.unitOrthogonal(), y = normal.cross(x);
        for (std::size_t corner = 0; corner < polygon.size(); ++corner) {
            const Eigen::Vector3d point = (polygon[corner] - polygon[0]).cast<double>();
            points_.emplace_back(point.dot(x), point.dot(y));
            before_[corner] = (corner + polygon.size() - 1) % polygon.size();
            after_[corner] = (corner + 1) % polygon.size();
        }
    }

    std::optional<std::vector<PolygonTriangle>> cut() {
        // Corners on a straight line are used up by their neighbours' ears if possible, so that no
        // triangle is without area.
        if (!cutEars(Straight::Kept) && !cutEars(Straight::Cut)) {
            return std::nullopt;
        }
        return triangles_;
    }

private:
    enum class Straight { Kept, Cut };

    // Returns whether it has used up the polygon.
    bool cutEars(Straight straight) {
        straight_ = straight;
        std::size_t corner = start_;
        for (std::size_t i = 0; i < left_; ++i, corner = after_[corner]) {
            isEar_[corner] = isEar(corner);
        }
        std::size_t tried = 0;
        while (left_ > 3 && tried <= left_) {
            if (!isEar_[corner]) {
                corner = after_[corner];
                ++tried;
                continue;
            }
            tried = 0;
            corner = cutOff(corner);
        }
        start_ = corner;
        const PolygonTriangle last = triangleAt(corner);
        if (left_ > 3 || area(last) < -rounding_) {
            return false;
        }
        triangles_.push_back(last);
        return true;
    }

    // Returns the corner from which to go on.
    std::size_t cutOff(std::size_t corner) {
        triangles_.push_back(triangleAt(corner));
        const std::size_t before = before_[corner], after = after_[corner];
        after_[before] = after;
        before_[after] = before;
        --left_;
        isEar_[before] = isEar(before);
        isEar_[after] = isEar(after);
        return after;
    }

    PolygonTriangle triangleAt(std::size_t corner) const {
        return {before_[corner], corner, after_[corner]};
    }

    // Returns twice the area of a triangle; negative if it is turned the other way.
    double area(const PolygonTriangle& triangle) const {
        const Eigen::Vector2d u = points_[triangle[1]] - points_[triangle[0]];
        const Eigen::Vector2d v = points_[triangle[2]] - points_[triangle[0]];
        return u.x() * v.y() - u.y() * v.x();
    }

    bool isEar(std::size_t corner) const {
        const PolygonTriangle triangle = triangleAt(corner);
        const double size = area(triangle);
        if (straight_ == Straight::Kept ? size <= rounding_ : size < -rounding_) {
            return false;
        }
        std::size_t other = after_[triangle[2]];
        for (std::size_t i = 3; i < left_; ++i, other = after_[other]) {
            if (contains(triangle, other)) {
                return false;
            }
        }
        return true;
    }

    // Whether a corner lies in a triangle, but not at one of its corners.
    bool contains(const PolygonTriangle& triangle, std::size_t corner) const {
        const auto& [a, b, c] = triangle;
        const double least =
            std::min({area({a, b, corner}), area({b, c, corner}), area({c, a, corner})});
        const auto isHere = [&](std::size_t each) { return points_[each] == points_[corner]; };
        return (straight_ == Straight::Kept ? least >= -rounding_ : least > rounding_) &&
               std::none_of(triangle.begin(), triangle.end(), isHere);
    }

    const double rounding_;
    std::vector<Eigen::Vector2d> points_;     // in the polygon's plane
    std::vector<std::size_t> before_, after_; // neighbours of each corner that is left
    std::vector<char> isEar_;
    std::size_t left_, start_ = 0;
    Straight straight_ = Straight::Kept;
    std::vector<PolygonTriangle> triangles_;
};

} // namespace

bool isFoldedFan(const Points& polygon) {
    const Eigen::Vector3d whole = polygonArea(polygon);
    const double size = whole.norm(), rounding = roundingOf(polygon);
    for (std::size_t last = 2; last < polygon.size(); ++last) {
        const Eigen::Vector3d part = fanArea(polygon, last);
        if (part.dot(whole) < -rounding * size || (size <= rounding && part.norm() > rounding)) {
            return true;
        }
    }
    return false;
}

std::optional<std::vector<PolygonTriangle>> cutPolygon(const Points& polygon) {
    const bool isFlat = polygonArea(polygon).norm() > roundingOf(polygon);
    return isFlat ? EarCutter(polygon).cut() : std::nullopt;
}

} // namespace dipwright
