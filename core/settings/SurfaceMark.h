// Marks on the body's surface: by a stroke of a brush, or around one place. Zones, masks and the
// marks for the seam consist of them.
#pragma once

#include "base/Units.h"
#include "settings/UnknownKeys.h"

#include <QString>
#include <array>
#include <cstdint>
#include <vector>

namespace dipwright {

// A point of a brush stroke.
struct BrushPoint {
    std::array<Millimetres, 3> place{}; // model coordinates
    // Surface normal at the place. The stroke marks only surface that faces it, so that it does not
    // mark the back of a thin wall. 0, 0, 0: the stroke marks all surface near the place.
    std::array<double, 3> outward{};
    bool operator==(const BrushPoint&) const = default;
};
using BrushPath = std::vector<BrushPoint>;

inline constexpr std::size_t mostBrushPoints = 5000;        // of one stroke
inline constexpr std::size_t mostBrushPointsOfAll = 50'000; // of all strokes of one kind

// Largest coordinate of a place in model coordinates, mm: import/trusted/ImportModel.cpp accepts
// edges up to 1e5 mm, and models up to 1e4 of their longest edges from their origin.
inline constexpr double farthestPlace = 1e9;

inline constexpr int longestMaterialName = 200; // in the project file

// How far a mark extends.
enum class MarkExtent : std::uint8_t {
    Spot,     // a radius along the surface around the place
    Face,     // the face that the place lies on
    Material, // all surface with the material of the place
    Stroke,   // all surface within the radius of a path, in a straight line
};

struct SurfaceMark {
    std::array<Millimetres, 3> place{}; // the point of the model nearest to this; model coordinates
    MarkExtent extent = MarkExtent::Spot;
    Millimetres radius{5}; // of a spot or stroke
    BrushPath path = {};   // of a stroke: the points, joined by straight lines
    // With MarkExtent::Material: marks all surface with the material of this name, wherever `place`
    // is. Each face of a CAD model has its own material. Empty: the material at the place.
    QString material = {};
    UnknownKeys unknown = {};
    bool operator==(const SurfaceMark&) const = default;
};

} // namespace dipwright
