// Putting an imported mesh right.
#pragma once

#include "model/TexturedMesh.h"

#include <functional>

namespace dipwright {

// Makes corners at exactly the same place share one position, and drops positions that no triangle
// uses. In the order of first use.
void weldPositions(TriangleMesh& mesh);

// Removes triangles without area, with what belongs to them; returns how many. Of a closed mesh
// only those whose removal leaves it closed.
std::size_t removeDegenerateTriangles(TexturedMesh& mesh);

// Turns triangles until neighbours run along their shared edges in opposite directions, in each
// connected piece those that are fewer; returns how many. Where no such choice exists (a Möbius
// strip) nothing is turned.
std::size_t orientTriangles(TexturedMesh& mesh);

// Turns closed parts that are inside out, so that they enclose a positive volume; returns how many.
// A part that lies inside others is a cavity of theirs and stays. To know, rays from some fifty
// places of each such part are followed through all others: seconds for any body, and no end where
// parts were nested by the ten thousands to that end. So `goOn` is called before each place, and
// ends it all by throwing; the mesh is as it was then.
std::size_t turnInsideOutParts(TexturedMesh& mesh, const std::function<void()>& goOn);

} // namespace dipwright
