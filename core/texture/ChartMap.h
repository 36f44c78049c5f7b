// Which chart each texel of a texture belongs to, so that no filter reaches across a chart's
// border.
#pragma once

#include "model/TexturedMesh.h"

#include <memory>

namespace dipwright {

// Whether any triangle's coordinates on a texture lie outside [0, 1] by more than rounding.
bool textureRepeats(const SurfaceAppearance& appearance, int texture);

class ChartMap {
public:
    // Of a texture that does not repeat; tiles are made to fit on each other and need none. Null
    // where there is nothing to keep apart, because one chart covers the whole texture.
    static std::unique_ptr<ChartMap> of(const SurfaceAppearance& appearance, int texture);

    // Whether the texel with its middle in `chart` may be seen there; texels are numbered row by
    // row from the picture's upper left corner.
    bool belongs(std::size_t texel, std::uint32_t chart) const {
        return owner_[texel] == chart || owner_[texel] == several;
    }
    // Whether all texels in a box, in texels from the upper left corner, belong to `chart`; may
    // also say no when a texel close by does not.
    bool isWithin(const Eigen::AlignedBox2f& box, std::uint32_t chart) const;

private:
    static constexpr std::uint32_t nobody = 0xffffffffu;
    static constexpr std::uint32_t several = 0xfffffffeu; // charts that lie on each other
    static constexpr int blockSize = 8;

    ChartMap(const SurfaceAppearance& appearance, int texture);
    void fillRows(const SurfaceAppearance& appearance, const std::vector<std::uint32_t>& triangles,
                  int begin, int end);
    void findBlocks();

    int width_ = 0;
    int height_ = 0;
    int blockColumns_ = 0;
    std::vector<std::uint32_t> owner_; // a texel each
    std::vector<std::uint32_t> block_; // a block of texels each: its only owner, or nobody
};

} // namespace dipwright
