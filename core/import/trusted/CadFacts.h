// What is known about a model that was made from a CAD file.
#pragma once

#include <QString>

#include <algorithm>
#include <cmath>

namespace dipwright {

// Limits of the tolerance with which triangles approximate the surfaces of a CAD model, mm.
inline constexpr double finestTessellation = 0.001, coarsestTessellation = 10;

// Returns the tolerance for a part whose longest edge is this long: fine enough that triangles are
// not seen on the printed part, mm. It is rounded as the window shows it.
inline double usualTessellation(double longestEdge) {
    return std::round(std::clamp(longestEdge / 5000, 0.005, 0.1) * 1000) / 1000;
}

// How the triangles of a CAD model are to be made, in the reader's job.
struct Tessellation {
    double tolerance = 0;       // mm on the part; 0: usualTessellation()
    double unitMillimetres = 1; // size on the part of a millimetre in the file
    double longestEdge = 0;     // > 0: the part's longest edge, mm; unitMillimetres is not used
};

// What the reader found in a CAD file.
struct CadFacts {
    QString unit;            // of the file, in the file's word, such as "inch"; empty: unknown
    double tessellation = 0; // tolerance that was used, mm on the part
};

} // namespace dipwright
