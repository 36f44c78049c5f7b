// Applies the user's marks on the body to the costs of the cut.
#pragma once

#include "geometry/SurfaceQuery.h"
#include "settings/ShareSettings.h"

#include <optional>

namespace dipwright {

// Changes the cost of triangles for each dip (`costs`) and the visibility of a seam (`weights`) as
// `marks` say. Both arrays are per triangle of `mesh`. Returns, also per triangle, the dip (0 or 1)
// that the marks assign it to.
std::vector<std::optional<std::size_t>> applyShareMarks(const TriangleMesh& mesh,
                                                        const std::vector<ShareMark>& marks,
                                                        std::vector<std::array<double, 2>>& costs,
                                                        std::vector<float>& weights);

// Returns the outline of the area that a mark covers, in pieces. `query` must search `mesh`.
std::vector<std::array<Eigen::Vector3f, 2>>
markOutline(const TriangleMesh& mesh, const SurfaceQuery& query, const ShareMark& mark);

} // namespace dipwright
