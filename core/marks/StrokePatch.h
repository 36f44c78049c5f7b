// The surface that a brush stroke marks while it is drawn: each new point costs only the triangles
// near it.
#pragma once

#include "geometry/SurfaceQuery.h"
#include "marks/MarkedPieces.h"
#include "marks/StrokeArea.h"

#include <map>

namespace dipwright {

// Not for several threads at once. Keeps references to mesh and query, which must be of one body.
class StrokePatch {
public:
    StrokePatch(const TriangleMesh& mesh, const SurfaceQuery& query, Millimetres radius);

    const BrushPath& path() const { return path_; }
    void add(const BrushPoint& point);
    std::vector<MarkedPiece> pieces() const; // do not overlap

private:
    const TriangleMesh& mesh_;
    const SurfaceQuery& query_;
    StrokeArea stroke_;
    BrushPath path_;
    std::vector<std::uint8_t> isWhole_; // per triangle: 1 if all of it is marked
    std::vector<MarkedPiece> whole_;    // these triangles
    std::map<std::uint32_t, std::vector<MarkedPiece>> parts_; // of other triangles
};

} // namespace dipwright
