// The colours of a body's materials and textures, ready to be read in linear light.
#pragma once

#include "texture/TextureSampler.h"

namespace dipwright {

// A texture with what keeps its charts apart.
struct BodyTexture {
    TextureSampler sampler;
    std::unique_ptr<ChartMap> charts; // null: nothing to keep apart
};

// Keeps a reference to the appearance. Reading is const, any thread.
class BodyColours {
public:
    explicit BodyColours(const SurfaceAppearance& appearance);

    const SurfaceAppearance& appearance() const { return appearance_; }
    // Whether colours are shares of wide colour's primaries, of all where one texture is wide.
    bool isWide() const { return wide_; }

    // Null where a body triangle has a plain colour: without texture or texture coordinates.
    const BodyTexture* texture(std::uint32_t bodyTriangle) const;
    const LinearColour& plain(std::uint32_t bodyTriangle) const;

private:
    const SurfaceAppearance& appearance_;
    bool wide_;
    std::vector<BodyTexture> textures_; // as the appearance's
    std::vector<LinearColour> plain_;   // a material each
};

} // namespace dipwright
