// Repairs imported meshes.
#pragma once

#include "model/TexturedMesh.h"

#include <QStringList>

#include <functional>

namespace dipwright {

// How many faults of each kind were repaired when a model was imported.
struct ModelRepairs {
    int joinedPoints = 0;      // points merged at seams that rounding had opened
    int removedTriangles = 0;  // triangles without area that were removed
    int mergedTriangles = 0;   // duplicate triangles that were removed
    int turnedTriangles = 0;   // triangles flipped to face the same way as their neighbours
    int turnedParts = 0;       // parts flipped because they were inside out
    int enclosedTriangles = 0; // triangles of closed parts inside others that were removed
};

// Returns the repairs as sentences for the user, one for each kind that occurred.
QStringList sentencesOf(const ModelRepairs& repairs);

// Merges positions that are exactly equal and removes unused ones. The remaining positions are in
// the order of their first use.
void weldPositions(TriangleMesh& mesh);

// Merges positions at the edges of holes if they differ only by the rounding of coordinates: by at
// most 10⁻⁵ of the bounding box's longest edge. Returns how many positions were removed. Among
// merged positions, the one that is used first stays. `mesh` must be welded, and is welded
// afterwards.
std::size_t joinOpenSeams(TriangleMesh& mesh);

// Removes triangles that use a position twice, and the positions that no triangle uses then;
// returns how many triangles. `mesh` must be welded, and is welded afterwards.
std::size_t removeCollapsedTriangles(TexturedMesh& mesh);

// Removes triangles without area and their attributes; returns how many. From a closed mesh,
// removes only triangles whose removal leaves the mesh closed.
std::size_t removeDegenerateTriangles(TexturedMesh& mesh);

// Removes duplicate triangles (with the same three corners) and returns how many. If duplicates
// face both ways, keeps the first one that faces like the majority. If equally many face each way,
// there are two cases. If all connected triangles are duplicated in this way, they are one surface
// stored from both sides. Then one triangle of each pair stays. Otherwise they are a wall between
// two parts, and both stay.
std::size_t mergeDoubledTriangles(TexturedMesh& mesh);

// Flips triangles until neighbours run along their shared edges in opposite directions. In each
// connected piece the minority is flipped. Returns how many. If that is impossible (a Möbius
// strip), nothing is flipped.
std::size_t orientTriangles(TexturedMesh& mesh);

// Flips parts that are inside out; returns how many. A closed part is inside out if it encloses a
// negative volume. A closed part inside other parts is their cavity and stays. For an open part,
// rays are cast to both sides from about fifty places. A ray that crosses an odd number of
// triangles votes that its side is inside. The part is flipped if the side that it faces gets more
// votes than the other side, by at least half of the rays. So a flat sheet or a shallow bowl stays.
// Rays pass through all parts: this takes seconds for usual bodies, but could take forever for tens
// of thousands of nested parts. So `goOn` is called before each place and may throw to stop; the
// mesh is then unchanged.
std::size_t flipInsideOutParts(TexturedMesh& mesh, const std::function<void()>& goOn);

// Removes the closed parts inside other closed parts, which neither water nor film reaches:
// cavities, and inner bodies that face outwards. Returns how many triangles. If a part of the mesh
// is open, nothing is removed. `goOn` as above.
std::size_t removeEnclosedParts(TexturedMesh& mesh, const std::function<void()>& goOn);

} // namespace dipwright
