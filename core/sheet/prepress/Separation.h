// Separates a sheet's film into a printer's inks, as every CMYK page needs it.
#pragma once

#include "sheet/page/Sheet.h"
#include "sheet/pdf/Plates.h"

#include <memory>

namespace dipwright {

class PlateCompensation;

// Separates the sheet's film on white paper into the inks of `correction`, within its limit of
// total area coverage, and into the sheet's spot inks. The colour of `correction` must be CMYK. If
// the sheet has the film's stretch, the wanted colours are separated first, and then each ink is
// compensated by its own law (PlateCompensation). Where the sheet has amounts of ink, these are
// taken instead of colours (PrinterColour::convertInks). Uses all cores.
Plates separate(const Sheet& sheet, const PrintCorrection& correction);

// Separates some rows of a sheet's film, as separate() does. Const members may be used from several
// threads.
class RowSeparation {
public:
    // Keeps a reference to `correction`.
    RowSeparation(const Sheet& sheet, const PrintCorrection& correction);
    ~RowSeparation();

    Plates plates(int first, int end) const; // of the rows first … end - 1
    PackedPlates packed() const;             // of all rows

private:
    QByteArray cmyk(const Sheet& rows) const;

    Sheet sheet_; // with its plates continued past the cut contour
    const PrintCorrection& correction_;
    std::unique_ptr<const PlateCompensation> law_; // null: the sheet has no wanted colours
};

// Returns the area of the part, in mm², that stays visibly paler than wanted. There, full ink does
// not compensate the stretch, or one of the two ink limits forbids more ink. 0 if the sheet does
// not have the film's stretch, or is not compensated.
double inkShortfall(const Sheet& sheet, const PrintCorrection& correction);

// How much of one ink a sheet takes.
struct InkArea {
    QString ink;          // "Cyan", "Magenta", "Yellow", "Black", or the name of a spot ink
    double area = 0;      // mm² of the film at full tint: the sum of the plate's tints
    int process = -1;     // 0 … 3 of cyan, magenta, yellow and black; −1: a spot ink
    bool isWhite = false; // the white layer
    bool operator==(const InkArea&) const = default;
};
// Returns the inks of the sheet's picture, of all passes, in printing order; marks and lettering
// are not counted. If `correction` has a CMYK colour, they are the inks of separate(). Otherwise
// the printer's driver makes the plates, and the inks are estimated: cyan is 1 − red, magenta 1 −
// green and yellow 1 − blue of the sRGB values, without black. Uses all cores; deterministic.
std::vector<InkArea> inkAreas(const Sheet& sheet, const PrintCorrection& correction);
// Tells whether inkAreas() estimated these inks.
bool areEstimated(const std::vector<InkArea>& inks);

// Returns a sentence, without full stop, for the white layer and for the spot colours if the sheet
// has them and its printer cannot print them: they need a printer profile with an ICC profile in
// CMYK. `isSeparated`: whether there is one.
QStringList lostPlates(const Sheet& sheet, bool isSeparated);

// Returns the amounts of the four inks on the bare paper around the film.
std::array<char, 4> bareInks(const PrinterColour& colour);

// Returns a copy of the plate (Grayscale8) whose hard edges lie `choke` pixels further inside.
// Where a tint fades to nothing, as at the seam of two dips, it stays as it is.
QImage choked(const QImage& tint, double choke);

// Reduces pixels whose four inks sum to more than `most` (4: full ink of each). Cyan, magenta and
// yellow are scaled by one factor, which keeps the hue. Black is reduced only if black alone
// exceeds `most`, because it gives the most darkness for the least ink.
void limitInk(QByteArray& cmyk, double most);

} // namespace dipwright
