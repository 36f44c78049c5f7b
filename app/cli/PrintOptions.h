// What the commands that print share: the printer, its profile, a file in its place.
#pragma once

#include "cli/Command.h"
#include "printing/PrintService.h"
#include "project/ProfileLibrary.h"

namespace dipwright::cli {

// --printer, --printers, --to, --profile, --accept-other-paper.
void declarePrinter(QCommandLineParser& parser);
bool listsPrinters(const QCommandLineParser& parser);
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
bool isTiff(const QString& path);

// Writes a file whole or not at all. Throws Error.
void writeWhole(const QString& path, const std::function<void(QIODevice&)>& write);

// The profile's colours; null where it has none. Throws Error.
std::unique_ptr<PrinterColour> printerColour(const PrinterProfile& profile);

// Submits, follows to the end, and tells in a line what became of it.
void printAndTell(PrintSystem& system, const PrintPlan& plan, const Progress& progress,
                  QTextStream& out);

} // namespace dipwright::cli
