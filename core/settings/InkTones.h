// Ink tones measured with a step wedge: their text form in files, and checks of their values.
#pragma once

#include "settings/InkSettings.h"

#include <QString>
#include <QStringList>
#include <optional>

namespace dipwright {

// "cyan", "magenta", "yellow", "black", "white".
QString inkName(FilmInk ink);
std::optional<FilmInk> inkOf(const QString& name); // none if no ink has this name

// Text such as "cyan 0.3 0.48 0.11 2.9; …": ink, density, exponent, bend, greatest stretch. Reading
// gives the same numbers. It throws Error if the text is malformed, or as checkInkLaw() does.
QString inkTonesText(const std::vector<InkTone>& tones);
std::vector<InkTone> inkTones(const QString& text, const QString& where);

// Throws Error if an ink's tones are not in ascending order, or if more of the ink would show less.
void checkInkLaw(const InkLaw& law, const QString& where);

// Returns the share of a tone's density that remains where the film's area has grown by `stretch`.
double thinned(const InkTone& tone, double stretch);

// Returns none if one of the words is no finite number.
std::optional<std::vector<double>> finiteNumbers(const QStringList& words);

} // namespace dipwright
