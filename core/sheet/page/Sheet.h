// Describes and draws the printed page: film image, marks, ruler and job line at true size.
//
// Functions that draw text need a QGuiApplication; the "offscreen" platform suffices. sheetPixels,
// pageSize and flattened draw no text. All functions are reentrant.
#pragma once

#include "base/InkPicture.h"
#include "base/Units.h"
#include "settings/InkSettings.h"
#include "settings/PdfTarget.h"
#include "settings/SheetSettings.h"

#include <QImage>
#include <QPainter>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace dipwright {

class PrinterColour;
struct Sheet;
struct SheetLayout;

// The content of the job line. `hash` identifies image and settings. `date` is the project's own
// date, not the current one, so that the same project always gives the same sheet.
struct JobLine {
    QString project, immersion, date, film, scale, hash;
};

// One of several jobs on a film (FilmPacking.h): its place in the sheet's image, and what is
// printed around it. Lengths in mm.
struct SheetPiece {
    QPointF corner;      // upper left corner of its box on the page
    QSizeF size;         // size of the whole cut-out piece, upright
    QRectF picture;      // inked part, in the upright piece
    QPointF middle;      // centre of its job's film (offset 0), in the upright piece
    bool turned = false; // whether the piece is turned clockwise by 90° on the page
    JobLine job;
    int dip = 1, copy = 1, copies = 1; // counted from 1
    bool marks = true, jobLine = true;
    double cutReach = 0; // from the inked part to the end of the cut contour's bleed (CutContour.h)
    // Set for a whole sheet in a series on a roll: what is printed around its film. The sheet is
    // cut out along its edge, between the cut marks.
    std::shared_ptr<const SheetLayout> whole = {};
    double gap = 0; // mm of bare film around a whole sheet, for the cut marks

    // The piece's box on the page.
    QRectF box() const { return {corner, turned ? size.transposed() : size}; }
    // The inked part's box on the page.
    QRectF pictureOnPage() const {
        const QRectF upright = turned ? QRectF(size.height() - picture.bottom(), picture.left(),
                                               picture.height(), picture.width())
                                      : picture;
        return upright.translated(corner);
    }
};

// A plate besides the four inks: white, varnish or another spot colour.
struct SheetPlate {
    QString name;       // ink name that raster image processors know
    QImage tint;        // size of the film image, Grayscale8, 255 is full tint
    bool first = false; // printed before the four inks, so that it lies outermost on the part
    QColor alternate{}; // colour of full ink where the name is unknown; invalid: no colour
};

// What a CMYK printer needs to compensate each ink separately, after separation.
struct WantedInk {
    QImage image;   // the wanted colours, not compensated; size and colour space as the film image
    QImage stretch; // the film's stretch, same size: Grayscale16, codes of texture/StretchPlane.h
    InkSettings settings;
    // The amounts of ink of pictures in CMYK, not compensated; same size. Null: there are none.
    InkPlanes inks = {};
};

// Makes the pictures of a film that is too large to keep them, such as metres of a roll.
struct FilmRows {
    QSize pixels; // size of the film image
    // Returns a sheet with the rows first … end - 1 of the film image, of all plates and of the
    // wanted colours. Called from several threads.
    std::function<Sheet(int first, int end)> make;
};

// A film image at its printed size, and what is printed around it.
struct Sheet {
    QImage image;                                // ink side up, the whole film; sRGB or wide
    Millimetres filmWidth{210}, filmHeight{297}; // size as printed
    SheetSettings settings;
    JobLine job;
    // Distance of marks, ruler and job line from the page's edge; larger for printers with larger
    // margins.
    Millimetres clearance{3};
    std::vector<SheetPlate> plates = {};  // in printing order
    std::optional<WantedInk> wanted = {}; // none: print the image as it is
    std::vector<SheetPiece> pieces = {};  // several jobs on the film; empty: a single job
    // Set if the pictures are made on demand (SheetRows.h). `image`, the plates' tints and the
    // wanted colours are then null images.
    std::shared_ptr<const FilmRows> rows = {};
    int passes = 1; // how many times the sheet is to be printed onto the same film
};

// Whether a plate is the white layer of a sheet with these settings.
bool isWhite(const SheetPlate& plate, const SheetSettings& settings);

// Returns one job number for several sheets: twelve hexadecimal digits of a SHA-256 of `jobs`, the
// sheets' job numbers.
QString hashOfJobs(const QStringList& jobs);

// Most pixels per side of a film image in memory, because QImage and QPainter count in 16 bits.
inline constexpr int mostSheetPixels = 32'000;
// Returns the film image's size in pixels at true size: A4 at 300 dpi is 2480 × 3508. Throws Error
// if a side has more than mostSheetPixels.
QSize sheetPixels(Millimetres width, Millimetres height, DotsPerInch resolution);
// Returns the page size in mm for this film. Throws Error if the paper is unknown or smaller than
// the film.
QSizeF pageSize(const Sheet& sheet);
// Returns the film image on white, opaque, in its own colours: RGB888 in sRGB, or wide (RGBX64).
QImage onWhitePaper(const QImage& filmImage);
// Returns the film image on white in sRGB (Format_RGB888), for the screen and for printers without
// an ICC profile.
QImage flattened(const QImage& filmImage);
// Returns the film image on white in sRGB, reduced to `width` pixels in width and proportionally in
// height. Does not copy a large image as a whole.
QImage reduced(const Sheet& sheet, int width);
// Draws the whole page for PDF, printer and preview. The painter's unit is the millimetre, its
// origin the page's upper left corner.
void paintSheet(QPainter& painter, const Sheet& sheet);

// Corrections that one printer's paper needs for true size and colour.
struct PrintCorrection {
    // Measured printed length divided by true length. The page is scaled about its middle by the
    // inverse of these factors, so that it is printed at true size.
    double scaleX = 1, scaleY = 1;
    const PrinterColour* colour = nullptr; // not owned; null: sRGB
    // Limit of total area coverage: the largest sum of the four inks at one place. Full ink of one
    // plate counts as 1. None: no limit.
    std::optional<double> totalInk = {};
    // The raster image processor that a CMYK PDF is made for.
    PdfTarget pdfTarget = PdfTarget::Ghostscript;
    // Whether a TIFF has one resolution in X and Y: if the scales differ, its pixels are resampled.
    bool squarePixels = false;
    // True if the page is turned by 90°, so that its upper left corner lies in the paper's upper
    // right corner.
    bool acrossPaper = false;
};

// Scales the painter down by the correction's scales. The painter's unit is the millimetre, its
// origin the paper's upper left corner.
void correctScale(QPainter& painter, QSizeF paper, const PrintCorrection& correction);
// Draws the page onto the paper, in sRGB.
void paintCorrectedSheet(QPainter& painter, const Sheet& sheet, const PrintCorrection& correction);

} // namespace dipwright
