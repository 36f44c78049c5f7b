// What several commands read from their command line.
#pragma once

#include "cli/Command.h"
#include "parallel/Threads.h"
#include "pipeline/JobOptions.h"

#include <QStringList>

namespace dipwright {

struct Project;

} // namespace dipwright

namespace dipwright::cli {

// The one positional argument that the command was declared with. Throws UsageError.
QString positionalArgument(const QCommandLineParser& parser, const QString& name);
void requireNoPositionalArgument(const QCommandLineParser& parser);

// The words after a command that does several things: what to do, and with what.
class Words {
public:
    Words(const QString& command, const QStringList& words) : command_(command), words_(words) {}

    // The next one; throws UsageError that `what` is missing.
    QString take(const QString& what);
    // Throws UsageError where some are left.
    void finish() const;

private:
    QString command_;
    QStringList words_;
};

// A number within limits; throws UsageError naming the option.
double numberOption(const QCommandLineParser& parser, const QString& option, double minimum,
                    double maximum);
int wholeNumberOption(const QCommandLineParser& parser, const QString& option, int minimum,
                      int maximum);

// The file that a picture is to be written to, empty without the option; throws UsageError where
// its name does not end on one of `endings` (".png").
QString pictureOption(const QCommandLineParser& parser, const QString& option,
                      const QStringList& endings);

// setByPath on behalf of an option: a refusal is a UsageError that names the option.
void setByOption(Project& project, const QString& path, const QString& value,
                 const QString& option);

// --set PATH=VALUE, repeatable.
void declareSettings(CommandSyntax& syntax);
// A film's preset and size are set before all else, so that --set film.points holds wherever it
// stands. Throws UsageError for an unknown path or a value out of range.
void applySettings(Project& project, const QCommandLineParser& parser);

// JOB.dipw and --set.
void declareProject(CommandSyntax& syntax);
QString projectPath(const QCommandLineParser& parser);
Project projectArgument(const QCommandLineParser& parser);
// The same for a command that takes several; throws UsageError where there is none.
void declareProjects(CommandSyntax& syntax);
QStringList projectPaths(const QCommandLineParser& parser);
Project readProject(const QString& path, const QCommandLineParser& parser);

// What the user is to know of how a result came about, a line each.
void printWarnings(const QStringList& warnings, QTextStream& out);

// --film-image chessboard|FILE. Throws Error for a picture that cannot be read.
void declareFilmImage(CommandSyntax& syntax);
void applyFilmImage(JobOptions& options, const QCommandLineParser& parser);

// --threads N: no more than N threads compute while the object lives.
void declareThreads(CommandSyntax& syntax);
ThreadLimit threadLimit(const QCommandLineParser& parser);

} // namespace dipwright::cli
