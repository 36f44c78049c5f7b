// Provides the colours of a body's materials and textures in linear light.
#pragma once

#include "texture/TextureSampler.h"

namespace dipwright {

// A texture and the map that keeps its charts apart.
struct BodyTexture {
    TextureSampler sampler;
    std::unique_ptr<ChartMap> charts; // null: nothing to keep apart
};

// Keeps a reference to the appearance. Const members may be used from several threads.
class BodyColours {
public:
    explicit BodyColours(const SurfaceAppearance& appearance);

    const SurfaceAppearance& appearance() const { return appearance_; }
    // Tells whether colours are in wide colour's primaries: all are if one texture is wide.
    bool isWide() const { return wide_; }

    // Returns null where a body triangle has a plain colour: it has no texture or no texture
    // coordinates.
    const BodyTexture* texture(std::uint32_t bodyTriangle) const;
    const LinearColour& plain(std::uint32_t bodyTriangle) const;

private:
    const SurfaceAppearance& appearance_;
    bool wide_;
    std::vector<BodyTexture> textures_; // in the appearance's order
    std::vector<LinearColour> plain_;   // one per material
};

} // namespace dipwright
