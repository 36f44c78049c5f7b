// “inspect built”: measures a finished part, finds the repeating error and saves both in the job.
#pragma once

#include "cli/Command.h"
#include "inspection/FilmWatch.h"

#include <QDateTime>
#include <QStringList>
#include <functional>

namespace dipwright::cli {

void declareBuilt(CommandSyntax& syntax);
// `lens` describes the camera, if it was measured before. `dateOf` returns the date of the photos;
// its argument is the time at which the first photo was taken, if it is known.
void inspectBuilt(const QStringList& files, const QCommandLineParser& parser,
                  const std::optional<Lens>& lens,
                  const std::function<QString(const std::optional<QDateTime>&)>& dateOf,
                  Console& console);

} // namespace dipwright::cli
