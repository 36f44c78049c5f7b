#include "texture/SurfaceColours.h"

#include "parallel/ParallelFor.h"
#include "texture/BodyColours.h"

namespace dipwright {

SurfaceColours::SurfaceColours(const SurfaceAppearance& appearance)
    : appearance_(appearance), colours_(std::make_unique<const BodyColours>(appearance)) {}

SurfaceColours::~SurfaceColours() = default;

std::vector<LinearColour> SurfaceColours::at(const std::vector<SurfacePoint>& places) const {
    std::vector<LinearColour> result(places.size());
    parallelFor(std::size_t(0), places.size(), [&](std::size_t k) {
        const BodyTexture* texture = colours_->texture(places[k].triangle);
        result[k] = texture ? texture->sampler.sample(appearance_.textureCoordinate(places[k]), {})
                            : colours_->plain(places[k].triangle);
    });
    return result;
}

LinearColour SurfaceColours::at(const SurfacePoint& place,
                                const Eigen::Matrix<float, 3, 2>& steps) const {
    const BodyTexture* texture = colours_->texture(place.triangle);
    if (!texture) {
        return colours_->plain(place.triangle);
    }
    const auto& corners = appearance_.textureCoordinates[place.triangle];
    Eigen::Matrix<float, 2, 3> coordinates;
    coordinates << corners[0], corners[1], corners[2];
    const TextureSteps onTexture = coordinates * steps;
    const Eigen::Vector2f coordinate = appearance_.textureCoordinate(place);
    if (texture->charts) {
        return texture->sampler.sampleWithin(coordinate, onTexture, *texture->charts,
                                             appearance_.chart[place.triangle]);
    }
    return texture->sampler.sample(coordinate, texture->sampler.footprint(onTexture));
}

} // namespace dipwright
