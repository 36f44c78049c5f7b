#include "artwork/Patterns.h"

#include "base/Units.h"
#include "parallel/ParallelFor.h"
#include "texture/LinearLight.h"

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

constexpr int samplesAcross = 3; // samples per side of a pixel

// Returns a pseudo-random number 0 … 1 for a lattice point (Jenkins's mixing, in integers).
double noiseAt(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    std::uint32_t h = x * 0x9e3779b1u ^ y * 0x85ebca77u ^ seed * 0xc2b2ae3du;
    h ^= h >> 15;
    h *= 0x2c1b3c6du;
    h ^= h >> 12;
    h *= 0x297a2d39u;
    h ^= h >> 15;
    return double(h) / 4294967295.0;
}

// Returns smooth noise that repeats after `columns` × `rows` lattice points. x and y are in lattice
// points.
double smoothNoise(double x, double y, int columns, int rows, std::uint32_t seed) {
    const double left = std::floor(x), top = std::floor(y);
    const auto ease = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
    const double right = ease(x - left), down = ease(y - top);
    const auto corner = [&](int across, int below) {
        const auto wrap = [](int k, int count) {
            return std::uint32_t(((k % count) + count) % count);
        };
        return noiseAt(wrap(int(left) + across, columns), wrap(int(top) + below, rows), seed);
    };
    return (1 - down) * ((1 - right) * corner(0, 0) + right * corner(1, 0)) +
           down * ((1 - right) * corner(0, 1) + right * corner(1, 1));
}

// Sums several octaves of smoothNoise(), each twice as fine and half as strong as the one before. x
// and y are in repeats.
double cloud(double x, double y, int columns, int rows, int octaves, std::uint32_t seed) {
    double sum = 0, weight = 0, strength = 1;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += strength *
               smoothNoise(x * columns, y * rows, columns, rows, seed + std::uint32_t(octave));
        weight += strength;
        strength /= 2;
        columns *= 2;
        rows *= 2;
    }
    return sum / weight;
}

// Each pattern returns the lightness at a place of the repeat: 0 is the dark colour, 1 the light
// one. x and y are 0 … 1 to the right and down.

// A 2/2 twill of four threads in each direction. Each thread passes over two threads and then under
// two, shifted by one thread from its neighbour.
double carbon(double x, double y, std::uint32_t seed) {
    constexpr int threads = 4, filaments = 24;
    const int column = std::min(int(x * threads), threads - 1);
    const int row = std::min(int(y * threads), threads - 1);
    const bool isWarp = (column + row) % threads < threads / 2; // the thread runs down
    const double along = isWarp ? y : x;
    const double across = (isWarp ? x : y) * threads;
    const double inThread = across - std::floor(across);
    // Position along the piece of the thread that lies over two others; its middle is lightest.
    double run = along * threads - (isWarp ? -column : threads / 2 - row);
    run -= threads * std::floor(run / threads);
    const double arch = std::sin(pi * std::clamp(run / 2, 0.0, 1.0));
    const double round = 1 - std::pow(std::abs(2 * inThread - 1), 3);
    const double fibre =
        noiseAt(std::uint32_t(int(across * filaments) % (threads * filaments)), isWarp, seed);
    const double shine = isWarp ? 0.35 + 0.65 * arch : 0.12 + 0.45 * arch;
    return std::clamp((0.15 + 0.85 * round) * shine * (0.8 + 0.2 * fibre), 0.0, 1.0);
}

// Blots in four tones; each tone is painted over the earlier tones.
double camouflage(double x, double y, std::uint32_t seed) {
    double tone = 1.0;
    constexpr std::array<double, 3> tones{0.62, 0.28, 0.0};
    constexpr std::array<double, 3> borders{0.5, 0.56, 0.6};
    for (std::size_t blot = 0; blot < tones.size(); ++blot) {
        const auto own = seed + 101 * std::uint32_t(blot + 1);
        const double bend = 0.06 * (cloud(x, y, 6, 6, 2, own + 50) - 0.5);
        if (cloud(x + bend, y - bend, 4, 5, 3, own) > borders[blot]) {
            tone = tones[blot];
        }
    }
    return tone;
}

// Wood grain that runs downwards: lengthwise cut rings, and fine pores.
double wood(double x, double y, std::uint32_t seed) {
    constexpr int rings = 9;
    const double bend = cloud(x, y, 3, 2, 3, seed);
    const double ring = x * rings + 2.2 * bend;
    const double inRing = ring - std::floor(ring);
    // Early wood is light and darkens gradually into late wood, which ends abruptly.
    const double late = std::pow(inRing, 2.2) * (1 - std::pow(inRing, 24));
    const double pores = smoothNoise(x * 160, y * 12, 160, 12, seed + 77);
    const double pore = pores > 0.78 ? 0.18 : 0.0;
    const double shade = 0.12 * (cloud(x, y, 2, 2, 2, seed + 33) - 0.5);
    return std::clamp(0.92 - 0.68 * late - pore + shade, 0.0, 1.0);
}

} // namespace

QImage patternRepeat(const ArtworkLayer& layer, int pixels) {
    const auto lightness = layer.kind == LayerKind::Carbon       ? carbon
                           : layer.kind == LayerKind::Camouflage ? camouflage
                                                                 : wood;
    const LinearColour dark = linearColour(layer.colour);
    const LinearColour light = linearColour(layer.secondColour);
    QImage image(pixels, pixels, QImage::Format_RGBA8888);
    const PixelCode code(image);
    unsigned char* bits = image.bits();
    const auto stride = image.bytesPerLine();
    parallelFor(0, pixels, [&](int row) {
        for (int column = 0; column < pixels; ++column) {
            double sum = 0;
            for (int k = 0; k < samplesAcross * samplesAcross; ++k) {
                sum += lightness((column + (k % samplesAcross + 0.5) / samplesAcross) / pixels,
                                 (row + (k / samplesAcross + 0.5) / samplesAcross) / pixels,
                                 std::uint32_t(layer.seed));
            }
            const auto share = float(sum / (samplesAcross * samplesAcross));
            code.write(bits + row * stride + code.bytes() * column, dark + share * (light - dark),
                       code.opaque());
        }
    });
    return image;
}

} // namespace dipwright
