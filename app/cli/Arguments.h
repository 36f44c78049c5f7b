// Parses the arguments and options that several commands share.
#pragma once

#include "cli/Command.h"
#include "parallel/Threads.h"
#include "pipeline/JobOptions.h"

#include <QStringList>
#include <functional>

namespace dipwright {

struct Project;
class SolverRegistry;

} // namespace dipwright

namespace dipwright::cli {

// Returns the only positional argument. Throws UsageError if it is missing or if there are several.
QString positionalArgument(const QCommandLineParser& parser, const QString& name);
void requireNoPositionalArgument(const QCommandLineParser& parser);

// The words after a command that has several actions: the action first, then its arguments.
class Words {
public:
    Words(const QString& command, const QStringList& words) : command_(command), words_(words) {}

    // Returns the next word. Throws UsageError, naming `what`, if there is none.
    QString take(const QString& what);
    // Throws UsageError if any words are left.
    void finish() const;

private:
    QString command_;
    QStringList words_;
};

// Throws UsageError if one of these options is given, because the command would ignore it. `when`
// continues the sentence "--to has no effect", for example "with --measured".
void refuseOptions(const QCommandLineParser& parser, const QStringList& options,
                   const QString& when);

// The same for the options that only other actions of a command use. `uses` has the options of each
// action; for an unknown action, nothing is refused.
void refuseOptionsOfOthers(const QCommandLineParser& parser, const QMap<QString, QStringList>& uses,
                           const QString& action);

// Returns the option's number. Throws UsageError, which names the option, if the number is out of
// range.
double numberOption(const QCommandLineParser& parser, const QString& option, double minimum,
                    double maximum);
int wholeNumberOption(const QCommandLineParser& parser, const QString& option, int minimum,
                      int maximum);

// Returns the name of the picture file to write, or an empty string without the option. Throws
// UsageError unless the name ends in one of `endings`, for example ".png".
QString pictureOption(const QCommandLineParser& parser, const QString& option,
                      const QStringList& endings);

// Calls setByPath() for an option. If the value is refused, throws a UsageError that names the
// option.
void setByOption(Project& project, const QString& path, const QString& value,
                 const QString& option);

// Returns work(), which reads the value of an option. If it throws an Error, throws a UsageError
// that names the option.
template <typename Work>
auto asUsage(const QString& option, const Work& work) {
    try {
        return work();
    } catch (const Error& error) {
        throw UsageError(error.message(), option);
    }
}

// Returns the value of --solver; empty without the option. Throws UsageError if the registry has no
// such solver. Loads no solver.
QString solverNamed(const QCommandLineParser& parser, const SolverRegistry& registry);

// Returns the line that tells of a written file or folder.
QString wrote(const QString& path);

// Throws Error if a file exists at `path` whose beginning (64 KiB) is not as `isOwn` says; an empty
// file may be replaced. `kind` names what may be replaced, such as "a table of costs".
void requireReplaceable(const QString& path, const std::function<bool(const QByteArray&)>& isOwn,
                        const QString& kind);

// Declares --set PATH=VALUE, which may be repeated. `areStored`: the command stores the values in a
// project file.
void declareSettings(CommandSyntax& syntax, bool areStored = false);
// A value of the project by its path.
struct Setting {
    QString path, value;
    QString where; // named in errors, such as "--set film.points=0x0"
};
// Applies the settings. Film preset and film size are applied first, so their order does not
// matter. Throws UsageError for an unknown path or a value out of range.
void applySettings(Project& project, std::vector<Setting> settings);
// Applies all --set options. Film preset and film size are applied first, so the order of the
// options does not matter. Throws UsageError for an unknown path or a value out of range.
void applySettings(Project& project, const QCommandLineParser& parser);

// Declares and reads JOB.dipw and --set.
void declareProject(CommandSyntax& syntax);
QString projectPath(const QCommandLineParser& parser);
Project projectArgument(const QCommandLineParser& parser);
// Does the same for commands that take several projects. `whatHappens` says what they do with
// several. Throws UsageError if no project is given.
void declareProjects(CommandSyntax& syntax, const QString& whatHappens);
QStringList projectPaths(const QCommandLineParser& parser);
Project readProject(const QString& path, const QCommandLineParser& parser);

// Prints one line for each warning about a result.
void printWarnings(const QStringList& warnings, QTextStream& out);

// Declares and reads --film-image chessboard|FILE. Throws Error if the picture cannot be read.
void declareFilmImage(CommandSyntax& syntax);
// Declares --film-image chessboard with this description, for a film that is printed already.
void declareChessboard(CommandSyntax& syntax, const QString& description);
void applyFilmImage(JobOptions& options, const QCommandLineParser& parser);

// Declares --threads N. At most N threads compute while the returned object exists.
void declareThreads(CommandSyntax& syntax);
ThreadLimit threadLimit(const QCommandLineParser& parser);

} // namespace dipwright::cli
