// Defines the interface of a dipwright-cli command and its exceptions, and lists all commands.
#pragma once

#include "base/Error.h"
#include "cli/CommandSyntax.h"
#include "cli/Console.h"

#include <memory>
#include <stdexcept>
#include <vector>

namespace dipwright::cli {

// Thrown for an invalid command line: exit code 2. Shown in the same way as Error.
class UsageError : public Error {
public:
    using Error::Error;
};

// Thrown after all results are written, if a verdict is worse than the user requires: exit code 3.
class VerdictError : public Error {
public:
    using Error::Error;
};

class Command {
public:
    virtual ~Command() = default;
    virtual QString name() const = 0;
    virtual QString summary() const = 0; // one sentence for --help
    // Adds the command's own options and positional arguments. The options --help, --quiet and
    // --version are added to every command.
    virtual void declare(CommandSyntax& syntax) const = 0;
    // Returns whether the command needs files that a crashed program may have left unfinished
    // (UnfinishedWrites.h).
    virtual bool needsFiles() const { return true; }
    // Executes the command. Throws Error, UsageError or Cancelled.
    virtual void run(const QCommandLineParser& parser, Console& console) const = 0;
};

// Returns all commands, in the order in which --help lists them.
std::vector<std::unique_ptr<Command>> allCommands();
// Returns the options of all commands, followed by the options and arguments of this command.
CommandSyntax syntaxOf(const Command& command);

std::unique_ptr<Command> newCommand();
std::unique_ptr<Command> runCommand();
std::unique_ptr<Command> optimizeCommand();
std::unique_ptr<Command> infoCommand();
std::unique_ptr<Command> validateCommand();
std::unique_ptr<Command> solversCommand();
std::unique_ptr<Command> benchCommand();
std::unique_ptr<Command> printCommand();
std::unique_ptr<Command> watchCommand();
std::unique_ptr<Command> serveCommand();
std::unique_ptr<Command> artworkCommand();
std::unique_ptr<Command> packCommand();
std::unique_ptr<Command> costCommand();
std::unique_ptr<Command> profileCommand();
std::unique_ptr<Command> calibrateCommand();
#ifdef DIPWRIGHT_INSPECTION
std::unique_ptr<Command> inspectCommand();
#endif
std::unique_ptr<Command> manualCommand();

} // namespace dipwright::cli
