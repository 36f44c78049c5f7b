#include "TurtleShape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dipwright::samples {

using Eigen::Vector2f;
using Eigen::Vector3f;

namespace {

const std::array<Part, 8> limbs{{
    {{0, 30}, 0, 13, 7, 7.5F, 7},        // neck
    {{0, 44}, 0, 12.5F, 9.5F, 10, 8},    // head
    {{0, -37}, 0, 15, 4, 4, 4},          // tail
    {{18, 20}, 1.3F, 14, 8, 6, 5.5F},    // fore flipper: arm
    {{27, 16}, 2.1F, 12.5F, 6, 5, 4.5F}, // fore flipper: hand
    {{17, -33}, 2.25F, 14, 6, 5, 4.5F},  // hind flipper
    {{0, -24}, 1.5708F, 15, 8, 6, 6},    // hips
    {{0, 20}, 1.5708F, 16, 8, 7, 6},     // shoulders
}};

// Returns approximately the distance to the part's surface.
float distance(const Part& part, const Vector3f& place) {
    const Vector2f offset = Vector2f(place.x(), place.z()) - part.centre;
    const float sine = std::sin(part.turned);
    const float cosine = std::cos(part.turned);
    const Vector3f own(offset.x() * cosine - offset.y() * sine, place.y(),
                       offset.x() * sine + offset.y() * cosine);
    const Vector3f radii(part.across, own.y() > 0 ? part.above : part.below, part.along);
    const float level = own.cwiseQuotient(radii).norm();
    const float steepness = own.cwiseQuotient(radii.cwiseProduct(radii)).norm();
    return steepness > 0 ? level * (level - 1) / steepness : -radii.minCoeff();
}

// Returns the smaller of two distances, rounded off where they differ by less than `radius`.
float smoothMinimum(float a, float b, float radius) {
    const float blend = std::max(radius - std::abs(a - b), 0.0F) / radius;
    return std::min(a, b) - blend * blend * radius / 4;
}

} // namespace

const Part turtleShell{{0, -3}, 0, 33.5F, 23, 21.5F, 11};

Vector3f mirrored(const Vector3f& place) {
    return {std::abs(place.x()), place.y(), place.z()};
}

float smoothStep(float from, float to, float value) {
    const float t = std::clamp((value - from) / (to - from), 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

float shellDistance(const Vector3f& place) {
    return distance(turtleShell, place);
}

float limbDistance(const Vector3f& place) {
    float result = distance(limbs[0], mirrored(place));
    for (std::size_t i = 1; i < limbs.size(); ++i) {
        result = smoothMinimum(result, distance(limbs[i], mirrored(place)), 8);
    }
    return result;
}

float turtleField(const Vector3f& place) {
    return smoothMinimum(shellDistance(place), limbDistance(place), 8);
}

float lift(const Vector3f& place) {
    return 3.5F * smoothStep(26, 52, place.z()) - 4.5F * smoothStep(17, 36, std::abs(place.x())) -
           2.5F * smoothStep(-30, -50, place.z()) * smoothStep(4, 16, std::abs(place.x()));
}

} // namespace dipwright::samples
