// Draws the outlines of the user's marks for the seam of two dips.
#pragma once

#include "geometry/RefinedMesh.h"
#include "geometry/SurfaceQuery.h"
#include "settings/ShareSettings.h"
#include "viewport/ViewLine.h"

namespace dipwright {

QColor shareMarkColour(ShareMarkKind kind);

// Caches the lines of each mark, so that only new marks cost time. UI thread only.
class MarkLines {
public:
    explicit MarkLines(const TriangleMesh& body);

    std::vector<ViewLine> lines(const std::vector<ShareMark>& marks);

private:
    struct Drawn {
        ShareMark mark;
        std::vector<ViewLine> lines;
    };

    RefinedMesh mesh_;
    SurfaceQuery query_; // on the fine mesh
    std::vector<Drawn> drawn_;
};

} // namespace dipwright
