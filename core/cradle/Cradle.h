// What holds a body over the film: a form that takes its dry upper side, under a plate.
//
// The body is taken out of the cradle downwards, in the direction of the dip. A cradle is therefore
// what is left of a block after the body, swelled by the clearance, was drawn down through it: it
// has no undercuts, whatever the body has. docs/cradle.md says what is kept clear of what, and why.
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

class DistanceField;
class LaidFilm;
struct Immersion;
struct ProcessSettings;

// A dip to hold a body in. Nothing is owned.
struct HeldDip {
    const LaidFilm& film; // at the end of this dip, on the body in its pose
    // Of the dips before it, on the same body in other poses.
    std::vector<const LaidFilm*> earlier;
    const DistanceField& field; // of the body in model coordinates
    const Immersion& immersion;
    const ProcessSettings& process;
    const DatumPins& pins;
    int number = 1;  // of the immersion
    QString jobHash; // for the engraving
};

struct Cradle {
    TriangleMesh mesh; // closed, in the body's pose frame; empty where nothing can be held
    // To the bed of a printer: Z up, the plate down, its corner at the origin.
    Eigen::Isometry3d poseToPrinter = Eigen::Isometry3d::Identity();
    double clearance = 0; // mm, as asked for
    double cell = 0;      // mm, of the grid that its form was computed on
    CradleCheck check;
    QStringList notes; // sentences for the user: why there is none, what to mind
};

// All cores; deterministic. Engraving sets type: needs a QGuiApplication ("offscreen" will do).
// Throws Cancelled.
Cradle makeCradle(const HeldDip& dip, const CradleSettings& settings, const Progress& progress);

} // namespace dipwright
