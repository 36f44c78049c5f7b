// The user's settings for the sheet and its page, as in the project file's "sheet".
#pragma once

#include "base/Units.h"

#include <QString>

namespace dipwright {

// Where the cut contour is drawn: around all ink, or along the film's edge.
enum class CutLine { None, Ink, Film };

// The white plate. Printed last, it touches the body and lies under the colours. Printed
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
    // The cut contour. A CMYK PDF has it in a spot ink of its own.
    CutLine cutLine = CutLine::None;
    Millimetres cutDistance{3};                     // from the ink to the cut contour
    QString cutName = QStringLiteral("CutContour"); // name of that spot ink
    // Bleed of all plates beyond the cut contour; only for CutLine::Ink and CMYK. It continues the
    // colours at the edge of the painted film, and ends at the film's edge.
    Millimetres cutBleed{0};
    WhiteLayer white = WhiteLayer::None;
    double whiteDensity = 1; // wanted density on the body, as a share of full tint
    // choke: how far the edge of the white stays inside the edge of the colour, on the film
    Millimetres whiteChoke{0.2};
    QString whiteName = QStringLiteral("White");
    bool operator==(const SheetSettings&) const = default;
};

} // namespace dipwright
