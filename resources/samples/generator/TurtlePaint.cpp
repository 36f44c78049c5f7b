#include "TurtlePaint.h"

#include "ImplicitSurface.h"
#include "Painting.h"
#include "TurtleShape.h"

#include <cmath>

namespace dipwright::samples {

using Eigen::Vector2f;
using Eigen::Vector3f;

namespace {

struct Colour {
    float red, green, blue;
};

Colour mixed(const Colour& a, const Colour& b, float share) {
    return {a.red + share * (b.red - a.red), a.green + share * (b.green - a.green),
            a.blue + share * (b.blue - a.blue)};
}

constexpr Colour outline{52, 44, 30};

QRgb pixel(const Colour& colour) {
    const auto byte = [](float value) { return int(std::lround(value)); };
    return qRgb(byte(colour.red), byte(colour.green), byte(colour.blue));
}

// Returns a pseudo-random number in 0 … 1 that depends only on x, y and z.
float scattered(int x, int y, int z) {
    auto bits = std::uint32_t(x) * 0x9e3779b1U ^ std::uint32_t(y) * 0x85ebca6bU ^
                std::uint32_t(z) * 0xc2b2ae35U;
    bits = (bits ^ (bits >> 15)) * 0x2c1b3c6dU;
    bits = (bits ^ (bits >> 12)) * 0x297a2d39U;
    return float((bits ^ (bits >> 15)) >> 8) / float(1 << 24);
}

// The nearest seed of a place, and the distance to the border of the seed's cell.
struct CellPlace {
    std::size_t seed = 0;
    float toSeed = 0;   // mm
    float toBorder = 0; // mm
};

CellPlace cellPlace(const std::vector<Vector3f>& seeds, const Vector3f& place) {
    CellPlace result;
    result.toSeed = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        const float length = (seeds[i] - place).norm();
        if (length < result.toSeed) {
            result.toSeed = length;
            result.seed = i;
        }
    }
    result.toBorder = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        if (i != result.seed) {
            const Vector3f across = seeds[i] - seeds[result.seed];
            const Vector3f middle = (seeds[i] + seeds[result.seed]) / 2;
            result.toBorder = std::min(result.toBorder, across.dot(middle - place) / across.norm());
        }
    }
    return result;
}

// Returns the point on the shell above or below the point (x, z) in the plane of the outline.
Vector3f onShell(float x, float z, bool above) {
    const Vector2f offset((x - turtleShell.centre.x()) / turtleShell.across,
                          (z - turtleShell.centre.y()) / turtleShell.along);
    const float height = std::sqrt(std::max(0.0F, 1 - offset.squaredNorm()));
    return {x, height * (above ? turtleShell.above : -turtleShell.below), z};
}

// Returns the seeds of the shell's plates: along the back and beside it.
std::vector<Vector3f> backPlates() {
    std::vector<Vector3f> seeds;
    for (const float z : {23.5F, 11.5F, -3.0F, -17.5F, -30.0F}) {
        seeds.push_back(onShell(0, z, true));
    }
    for (const auto& [x, z] : {std::pair(13.5F, 18.5F), std::pair(17.0F, 4.5F),
                               std::pair(17.0F, -10.5F), std::pair(12.5F, -24.5F)}) {
        seeds.push_back(onShell(x, z, true));
        seeds.push_back(onShell(-x, z, true));
    }
    return seeds;
}

std::vector<Vector3f> bellyPlates() {
    std::vector<Vector3f> seeds;
    for (const float z : {22.0F, 12.0F, 1.0F, -10.5F, -21.5F, -31.0F}) {
        const float x = z > 15 || z < -25 ? 5.0F : 8.0F;
        seeds.push_back(onShell(x, z, false));
        seeds.push_back(onShell(-x, z, false));
    }
    return seeds;
}

// A place around the rim: the number of its plate, counted from the tail, and the distance to the
// plate's next border, mm.
struct RimPlace {
    int plate;
    float toBorder;
};

