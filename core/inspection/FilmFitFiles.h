// What a fit to a dipped part has found, as files, sentences and a film profile
// (docs/files-and-commands.md, "Fit files").
#pragma once

#include "inspection/FilmFit.h"
#include "inspection/FilmWatch.h"

#include <QStringList>

namespace dipwright {

struct Project;

struct FittedPhoto {
    QString where, sha256;
};

// Replaces fit.json and fit-places.csv in `folder` together. Throws Error.
void writeFilmFit(const FilmFit& fit, const FitPairs& pairs, const std::vector<FittedPhoto>& photos,
                  const WatchNotes& notes, const QString& folder);

// A row of a table: name and unit, before, found, 95 %.
QStringList fitCells(const FittedQuantity& found);
// What was found, a sentence a line: of each quantity first.
QStringList fitSentences(const FilmFit& fit);

// The profile with the film's quantities that were fitted; swell is measured only where both
// directions were. Throws Error where one is past what a profile may say.
FilmProfile withFit(FilmProfile profile, const FilmFit& fit, const std::vector<FittedPhoto>& photos,
                    const WatchNotes& notes);

// The project with all that was found: placement and depth, and a film profile that is measured,
// its own or else a new one of that name, with its film as it is now. Throws Error as withFit() and
// withPlacement() do.
Project withFit(const Project& project, const FilmFit& fit, const std::vector<FittedPhoto>& photos,
                const WatchNotes& notes, const QString& newProfile);

// The project with where its dips really were: offsets, turns and depth, to the digits that its
// file keeps. Throws Error where one is past what a project may say.
Project withPlacement(Project project, const FilmFit& fit);

} // namespace dipwright
