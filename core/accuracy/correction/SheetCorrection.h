// The next sheet, printed so that what the parts before it were off does not come again
// (docs/inspection.md, "As built").
#pragma once

#include "accuracy/correction/RepeatingError.h"
#include "base/Units.h"

#include <QImage>
#include <QString>

namespace dipwright {

// Whether the sheet of a dip, from 1, is another one for it.
bool isCorrected(const AsBuilt& built, int dip);

// The film image of a sheet of `width` × `height`, each pixel in the colour that the film as it was
// made has `strength` times the error farther on; between pixels in linear light. RGBA8888, or wide
// as it is. All cores, deterministic.
QImage correctedImage(const QImage& filmImage, Millimetres width, Millimetres height,
                      const RepeatingError& error, double strength);

// Where the film of `place` is printed on a corrected sheet, mm.
Eigen::Vector2d printedAt(const Eigen::Vector2d& place, const RepeatingError& error,
                          double strength);

// What repeats in the parts, a sentence for the user. Of something.
QString repeatingSentence(const RepeatingError& error, int dip);

// Arrows on the sheet from each place to where its film is meant to lie, enlarged, over the smooth
// error that the correction takes; `height` pixels. Needs a QGuiApplication.
QImage correctionPicture(const RepeatingError& error, Millimetres width, Millimetres height,
                         double strength, int pixels);

} // namespace dipwright
