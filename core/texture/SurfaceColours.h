// What a body is to look like, place by place.
#pragma once

#include "model/TexturedMesh.h"
#include "texture/LinearLight.h"

#include <memory>

namespace dipwright {

// The colour of the texture, or the plain one, at each of these places of the body, in linear
// light; of a fine pattern a single texel. All cores.
std::vector<LinearColour> surfaceColours(const SurfaceAppearance& appearance,
                                         const std::vector<SurfacePoint>& places);

class BodyColours;

// The same, filtered, for many places. Keeps a reference to the appearance. Reading is const, any
// thread.
class SurfaceColours {
public:
    explicit SurfaceColours(const SurfaceAppearance& appearance);
    ~SurfaceColours();

    // The mean over a small piece of the surface: `steps` say how far it goes to the right and
    // down, as weights of the triangle's corners. As shares of wide colour's primaries where any of
    // the appearance's textures is wide.
    LinearColour at(const SurfacePoint& place, const Eigen::Matrix<float, 3, 2>& steps) const;

private:
    const SurfaceAppearance& appearance_;
    std::unique_ptr<const BodyColours> colours_;
};

} // namespace dipwright
