// dipwright-cli: all computations of the workbench, without a display.
#include "base/ProgramName.h"
#include "base/ShippedFolders.h"
#include "cli/Command.h"
#include "disk/UnfinishedWrites.h"

#include <QDir>
#include <QGuiApplication>
#include <QLocale>
#include <QLoggingCategory>

namespace dipwright::cli {
namespace {

enum ExitCode { Done = 0, Failed = 1, WrongUsage = 2, WorseVerdict = 3 };

void printHelp(const std::vector<std::unique_ptr<Command>>& commands, QTextStream& out) {
    out << "Usage: dipwright-cli COMMAND …\n\n"
           "Computational hydrographic printing: from a textured model to a sheet to print.\n\n"
           "Commands:\n";
    for (const auto& command : commands) {
        out << QStringLiteral("  %1 %2\n").arg(command->name(), -10).arg(command->summary());
    }
    out << "\nOptions:\n"
           "  -h, --help     Shows this help, or after a command the help of that command.\n"
           "  -v, --version  Shows the version.\n\n"
           "Exit codes: 0 done, 1 the job failed, 2 wrong usage, 3 a verdict worse than "
           "required.\n";
}

// Returns the parser's help text. In its usage, the command's name follows the program's name, and
// each action has a line.
QString commandHelp(const QCommandLineParser& parser, const QString& name) {
    const QString text = parser.helpText();
    const auto end = text.indexOf(QLatin1Char('\n'));
    const QString program = QStringLiteral("dipwright-cli %1 [options]").arg(name);
    QString usage = text.left(end).section(QStringLiteral("[options]"), 1);
    if (!usage.contains(QLatin1Char('['))) { // optional words stay on one line
        usage.replace(QLatin1String(" | "), QStringLiteral("\n       %1 ").arg(program));
    }
    return QStringLiteral("Usage: %1%2\n\n%3\n").arg(program, usage, text.mid(end).trimmed());
}

// Rejects empty option values, for example from a shell variable that is not set.
void requireValues(const QCommandLineParser& parser) {
    for (const QString& option : parser.optionNames()) {
        if (parser.values(option).contains(QString())) {
            throw UsageError(QStringLiteral("A value is missing; see --help"),
                             QStringLiteral("--") + option);
        }
    }
}

void printVersion(QTextStream& out) {
    out << "dipwright-cli " << QCoreApplication::applicationVersion() << '\n';
}

// `arguments` holds the program's name and the words after the command.
void runCommand(const Command& command, const QStringList& arguments, Console& console) {
    QCommandLineParser parser;
    parser.setApplicationDescription(command.summary());
    fill(parser, syntaxOf(command));
    const bool understood = parser.parse(arguments);
    if (parser.isSet(QStringLiteral("help"))) {
        console.out() << commandHelp(parser, command.name());
        return;
    }
    if (parser.isSet(QStringLiteral("version"))) {
        printVersion(console.out());
        return;
    }
    if (!understood) {
        throw UsageError(QStringLiteral("%1 See --help").arg(parser.errorText()), command.name());
    }
    requireValues(parser);
    console.setQuiet(parser.isSet(QStringLiteral("quiet")));
    if (command.needsFiles()) {
        const CancelToken cancelToken = console.progress().cancelToken;
        recoverUnfinishedWrites(cancelToken);
        cancelToken.throwIfCancelled();
    }
    command.run(parser, console);
}

void run(const QStringList& arguments, Console& console) {
    const auto commands = allCommands();
    const QString first = arguments.value(1);
    if (first == QLatin1String("--help") || first == QLatin1String("-h")) {
        printHelp(commands, console.out());
        return;
    }
    if (first == QLatin1String("--version") || first == QLatin1String("-v")) {
        printVersion(console.out());
        return;
    }
    for (const auto& command : commands) {
        if (first == command->name()) {
            QStringList rest = arguments;
            rest.removeAt(1);
            runCommand(*command, rest, console);
            return;
        }
    }
    throw UsageError(first.isEmpty() ? QStringLiteral("A command is missing; see --help")
                                     : QStringLiteral("There is no such command; see --help"),
                     first.isEmpty() ? QStringLiteral("command line") : first);
}

// Rejects arguments that are not UTF-8. Qt would replace their characters and so name another file.
void requireText(const QStringList& arguments) {
    for (const QString& argument : arguments) {
        if (argument.contains(QChar::ReplacementCharacter)) {
            throw UsageError(QStringLiteral("This is not UTF-8 text; rename the file"), argument);
        }
    }
    if (QDir::currentPath().contains(QChar::ReplacementCharacter)) {
        throw UsageError(
            QStringLiteral(
                "The working folder's name is not UTF-8 text; rename it or work in another folder"),
            QDir::currentPath());
    }
}

int guardedRun(const QStringList& arguments, Console& console) {
    try {
        requireText(arguments);
        run(arguments, console);
        if (!console.finish()) {
            throw Error(QStringLiteral("The output cannot be written"),
                        QStringLiteral("standard output"));
        }
        return Done;
    } catch (const UsageError& error) {
        console.error(error);
        return WrongUsage;
    } catch (const VerdictError& error) {
        console.error(error);
        return WorseVerdict;
    } catch (const Error& error) {
        console.error(error);
    } catch (const Cancelled&) {
        console.error(Error(QStringLiteral("Cancelled; nothing was written"), arguments.value(1)));
    } catch (const std::bad_alloc&) {
        console.error(
            Error(QStringLiteral(
                      "There is not enough memory; choose a smaller film, field or resolution"),
                  arguments.value(1)));
    } catch (const std::exception& failure) {
        console.error(
            Error(QStringLiteral("Unexpected error: %1").arg(QString::fromUtf8(failure.what())),
                  arguments.value(1)));
    }
    return Failed;
}

} // namespace

std::vector<std::unique_ptr<Command>> allCommands() {
    std::vector<std::unique_ptr<Command>> commands;
    commands.push_back(newCommand());
    commands.push_back(cli::runCommand());
    commands.push_back(printCommand());
    commands.push_back(watchCommand());
    commands.push_back(serveCommand());
    commands.push_back(artworkCommand());
    commands.push_back(packCommand());
    commands.push_back(costCommand());
    commands.push_back(profileCommand());
    commands.push_back(calibrateCommand());
    commands.push_back(optimizeCommand());
    commands.push_back(infoCommand());
    commands.push_back(validateCommand());
    commands.push_back(solversCommand());
    commands.push_back(benchCommand());
#ifdef DIPWRIGHT_INSPECTION
    commands.push_back(inspectCommand());
#endif
    commands.push_back(manualCommand());
    return commands;
}

CommandSyntax syntaxOf(const Command& command) {
    CommandSyntax syntax;
    syntax.addOption(
        {{QStringLiteral("h"), QStringLiteral("help")}, QStringLiteral("Shows this help.")});
    syntax.addOption(
        {{QStringLiteral("q"), QStringLiteral("quiet")}, QStringLiteral("Shows no progress.")});
    syntax.addOption(
        {{QStringLiteral("v"), QStringLiteral("version")}, QStringLiteral("Shows the version.")});
    command.declare(syntax);
    return syntax;
}

} // namespace dipwright::cli

int main(int argc, char* argv[]) {
    // Text on the sheets needs Qt Gui, but not a display.
    qputenv("QT_QPA_PLATFORM", "offscreen");
    // Hides the libraries' warnings, so that scripts find only one error line.
    QLoggingCategory::setFilterRules(
        QStringLiteral("*.debug=false\n*.info=false\n*.warning=false"));
    dipwright::useShippedFonts();
    const QGuiApplication application(argc, argv);
    QLocale::setDefault(QLocale::c()); // all output is in English, including the maps
    dipwright::nameProgram();
    dipwright::cli::Console console;
    return dipwright::cli::guardedRun(QCoreApplication::arguments(), console);
}
