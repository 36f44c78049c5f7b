// One command of dipwright-cli, and what all commands share.
#pragma once

#include "base/Error.h"
#include "cli/CommandSyntax.h"
#include "cli/Console.h"

#include <memory>
#include <stdexcept>
#include <vector>

namespace dipwright::cli {

// Thrown for a command line that makes no sense: exit code 2. Shown as Error is.
class UsageError : public Error {
public:
    using Error::Error;
};

// Thrown, once all is written, where a verdict is worse than was asked for: exit code 3.
class VerdictError : public Error {
public:
    using Error::Error;
};

class Command {
public:
    virtual ~Command() = default;
    virtual QString name() const = 0;
    virtual QString summary() const = 0; // a sentence for --help
    // Adds options and positional arguments; --help, --quiet and the command's name are there.
    virtual void declare(CommandSyntax& syntax) const = 0;
    // Does it. Throws Error, UsageError or Cancelled.
    virtual void run(const QCommandLineParser& parser, Console& console) const = 0;
};

// All commands, in the order in which --help lists them.
std::vector<std::unique_ptr<Command>> allCommands();
// What a command declares, after the options that all have.
CommandSyntax syntaxOf(const Command& command);

std::unique_ptr<Command> newCommand();
std::unique_ptr<Command> runCommand();
std::unique_ptr<Command> optimizeCommand();
std::unique_ptr<Command> infoCommand();
std::unique_ptr<Command> validateCommand();
std::unique_ptr<Command> solversCommand();
std::unique_ptr<Command> benchCommand();
std::unique_ptr<Command> printCommand();
std::unique_ptr<Command> artworkCommand();
std::unique_ptr<Command> packCommand();
std::unique_ptr<Command> profileCommand();
std::unique_ptr<Command> calibrateCommand();
#ifdef DIPWRIGHT_INSPECTION
std::unique_ptr<Command> inspectCommand();
#endif
std::unique_ptr<Command> manualCommand();

} // namespace dipwright::cli
