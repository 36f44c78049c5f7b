// “inspect built”: keeps with a job how a part of it came out, and says what repeats.
#pragma once

#include "cli/Command.h"
#include "inspection/FilmWatch.h"

#include <QDateTime>
#include <QStringList>
#include <functional>

namespace dipwright::cli {

void declareBuilt(CommandSyntax& syntax);
// `lens`: of a camera measured before. `dateOf`: the day of the photos, where the first says when
// it was taken or nothing.
void inspectBuilt(const QStringList& files, const QCommandLineParser& parser,
                  const std::optional<Lens>& lens,
                  const std::function<QString(const std::optional<QDateTime>&)>& dateOf,
                  Console& console);

} // namespace dipwright::cli
