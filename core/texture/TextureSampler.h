// Filtered look-ups in a body's texture, in linear light.
#pragma once

#include "texture/ChartMap.h"
#include "texture/LinearLight.h"

#include <QImage>
#include <vector>

namespace dipwright {

// How far one step to the right and one step down on the film go on the texture, as the columns of
// a matrix, in texture coordinates.
using TextureSteps = Eigen::Matrix2f;

// What a pixel of the film covers on the texture: `taps` round spots along a line, each as wide as
// a texel of `level`.
struct TextureFootprint {
    int taps = 1;
    Eigen::Vector2f step = Eigen::Vector2f::Zero(); // between taps, texture coordinates
    float level = 0;
};

// A picture with its smaller versions (a mip pyramid filtered by area in linear light). Texture
// coordinates are OBJ's, see SurfaceAppearance. See-through texels let the white body show. Reading
// is const and may go on on many threads.
class TextureSampler {
public:
    // `image` has Format_RGBA8888 or is wide; its colours are read as shares of its own primaries.
    // `repeats`: coordinates outside [0, 1] wrap; else they are
    // clamped.
    TextureSampler(const QImage& image, bool repeats);

    // For pixels that are minified: at most eight taps along the longer axis (anisotropic), between
    // two levels (trilinear). Magnified pixels get the bilinear texel.
    TextureFootprint footprint(const TextureSteps& steps) const;
    LinearColour sample(const Eigen::Vector2f& coordinate, const TextureFootprint& footprint) const;
    // For pixels near the border of their chart: the mean over the pixel of the texels of the first
    // level that belong to `chart`.
    LinearColour sampleWithin(const Eigen::Vector2f& coordinate, const TextureSteps& steps,
                              const ChartMap& charts, std::uint32_t chart) const;
    // Whether all that sample() may read for places in the triangle `corners` belongs to `chart`.
    bool isWithin(const std::array<Eigen::Vector2f, 3>& corners, const TextureSteps& steps,
                  const ChartMap& charts, std::uint32_t chart) const;

private:
    struct Level {
        int width = 0, height = 0;
        std::vector<std::array<std::uint16_t, 4>>
            texels; // linear light; empty for a first level of eight bits
    };
    // The four texels round a place and their weights.
    struct Corners {
        std::array<std::size_t, 4> texel;
        std::array<float, 4> weight;
    };
    Eigen::Vector2f size() const;                       // texels
    float longestStep(const TextureSteps& steps) const; // texels
    Level halved(const Level& level) const;
    LinearColour texel(const Level& level, std::size_t index) const;
    Corners corners(const Level& level, const Eigen::Vector2f& coordinate) const;
    LinearColour bilinear(const Level& level, const Eigen::Vector2f& coordinate) const;
    LinearColour trilinear(const Eigen::Vector2f& coordinate, float level) const;

    QImage image_; // never detached, so that encoded_ stays
    const unsigned char* encoded_;
    const std::array<float, 256>& linear_;
    bool repeats_;
    std::vector<Level> levels_;
};

} // namespace dipwright
