// Tells which chart each texel of a texture belongs to, so that no filter reaches across a chart's
// border.
#pragma once

#include "model/TexturedMesh.h"

#include <memory>

namespace dipwright {

// Tells whether a triangle's coordinates on a texture lie outside [0, 1] by more than rounding.
bool textureRepeats(const SurfaceAppearance& appearance, int texture);

class ChartMap {
public:
    // Makes the map of a texture that does not repeat; repeating textures need no map, because
    // their opposite edges fit together. Null if one chart covers the whole texture or no triangle
    // uses the texture.
    static std::unique_ptr<ChartMap> of(const SurfaceAppearance& appearance, int texture);

    // Tells whether a filter for `chart` may use a texel. Texels are numbered row by row from the
    // picture's upper left corner.
    bool belongs(std::size_t texel, std::uint32_t chart) const {
        return owner_[texel] == chart || owner_[texel] == several;
    }
    // Tells whether all texels in a box belong to `chart`. The box is in texels from the upper left
    // corner. May also return false if only a texel near the box does not belong to `chart`.
    bool isWithin(const Eigen::AlignedBox2f& box, std::uint32_t chart) const;

private:
    static constexpr std::uint32_t nobody = 0xffffffffu;  // no chart
    static constexpr std::uint32_t several = 0xfffffffeu; // several charts overlap here
    static constexpr int blockSize = 8;

    ChartMap(const SurfaceAppearance& appearance, int texture);
    void fillRows(const SurfaceAppearance& appearance, const std::vector<std::uint32_t>& triangles,
                  int begin, int end);
    void findBlocks();

    int width_ = 0;
    int height_ = 0;
    int blockColumns_ = 0;
    std::vector<std::uint32_t> owner_; // per texel: its chart, `nobody` or `several`
    std::vector<std::uint32_t> block_; // per block of texels: its only chart, or `nobody`
};

} // namespace dipwright
