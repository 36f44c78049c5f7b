// Writes completion scripts for bash, zsh and fish.
#pragma once

#include "cli/Command.h"

namespace dipwright::cli {

using Commands = std::vector<std::unique_ptr<Command>>;

QString bashCompletion(const Commands& commands);
QString zshCompletion(const Commands& commands);
QString fishCompletion(const Commands& commands);

} // namespace dipwright::cli
