// Measures the printer's length error: a page with rulers and a chessboard, and the scale that
// follows from the user's measurements.
#pragma once

#include "base/Units.h"

#include <QIODevice>
#include <QPainter>
#include <QSizeF>
#include <QString>

namespace dipwright {

// Describes one calibration page. `scaleX` and `scaleY` are 1 on the first page, which measures the
// printer. On the second page, which verifies it, they are the profile's scales.
struct CalibrationPage {
    QSizeF paper{210, 297}; // mm
    QString printer;        // shown on the page
    double scaleX = 1;
    double scaleY = 1;
    Millimetres clearance{10}; // empty border of the page

    bool verifies() const { return scaleX != 1 || scaleY != 1; }
};

// Lengths of the page's two rulers, in whole centimetres. Throws Error if the paper is too small
// for rulers of 50 mm.
struct CalibrationLengths {
    Millimetres x, y;
};
CalibrationLengths calibrationLengths(const CalibrationPage& page);

// Draws the page without scale correction. The painter's unit is the millimetre, its origin the
// page's upper left corner. Needs a QGuiApplication.
void paintCalibrationPage(QPainter& painter, const CalibrationPage& page);
// Writes the page as a PDF, so that the printer prints it at true size (scaleX, scaleY). The same
// page gives the same bytes. Throws Error.
void writeCalibrationPdf(const CalibrationPage& page, QIODevice& device);

// Returns the scale for the printer's profile: a ruler of the nominal length `length` was printed
// with the scale `printed` and measures `measured` mm. Throws Error if the result differs from 1 by
// more than 10 %, because the printer then scales the page on purpose.
double calibratedScale(double printed, Millimetres length, Millimetres measured);

} // namespace dipwright
