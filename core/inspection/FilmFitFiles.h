// What a fit to a dipped part has found, as files, sentences and a film profile
// (docs/files-and-commands.md, "Fit files").
#pragma once

#include "inspection/FilmFit.h"
#include "inspection/FilmWatch.h"

#include <QStringList>

namespace dipwright {

struct FittedPhoto {
    QString where, sha256;
};

// Replaces fit.json and fit-places.csv in `folder` together. Throws Error.
void writeFilmFit(const FilmFit& fit, const FitPairs& pairs, const std::vector<FittedPhoto>& photos,
                  const WatchNotes& notes, const QString& folder);

// What was found, a sentence a line.
QStringList fitSentences(const FilmFit& fit);

// The profile with the film's quantities that were fitted; swell is measured only where both
// directions were. Throws Error where one is past what a profile may say.
FilmProfile withFit(FilmProfile profile, const FilmFit& fit, const std::vector<FittedPhoto>& photos,
                    const WatchNotes& notes);

// The project with where its dips really were: offsets, turns and depth, to the digits that its
// file keeps. Throws Error where one is past what a project may say.
Project withPlacement(Project project, const FilmFit& fit);

} // namespace dipwright
