// Prints a job's verdict in the same way for all commands that run a job.
#pragma once

#include "cli/Command.h"
#include "pipeline/JobResult.h"

#include <QTextStream>
#include <optional>

namespace dipwright::cli {

// Prints the verdict and all reasons for it, worst first. If the ink makes the part too pale,
// prints what helps.
void printVerdict(const JobResult& result, QTextStream& out);

// Declares and reads --require: the worst verdict that the user accepts; nothing if any verdict is
// accepted. Throws UsageError.
void declareRequired(CommandSyntax& syntax, const QString& description, const QString& byDefault);
std::optional<Advice> requiredAdvice(const QCommandLineParser& parser);
// Returns the verdict to compare with the requirement. A job whose numerical error was not judged
// meets no requirement.
Advice verdictToCompare(const JobResult& result);
bool isWorse(Advice verdict, Advice required);

} // namespace dipwright::cli
