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

// The largest change of the error, per mm of the sheet, that counts as possible. Film that swells
// unevenly or flows changes it by a few per cent. If sheet and part were measured in different
// directions, it is about 2: s + error(s) then folds, turns or mirrors the sheet.
inline constexpr double mostErrorGradient = 0.5;

// Returns the largest change of the error between neighbouring places of a sheet of `width` ×
// `height`, per mm of their distance. Uses all cores.
double errorGradient(const RepeatingError& error, Millimetres width, Millimetres height);

// Throws Error, naming `where`, if errorGradient() of a dip exceeds mostErrorGradient. Such errors
// must not be corrected, whatever the strength. `width` × `height` is the size of the sheets.
void requirePossibleErrors(const AsBuilt& built, Millimetres width, Millimetres height,
                           const QString& where);

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
