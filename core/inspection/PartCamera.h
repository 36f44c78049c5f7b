// Finds the camera with which a dipped part was photographed, from places with known positions on
// the model. Measures how far the print lies from its intended place (docs/inspection.md, "The
// part's camera").
#pragma once

#include "inspection/FlatFilm.h"

#include <Eigen/Core>

#include <QSize>
#include <QString>
#include <optional>
#include <vector>

namespace dipwright {

// A place in a photo and the place on the model that appears there.
struct PlacePair {
    int photo = 0;         // index of the photo
    Eigen::Vector2d pixel; // place in the photo, as in Lens.h
    Eigen::Vector3d model; // mm, in the project's model coordinates
    int line = 0;          // line of the table that names the pair; 0: none
};

// The pose of the camera in one photo. A place appears where turn · place + shift is projected
// along the third axis. The first axis points right in the picture, the second down, and the third
// away from the camera.
struct PartPose {
    Eigen::Matrix3d turn;
    Eigen::Vector3d shift; // mm
};

struct PairDistance {
    Eigen::Vector2d pixels; // seen minus expected
    double millimetres = 0; // across the line of sight, at the place
};

// Statistics of the distances between seen and expected places: the figures of the paper's Table
// II, and two in mm.
struct PartFigures {
    int count = 0;
    double meanPixels = 0, deviationPixels = 0;
    double shareOfDiagonal = 0; // mean distance divided by the picture's diagonal
    double percentile95 = 0;    // mm
    double worst = 0;           // mm
    std::size_t worstPair = 0;  // index of the pair with the largest distance
};

struct PartView {
    std::vector<PartPose> photos;
    Measured focalLength; // in half diagonals; the same for all photos
    Lens lens;
    std::vector<PairDistance> off; // one per pair
    PartFigures figures;
};

// Least number of pairs per photo.
inline constexpr int leastPairs = 6;
// Least number of pairs, in all photos together, to fit k1; k2 needs twice as many.
inline constexpr int pairsForDistortion = 30;

// Fits one camera to photos of one size. Uses `lens` if it is given. Otherwise fits k1 and k2 if
// there are enough pairs, or leaves them 0. Throws Error, naming `where`, if the pairs are too few
// or do not determine the camera, for example if all lie in one plane or the photo is mirrored.
PartView fitPartCamera(const std::vector<PlacePair>& pairs, int photos, QSize picture,
                       const QString& where, const std::optional<Lens>& lens = {});

// Returns the same camera with the distances and figures of other pairs in the same photos.
PartView viewOf(const PartView& camera, const std::vector<PlacePair>& pairs, QSize picture);

// Returns the figures of one photo. `view` and `pairs` include all photos.
PartFigures figuresOfPhoto(const PartView& view, const std::vector<PlacePair>& pairs, int photo,
                           QSize picture);

// Returns where a place of the model appears, in pixels.
Eigen::Vector2d seenAt(const PartView& view, int photo, QSize picture,
                       const Eigen::Vector3d& model);

} // namespace dipwright
