// What the film watch writes: numbers, a table and a picture.
#pragma once

#include "inspection/FilmWatch.h"

namespace dipwright {

// film-watch.json, unevenness.csv and unevenness.png.
QStringList filmWatchFiles();

// Replaces them in `folder` together. Needs a QGuiApplication. Throws Error.
void writeFilmWatch(const FilmWatch& watch, const WatchNotes& notes, const QString& folder);

// The photo, at most `longest` pixels wide and high, with the corners that were found in it: the
// film's as circles, the card's as squares. Needs a QGuiApplication.
QImage boardsPicture(const QImage& photo, const FlatFilm& film, int longest);

// How much more or less each place has grown than the film's mean, with an arrow to where it has
// moved, enlarged. `height` pixels.
QImage unevennessMap(const WatchedPhoto& photo, int height);

} // namespace dipwright
