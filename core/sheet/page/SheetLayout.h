// Where things stand on a sheet: the film, the registration marks, the ruler and the job line.
//
// Marks, ruler and job line keep clear of the page's edge, where printers do not reach, and look
// for a place that the film image leaves unprinted. Only where there is none (an image that covers
// the whole film) they stand on the image, with a white rim to be legible.
#pragma once

#include "sheet/page/Sheet.h"

#include <optional>
#include <vector>

namespace dipwright {

// A strip along one edge of the page, with coordinates of its own: (0, 0) at `origin`, the first
// axis along the reading direction, `size` in mm, turned clockwise by `angle` degrees on the page.
struct SheetStrip {
    QPointF origin;
    double angle = 0;
    QSizeF size;
    bool overPaint = false;

    QRectF box() const; // on the page
};

struct SheetMark {
    QPointF centre;
    bool overPaint = false;
    QRectF box() const; // on the page
};

// Page coordinates: mm from the page's upper left corner.
struct SheetLayout {
    QSizeF page;
    QRectF film;
    std::vector<SheetMark>
        marks; // of the film's corners: upper left, upper right, lower left, lower right
    std::optional<SheetStrip>
        ruler; // its scale runs along the whole strip less `rulerEnd` on each side
    std::optional<SheetStrip> jobLine;
    QString jobLineText;
    double jobLineHeight = 0;       // of its type, mm
    std::vector<SheetPiece> pieces; // of several jobs: each has marks and a job line of its own
};

// Whether a pixel, red, green, blue and alpha a byte each, is printed at all.
inline bool prints(const uchar* pixel) {
    return pixel[3] != 0 && (pixel[0] & pixel[1] & pixel[2]) != 255;
}

inline constexpr double markReach = 3;  // mm from a mark's centre to the ends of its cross
inline constexpr double rulerEnd = 5;   // mm of a ruler's strip before 0 and after its last line
inline constexpr double rulerDepth = 5; // mm

// Throws Error as pageSize() does.
SheetLayout sheetLayout(const Sheet& sheet);

// The type that marks are set in, at `height` mm for a painter whose unit is the millimetre times
// `typeUnit` (a QFont has no sizes below a whole unit).
inline constexpr double typeUnit = 0.01;
QFont sheetFont(double height);

} // namespace dipwright
