// What is laid onto a body beside its own texture: pictures, text and repeating patterns, one above
// the other, as in the project file's "artwork". Values; what they look like on a body is
// artwork/PaintArtwork.h's.
#pragma once

#include "base/Units.h"

#include <QColor>
#include <QImage>
#include <QString>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace dipwright {

// What a layer shows. The patterns are made by the program (artwork/Patterns.h) and have no seams.
enum class LayerKind : std::uint8_t { Picture, Text, Carbon, Camouflage, Wood };
bool isPattern(LayerKind kind);

// How a layer comes onto the body.
enum class LayerPlacement : std::uint8_t {
    Decal,    // the surface laid flat round the place: lengths and straight lines are kept
    Plane,    // straight along the axis, onto what faces it
    Cylinder, // round the axis through the place, at the body's mean distance from it
    Box       // from six sides, each face from that which it looks to most
};

// The direction that a projection's axis points to, in the model's coordinates; decals and boxes
// have none.
enum class LayerAxis : std::uint8_t { X, Y, Z, MinusX, MinusY, MinusZ };

// A picture by content: two of one id are equal.
struct ArtworkPicture {
    QString id;   // the sha256 of its pixels, hex; empty: none
    QImage image; // RGBA8888 in sRGB, or wide (base/WideGamut.h)
    bool operator==(const ArtworkPicture& other) const { return id == other.id; }
};
// `image` is in sRGB of any format, or wide.
ArtworkPicture artworkPicture(const QImage& image);

struct ArtworkLayer {
    QString name;
    LayerKind kind = LayerKind::Picture;
    bool visible = true;
    double opacity = 1; // 0 … 1
    ArtworkPicture picture;
    QString text;
    QString font = QStringLiteral("DejaVu Sans"); // of the text, a family's name
    QColor colour = Qt::black;                    // of the text, or the pattern's dark one
    QColor secondColour = Qt::white;              // the pattern's light one
    int seed = 1;                                 // of the pattern
    LayerPlacement placement = LayerPlacement::Decal;
    LayerAxis axis = LayerAxis::Z;
    // Where its middle lies, the point of the model nearest to this, or where the projection's axis
    // passes; model coordinates.
    std::array<Millimetres, 3> place{};
    Degrees turn{0}; // counterclockwise as seen from outside; of a cylinder, about the axis
    // Width and height of the area that it takes: a picture or text is as large as fits in, its
    // proportions kept. Repeats of a projection go on all over the body.
    std::array<Millimetres, 2> size{Millimetres(50), Millimetres(50)};
    Millimetres repeat{0}; // the width of one repeat; 0: shown once
    // The spot ink, as varnish or a colour of its own, that it is printed with, in full tint where
    // it covers all: a plate beside the four inks. Empty: in its colours.
    QString spot = {};
    QColor spotColour{128, 128, 128}; // what the ink looks like where nobody knows its name
    bool spotFirst = false;           // printed before the four inks: it ends up outside them
    bool operator==(const ArtworkLayer&) const = default;
};

// Limits, of the project file too.
inline constexpr std::size_t mostArtworkLayers = 100;
inline constexpr int longestLayerName = 100, longestLayerText = 500, mostSeed = 1'000'000;
inline constexpr int longestSpotName = 60;
inline constexpr std::size_t mostSpots = 8;                       // inks of one artwork
inline constexpr double smallestLayer = 0.1, largestLayer = 5000; // mm
inline constexpr double farthestLayer = 1e5;                      // mm, of a place

struct Artwork {
    // What lies below all layers; none: what the model looks like by itself.
    std::optional<QColor> base;
    std::vector<ArtworkLayer> layers; // from below to above

    bool isEmpty() const { return !base && layers.empty(); }
    // Without what is printed with spot inks.
    Artwork inColours() const;
    // The layers that are printed with a spot ink; nothing below them.
    Artwork inSpot(const QString& spot) const;
    // Of the layers that are shown, from below to above; each once, as its lowest layer has it.
    std::vector<ArtworkLayer> spots() const;
    bool operator==(const Artwork&) const = default;
};

} // namespace dipwright
