// The manual page dipwright-cli(1), in the man macros of roff.
#pragma once

#include "cli/Command.h"

namespace dipwright::cli {

QString manualPage(const std::vector<std::unique_ptr<Command>>& commands, const QString& version);

} // namespace dipwright::cli
