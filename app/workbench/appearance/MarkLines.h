// The lines round what the user has marked on the body for the join of two dips.
#pragma once

#include "geometry/RefinedMesh.h"
#include "geometry/SurfaceQuery.h"
#include "settings/ShareSettings.h"
#include "viewport/ViewLine.h"

namespace dipwright {

// Keeps the lines that it has drawn: a mark more costs that mark's. UI thread.
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
    SurfaceQuery query_; // of the fine mesh
    std::vector<Drawn> drawn_;
};

} // namespace dipwright
