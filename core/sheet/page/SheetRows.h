// Reads a sheet's film row by row. The film's pictures may be in memory, or made on demand because
// the film is too long (FilmRows). All functions may be called from several threads.
#pragma once

#include "sheet/page/Sheet.h"

#include <functional>

namespace dipwright {

// Returns the size of the film image in pixels.
QSize filmPixels(const Sheet& sheet);

// Returns a sheet with only the rows first … end - 1 of the film image, of the plates' tints and of
// the wanted colours. Its settings are those of `sheet`. Pictures in memory are shared, so the
// result must not outlive `sheet`.
Sheet sheetRows(const Sheet& sheet, int first, int end);

// Calls work(rows, first) for bands of about one megapixel each, from top to bottom. `first` is the
// number of the band's first row.
void forSheetRows(const Sheet& sheet,
                  const std::function<void(const Sheet& rows, int first)>& work);

// Returns the sheet with film image and wanted colours scaled to this size in pixels, in memory and
// without plates.
Sheet scaledSheet(const Sheet& sheet, QSize pixels);

} // namespace dipwright
