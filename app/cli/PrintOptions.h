// Declares and reads the options of the commands that print: the printer, its profile, or a file
// instead.
#pragma once

#include "cli/Command.h"
#include "printing/PrintFile.h"
#include "printing/PrintService.h"
#include "project/ProfileLibrary.h"

namespace dipwright::cli {

// Declares and reads --printer, --profile and --accept-other-paper.
void declarePrinterOnly(CommandSyntax& syntax);
QString printerName(const QCommandLineParser& parser); // empty without --printer
// Declares and reads these options, --printers and --to. `file` describes --to; without it, a sheet
// is written as PDF or TIFF.
void declarePrinter(CommandSyntax& syntax, const QString& file = {});
bool listsPrinters(const QCommandLineParser& parser);
bool acceptsOtherPaper(const QCommandLineParser& parser);
void listPrinters(QTextStream& out);

// The destination of a print. Exactly one of the two members is set.
struct PrintTarget {
    QString printer;
    QString file; // name ends in .pdf, .tif or .tiff
};
// Tells whether --printer or --to is given.
bool namesTarget(const QCommandLineParser& parser);
// Throws UsageError if an option of printing is given: --printer, --to or --accept-other-paper.
// `when` ends the message.
void refuseTarget(const QCommandLineParser& parser, const QString& when);
// Throws UsageError unless exactly one of --printer and --to is given, and Error if the file of
// --to may not be replaced.
PrintTarget printTarget(const QCommandLineParser& parser);
// Throws Error if a file exists that is not a PDF or TIFF file of this program.
void requireReplaceableSheet(const QString& path);
// Puts the profile of --profile into a project, so that its verdict is that of this printer. Throws
// Error for an unknown profile.
void useProfile(const QCommandLineParser& parser, Project& project);
// Returns the request for a project on which useProfile() was called.
PrintRequest printRequest(const QCommandLineParser& parser, const PrintTarget& target,
                          const Project& project);
// Prints the plans. Writes one line with the outcome of each job.
void printAndReport(PrintSystem& system, const std::vector<PrintPlan>& plans,
                    const Progress& progress, QTextStream& out);

} // namespace dipwright::cli
