// The surface of a body that must stay free of film. Everything that prints, judges or holds the
// body asks it.
#pragma once

#include "geometry/SurfaceQuery.h"
#include "marks/MarkedPieces.h"
#include "marks/StrokeArea.h"
#include "model/TexturedMesh.h"
#include "settings/MaskSettings.h"

#include <memory>
#include <span>
#include <vector>

namespace dipwright {

// The number of connected areas, and their total area.
struct MaskedAreas {
    std::size_t count = 0; // areas less than `joined` mm apart count as one
    double area = 0;       // mm²
    static constexpr float joined = 0.5f;
};

// Exact within triangles. Immutable; any thread may read. Places are on the model's mesh, lengths
// in mm.
class SurfaceMask {
public:
    // Uses all cores. Deterministic.
    SurfaceMask(std::shared_ptr<const TexturedMesh> model, const std::vector<MaskMark>& marks);
    // Copies a mask and adds marks to it.
    SurfaceMask(const SurfaceMask& before, const std::vector<MaskMark>& added);

    const std::vector<MaskMark>& marks() const { return marks_; }
    const std::shared_ptr<const TexturedMesh>& model() const { return model_; }
    bool covers(const SurfacePoint& place) const;
    // Returns the masked surface, with the accuracy of sidePerRadius. Strokes longer than the brush
    // draws are less accurate, so that the number of pieces is limited.
    std::vector<MarkedPiece> pieces() const;

private:
    // A mark that concerns a triangle.
    struct Concern {
        std::uint32_t mark = 0;
        bool isWhole = false; // it covers the whole triangle
    };
    void add(const std::vector<MaskMark>& marks);
    std::vector<std::uint32_t> lastWhole(std::uint32_t first) const;
    void addConcerns(std::uint32_t triangle, std::uint32_t whole, std::uint32_t first,
                     std::vector<Concern>& found) const;
    std::span<const Concern> concerns(std::uint32_t triangle) const; // the oldest first
    // Distance of a place on a triangle from the border of the masked surface; positive inside.
    float inside(std::uint32_t triangle, const Eigen::Vector3f& place) const;
    // Length of the sides into which the border of a stroke is divided.
    float sideOf(const StrokeArea& stroke) const;
    // Length of the sides into which a triangle is divided at the border.
    float finest(std::uint32_t triangle) const;

    std::shared_ptr<const TexturedMesh> model_;
    std::vector<MaskMark> marks_;
    std::vector<StrokeArea> strokes_; // of each mark; empty without a path
    std::vector<Concern> concerns_;   // of all triangles, one triangle after the other
    std::vector<std::size_t> begins_; // of each triangle in concerns_, and the end of the last one
    float leastSide_ = 0;             // of a piece at the border, mm
    double sides_ = 0;                // along the borders of all strokes
};

// Returns the mask of a body; null without marks. Reuses an earlier mask, which may be null, as far
// as it has the same marks.
std::shared_ptr<const SurfaceMask>
surfaceMask(std::shared_ptr<const TexturedMesh> model, const std::vector<MaskMark>& marks,
            const std::shared_ptr<const SurfaceMask>& earlier = nullptr);

MaskedAreas maskedAreas(const SurfaceMask& mask);
// Returns a sentence for the user: "Masked areas: 2 (412 mm²). Cover …".
QString maskText(const MaskedAreas& areas);

} // namespace dipwright
