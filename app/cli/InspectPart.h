// “inspect part”: how far what photos of a dipped part show lies from where it was to be.
#pragma once

#include "cli/Command.h"
#include "inspection/Lens.h"

#include <optional>

namespace dipwright::cli {

void declarePart(CommandSyntax& syntax);
// `lens`: of a camera measured before.
void inspectPart(const QStringList& files, const QCommandLineParser& parser,
                 const std::optional<Lens>& lens, Console& console);

} // namespace dipwright::cli
