// Writes a film's stretch as a CSV table.
#pragma once

#include "workbench/dip/FilmReadout.h"

namespace dipwright {

// Writes a header line and one line for each film point: column, row, rest_x_mm, rest_z_mm, x_mm,
// y_mm, z_mm (pose frame), adhered, stretch, area, largest, smallest. The write is atomic. Throws
// Error.
void writeFilmTable(const FilmReadout& reading, const QString& path);

} // namespace dipwright
