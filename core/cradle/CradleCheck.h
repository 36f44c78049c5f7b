// Whether a cradle is what it should be, by other means than those it was made with: rays and
// closest points of the finished triangles.
#pragma once

#include "base/Progress.h"
#include "geometry/SurfaceQuery.h"

#include <vector>

namespace dipwright {

// A piece of the body's surface that may lie on a cradle. Pose frame.
struct SeatPiece {
    Eigen::Vector3d place, normal; // outward
    double area = 0;               // mm²
    bool isPadded = false;         // it has paint of an earlier dip
};

// How a body stands on what it lies on, taken as if the plate lay on a table and the body in it.
struct Standing {
    // Degrees by which the plate can be tilted before the body tips over, its material being even;
    // negative where it falls over by itself.
    double tiltDegrees = -90;
    // The least slope, in degrees, of what keeps the body from sliding off in a level direction; 0:
    // nothing does in some direction.
    double sideHoldDegrees = 0;
};

struct CradleCheck {
    bool isClosed = false; // every edge in two triangles, run along in opposite directions
    int parts = 0;         // connected by edges; 1 is right
    double volume = 0;     // mm³; positive: its triangles face outwards
    double leastGap = 0;   // mm between cradle and body, negative where they overlap
    double paintGap = 0;   // mm between the cradle and what this dip's film reaches
    bool comesOut = false; // nothing of the cradle is in the body's way down
    double seatArea = 0;   // mm² of the body that lie on it
    double paddedArea = 0; // of these, on paint of an earlier dip
    Standing standing;
};

// isClosed(), and the triangles round every position form one ring.
bool isClosedSurface(const TriangleMesh& mesh);

// The middle of a closed body's volume.
Eigen::Vector3d centreOfVolume(const TriangleMesh& body);
Standing standingOn(const std::vector<SeatPiece>& seat, const Eigen::Vector3d& centre);

// `seat`: what may lie on the cradle, of which it counts what does, at no more than `nearest` mm
// (and `padding` where padded). `painted`: what film reaches; may be null.
CradleCheck checkCradle(const TriangleMesh& cradle, const TriangleMesh& body,
                        const SurfaceQuery& bodyQuery, const SurfaceQuery* painted,
                        const std::vector<SeatPiece>& seat, double nearest, double padding,
                        const Progress& progress);

} // namespace dipwright
