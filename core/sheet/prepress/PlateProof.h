// Shows and measures the plates of a sheet's film as print files contain them: a separation
// preview. Marks and lettering are not on these plates. All functions use all cores, are
// deterministic and may be called from any thread.
#pragma once

#include "sheet/page/Sheet.h"
#include "sheet/pdf/Plates.h"

#include <QColor>
#include <QJsonObject>

namespace dipwright {

// One plate of Plates.
struct ProofPlate {
    QString ink;     // "Cyan", "Magenta", "Yellow", "Black", or the name of a spot ink
    int channel = 0; // 0 … 3: process inks; 4 and above: spot inks in the order of Plates::spots
    QColor colour;   // of full ink on white, in sRGB
    bool isWhite = false; // covers what lies beneath instead of colouring it
};
// Returns the plates in printing order.
std::vector<ProofPlate> proofPlates(const Plates& plates, const PrinterColour& colour);

// Amounts of ink. Tints and sums of tints are shares of full ink of one plate, areas mm² of film.
struct PlateFigures {
    ProofPlate plate;
    double fullTintArea = 0; // the sum of the tints: the area at full tint with the same ink
    double inkedArea = 0;    // with any ink of this plate
    double mostTint = 0;
};
struct InkFigures {
    std::vector<PlateFigures> plates; // in printing order
    double inkedArea = 0;             // with any ink of the four process plates
    // The sum of the four process inks: its largest value, and its 95th percentile where there is
    // ink. The sum of all plates at one place: its largest value.
    double mostInk = 0, ink95 = 0, mostOfAllPlates = 0;
    std::optional<double> limit; // of the sum of the four inks, or none
    double areaAbove = 0;        // where the sum exceeds `limit`
    double shareAbove() const { return inkedArea > 0 ? areaAbove / inkedArea : 0; }
};
// `film` is the size of the film in mm.
InkFigures inkFigures(const Plates& plates, const PrinterColour& colour, QSizeF film,
                      const std::optional<double>& limit);
// Returns the figures as a table for the terminal, and as the content of plates.json. A sheet that
// is printed in several `passes` has these figures in each pass.
QString figuresTable(const InkFigures& figures, int passes = 1);
QJsonObject figuresJson(const InkFigures& figures);

// Returns the tint of one channel at a pixel, 0 … 255.
int tintAt(const Plates& plates, int channel, QPoint pixel);
// Returns the sum of the four process inks at a pixel, 0 … 4.
double inkAt(const Plates& plates, QPoint pixel);

// Returns the plates in a smaller size: each pixel is the mean of factor × factor pixels. The last
// row and column may be left out.
Plates reducedPlates(const Plates& plates, int factor);

// Returns a plate in grey as a positive: black is full ink. Grayscale8.
QImage greyPlate(const Plates& plates, int channel);
// Returns the print of the chosen channels over `ground`, the colour beneath the film, in sRGB
// (RGB888). White covers the ground.
QImage composite(const Plates& plates, const PrinterColour& colour,
                 const std::vector<bool>& isShown, const QColor& ground = Qt::white);
// Returns a map of the sum of the four inks (RGB32): from white, no ink, to dark blue at the limit
// or, without a limit, at 400 %. Above the limit the map is red.
QImage totalInkMap(const Plates& plates, const std::optional<double>& limit);
// The colours of this map.
QColor totalInkColour(double ink, const std::optional<double>& limit);

// A file of a separation proof.
struct ProofFile {
    QString name;
    QByteArray contents;
};
struct SeparationProof {
    InkFigures figures;
    std::vector<ProofFile> files;
};
// Returns one grey PNG per plate ("plate-1-Cyan.png"), total-ink.png, composite.png, and
// plates.json with the figures. The pictures have the film's resolution.
SeparationProof separationProof(const Sheet& sheet, const PrintCorrection& correction);

} // namespace dipwright
