// A film measured by photos while it floats flat: swell, growth and unevenness
// (docs/inspection.md, "Film watch").
#pragma once

#include "inspection/GrowthFit.h"
#include "settings/FilmOnWater.h"
#include "settings/Profile.h"

#include <QImage>
#include <QString>
#include <optional>
#include <vector>

namespace dipwright {

// What is told of the tank and the camera, for a photo that says itself how long the camera's lens
// was, in half diagonals, or does not. Throws Error, naming `where`, where that is needed and
// nobody says.
FlatSettings flatSettings(const FilmOnWater& told, const std::optional<double>& focalLength,
                          const QString& where);

// Finds the film's chessboard and the card in a photo and measures. Throws Error, naming `where`,
// where one of them is missing, mirrored or seen in too small a part.
FlatFilm measureFlatFilm(const QImage& photo, const FlatSettings& settings, const QString& where);

struct WatchedPhoto {
    QString where, sha256;
    std::optional<double> seconds; // since the film was laid on the water
    QSize size;                    // pixels
    FlatFilm film;
};

struct FilmWatch {
    std::vector<WatchedPhoto> photos; // by their seconds
    GrowthFit growth;
    double begin = 0;      // seconds at which the dip begins
    double rulerError = 0; // mm, 95 %, of each of the rulers
};

// What follows from the photos together; at least one. Those without a time are taken to have been
// made when the dip begins. The swell's interval holds how exactly the rulers were read; growth is
// told by photos of one scale and has nothing of it. Throws Error where three moments and more say
// nothing of when the dip begins.
FilmWatch watchedFilm(std::vector<WatchedPhoto> photos, double begin, double rulerError = 0);

// What was known besides when the photos were made.
struct WatchNotes {
    QString date; // ISO
    QString lot;  // empty: the profile keeps its own
    std::optional<double> waterTemperature;
};

// The profile with what was measured. Growth is taken over where rate and limit are known or there
// is none; else the profile keeps its own. Throws Error where the swell is past what a profile may
// say.
FilmProfile withMeasurement(FilmProfile profile, const FilmWatch& watch, const WatchNotes& notes);

// What was found, a sentence a line, the last ones what to photograph to know more.
QStringList watchSentences(const FilmWatch& watch);

} // namespace dipwright
