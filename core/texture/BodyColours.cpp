#include "texture/BodyColours.h"

#include "base/WideColour.h"

#include <algorithm>

namespace dipwright {

BodyColours::BodyColours(const TexturedMesh& model)
    : model_(model),
      wide_(std::any_of(model.textures.begin(), model.textures.end(), dipwright::isWide)) {
    for (std::size_t texture = 0; texture < model.textures.size(); ++texture) {
        const bool repeats = textureRepeats(model, int(texture));
        const QImage& picture = model.textures[texture];
        textures_.push_back({TextureSampler(wide_ ? inWide(picture) : picture, repeats),
                             repeats ? nullptr : ChartMap::of(model, int(texture))});
    }
    for (const Material& material : model.materials) {
        const LinearColour plain = linearColour(material.colour);
        plain_.push_back(wide_ ? wideLight(plain) : plain);
    }
}

const BodyTexture* BodyColours::texture(std::uint32_t bodyTriangle) const {
    const int texture = model_.materials[model_.material[bodyTriangle]].texture;
    const bool textured = texture >= 0 && model_.hasTextureCoordinates(bodyTriangle);
    return textured ? &textures_[std::size_t(texture)] : nullptr;
}

const LinearColour& BodyColours::plain(std::uint32_t bodyTriangle) const {
    return plain_[model_.material[bodyTriangle]];
}

} // namespace dipwright
