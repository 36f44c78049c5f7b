// What the commands that print share: the printer, its profile, a file in its place.
#pragma once

#include "cli/Command.h"
#include "printing/PrintFile.h"
#include "printing/PrintService.h"
#include "project/ProfileLibrary.h"

namespace dipwright::cli {

// --printer, --printers, --to, --profile, --accept-other-paper.
void declarePrinter(CommandSyntax& syntax);
bool listsPrinters(const QCommandLineParser& parser);
bool acceptsOtherPaper(const QCommandLineParser& parser);
void listPrinters(QTextStream& out);

// Where to print: one of the two is empty.
struct PrintTarget {
    QString printer;
    QString file; // .pdf, .tif or .tiff
};
// Throws UsageError unless exactly one of --printer and --to is there.
PrintTarget printTarget(const QCommandLineParser& parser);
// With the profile of --profile, else the `remembered` one. Throws Error for an unknown profile.
PrintRequest printRequest(const QCommandLineParser& parser, const PrintTarget& target,
                          const std::optional<PrinterProfile>& remembered);
// Prints what was planned, and tells in a line what became of each job.
void printAndTell(PrintSystem& system, const std::vector<PrintPlan>& plans,
                  const Progress& progress, QTextStream& out);

} // namespace dipwright::cli
