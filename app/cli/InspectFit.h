// “inspect fit”: finds the real film and dip parameters from photos of a dipped part.
#pragma once

#include "cli/Command.h"
#include "inspection/FilmFitFiles.h"
#include "project/Project.h"
#include "project/ProjectFile.h"

#include <QDateTime>
#include <memory>

namespace dipwright::cli {

struct FittedPart {
    Project project; // the job, before the fit
    FitPairs pairs;
    FilmFit fit;
    std::vector<FittedPhoto> photos;
    std::optional<QDateTime> taken;   // when the first photo was taken
    std::unique_ptr<ProjectFile> job; // set with --update-job; locks the job against other writers
};

void declareFit(CommandSyntax& syntax);
// `lens` describes the camera, if it was measured before.
FittedPart fitPart(const QStringList& files, const QCommandLineParser& parser,
                   const std::optional<Lens>& lens, Console& console);
// Writes placement and depth into the job, if --update-job is given.
void updateJob(const FittedPart& part, const QCommandLineParser& parser, Console& console);

} // namespace dipwright::cli
