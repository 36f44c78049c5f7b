// A film's stretch as a table of numbers.
#pragma once

#include "workbench/dip/FilmReadout.h"

namespace dipwright {

// CSV with a header line, a film point a line: column, row, rest_x_mm, rest_z_mm, x_mm, y_mm, z_mm
// (pose frame), adhered, stretch, area, largest, smallest. Whole or not at all; throws Error.
void writeFilmTable(const FilmReadout& reading, const QString& path);

} // namespace dipwright
