// Writes a sheet to PNG, PDF and TIFF files. All functions are reentrant; all but writeSheetPng
// need a QGuiApplication.
#pragma once

#include "sheet/page/Sheet.h"
#include "sheet/pdf/PdfDocument.h"

#include <QIODevice>

namespace dipwright {

// Returns the compressed film image on white for RGB files: in the RGB of `colour`, or in sRGB if
// it is null.
PackedPixels packedFilm(const Sheet& sheet, const PrinterColour* colour = nullptr);

// Writes a PNG of the film with its resolution and an sRGB profile. Unprinted areas are white.
// Throws Error if `device` cannot be written.
void writeSheetPng(const Sheet& sheet, QIODevice& device);

// A sheet in the printer's colours, with the settings of its PDF.
struct PreparedSheet {
    Sheet sheet;
    PdfSettings settings;
};
PreparedSheet preparedSheet(const Sheet& sheet, const PrintCorrection& correction);

// Writes a PDF at true size. The image is stored without loss, and viewers are asked not to scale.
// The output intent is the printer's RGB or CMYK space, or sRGB. In CMYK, ruler and lettering are
// in black ink only, and registration marks are on every plate. The same sheet gives the same
// bytes. Throws Error if `device` cannot be written.
void writeSheetPdf(const Sheet& sheet, QIODevice& device, const PrintCorrection& correction = {});

// Returns both files in sRGB. The picture is compressed once for both.
struct SheetPngPdf {
    QByteArray png, pdf;
};
SheetPngPdf sheetPngPdf(const Sheet& sheet);

// Writes a TIFF of the whole page for raster image processors, in RGB or CMYK, with resolution and
// ICC profile, compressed without loss. In CMYK, a sheet's white is an additional named sample. The
// film image is moved to whole pixels and not resampled: the resolutions in X and Y correct the
// scales. The page is never turned. The same sheet gives the same bytes. Throws Error if `device`
// cannot be written.
void writeSheetTiff(const Sheet& sheet, QIODevice& device, const PrintCorrection& correction = {});

} // namespace dipwright
