// Provides the colours of a body's materials and textures in linear light.
#pragma once

#include "texture/TextureSampler.h"

namespace dipwright {

// A texture and the map that separates its charts.
struct BodyTexture {
    TextureSampler sampler;
    std::unique_ptr<ChartMap> charts; // null: the charts need no separation
};

// The colours of one appearance, to which it keeps a reference. Const members may be used from
// several threads.
class BodyColours {
public:
    explicit BodyColours(const SurfaceAppearance& appearance);

    const SurfaceAppearance& appearance() const { return appearance_; }
    // Tells whether all colours are in wide colour's primaries. They are if any texture is wide.
    bool isWide() const { return wide_; }

    // Returns the texture of a body triangle. Null if the triangle has a plain colour because it
    // has no texture or no texture coordinates.
    const BodyTexture* texture(std::uint32_t bodyTriangle) const;
    // Returns the plain colour of a body triangle's material.
    const LinearColour& plain(std::uint32_t bodyTriangle) const;

private:
    const SurfaceAppearance& appearance_;
    bool wide_;
    std::vector<BodyTexture> textures_; // in the appearance's order
    std::vector<LinearColour> plain_;   // one per material
};

} // namespace dipwright
