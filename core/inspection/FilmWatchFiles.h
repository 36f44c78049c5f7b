// Writes the results of the film watch: numbers, a table and a picture.
#pragma once

#include "inspection/FilmWatch.h"

namespace dipwright {

// Returns the names film-watch.json, unevenness.csv and unevenness.png.
QStringList filmWatchFiles();

// Replaces these files in `folder`, all or none. Needs a QGuiApplication. Throws Error.
void writeFilmWatch(const FilmWatch& watch, const WatchNotes& notes, const QString& folder);

// Returns the photo, at most `longest` pixels wide and high, with the corners that were found: the
// film's as circles, the card's as squares. Needs a QGuiApplication.
QImage boardsPicture(const QImage& photo, const FlatFilm& film, int longest);

// Returns a map `height` pixels high of the growth of each place relative to the film's mean.
// Arrows show the displacements, enlarged.
QImage unevennessMap(const WatchedPhoto& photo, int height);

} // namespace dipwright
