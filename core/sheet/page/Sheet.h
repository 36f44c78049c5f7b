// The page as it leaves the printer: film image, marks, ruler and job line at true size.
//
// Everything here that sets type (all but sheetPixels, pageSize and flattened) needs a
// QGuiApplication; the "offscreen" platform will do. All functions are reentrant.
#pragma once

#include "base/Units.h"
#include "settings/InkSettings.h"
#include "settings/SheetSettings.h"

#include <QImage>
#include <QPainter>
#include <optional>
#include <vector>

namespace dipwright {

class PrinterColour;

// What the job line says. The hash identifies image and settings; no time of day, so that the same
// project gives the same sheet bit for bit; `date` is the project's own.
struct JobLine {
    QString project, immersion, date, film, scale, hash;
};

// One of several jobs on a film (FilmPacking.h): where its picture lies in the sheet's image, and
// what is printed round it. Lengths in mm.
struct SheetPiece {
    QPointF corner; // of its box on the page, the upper left one
    QSizeF size;    // of all that is cut out, as it stands upright
    QRectF picture; // in it, upright: what is inked
    QPointF middle; // in it, upright: of its job's own film, over which the body's place counts
    bool turned = false; // on the page, by a quarter clockwise
    JobLine job;
    int dip = 1, copy = 1, copies = 1; // from 1
    bool marks = true, jobLine = true;

    QRectF box() const { return {corner, turned ? size.transposed() : size}; } // on the page
};

// A plate beside the four inks: white, varnish, a colour of its own.
struct SheetPlate {
    QString name;       // of its ink, as raster image processors know it
    QImage tint;        // of the film image's size, Grayscale8, 255 full tint
    bool first = false; // printed before the four inks, so that it ends up outside them
    QColor alternate{}; // what stands for full ink where the name is not known; invalid: nothing
};

// What printers of inks need to compensate each of these by itself, after separation.
struct WantedInk {
    QImage image;   // what is to show, of the film image's size and colours, not compensated
    QImage stretch; // of the film there, of its size: Grayscale16, codes of texture/StretchPlane.h
    InkSettings settings;
};

// A film image at its printed size with what is printed round it.
struct Sheet {
    QImage image; // ink side up, the film's printed size; sRGB or wide
    Millimetres filmWidth{210}, filmHeight{297}; // printed size
    SheetSettings settings;
    JobLine job;
    // Of marks, ruler and job line from the page's edge; more where a printer reaches less.
    Millimetres clearance{3};
    std::vector<SheetPlate> plates = {};  // in the order of printing
    std::optional<WantedInk> wanted = {}; // none: the film image is what is printed, in any colours
    std::vector<SheetPiece> pieces = {};  // empty: the image is of one job
};

// The job of several sheets together, twelve hex digits of a SHA-256. `jobs`: those of the sheets.
QString hashOfJobs(const QStringList& jobs);

inline constexpr int mostSheetPixels = 32'000; // a side: QImage and QPainter count in 16 bits
// Pixels of a film image at true size: A4 at 300 dpi is 2480 × 3508. Throws Error past
// mostSheetPixels a side.
QSize sheetPixels(Millimetres width, Millimetres height, DotsPerInch resolution);
// The page in mm for this film; throws Error when the paper is smaller than the film or unknown.
QSizeF pageSize(const Sheet& sheet);
// The film image on white, opaque, in its own colours: RGB888 in sRGB, or wide (RGBX64).
QImage onPaper(const QImage& filmImage);
// The same in sRGB (Format_RGB888): what is seen, and what a printer without an ICC profile is
// sent.
QImage flattened(const QImage& filmImage);
// The same, `width` pixels wide, its height in proportion; large pictures without a copy.
QImage reduced(const QImage& filmImage, int width);
// Draws the whole page with a painter whose unit is the millimetre and whose origin is the page's
// upper left corner: used by the PDF, the printer and the preview.
void paintSheet(QPainter& painter, const Sheet& sheet);

// What stands between the sheet and true size and colour on one printer's paper.
struct PrintCorrection {
    // Printed length over true length, measured; the page is drawn smaller by these about its
    // middle, and comes out true.
    double scaleX = 1, scaleY = 1;
    const PrinterColour* colour = nullptr; // not owned; null: sRGB
    // Most of the four inks together on one place, full ink of one being 1; none: what the colour
    // asks for.
    std::optional<double> totalInk = {};
    // The page lies across the paper, its upper left corner in the paper's upper right one.
    bool acrossPaper = false;
};

// Makes a painter whose unit is the millimetre and whose origin is the paper's upper left corner
// draw smaller by the correction's scales.
void correctScale(QPainter& painter, QSizeF paper, const PrintCorrection& correction);
// Draws the page onto the paper, in sRGB.
void paintCorrectedSheet(QPainter& painter, const Sheet& sheet, const PrintCorrection& correction);

} // namespace dipwright
