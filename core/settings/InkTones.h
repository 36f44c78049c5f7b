// Ink tones measured with a step wedge: their text form in files, and checks of their values.
#pragma once

#include "settings/InkSettings.h"

#include <QString>
#include <QStringList>
#include <optional>

namespace dipwright {

// Returns "cyan", "magenta", "yellow", "black" or "white".
QString inkName(FilmInk ink);
std::optional<FilmInk> inkOf(const QString& name); // nothing if no ink has this name

// Returns text such as "cyan 0.3 0.48 0.11 2.9; …": ink, density, exponent, bend, greatest stretch.
// inkTones() reads exactly the same numbers back.
QString inkTonesText(const std::vector<InkTone>& tones);
// Reads that text. Throws Error if it is malformed, or where checkInkLaw() would throw.
std::vector<InkTone> inkTones(const QString& text, const QString& where);

// Throws Error if an ink's tones are not in ascending order, or if on stretched film a denser patch
// would look lighter.
void checkInkLaw(const InkLaw& law, const QString& where);

// Returns the share of a tone's density that remains where the film's area has grown by `stretch`.
double thinned(const InkTone& tone, double stretch);

// Converts the words to numbers. Returns nothing if one of them is not a finite number.
std::optional<std::vector<double>> finiteNumbers(const QStringList& words);

} // namespace dipwright