RimPlace rimPlace(const Vector3f& place) {
    constexpr float count = 24;
    const float angle = std::atan2(place.x() / turtleShell.across,
                                   (place.z() - turtleShell.centre.y()) / turtleShell.along);
    const float turns = angle / (2 * 3.14159265F) * count + count / 2;
    const float within = turns - std::floor(turns);
    const float length = 2 * 3.14159265F * 30 / count;
    return {int(std::floor(turns)), std::min(within, 1 - within) * length};
}

// Returns the colour of a plate: amber in the middle, darker towards the edge, with growth rings
// and a dark border.
Colour plateColour(float toSeed, float toBorder, float size, float shade) {
    const Colour amber{222, 158 + 14 * shade, 74};
    const Colour moss{104 + 14 * shade, 104, 44};
    const float outwards = smoothStep(0.05F, 0.85F, toSeed / (toSeed + toBorder + 0.15F * size));
    Colour colour = mixed(amber, moss, outwards);
    for (const float ring : {1.9F, 3.3F}) {
        const float line = 1 - smoothStep(0.12F, 0.3F, std::abs(toBorder - ring));
        colour = mixed(colour, outline, 0.28F * line);
    }
    return mixed(outline, colour, smoothStep(0.45F, 0.75F, toBorder));
}

Colour rimColour(const Vector3f& place) {
    const RimPlace rim = rimPlace(place);
    const Colour light{206, 150, 76};
    const Colour dark{116, 106, 48};
    const Colour plate = rim.plate % 2 == 0 ? light : mixed(light, dark, 0.55F);
    return mixed(outline, plate, smoothStep(0.35F, 0.6F, rim.toBorder));
}

constexpr float rimTop = 5;    // mm above the outline
constexpr float rimBottom = 3; // mm below it

Colour shellColour(const Vector3f& place) {
    static const std::vector<Vector3f> back = backPlates();
    static const std::vector<Vector3f> belly = bellyPlates();
    const bool above = place.y() > 0;
    const float inwards = above ? place.y() - rimTop : -place.y() - rimBottom;
    const float edge = smoothStep(0.35F, 0.65F, std::abs(inwards));
    if (inwards < 0) {
        return mixed(outline, rimColour(place), edge);
    }
    const CellPlace cell = cellPlace(above ? back : belly, place);
    if (above) {
        const float toBorder = std::min(cell.toBorder, inwards);
        return mixed(outline,
                     plateColour(cell.toSeed, toBorder, 9, scattered(int(cell.seed), 1, 7)), edge);
    }
    const Colour cream{241, 221, 160};
    const Colour straw{226, 194, 116};
    Colour colour = mixed(straw, cream, smoothStep(0.5F, 5, std::min(cell.toBorder, inwards)));
    colour = mixed({150, 112, 58}, colour, smoothStep(0.25F, 0.5F, cell.toBorder));
    return mixed(outline, colour, edge);
}

// Returns dark scales with light skin between them. They are computed from the place in space, so
// that the charts' borders are invisible.
Colour skinColour(const Vector3f& place) {
    constexpr float scale = 4.6F; // mm
    const Vector3f own = mirrored(place) / scale;
    const Eigen::Vector3i home = own.array().floor().cast<int>();
    std::vector<Vector3f> seeds;
    seeds.reserve(27);
    for (int i = 0; i < 27; ++i) {
        const Eigen::Vector3i cell = home + Eigen::Vector3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        const Vector3f jitter(scattered(cell.x(), cell.y(), cell.z()),
                              scattered(cell.y(), cell.z(), cell.x() + 91),
                              scattered(cell.z(), cell.x() + 57, cell.y()));
        seeds.push_back(cell.cast<float>() + 0.15F * Vector3f::Ones() + 0.7F * jitter);
    }
    const CellPlace cell = cellPlace(seeds, own);
    const Colour skin{196, 206, 142};
    const Colour scaleColour =
        mixed({62, 112, 82}, {88, 138, 92}, scattered(int(100 * seeds[cell.seed].x()), 3, 5));
    // On the underside the skin is pale and the scales fade.
    const float below = smoothStep(0.5F, -3.5F, place.y());
    const float isScale = smoothStep(0.35F, 0.65F, cell.toBorder * scale);
    return mixed(mixed(skin, scaleColour, isScale * (1 - 0.85F * below)), {226, 222, 176},
                 0.6F * below);
}

