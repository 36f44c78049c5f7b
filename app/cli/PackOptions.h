// The options that describe the film on which several sheets are packed.
#pragma once

#include "cli/CommandSyntax.h"
#include "pipeline/JobPacking.h"

#include <QCommandLineParser>

namespace dipwright::cli {

// Declares --film, --spacing, --margin, --whole, --feed and --turn. `withoutFilm` is a sentence
// about a command line without --film.
void declarePacking(CommandSyntax& syntax, const QString& withoutFilm);
// Tells whether --film is given.
bool packs(const QCommandLineParser& parser);
// Reads the options. Throws UsageError.
PackSettings packSettings(const QCommandLineParser& parser);

} // namespace dipwright::cli
