// Putting an imported mesh right.
#pragma once

#include "model/TexturedMesh.h"

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
// A part that lies inside others is a cavity of theirs and stays.
std::size_t turnInsideOutParts(TexturedMesh& mesh);

} // namespace dipwright
