// The files that a sheet is written to. All functions are reentrant; all but writeSheetPng need a
// QGuiApplication.
#pragma once

#include "sheet/page/Sheet.h"
#include "sheet/pdf/PdfDocument.h"

#include <QIODevice>

namespace dipwright {

// The film image as it stands in RGB files: on white, in sRGB or the printer's RGB.
PackedPixels packedFilm(const Sheet& sheet, const PrinterColour* colour = nullptr);

// PNG of the film with resolution and sRGB profile. Unprinted is white. Throws Error when not
// writable.
void writeSheetPng(const Sheet& sheet, QIODevice& device);

// A sheet in the printer's colours, and how its document is to be written.
struct PreparedSheet {
    Sheet sheet;
    PdfSettings settings;
};
PreparedSheet preparedSheet(const Sheet& sheet, const PrintCorrection& correction);

// PDF at true size, the image stored without loss, viewers asked not to scale, with the colour's
// space as output intent; RGB, or CMYK where the colour is in CMYK: ruler and lettering are then in
// black ink only, registration marks on every plate.
// Same bytes for the same sheet. Throws Error when not writable.
void writeSheetPdf(const Sheet& sheet, QIODevice& device, const PrintCorrection& correction = {});

// Both of these files in sRGB, of one packing.
struct SheetPngPdf {
    QByteArray png, pdf;
};
SheetPngPdf sheetPngPdf(const Sheet& sheet);

// TIFF of the whole page, for raster image processors: RGB, or CMYK where the colour is in CMYK,
// with resolution and ICC profile, compressed without loss; in CMYK a sheet's white is one more
// sample with its name. The film image is moved to whole pixels
// and not resampled: scales are corrected by the resolutions in X and Y. The page is never turned.
// Same bytes for the same sheet. Throws Error when not writable.
void writeSheetTiff(const Sheet& sheet, QIODevice& device, const PrintCorrection& correction = {});

} // namespace dipwright
