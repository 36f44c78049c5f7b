// The camera that photographed a dipped part, by places of which one knows where they are on the
// model, and how far what is seen lies from there (docs/inspection.md, "The part's camera").
#pragma once

#include "inspection/FlatFilm.h"

#include <Eigen/Core>

#include <QSize>
#include <QString>
#include <optional>
#include <vector>

namespace dipwright {

// A place in a photo and the one on the model that is to be seen there.
struct PlacePair {
    int photo = 0;         // index of the photo
    Eigen::Vector2d pixel; // as in Lens.h
    Eigen::Vector3d model; // mm, as the project has the model
};

// How one photo was taken: a place appears where turn · place + shift is projected along the third
// axis, which points away from the camera; the first points right in the picture, the second down.
struct PartPose {
    Eigen::Matrix3d turn;
    Eigen::Vector3d shift; // mm
};

struct PairOff {
    Eigen::Vector2d pixels; // seen less expected
    double millimetres = 0; // across the line of sight, where the place is
};

// The paper's figures (its Table II) and ours, of the distances between seen and expected.
struct PartFigures {
    int count = 0;
    double meanPixels = 0, deviationPixels = 0;
    double shareOfDiagonal = 0; // mean over the picture's diagonal
    double percentile95 = 0;    // mm
    double worst = 0;           // mm …
    std::size_t worstPair = 0;  // … of this pair
};

struct PartView {
    std::vector<PartPose> photos;
    Measured focalLength; // half diagonals; the same lens for all photos
    Lens lens;
    std::vector<PairOff> off; // of each pair
    PartFigures figures;
};

// Least pairs of each photo.
inline constexpr int leastPairs = 6;
// From so many in all photos together on k1 is fitted, from twice as many k2.
inline constexpr int pairsForDistortion = 30;

// One camera for photos of one size. Its lens is `lens`, where it is known; else k1 and k2 are
// fitted as far as there are pairs for them, and 0. Throws Error where the
// pairs are too few or do not tell the camera: all in one plane, say, or of a mirrored photo.
// `where` names them.
PartView fitPartCamera(const std::vector<PlacePair>& pairs, int photos, QSize picture,
                       const QString& where, const std::optional<Lens>& lens = {});

// The same camera's figures of other pairs of its photos.
PartView viewOf(const PartView& camera, const std::vector<PlacePair>& pairs, QSize picture);

// Those of one photo's pairs alone; `view` is of all of them.
PartFigures figuresOfPhoto(const PartView& view, const std::vector<PlacePair>& pairs, int photo,
                           QSize picture);

// Where a place of the model appears, in pixels.
Eigen::Vector2d seenAt(const PartView& view, int photo, QSize picture,
                       const Eigen::Vector3d& model);

} // namespace dipwright
