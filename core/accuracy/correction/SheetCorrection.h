// Corrects the next sheet for the error that repeats in the parts made so far
// (docs/inspection.md, "As built").
#pragma once

#include "accuracy/correction/RepeatingError.h"
#include "base/Units.h"

#include <QImage>
#include <QString>

namespace dipwright {

// Tells whether the sheet of a dip, counted from 1, is corrected.
bool isCorrected(const AsBuilt& built, int dip);

enum class Resampling { Linear, Nearest };

// Returns the corrected film image of a sheet of `width` × `height`. Each pixel takes its colour
// from a place that is displaced by `strength` times the error, interpolated in linear light. The
// result is RGBA8888; a wide image keeps its format. Uses all cores; deterministic.
// Pictures whose pixels are no colours, such as amounts of ink, take the nearest pixel instead.
QImage correctedImage(const QImage& filmImage, Millimetres width, Millimetres height,
                      const RepeatingError& error, double strength,
                      Resampling resampling = Resampling::Linear);

// Returns where a corrected sheet shows the place `place` of the uncorrected sheet, in mm.
Eigen::Vector2d printedAt(const Eigen::Vector2d& place, const RepeatingError& error,
                          double strength);

// Describes the repeating error to the user. `error` must not be isNothing().
QString repeatingSentence(const RepeatingError& error, int dip);

// Draws the sheet with the measured errors and the correction of the next sheet as enlarged arrows.
// The picture is `pixels` high. Needs a QGuiApplication.
QImage correctionPicture(const RepeatingError& error, Millimetres width, Millimetres height,
                         double strength, int pixels);

} // namespace dipwright
