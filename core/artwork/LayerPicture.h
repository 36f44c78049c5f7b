// Renders the content of a layer to a picture that can be sampled anywhere in its plane. Private to
// this folder.
#pragma once

#include "settings/Artwork.h"
#include "texture/LinearLight.h"

#include <Eigen/Core>

namespace dipwright {

// Red, green and blue in linear light, premultiplied by alpha; then alpha.
using CoveringLight = Eigen::Array4f;

// A picture in linear light, reduced to the texel size by area filtering. Immutable; any thread may
// read.
class LayerPicture {
public:
    // `texel` is the size of a result pixel on the body, mm. If `wide`, colours are in the
    // primaries of wide colour (base/WideGamut.h). Text needs a QGuiApplication.
    LayerPicture(const ArtworkLayer& layer, double texel, bool wide);

    // Returns the light at a place of the layer's plane. `place` is given in mm to the right and up
    // from the plane's middle. With `isEndless`, repeats continue past the layer's size.
    CoveringLight at(const Eigen::Vector2d& place, bool isEndless) const;
    // Returns the size of one repeat, or of content that is shown once.
    const Eigen::Vector2d& size() const { return size_; } // mm

private:
    CoveringLight pixel(int column, int row) const;

    int columns_ = 0, rows_ = 0;
    bool repeats_ = false;
    double texel_;                // mm
    Eigen::Vector2d size_, area_; // sizes of one picture and of the whole layer, mm
    std::vector<std::array<std::uint16_t, 4>> pixels_;
};

// Returns width divided by height of a layer's content. Text needs a QGuiApplication.
double proportionsOf(const ArtworkLayer& layer);

} // namespace dipwright
