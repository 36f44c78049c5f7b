// The artwork on a body besides its own texture: layers of pictures, text and repeating patterns,
// as in the project file's "artwork". These are plain values; artwork/PaintArtwork.h computes what
// they look like on a body.
#pragma once

#include "base/Units.h"
#include "settings/UnknownKeys.h"

#include <QColor>
#include <QImage>
#include <QString>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace dipwright {

// What a layer shows. The program generates the patterns (artwork/Patterns.h), which repeat without
// seams.
enum class LayerKind : std::uint8_t { Picture, Text, Carbon, Camouflage, Wood };
bool isPattern(LayerKind kind);

// How a layer is mapped onto the body.
enum class LayerPlacement : std::uint8_t {
    Decal,    // unfolds the surface around the place, which keeps lengths and straight lines
    Plane,    // projects along the axis onto the surface that faces it
    Cylinder, // wraps around the axis through the place, at the body's mean distance from the axis
    Box       // projects from six sides; each face takes the side that it faces most directly
};

// The direction of a projection's axis in the model's coordinates. Decals and boxes do not use it.
enum class LayerAxis : std::uint8_t { X, Y, Z, MinusX, MinusY, MinusZ };

// A picture that is identified by its content: equal ids mean equal pictures.
struct ArtworkPicture {
    QString id;   // SHA-256 of its pixels, hexadecimal; empty: no picture
    QImage image; // RGBA8888 in sRGB, or wide (base/WideGamut.h)
    bool operator==(const ArtworkPicture& other) const { return id == other.id; }
};
// Makes an artwork picture of `image`, which is in sRGB in any format, or wide.
ArtworkPicture artworkPicture(const QImage& image);

struct ArtworkLayer {
    QString name;
    LayerKind kind = LayerKind::Picture;
    bool visible = true;
    double opacity = 1; // 0 … 1
    ArtworkPicture picture;
    QString text;
    QString font = QStringLiteral("DejaVu Sans"); // name of the text's font family
    QColor colour = Qt::black;       // colour of the text, or the pattern's dark colour
    QColor secondColour = Qt::white; // the pattern's light colour
    int seed = 1;                    // for the pattern's random numbers
    LayerPlacement placement = LayerPlacement::Decal;
    LayerAxis axis = LayerAxis::Z;
    // For a decal, the layer's middle is the point of the model nearest to this. For a projection,
    // this is a point on its axis. In model coordinates.
    std::array<Millimetres, 3> place{};
    Degrees turn{0}; // counterclockwise seen from outside; for a cylinder, about its axis
    // Width and height of the layer's area. A picture or text fills it as far as its proportions
    // allow. Repeats of a projection continue over the whole body.
    std::array<Millimetres, 2> size{Millimetres(50), Millimetres(50)};
    Millimetres repeat{0}; // width of one repeat; 0: shown once
    // The spot ink that prints the layer, such as varnish or a special colour. It gets a plate
    // besides the four inks, with full tint where the layer is opaque. Empty: the layer is printed
    // in its colours.
    QString spot = {};
    QColor spotColour{128, 128, 128}; // how the ink looks where its name is unknown
    // Whether the ink is printed before the four inks, so that it lies outside them on the part.
    bool spotFirst = false;
    // The layer shows only on surface with the material of this name. Each face of a CAD model has
    // its own material. Empty: on all surface.
    QString material = {};
    UnknownKeys unknown = {};
    bool operator==(const ArtworkLayer&) const = default;
};

// Limits, also for the project file.
inline constexpr std::size_t mostArtworkLayers = 100;
inline constexpr int longestLayerName = 100, longestLayerText = 500, mostSeed = 1'000'000;
inline constexpr int longestSpotName = 60;
inline constexpr std::size_t mostSpots = 8;                       // spot inks in one artwork
inline constexpr double smallestLayer = 0.1, largestLayer = 5000; // mm

struct Artwork {
    // The colour below all layers. None: the layers lie on the model's own appearance.
    std::optional<QColor> base;
    std::vector<ArtworkLayer> layers; // from bottom to top

    bool isEmpty() const { return !base && layers.empty(); }
    // Returns the layers that colour the part: neither hidden nor printed with spot inks.
    Artwork inColours() const;
    // Returns only the layers that are printed with this spot ink, on white.
    Artwork inSpot(const QString& spot) const;
    // Returns one visible layer for each spot ink, from bottom to top: the lowest layer that uses
    // the ink.
    std::vector<ArtworkLayer> spots() const;
    bool operator==(const Artwork&) const = default;
};

} // namespace dipwright
