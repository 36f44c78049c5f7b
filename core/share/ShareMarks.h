// What the user's marks on the body mean for the cut.
#pragma once

#include "geometry/SurfaceQuery.h"
#include "settings/ShareSettings.h"

namespace dipwright {

// Changes what triangles cost each dip (`costs`) and how much a join is seen there (`weights`), a
// triangle each, where `marks` on the mesh say so.
void obeyMarks(const TriangleMesh& mesh, const std::vector<ShareMark>& marks,
               std::vector<std::array<double, 2>>& costs, std::vector<float>& weights);

// The line round what a mark on the mesh marks, in pieces; `query` is of the mesh.
std::vector<std::array<Eigen::Vector3f, 2>>
markOutline(const TriangleMesh& mesh, const SurfaceQuery& query, const ShareMark& mark);

} // namespace dipwright
