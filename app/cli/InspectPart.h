// “inspect part”: how far what photos of a dipped part show lies from where it was to be.
#pragma once

#include "cli/Command.h"

namespace dipwright::cli {

void declarePart(CommandSyntax& syntax);
void inspectPart(const QStringList& files, const QCommandLineParser& parser, Console& console);

} // namespace dipwright::cli
