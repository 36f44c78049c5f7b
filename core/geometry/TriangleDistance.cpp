#include "geometry/TriangleDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

Corners inDouble(const std::array<Eigen::Vector3f, 3>& triangle) {
    return {triangle[0].cast<double>(), triangle[1].cast<double>(), triangle[2].cast<double>()};
}

double fraction(double part, double whole) {
    return whole > 0 ? std::clamp(part / whole, 0.0, 1.0) : 0;
}

// Returns the squared distance between the segments from a to b and from c to d (Ericson, Real-Time
// Collision Detection, section 5.1.9).
double segmentDistance(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                       const Eigen::Vector3d& d) {
    const Eigen::Vector3d ab = b - a, cd = d - c, ca = a - c;
    const double abAb = ab.squaredNorm(), cdCd = cd.squaredNorm(), abCd = ab.dot(cd);
    const double abCa = ab.dot(ca), cdCa = cd.dot(ca);
    double onFirst = fraction(abCd * cdCa - abCa * cdCd, abAb * cdCd - abCd * abCd);
    const double onSecond = fraction(abCd * onFirst + cdCa, cdCd);
    onFirst = fraction(abCd * onSecond - abCa, abAb);
    return (ca + onFirst * ab - onSecond * cd).squaredNorm();
}

double cornerDistance(const Eigen::Vector3d& corner, const Corners& triangle) {
    const auto& [a, b, c] = triangle;
    const Eigen::Vector3d weights = closestWeights(corner, a, b, c);
    return (weights[0] * a + weights[1] * b + weights[2] * c - corner).squaredNorm();
}

} // namespace

// Uses the Voronoi regions of the triangle's corners and edges (Ericson, Real-Time Collision
// Detection, section 5.1.5).
Eigen::Vector3d closestWeights(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                               const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const Eigen::Vector3d ab = b - a, ac = c - a;
    const Eigen::Vector3d ap = p - a, bp = p - b, cp = p - c;
    const double abAp = ab.dot(ap), acAp = ac.dot(ap);
    if (abAp <= 0 && acAp <= 0) {
        return {1, 0, 0};
    }
    const double abBp = ab.dot(bp), acBp = ac.dot(bp);
    if (abBp >= 0 && acBp <= abBp) {
        return {0, 1, 0};
    }
    const double abCp = ab.dot(cp), acCp = ac.dot(cp);
    if (acCp >= 0 && abCp <= acCp) {
        return {0, 0, 1};
    }
    const double areaC = abAp * acBp - abBp * acAp;
    if (areaC <= 0 && abAp >= 0 && abBp <= 0) {
        const double along = abAp / (abAp - abBp);
        return {1 - along, along, 0};
    }
    const double areaB = abCp * acAp - abAp * acCp;
    if (areaB <= 0 && acAp >= 0 && acCp <= 0) {
        const double along = acAp / (acAp - acCp);
        return {1 - along, 0, along};
    }
    const double areaA = abBp * acCp - abCp * acBp;
    const double fromB = acBp - abBp, fromC = abCp - acCp;
    if (areaA <= 0 && fromB >= 0 && fromC >= 0) {
        const double along = fromB / (fromB + fromC);
        return {0, 1 - along, along};
    }
    const double area = areaA + areaB + areaC;
    return {areaA / area, areaB / area, areaC / area};
}

double triangleDistance(const std::array<Eigen::Vector3f, 3>& one,
                        const std::array<Eigen::Vector3f, 3>& other) {
    const Corners first = inDouble(one), second = inDouble(other);
    double least = std::numeric_limits<double>::infinity(); // squared
    for (std::size_t k = 0; k < 3; ++k) {
        least =
            std::min({least, cornerDistance(first[k], second), cornerDistance(second[k], first)});
        for (std::size_t j = 0; j < 3; ++j) {
            least = std::min(least, segmentDistance(first[k], first[(k + 1) % 3], second[j],
                                                    second[(j + 1) % 3]));
        }
    }
    return std::sqrt(least);
}

} // namespace dipwright
