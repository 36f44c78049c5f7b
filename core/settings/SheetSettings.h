// The user's settings for the sheet and its page, as in the project file's "sheet".
#pragma once

#include "base/Units.h"

#include <QString>

namespace dipwright {

// Where the cut contour is drawn: around all ink, or along the film's edge.
enum class CutLine { None, Ink, Film };

// The white plate. Printed last, it touches the body and lies under the part's colour. Printed
// first, it lies outside, over the colour.
enum class WhiteLayer { None, Last, First };

struct SheetSettings {
    QString paper = QStringLiteral("film"); // film (the page is the film), A4, A3, Letter, custom
    bool landscape = false; // rotates A4, A3 and Letter; film and custom pages stay as given
    Millimetres customWidth{210};
    Millimetres customHeight{297};
    DotsPerInch resolution{300};
    Millimetres bleed{2};
    bool marks = true;
    bool ruler = true;
    bool jobLine = true;
    // In a CMYK PDF: the cut contour as a spot ink of this name, and its distance from the ink.
    CutLine cutLine = CutLine::None;
    Millimetres cutDistance{3};
    QString cutName = QStringLiteral("CutContour");
    // How far all plates continue beyond the cut contour around the ink, in CMYK. The colours are
    // those at the edge of the painted film. The film's edge limits it.
    Millimetres cutBleed{0};
    WhiteLayer white = WhiteLayer::None;
    double whiteDensity = 1; // wanted on the body, as a share of full tint
    // choke: how far white is smaller than the colour all round, on the film
    Millimetres whiteChoke{0.2};
    QString whiteName = QStringLiteral("White");
    bool operator==(const SheetSettings&) const = default;
};

} // namespace dipwright
