// Corrects the next sheet for the error that repeats in the parts made so far
// (docs/inspection.md, "As built").
#pragma once

#include "accuracy/correction/RepeatingError.h"
#include "base/Units.h"

#include <QImage>
#include <QString>

#include <vector>

namespace dipwright {

// Tells whether the sheet of a dip, counted from 1, is corrected.
bool isCorrected(const AsBuilt& built, int dip);

// The largest change of the error, per mm of the sheet, that counts as possible. Film that swells
// unevenly or flows changes it by a few per cent. If sheet and part were measured in different
// directions, it is about 2: s + error(s) then folds, turns or mirrors the sheet.
inline constexpr double mostErrorGradient = 0.5;

// The error on a grid over a sheet of `width` × `height`, interpolated bilinearly, which is
// accurate to 0.2 %. Made on all cores. Immutable; any thread may read it.
class DenseError {
public:
    DenseError(const RepeatingError& error, Millimetres width, Millimetres height);

    Eigen::Array2d size() const { return size_; } // of the sheet, mm
    // Returns the error in mm. `right` and `down` are fractions of the width and height, 0 … 1.
    Eigen::Vector2d at(double right, double down) const;
    // Returns the largest change of the error between neighbouring places, per mm of their
    // distance.
    double gradient() const;

private:
    const Eigen::Vector2d& value(int column, int row) const {
        return values_[std::size_t(row) * std::size_t(columns_ + 1) + std::size_t(column)];
    }

    Eigen::Array2d size_;
    int columns_, rows_;
    std::vector<Eigen::Vector2d> values_;
};

// Throws Error, naming `where`, if the gradient of a dip's error exceeds mostErrorGradient. Such
// errors must not be corrected, whatever the strength. `width` × `height` is the size of the
// sheets.
void requirePossibleErrors(const AsBuilt& built, Millimetres width, Millimetres height,
                           const QString& where);

// A larger repeating error is possible, but unusual: mm, and the relative change of lengths by the
// affine map that is closest to it. A film that swells otherwise than assumed changes lengths by a
// few per cent.
inline constexpr double mostUsualError = 5, mostUsualLengthChange = 0.08;

// Returns a sentence if the error is unusually large, so that places may have been measured wrongly
// or on another part; empty if it is usual.
QString unusualErrorNote(const RepeatingError& error);

enum class Resampling { Linear, Nearest };

// Returns the corrected film image of the sheet of `error`. Each pixel takes its colour from a
// place that is displaced by `strength` times the error, interpolated in linear light between
// painted pixels. It is painted if the nearest pixel is, so edges stay hard. The result is
// RGBA8888; a wide image keeps its format. Uses all cores; deterministic. Pictures whose pixels are
// no colours, such as amounts of ink, take the nearest pixel instead.
QImage correctedImage(const QImage& filmImage, const DenseError& error, double strength,
                      Resampling resampling = Resampling::Linear);
// The same for the tints of a plate, Grayscale8; 0 is bare.
QImage correctedTints(const QImage& tints, const DenseError& error, double strength);

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
