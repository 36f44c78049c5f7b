// Writes a sheet to PNG, PDF and TIFF files. All functions are reentrant; all but writeSheetPng
// need a QGuiApplication.
#pragma once

#include "sheet/page/Sheet.h"
#include "sheet/pdf/PdfDocument.h"

#include <QIODevice>

namespace dipwright {

// Writes a PNG of the film with its resolution and an sRGB profile. Unprinted areas are white.
// Throws Error if `device` cannot be written.
void writeSheetPng(const Sheet& sheet, QIODevice& device);

// Writes a PDF at true size. The image is stored without loss, and viewers are asked not to scale.
// The output intent is the printer's RGB or CMYK space, or sRGB. In CMYK, ruler and lettering are
// in black ink only, and registration marks are on every plate. The same sheet gives the same
// bytes. Throws Error if `device` cannot be written.
void writeSheetPdf(const Sheet& sheet, QIODevice& device, const PrintCorrection& correction = {});

// A sheet with its picture in the printer's colours, and the settings of its PDF. One prepared
// sheet serves several files, so that the picture is compressed once.
struct PreparedSheet {
    Sheet sheet;
    PdfSettings settings;
};
PreparedSheet preparedSheet(const Sheet& sheet, const PrintCorrection& correction);
// The PNG of writeSheetPng(). `prepared` must have been made without a PrinterColour.
QByteArray sheetPng(const PreparedSheet& prepared);
// The PDF of writeSheetPdf(), with the correction that `prepared` was made with.
QByteArray sheetPdf(const PreparedSheet& prepared, const PrintCorrection& correction);

// Writes a TIFF of the whole page for raster image processors, in RGB or CMYK, with resolution and
// ICC profile, compressed without loss. In CMYK, a sheet's white is an additional named sample. The
// film image is not resampled. It is shifted to a whole number of pixels, and the file's
// resolutions in X and Y correct the printer's scales. The page is never turned. The same sheet
// gives the same bytes. Throws Error if `device` cannot be written.
void writeSheetTiff(const Sheet& sheet, QIODevice& device, const PrintCorrection& correction = {});

} // namespace dipwright
