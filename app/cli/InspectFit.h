// “inspect fit”: what film and dip were, by photos of a dipped part.
#pragma once

#include "cli/Command.h"
#include "inspection/FilmFitFiles.h"
#include "project/ProjectFile.h"

#include <QDateTime>
#include <memory>

namespace dipwright::cli {

struct FittedPart {
    FitPairs pairs;
    FilmFit fit;
    std::vector<FittedPhoto> photos;
    std::optional<QDateTime> taken;   // the first of them
    std::unique_ptr<ProjectFile> job; // where it is to be updated: nobody else writes it meanwhile
};

void declareFit(CommandSyntax& syntax);
// `lens`: of a camera measured before.
FittedPart fitPart(const QStringList& files, const QCommandLineParser& parser,
                   const std::optional<Lens>& lens, Console& console);
// Writes placement and depth into the job, where that is asked for.
void updateJob(const FittedPart& part, const QCommandLineParser& parser, Console& console);

} // namespace dipwright::cli
