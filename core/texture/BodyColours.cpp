#include "texture/BodyColours.h"

namespace dipwright {

BodyColours::BodyColours(const TexturedMesh& model) : model_(model) {
    for (std::size_t texture = 0; texture < model.textures.size(); ++texture) {
        const bool repeats = textureRepeats(model, int(texture));
        textures_.push_back({TextureSampler(model.textures[texture], repeats),
                             repeats ? nullptr : ChartMap::of(model, int(texture))});
    }
    for (const Material& material : model.materials) {
        plain_.push_back(linearColour(material.colour));
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
