// Corrects the next sheet for the error that repeats in the parts made so far
// (docs/inspection.md, "As built").
#pragma once

#include "accuracy/correction/RepeatingError.h"
#include "base/Units.h"

#include <QImage>
#include <QString>

namespace dipwright {

// Whether the sheet of a dip, counted from 1, is corrected.
bool isCorrected(const AsBuilt& built, int dip);

// Returns the corrected film image of a sheet of `width` × `height`. Each pixel takes its colour
// from `strength` times the error away, interpolated in linear light. RGBA8888; a wide image keeps
// its format. All cores, deterministic.
QImage correctedImage(const QImage& filmImage, Millimetres width, Millimetres height,
                      const RepeatingError& error, double strength);

// Returns where the film of `place` is printed on a corrected sheet, in mm.
Eigen::Vector2d printedAt(const Eigen::Vector2d& place, const RepeatingError& error,
                          double strength);

// Describes the repeating error to the user. `error` must not be isNothing().
QString repeatingSentence(const RepeatingError& error, int dip);

// Draws the measured errors on the sheet as enlarged arrows, over the smooth error that the
// correction uses. The picture is `pixels` high. Needs a QGuiApplication.
QImage correctionPicture(const RepeatingError& error, Millimetres width, Millimetres height,
                         double strength, int pixels);

} // namespace dipwright