// Projects `place` onto the surface.
Vector3f onSurface(Vector3f place) {
    for (int round = 0; round < 4; ++round) {
        const Vector3f gradient = slope(turtleField, place);
        place -= turtleField(place) / gradient.squaredNorm() * gradient;
    }
    return place;
}

// Paints the face over `colour` if the place is on the head.
Colour withFace(Colour colour, const Vector3f& place) {
    static const Vector3f eye = onSurface({8, 4.4F, 47});
    static const Vector3f glint = onSurface(eye + Vector3f(0, 1.0F, 0.7F));
    const float fromEye = (mirrored(place) - eye).norm();
    const float fromGlint = (mirrored(place) - glint).norm();
    colour = mixed({236, 222, 150}, colour, smoothStep(2.9F, 3.2F, fromEye));
    colour = mixed({24, 22, 20}, colour, smoothStep(2.3F, 2.5F, fromEye));
    colour = mixed({255, 255, 255}, colour, smoothStep(0.75F, 0.95F, fromGlint));
    // The mouth runs around the snout above the outline and rises at both ends.
    const float line = 1.1F + 0.04F * std::pow(std::max(52 - place.z(), 0.0F), 2.0F);
    const float toEnd = std::max(place.z() - 46.5F, 0.0F);
    const float toMouth = std::abs(place.y() - line);
    return mixed({44, 52, 40}, colour,
                 std::max(smoothStep(0.25F, 0.45F, toMouth), 1 - smoothStep(0, 0.5F, toEnd)));
}

// Returns the maker's mark as a mask: 1 where there is ink. The mark is an R, which looks wrong
// when it is mirrored or rotated.
QImage makersMark() {
    QImage image(1000, 1000, QImage::Format_Grayscale8);
    image.fill(Qt::black);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(Qt::white, 42));
    painter.drawEllipse(QPointF(500, 500), 455, 455);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    paintLetters(painter, QPointF(510, 500), 480, QStringLiteral("R"));
    return image;
}

// Paints the mark on the belly and on the middle plate of the back, upright when the head is up.
Colour withMark(const Colour& colour, const Vector3f& place) {
    static const QImage mark = makersMark();
    const bool above = place.y() > 0;
    const float size = above ? 9 : 22; // mm
    const Vector2f centre(0, above ? -3 : 1);
    const float right = above ? -place.x() : place.x(); // seen from outside
    const int x = int(std::floor((0.5F + (right - centre.x()) / size) * float(mark.width())));
    const int y = int(std::floor((0.5F - (place.z() - centre.y()) / size) * float(mark.height())));
    if (!mark.valid(x, y)) {
        return colour;
    }
    const Colour ink = above ? outline : Colour{46, 84, 84};
    return mixed(colour, ink, float(qGray(mark.pixel(x, y))) / 255);
}

// Returns the distance to the edge of the shell, mm; negative where the shell is nearer than the
// limbs. Because it is a distance, the outline that is painted by it has a constant width.
float toShellEdge(const Vector3f& place) {
    const Field difference = [](const Vector3f& at) {
        return shellDistance(at) - limbDistance(at);
    };
    const float value = difference(place);
    return std::abs(value) > 3 ? value : value / slope(difference, place).norm();
}

} // namespace

QRgb turtleColour(const Vector3f& place) {
    const float toEdge = toShellEdge(place);
    const Colour colour =
        toEdge < 0 ? withMark(shellColour(place), place) : withFace(skinColour(place), place);
    return pixel(mixed(outline, colour, smoothStep(0.3F, 0.6F, std::abs(toEdge))));
}

} // namespace dipwright::samples
