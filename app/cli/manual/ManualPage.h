// Writes the manual page dipwright-cli(1) with roff's man macros.
#pragma once

#include "cli/Command.h"

namespace dipwright::cli {

QString manualPage(const std::vector<std::unique_ptr<Command>>& commands, const QString& version);

} // namespace dipwright::cli
