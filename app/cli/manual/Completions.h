// What shells complete after dipwright-cli: a script for each.
#pragma once

#include "cli/Command.h"

namespace dipwright::cli {

using Commands = std::vector<std::unique_ptr<Command>>;

QString bashCompletion(const Commands& commands);
QString zshCompletion(const Commands& commands);
QString fishCompletion(const Commands& commands);

} // namespace dipwright::cli
