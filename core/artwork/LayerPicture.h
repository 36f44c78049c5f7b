// What a layer shows, as a picture ready to be read anywhere in its plane. Private to this folder.
#pragma once

#include "settings/Artwork.h"
#include "texture/LinearLight.h"

#include <Eigen/Core>

namespace dipwright {

// Light and how much of what lies behind is hidden, multiplied by it.
using CoveringLight = Eigen::Array4f;

// Reading is const, any thread. In linear light, filtered by area down to texels of one size.
class LayerPicture {
public:
    // `texel`: mm on the body that a pixel of the result covers. `wide`: colours are told as shares
    // of wide colour's primaries. Text needs a QGuiApplication.
    LayerPicture(const ArtworkLayer& layer, double texel, bool wide);

    // At a place of the layer's plane, mm to the right and up from its middle. `isEndless`: repeats
    // go on past the layer's size.
    CoveringLight at(const Eigen::Vector2d& place, bool isEndless) const;
    // Of one repeat, or of what is shown once.
    const Eigen::Vector2d& size() const { return size_; } // mm

private:
    CoveringLight pixel(int column, int row) const;

    int columns_ = 0, rows_ = 0;
    bool repeats_ = false;
    Eigen::Vector2d size_, area_; // mm: one picture; all that the layer takes
    std::vector<std::array<std::uint16_t, 4>> pixels_;
};

// The proportions, width over height, of what a layer shows; needs a QGuiApplication for text.
double proportionsOf(const ArtworkLayer& layer);

} // namespace dipwright
