#include "texture/BodyColours.h"

#include "base/WideGamut.h"

#include <algorithm>

namespace dipwright {

BodyColours::BodyColours(const SurfaceAppearance& appearance)
    : appearance_(appearance), wide_(std::any_of(appearance.textures.begin(),
                                                 appearance.textures.end(), dipwright::isWide)) {
    for (std::size_t texture = 0; texture < appearance.textures.size(); ++texture) {
        const bool repeats = textureRepeats(appearance, int(texture));
        const QImage& picture = appearance.textures[texture];
        textures_.push_back({TextureSampler(wide_ ? inWide(picture) : picture, repeats),
                             repeats ? nullptr : ChartMap::of(appearance, int(texture))});
    }
    for (const Material& material : appearance.materials) {
        const LinearColour plain = linearColour(material.colour);
        plain_.push_back(wide_ ? wideLight(plain) : plain);
    }
}

const BodyTexture* BodyColours::texture(std::uint32_t bodyTriangle) const {
    const int texture = appearance_.materials[appearance_.material[bodyTriangle]].texture;
    const bool textured = texture >= 0 && appearance_.hasTextureCoordinates(bodyTriangle);
    return textured ? &textures_[std::size_t(texture)] : nullptr;
}

const LinearColour& BodyColours::plain(std::uint32_t bodyTriangle) const {
    return plain_[appearance_.material[bodyTriangle]];
}

} // namespace dipwright
