#include "texture/SurfaceColours.h"

#include "parallel/ParallelFor.h"
#include "texture/BodyColours.h"

namespace dipwright {

std::vector<LinearColour> surfaceColours(const TexturedMesh& model,
                                         const std::vector<SurfacePoint>& places) {
    const BodyColours colours(model);
    std::vector<LinearColour> result(places.size());
    parallelFor(std::size_t(0), places.size(), [&](std::size_t k) {
        const BodyTexture* texture = colours.texture(places[k].triangle);
        result[k] = texture ? texture->sampler.sample(model.textureCoordinate(places[k]), {})
                            : colours.plain(places[k].triangle);
    });
    return result;
}

} // namespace dipwright
