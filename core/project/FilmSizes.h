// The film sizes that have a name, and how the grid follows a change of size.
#pragma once

#include "settings/FilmSettings.h"

#include <QSizeF>
#include <QStringList>

namespace dipwright {

inline constexpr int minimumFilmPoints = 8;    // a side
inline constexpr int maximumFilmPoints = 2048; // a side
bool mayHavePoints(int columns, int rows);     // no more than that, and than maximumFilmGrid

// "A5", "A4", "A3", "Letter" …; upright.
QStringList filmSizeNames();
// mm; throws Error for a name that is none of the above.
QSizeF filmSize(const QString& name);

// Gives the film another printed size. The cells stay as large as they were and square, within the
// limits above; the preset's name becomes that of the size, or "custom". A film that has this size
// already is left alone.
void resizeFilm(FilmSettings& film, Millimetres width, Millimetres height);

} // namespace dipwright
