// The options that describe the film on which several sheets are packed.
#pragma once

#include "cli/CommandSyntax.h"
#include "pipeline/JobPacking.h"

#include <QCommandLineParser>

namespace dipwright::cli {

// Declares --film, --spacing, --margin, --whole, --feed and --turn. `withoutFilm` is a sentence
// about a command line without --film.
void declarePacking(CommandSyntax& syntax, const QString& withoutFilm);
// Throws UsageError if an option of packing is given without --film.
void refusePackingWithoutFilm(const QCommandLineParser& parser);
// Tells whether --film is given.
bool packs(const QCommandLineParser& parser);
// Reads the options. Throws UsageError.
PackSettings packSettings(const QCommandLineParser& parser);

} // namespace dipwright::cli
