// Places the film, the registration marks, the ruler and the job line on a sheet.
//
// Marks, ruler and job line keep away from the page's edge, which printers do not reach. They take
// a place that the film image leaves unprinted. If there is none, because the image fills the whole
// film, they stand on the image with a white rim to be legible.
#pragma once

#include "sheet/page/Sheet.h"

#include <optional>
#include <vector>

namespace dipwright {

// A strip along one edge of the page, with its own coordinates: (0, 0) at `origin`, the first axis
// along the reading direction. `size` is in mm. The strip is turned clockwise on the page by
// `angle` degrees.
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
        marks; // at the film's corners: upper left, upper right, lower left, lower right
    std::optional<SheetStrip> ruler; // its scale fills the strip except `rulerEnd` at each end
    std::optional<SheetStrip> jobLine;
    QString jobLineText;
    double jobLineHeight = 0;       // type height, mm
    std::vector<SheetPiece> pieces; // with several jobs; each has its own marks and job line
};

// Tells whether a pixel prints. It has one byte each for red, green, blue and alpha.
inline bool prints(const uchar* pixel) {
    return pixel[3] != 0 && (pixel[0] & pixel[1] & pixel[2]) != 255;
}

inline constexpr double markReach = 3;  // mm from a mark's centre to the ends of its cross
inline constexpr double rulerEnd = 5;   // mm of the ruler's strip before 0 and after the last line
inline constexpr double rulerDepth = 5; // mm

// Throws the same errors as pageSize().
SheetLayout sheetLayout(const Sheet& sheet);

// Returns the font of the marks, `height` mm high for a painter whose unit is `typeUnit` mm, since
// a QFont has no sizes below a whole unit.
inline constexpr double typeUnit = 0.01;
QFont sheetFont(double height);

} // namespace dipwright
