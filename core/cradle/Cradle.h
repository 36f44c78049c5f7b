// Makes the cradle that holds a body over the film: a form that fits its dry upper side, under a
// plate.
//
// The body leaves the cradle downwards, in the direction of the dip. Imagine that the body,
// enlarged by the clearance, is drawn down through a block: the rest of the block is the cradle.
// The cradle therefore has no undercuts, even if the body has some. docs/cradle.md explains the
// clearances.
#pragma once

#include "base/Progress.h"
#include "cradle/CradleCheck.h"
#include "cradle/DatumPins.h"
#include "geometry/TriangleMesh.h"
#include "settings/CradleSettings.h"

#include <Eigen/Geometry>
#include <QStringList>
#include <vector>

namespace dipwright {

struct DistanceField;
class LaidFilm;
class SurfaceMask;
struct Immersion;
struct ProcessSettings;

// The dip that a cradle is made for. Owns nothing; the references must stay valid.
struct HeldDip {
    const LaidFilm& film; // the film of this dip, laid on the body in its pose
    // Films of the earlier dips, on the same body in other poses.
    std::vector<const LaidFilm*> earlier;
    const DistanceField& field; // distance field of the body, in model coordinates
    const Immersion& immersion;
    const ProcessSettings& process;
    const DatumPins& pins;
    int number = 1;                    // number of the dip, from 1
    QString jobHash;                   // hash of the job, for the engraving
    const SurfaceMask* mask = nullptr; // the cradle may touch masked surface; null: none
};

struct Cradle {
    TriangleMesh mesh; // closed, in the body's pose frame; empty if no cradle is possible
    // Maps to a 3D printer's bed: Z up, plate on the bed, its corner at the origin.
    Eigen::Isometry3d poseToPrinter = Eigen::Isometry3d::Identity();
    double clearance = 0; // distance to the body as set by the user, mm
    double cell = 0;      // cell of the grid on which the form was computed, mm
    CradleCheck check;
    QStringList notes; // sentences for the user: why there is no cradle, what to watch for
};

// Makes the cradle for a dip. Uses all cores; deterministic. Needs a QGuiApplication to engrave
// text (platform "offscreen" is enough). Throws Cancelled.
Cradle makeCradle(const HeldDip& dip, const CradleSettings& settings, const Progress& progress);

} // namespace dipwright
