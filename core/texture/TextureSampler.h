// Reads filtered colours from a body's texture, in linear light.
#pragma once

#include "texture/ChartMap.h"
#include "texture/LinearLight.h"

#include <QImage>
#include <vector>

namespace dipwright {

// Steps on the texture for one film pixel to the right and one film pixel down. They are the
// columns of a matrix, in texture coordinates.
using TextureSteps = Eigen::Matrix2f;

// The area of the texture that a film pixel covers: a grid of places (taps) on `level`, along the
// longer and the shorter axis of the area.
struct TextureFootprint {
    int along = 1, across = 1;                            // numbers of taps
    Eigen::Vector2f alongStep = Eigen::Vector2f::Zero();  // between taps, texture coordinates
    Eigen::Vector2f acrossStep = Eigen::Vector2f::Zero(); // between taps, texture coordinates
    float level = 0;
    float cubic = 0; // share of cubic in linear interpolation; only on the first level
};

// A picture and its smaller versions (a mip pyramid filtered by area in linear light). Texture
// coordinates are as in OBJ files; see SurfaceAppearance. Transparent texels show the white body.
// Const members may be used from several threads.
class TextureSampler {
public:
    // `image` has Format_RGBA8888 or is wide; its colours are read in its own primaries. If
    // `repeats`, coordinates outside [0, 1] wrap; otherwise they are clamped.
    TextureSampler(const QImage& image, bool repeats);

    // Returns the footprint of a pixel. Together, taps and interpolation have the variance of a
    // pixel's square, so that two-pixel lines keep 85 % of their contrast and finer ones fade
    // (docs/film-model.md, "Sampling the texture"). If a pixel covers two texels or more, it is
    // read between the two levels on which it covers about two texels (trilinear), with at most
    // 16 taps along the longer axis (anisotropic). If it covers about one texel, it is read by
    // cubic interpolation (Keys 1981, a = −½). If it covers half a texel or less, it is read
    // bilinearly.
    TextureFootprint footprint(const TextureSteps& steps) const;
    LinearColour sample(const Eigen::Vector2f& coordinate, const TextureFootprint& footprint) const;
    // Returns the colour of a pixel near its chart's border. It is the mean of the first level's
    // texels that the pixel covers and that belong to `chart`.
    LinearColour sampleWithin(const Eigen::Vector2f& coordinate, const TextureSteps& steps,
                              const ChartMap& charts, std::uint32_t chart) const;
    // Tells whether every texel that sample() may read for places in the triangle `corners` belongs
    // to `chart`.
    bool isWithin(const std::array<Eigen::Vector2f, 3>& corners, const TextureSteps& steps,
                  const ChartMap& charts, std::uint32_t chart) const;

private:
    struct Level {
        int width = 0, height = 0;
        // Linear light. Empty for the first level of an image with 8 bits per channel, whose texels
        // are read from the image itself.
        std::vector<std::array<std::uint16_t, 4>> texels;
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
    // Returns a place in texels, from the middle of the first texel.
    Eigen::Vector2f onLevel(const Level& level, const Eigen::Vector2f& coordinate) const;
    // Returns a row or column of a level, wrapped or clamped.
    std::size_t inside(int index, int length) const;
    Corners corners(const Level& level, const Eigen::Vector2f& coordinate) const;
    LinearColour bilinear(const Level& level, const Eigen::Vector2f& coordinate) const;
    LinearColour trilinear(const Eigen::Vector2f& coordinate, float level) const;
    LinearColour cubic(const Eigen::Vector2f& coordinate) const; // on the first level

    QImage image_; // never detached, so that encoded_ stays valid
    const unsigned char* encoded_;
    const std::array<float, 256>& linear_;
    bool repeats_;
    std::vector<Level> levels_;
};

} // namespace dipwright
