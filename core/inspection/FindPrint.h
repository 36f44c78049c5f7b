// Corners of the print in photos of a dipped part, each held against the place where it is meant to
// be (docs/inspection.md, "From photos of a part to corners").
#pragma once

#include "base/Progress.h"
#include "geometry/TriangleMesh.h"
#include "inspection/PartCamera.h"
#include "inspection/PrintedCorners.h"
#include "inspection/PrintedPlace.h"

#include <QImage>

namespace dipwright {

struct FindPrintSettings {
    // The camera is the clicked pairs' alone: for pairs of the body itself, its tips and edges, so
    // that a print that is shifted as a whole shows. Else the found corners say where the camera
    // was, as far as they alone can.
    bool keepsCamera = false;
    std::optional<Lens> lens; // of a camera measured before
};

struct FoundPrint {
    std::vector<PrintedPlace> places; // by photos
    std::vector<int> expected;        // of each photo: corners that should be seen
    bool followsPrint = false;        // whether the camera is that of the found places
    PartView view;                    // its `off` is of the places found
};

// `clicked`: at least six pairs a photo. Uses all cores; the same result on any number. Throws
// Error where a photo does not show the print, or shows it mirrored; Cancelled.
FoundPrint findPrint(const std::vector<QImage>& photos, const TriangleMesh& model,
                     const std::vector<PrintedCorner>& corners,
                     const std::vector<PlacePair>& clicked, const FindPrintSettings& settings,
                     const Progress& progress, const QString& where);

// As pairs of a camera's fit, in the same order.
std::vector<PlacePair> pairsOf(const std::vector<PrintedPlace>& places);

} // namespace dipwright
