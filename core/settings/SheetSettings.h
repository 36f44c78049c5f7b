// What the user says of the page, as in the project file's "sheet".
#pragma once

#include "base/Units.h"

#include <QString>

namespace dipwright {

// Where a line to cut along is drawn: round all ink, or along the film's edge.
enum class CutLine { None, Ink, Film };

// A plate of white: printed last it touches the body, and lies under the colour of the part.
// Printed first it lies on the outside, over the colour.
enum class WhiteLayer { None, Last, First };

struct SheetSettings {
    QString paper = QStringLiteral("film"); // film (the page is the film), A4, A3, Letter, custom
    bool landscape = false; // turns A4, A3 and Letter; film and custom pages are as they are given
    Millimetres customWidth{210};
    Millimetres customHeight{297};
    DotsPerInch resolution{300};
    Millimetres bleed{2};
    bool marks = true;
    bool ruler = true;
    bool jobLine = true;
    // In a PDF in CMYK, as a spot ink of this name; its distance from the ink.
    CutLine cutLine = CutLine::None;
    Millimetres cutDistance{3};
    QString cutName = QStringLiteral("CutContour");
    // How far beyond the line round the ink all plates go on, in CMYK: colours as at the painted
    // film's edge, as far as the film goes.
    Millimetres cutBleed{0};
    WhiteLayer white = WhiteLayer::None;
    double whiteDensity = 1;     // wanted on the body, share of full tint
    Millimetres whiteChoke{0.2}; // so much smaller than the colour all round, on the film
    QString whiteName = QStringLiteral("White");
    bool operator==(const SheetSettings&) const = default;
};

} // namespace dipwright
