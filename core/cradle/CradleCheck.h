// Checks a finished cradle with methods that were not used to make it: rays and closest points on
// its triangles.
#pragma once

#include "base/Progress.h"
#include "geometry/SurfaceQuery.h"

#include <dipwright/FilmSolver.h>

#include <vector>

namespace dipwright {

// A piece of the body's surface that may lie on the cradle, in the pose frame.
struct SeatPiece {
    Eigen::Vector3d place, normal; // outward
    double area = 0;               // mm²
    bool isPadded = false;         // an earlier dip has painted it
};

// How firmly a body rests in its cradle, with the cradle's plate (docs/cradle.md) on a table and
// the body on top.
struct CradleStability {
    // Tilt of the plate in degrees at which the body tips over, for a body of uniform density.
    // Negative if it tips over without tilt.
    double tiltDegrees = -90;
    // For each horizontal direction, take the slope in degrees of the steepest support that stops
    // the body from sliding that way. This is the smallest of these slopes; 0 if nothing stops the
    // body in some direction.
    double sideHoldDegrees = 0;
};

struct CradleCheck {
    bool isClosed = false; // every edge is in two triangles, in opposite directions
    int parts = 0;         // pieces connected by edges; should be 1
    double volume = 0;     // mm³; positive if its triangles face outwards
    double leastGap = 0;   // smallest gap between cradle and body, mm; negative if they overlap
    double paintGap = 0;   // smallest gap between the cradle and the surface that film reaches, mm
    bool comesOut = false; // the body can move down without touching the cradle
    double seatArea = 0;   // area of the body that lies on the cradle, mm²
    double paddedArea = 0; // part of seatArea that an earlier dip has painted, mm²
    CradleStability standing;
};

// Whether the mesh is closed (isClosed()) and the triangles round every position form one ring.
bool isClosedSurface(const TriangleMesh& mesh);

// Returns the centre of a closed body's volume.
Eigen::Vector3d centreOfVolume(const TriangleMesh& body);
// Returns how firmly a body with this centre of mass rests on the pieces of `seat`.
CradleStability standingOn(const std::vector<SeatPiece>& seat, const Eigen::Vector3d& centre);

// Whether a cradle touches the film on the water at a moment of the body's path. A place of the
// cradle may go under water only where the body is straight below it, because the body has pushed
// the film away from there. All arguments are in the pose frame; `path` has poses.
bool touchesFilmOnPath(const TriangleMesh& cradle, const TriangleMesh& body,
                       const SurfaceQuery& bodyQuery, const solver::BodyPath& path);

// Checks a cradle. `seat` holds the pieces that may lie on the cradle. A piece within `nearest` mm
// counts as lying on it; a padded piece, within `nearest` + `padding`. `painted` is the surface
// that film reaches; may be null.
CradleCheck checkCradle(const TriangleMesh& cradle, const TriangleMesh& body,
                        const SurfaceQuery& bodyQuery, const SurfaceQuery* painted,
                        const std::vector<SeatPiece>& seat, double nearest, double padding,
                        const Progress& progress);

} // namespace dipwright
