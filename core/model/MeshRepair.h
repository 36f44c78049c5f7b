// Repairs imported meshes.
#pragma once

#include "model/TexturedMesh.h"

#include <QStringList>

#include <functional>

namespace dipwright {

// What was repaired when a model was imported, in numbers.
struct ModelRepairs {
    int joinedPoints = 0;     // at seams that rounding had opened
    int removedTriangles = 0; // without area
    int mergedTriangles = 0;  // duplicates
    int turnedTriangles = 0;  // flipped, because they faced the other way than their neighbours
    int turnedParts = 0;      // flipped, because they were inside out
};

// Returns the repairs as sentences for the user, one for each kind that occurred.
QStringList sentencesOf(const ModelRepairs& repairs);

// Merges positions that are exactly equal and removes unused ones. Positions are in the order of
// first use.
void weldPositions(TriangleMesh& mesh);

// Merges positions at the edges of holes that differ by no more than the rounding of coordinates:
// 10⁻⁵ of the box's longest edge. Returns how many were removed. The position that is used first
// stays. `mesh` must be welded, and is welded afterwards.
std::size_t joinOpenSeams(TriangleMesh& mesh);

// Removes triangles without area and their attributes; returns how many. If the mesh is closed,
// removes only triangles that leave it closed.
std::size_t removeDegenerateTriangles(TexturedMesh& mesh);

// Removes duplicate triangles (with the same three corners) and returns how many. Among duplicates
// that face both ways, the first that faces the way of the majority stays. If as many face each
// way, there are two cases. If all connected triangles are duplicated like this, it is one surface
// stored from both sides, and one triangle of each pair stays. Otherwise it is a wall between two
// parts, and both stay.
std::size_t mergeDoubledTriangles(TexturedMesh& mesh);

// Flips triangles until neighbours run along their shared edges in opposite directions. In each
// connected piece the minority is flipped. Returns how many. If that is impossible (a Möbius
// strip), nothing is flipped.
std::size_t orientTriangles(TexturedMesh& mesh);

// Flips parts that are inside out; returns how many.
// A closed part is inside out if it encloses a negative volume. A closed part inside other parts is
// their cavity and stays.
// For an open part, rays are cast to both sides from about fifty places. A ray that crosses an odd
// number of triangles votes that its side is inside. The part is flipped if the votes for the side
// that it faces exceed the other side's by at least half of the rays. So a flat sheet or a shallow
// bowl stays.
// Rays pass through all parts: that takes seconds for usual bodies, but could take forever for tens
// of thousands of nested parts. So `goOn` is called before each place and may throw to stop; the
// mesh is then unchanged.
std::size_t flipInsideOutParts(TexturedMesh& mesh, const std::function<void()>& goOn);

} // namespace dipwright
