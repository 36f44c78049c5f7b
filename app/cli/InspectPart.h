// “inspect part”: how far what photos of a dipped part show lies from where it was to be.
#pragma once

#include "cli/Command.h"
#include "inspection/FindPrint.h"
#include "inspection/PartViewFiles.h"
#include "project/Project.h"

#include <memory>
#include <optional>

namespace dipwright::cli {

void declarePart(CommandSyntax& syntax);
// `lens`: of a camera measured before.
void inspectPart(const QStringList& files, const QCommandLineParser& parser,
                 const std::optional<Lens>& lens, Console& console);

// What “inspect fit” does as well. Throw UsageError or Error.
std::vector<PlacePair> partPairs(const QCommandLineParser& parser, int photos);
std::vector<PartPhoto> readPartPhotos(const QStringList& files, const Progress& progress);
// The films of --project as they lie on the body.
std::vector<std::shared_ptr<const LaidFilm>> dippedFilms(Project project, const Progress& progress);
// The places of --places, or else the corners of the print of --project in the photos, where they
// were printed: on a sheet that was corrected beside where the film was made.
std::vector<PrintedPlace> placesOnPart(const std::vector<PartPhoto>& photos,
                                       const std::vector<PlacePair>& clicked,
                                       const QCommandLineParser& parser,
                                       const std::optional<Lens>& lens, const Progress& progress);
// The corners of the print of --project in the photos.
FoundPrint searchPrint(const std::vector<PartPhoto>& photos, const std::vector<PlacePair>& clicked,
                       const QCommandLineParser& parser, const std::optional<Lens>& lens,
                       const Progress& progress);

} // namespace dipwright::cli
