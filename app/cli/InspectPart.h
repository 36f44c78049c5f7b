// “inspect part”: measures how far a dipped part's print lies from its intended place, from photos.
#pragma once

#include "cli/Command.h"
#include "inspection/FindPrint.h"
#include "inspection/PartViewFiles.h"
#include "project/Project.h"

#include <memory>
#include <optional>

namespace dipwright::cli {

void declarePart(CommandSyntax& syntax);
// `lens` describes the camera, if it was measured before.
void inspectPart(const QStringList& files, const QCommandLineParser& parser,
                 const std::optional<Lens>& lens, Console& console);

// The following functions are shared with “inspect fit” and “inspect built”. They throw UsageError
// or Error. partPairs() returns the pairs of --pairs, which are places in these photos.
std::vector<PlacePair> partPairs(const QCommandLineParser& parser,
                                 const std::vector<PartPhoto>& photos);
// Reads the photos of the part.
std::vector<PartPhoto> readPartPhotos(const QStringList& files, const Progress& progress);
// Simulates the dips of the project and returns the films as they lie on the body.
std::vector<std::shared_ptr<const LaidFilm>> dippedFilms(Project project, const Progress& progress);
// Returns the places of --places or, without this option, the corners of the print that were found
// in the photos, and prints how many. The places are on the uncorrected sheet.
std::vector<PrintedPlace> placesOnPart(const std::vector<PartPhoto>& photos,
                                       const std::vector<PlacePair>& clicked,
                                       const QCommandLineParser& parser,
                                       const std::optional<Lens>& lens, const Progress& progress,
                                       QTextStream& out);
// Converts the places to those on the sheet that was printed: the job's corrected sheet, or the
// film image of the options.
std::vector<PrintedPlace> onJobsSheet(std::vector<PrintedPlace> places,
                                      const QCommandLineParser& parser);
// Searches the photos for the corners of the print of --project.
FoundPrint searchPrint(const std::vector<PartPhoto>& photos, const std::vector<PlacePair>& clicked,
                       const QCommandLineParser& parser, const std::optional<Lens>& lens,
                       const Progress& progress);

} // namespace dipwright::cli
