// Putting an imported mesh right.
#pragma once

#include "model/TexturedMesh.h"

#include <QStringList>

#include <functional>

namespace dipwright {

// What was put right of a model when it was imported, in numbers.
struct ModelRepairs {
    int joinedPoints = 0;     // of seams that rounding had opened
    int removedTriangles = 0; // without area
    int mergedTriangles = 0;  // given twice
    int turnedTriangles = 0;  // that faced the other way than their neighbours
    int turnedParts = 0;      // that were inside out
};

// The repairs in sentences for the user, one for each kind that there was.
QStringList sentencesOf(const ModelRepairs& repairs);

// Makes corners at exactly the same place share one position, and drops positions that no triangle
// uses. In the order of first use.
void weldPositions(TriangleMesh& mesh);

// Makes positions at the edges of holes share one where they lie no farther apart than rounding of
// coordinates takes them: 10⁻⁵ of the box's longest edge; returns how many went. The one that is
// used first stays. `mesh` is welded before and after.
std::size_t joinOpenSeams(TriangleMesh& mesh);

// Removes triangles without area, with what belongs to them; returns how many. Of a closed mesh
// only those whose removal leaves it closed.
std::size_t removeDegenerateTriangles(TexturedMesh& mesh);

// Leaves one of triangles that have the same three corners; returns how many went. The first stays
// of those that face the way most of them do. Where as many face either way they are one surface
// given from both sides if all triangles that hang together with them are, and else a wall between
// two parts, which stays.
std::size_t mergeDoubledTriangles(TexturedMesh& mesh);

// Turns triangles until neighbours run along their shared edges in opposite directions, in each
// connected piece those that are fewer; returns how many. Where no such choice exists (a Möbius
// strip) nothing is turned.
std::size_t orientTriangles(TexturedMesh& mesh);

// Turns parts that are inside out; returns how many. Closed ones are those that enclose a negative
// volume; one that lies inside others is a cavity of theirs and stays. Open ones are put to the
// vote of rays: to either side of some fifty places of the part, rays that cross an odd number of
// triangles say that this side is inside. A part is turned where half of the rays more say so of
// the side that it faces than of the other; a flat sheet or a shallow bowl thus stays. To know,
// rays are followed through all parts: seconds for any body, and no end where parts were nested by
// the ten thousands to that end. So `goOn` is called before each place, and ends it all by
// throwing; the mesh is as it was then.
std::size_t turnInsideOutParts(TexturedMesh& mesh, const std::function<void()>& goOn);

} // namespace dipwright
