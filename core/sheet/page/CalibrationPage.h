// Finding out how true a printer's lengths are: a page with rulers and a chessboard, and what
// follows from what the user measured on it.
#pragma once

#include "base/Units.h"

#include <QIODevice>
#include <QPainter>
#include <QSizeF>
#include <QString>

namespace dipwright {

// What a calibration page is for: `scaleX` and `scaleY` are 1 for the first page, which measures,
// and the profile's for the second, which verifies.
struct CalibrationPage {
    QSizeF paper{210, 297}; // mm
    QString printer;        // shown on the page
    double scaleX = 1;
    double scaleY = 1;
    Millimetres clearance{10}; // from the page's edges

    bool verifies() const { return scaleX != 1 || scaleY != 1; }
};

// The length of the page's two rulers, in whole centimetres. Throws Error when the paper is too
// small for rulers of 50 mm.
struct CalibrationLengths {
    Millimetres x, y;
};
CalibrationLengths calibrationLengths(const CalibrationPage& page);

// Draws the page as for a true printer, with a painter in mm, origin its upper left corner. Needs a
// QGuiApplication.
void paintCalibrationPage(QPainter& painter, const CalibrationPage& page);
// As a PDF at true size, with the scales corrected. Same bytes for the same page. Throws Error.
void writeCalibrationPdf(const CalibrationPage& page, QIODevice& device);

// The profile's scale after a ruler of the nominal length `length` was printed with scale `printed`
// and measures `measured` mm. Throws Error when that is more than 10 % off, which is no matter of
// calibration but of a printer that was told to scale.
double calibratedScale(double printed, Millimetres length, Millimetres measured);

} // namespace dipwright
