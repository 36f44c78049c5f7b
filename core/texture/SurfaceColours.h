// Returns the colours that a body should show, place by place.
#pragma once

#include "model/TexturedMesh.h"
#include "texture/LinearLight.h"

#include <memory>

namespace dipwright {

class BodyColours;

// Returns colours for many places. Keeps a reference to the appearance. Const members may be used
// from several threads.
class SurfaceColours {
public:
    explicit SurfaceColours(const SurfaceAppearance& appearance);
    ~SurfaceColours();

    // Returns the mean over a small parallelogram of the surface with its middle at `place`. The
    // columns of `steps` are its two sides, as changes of the triangle's corner weights. The colour
    // is in wide colour's primaries if any of the appearance's textures is wide.
    LinearColour at(const SurfacePoint& place, const Eigen::Matrix<float, 3, 2>& steps) const;
    // Returns the colour of the texture, or the plain colour, at each of these places of the body,
    // in linear light. Does not filter: reads a single texel even in a fine pattern. Uses all
    // cores.
    std::vector<LinearColour> at(const std::vector<SurfacePoint>& places) const;

private:
    const SurfaceAppearance& appearance_;
    std::unique_ptr<const BodyColours> colours_;
};

} // namespace dipwright
