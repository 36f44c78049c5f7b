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
    // Makes the map of a texture that does not repeat. Repeating textures are made to fit edge to
    // edge and need no map. Null if one chart covers the whole texture or no triangle uses it.
    static std::unique_ptr<ChartMap> of(const SurfaceAppearance& appearance, int texture);

    // Tells whether a texel may be seen in `chart`. Texels are numbered row by row from the
    // picture's upper left corner.
    bool belongs(std::size_t texel, std::uint32_t chart) const {
        return owner_[texel] == chart || owner_[texel] == several;
    }
    // Tells whether all texels in a box belong to `chart`. The box is in texels from the upper left
    // corner. The answer may also be false if only a nearby texel does not belong to it.
    bool isWithin(const Eigen::AlignedBox2f& box, std::uint32_t chart) const;

private:
    static constexpr std::uint32_t nobody = 0xffffffffu;
    static constexpr std::uint32_t several = 0xfffffffeu; // charts overlap here
    static constexpr int blockSize = 8;

    ChartMap(const SurfaceAppearance& appearance, int texture);
    void fillRows(const SurfaceAppearance& appearance, const std::vector<std::uint32_t>& triangles,
                  int begin, int end);
    void findBlocks();

    int width_ = 0;
    int height_ = 0;
    int blockColumns_ = 0;
    std::vector<std::uint32_t> owner_; // one per texel
    std::vector<std::uint32_t> block_; // one per block of texels: its only owner, or nobody
};

} // namespace dipwright
