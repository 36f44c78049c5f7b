// Writes the result of a fit to a dipped part as files, sentences and a film profile
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

// Replaces fit.json and fit-places.csv in `folder`, both or neither. Throws Error.
void writeFilmFit(const FilmFit& fit, const FitPairs& pairs, const std::vector<FittedPhoto>& photos,
                  const WatchNotes& notes, const QString& folder);

// Returns a table row: name, value before, value found with unit, 95 % interval.
QStringList fitCells(const FittedQuantity& found);
// Returns the result as sentences, one per line; the quantities come first.
QStringList fitSentences(const FilmFit& fit);

// Returns the profile with the film quantities that were fitted. Swell counts as measured only if
// both directions were fitted. Throws Error if a value is outside the profile's limits.
FilmProfile withFit(FilmProfile profile, const FilmFit& fit, const std::vector<FittedPhoto>& photos,
                    const WatchNotes& notes);

// Returns a profile with this name and the film of the fitted project, for a fit that is saved to a
// new profile.
FilmProfile newProfileFor(const Project& project, const QString& name);

// Returns a sentence if values of the profile that were not fitted differ from the film of the
// fitted project; otherwise empty. The values were fitted with the project's film and may be wrong
// for another.
QString otherFilmNote(const FilmProfile& profile, const Project& project, const FilmFit& fit);

// Returns the project with the fitted placement, depth and film. The fitted film is stored as a
// measured film profile of the project: in the project's own film profile or, if there is none, in
// a new one named `newProfile`. Throws Error as withFit() and withPlacement() do.
Project withFit(const Project& project, const FilmFit& fit, const std::vector<FittedPhoto>& photos,
                const WatchNotes& notes, const QString& newProfile);

// Throws Error, naming `where`, if measured parts correct the project's sheets. A fit that is
// written into the project would correct the same error once more.
void requireUncorrected(const Project& project, const QString& where);

// Returns the project with the fitted offsets, turns and depth, rounded to the digits of its file.
// Throws Error if a value is outside the project's limits.
Project withPlacement(Project project, const FilmFit& fit);

} // namespace dipwright
