// Places the film, the registration marks, the ruler and the job line on a sheet.
//
// Marks, ruler and job line keep a distance from the page's edge, where printers do not print. They
// stand where the film image is unprinted, with a shorter ruler or text if need be. If it leaves no
// room, they stand on the image, with a white rim.
#pragma once

#include "sheet/page/Sheet.h"

#include <optional>
#include <vector>

namespace dipwright {

// A strip along one edge of the page. It has its own coordinates: (0, 0) is at `origin`, and the
// first axis is the reading direction. `size` is in mm. `angle` is the strip's clockwise rotation
// on the page in degrees.
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

// The places of all items on the page, in mm from the page's upper left corner.
struct SheetLayout {
    QSizeF page;
    QRectF film;
    std::vector<SheetMark>
        marks; // at the film's corners: upper left, upper right, lower left, lower right
    std::optional<SheetStrip> ruler; // the scale leaves `rulerEndRoom` free at each end
    std::optional<SheetStrip> jobLine;
    QStringList jobLineText;        // the job line's lines of text
    double jobLineHeight = 0;       // font height, mm
    std::vector<SheetPiece> pieces; // several jobs, each with its own marks and job line
};

// Tells whether a pixel is printed. `pixel` points to one byte each for red, green, blue and alpha.
inline bool prints(const uchar* pixel) {
    return pixel[3] != 0 && (pixel[0] & pixel[1] & pixel[2]) != 255;
}

// Returns the name on one line of at most 40 letters that the marks' font can draw.
QString nameOnPaper(const QString& name);

inline constexpr double markReach = 3; // mm from a mark's centre to the ends of its cross
inline constexpr double rulerEndRoom =
    5;                                  // mm of the ruler's strip before 0 and after the last line
inline constexpr double rulerDepth = 5; // mm
inline constexpr double jobLineType = 2.2; // mm, font height of job lines and labels
inline constexpr double jobLinePitch = 3;  // mm between two lines of text

// Returns the layout. Throws the same errors as pageSize().
SheetLayout sheetLayout(const Sheet& sheet);

// Returns a sentence, without a full stop, if marks, ruler or job line cover ink; empty if not, or
// if the film does not fit on the paper.
QString coveredPictureNote(const Sheet& sheet);

// Returns the size of the paper, even if the film does not fit on it. Throws Error if the paper's
// name is unknown.
QSizeF paperSize(const Sheet& sheet);

// Returns how far the registration marks are from the film's middle, to each side, in printed mm.
// None if the film is too small for marks, or if the paper round it, which is cut off, has them.
// Does not depend on whether marks are printed. Throws the same errors as pageSize().
std::optional<QPointF> marksOnFilm(const Sheet& sheet);

// Painter unit for text, mm. It is small because a QFont has no sizes below a whole unit.
inline constexpr double typeUnit = 0.01;
// Returns the font of the marks, `height` mm high, for a painter whose unit is `typeUnit`.
QFont sheetFont(double height);

} // namespace dipwright
