// Measures swell, growth and unevenness of a floating film from photos (docs/inspection.md, "Film
// watch").
#pragma once

#include "inspection/GrowthFit.h"
#include "settings/FilmOnWater.h"
#include "settings/Profile.h"

#include <QImage>
#include <QString>
#include <optional>
#include <vector>

namespace dipwright {

// Returns the settings for a photo from the user's data on tank and camera. `focalLength` is the
// focal length in the photo's metadata, in half diagonals. Throws Error, naming `where`, if the
// focal length is needed and neither source gives it.
FlatSettings flatSettings(const FilmOnWater& told, const std::optional<double>& focalLength,
                          const QString& where);

// Finds the film's chessboard and the card in a photo and measures the film. Throws Error, naming
// `where`, if a board is missing or mirrored, or if too little of it is visible.
FlatFilm measureFlatFilm(const QImage& photo, const FlatSettings& settings, const QString& where);

struct WatchedPhoto {
    QString where, sha256;
    std::optional<double> seconds; // since the film was laid on the water
    QSize size;                    // pixels
    FlatFilm film;
};

struct FilmWatch {
    std::vector<WatchedPhoto> photos; // in order of time
    GrowthFit growth;
    double begin = 0;      // when the dip begins, in seconds
    double rulerError = 0; // reading error of each ruler, mm (95 % interval)
};

// Evaluates all photos together; needs at least one photo. Photos without a time count as taken
// when the dip begins. The swell's interval includes the error of reading the rulers. Growth does
// not depend on that error, because all photos share one scale. Throws Error as fitGrowth() does,
// if there are three or more times and the dip begins before or after them, and if two photos have
// the same content. If rate and limit of the growth are known, the dip may begin somewhat before or
// after.
FilmWatch evaluatedFilmWatch(std::vector<WatchedPhoto> photos, double begin, double rulerError = 0);

// What the user noted when the photos were taken.
struct WatchNotes {
    QString date; // ISO 8601
    QString lot;  // empty: the profile keeps its lot
    std::optional<double> waterTemperature;
};

// Returns the profile with the measured values. Replaces the growth if rate and limit are known or
// if there is no growth; otherwise the profile keeps its own growth. Throws Error if the swell is
// outside the profile's limits.
FilmProfile withMeasurement(FilmProfile profile, const FilmWatch& watch, const WatchNotes& notes);

// Returns the result as sentences, one per line. The last sentences say which further photos would
// improve the result.
QStringList watchSentences(const FilmWatch& watch);

} // namespace dipwright
