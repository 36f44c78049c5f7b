// What the user's marks on the body mean for the cut.
#pragma once

#include "geometry/TriangleMesh.h"
#include "share/ShareSettings.h"

namespace dipwright {

// Changes what triangles cost each dip (`costs`) and how much a join is seen there (`weights`), a
// triangle each, where `marks` on the mesh say so.
void obeyMarks(const TriangleMesh& mesh, const std::vector<ShareMark>& marks,
               std::vector<std::array<double, 2>>& costs, std::vector<float>& weights);

} // namespace dipwright
