// Finds corners of the print in photos of a dipped part, and their intended places on the part
// (docs/inspection.md, "From photos of a part to corners").
#pragma once

#include "base/Progress.h"
#include "geometry/TriangleMesh.h"
#include "inspection/PartCamera.h"
#include "inspection/PrintedCorners.h"
#include "inspection/PrintedPlace.h"

#include <QImage>
#include <QString>

namespace dipwright {

struct FindPrintSettings {
    // If true, keeps the camera of the clicked pairs. Use this if the pairs lie on tips and edges
    // of the body itself: a shift of the whole print is then measured. If false, the camera is
    // fitted to the found corners if they determine it.
    bool keepsCamera = false;
    std::optional<Lens> lens; // known from an earlier measurement of the camera
};

// Squares. Corners of the same colours are a diagonal apart, 1.41 squares. A corner that is found
// nearer than this would have to be off by a whole square if it were another one.
inline constexpr double mostClearSteps = 0.35;

struct FoundPrint {
    std::vector<PrintedPlace> places; // photo by photo
    std::vector<int> expected;        // per photo: the number of corners that should be visible
    // Set if the median distance of the corners from where the camera of the clicked pairs should
    // see them is more than mostClearSteps: each may be a neighbour of the corner it is taken for.
    QString doubt;
    bool followsPrint = false; // whether the camera is fitted to the found places
    PartView view;             // camera; PartView::off is the error at the found places
};

// Returns the corners of the print that the photos show. `clicked` holds at least six pairs per
// photo. Uses all cores; the result does not depend on their number. Throws Cancelled, and Error if
// a photo does not show the print, or shows it mirrored.
FoundPrint findPrint(const std::vector<QImage>& photos, const TriangleMesh& model,
                     const std::vector<PrintedCorner>& corners,
                     const std::vector<PlacePair>& clicked, const FindPrintSettings& settings,
                     const Progress& progress, const QString& where);

// Returns the places as pairs for fitPartCamera(), in the same order.
std::vector<PlacePair> pairsOf(const std::vector<PrintedPlace>& places);

} // namespace dipwright
