// Lists the named film sizes and resizes a film with its grid.
#pragma once

#include "settings/FilmSettings.h"

#include <QSizeF>
#include <QStringList>

namespace dipwright {

inline constexpr int minimumFilmPoints = 8;    // per side
inline constexpr int maximumFilmPoints = 2048; // per side
// Whether these numbers of points are within maximumFilmPoints and maximumFilmGrid.
bool mayHavePoints(int columns, int rows);

// Returns the names: "A5", "A4", "A3", "Letter" …
QStringList filmSizeNames();
// Returns the size in mm, upright. Throws Error for an unknown name.
QSizeF filmSize(const QString& name);

// Sets the printed size. The cells keep their size and stay square as far as the limits above
// allow. The film's preset becomes the name of the size, or "custom". Does nothing if the film has
// this size already.
void resizeFilm(FilmSettings& film, Millimetres width, Millimetres height);

} // namespace dipwright
