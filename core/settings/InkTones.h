// The tones of inks that a step wedge told: their text in files, and whether they are sound.
#pragma once

#include "settings/InkSettings.h"

#include <QString>
#include <QStringList>
#include <optional>

namespace dipwright {

// "cyan", "magenta", "yellow", "black", "white".
QString inkName(FilmInk ink);
std::optional<FilmInk> inkOf(const QString& name); // none: no ink is called so

// "cyan 0.3 0.48 0.11 2.9; …": ink, density, exponent, bend, greatest stretch. Reading gives the
// same numbers; it throws Error on what is no such text and as checkInkLaw() does.
QString inkTonesText(const std::vector<InkTone>& tones);
std::vector<InkTone> inkTones(const QString& text, const QString& where);

// Throws Error where an ink's tones are not ascending, or more of it would show less.
void checkInkLaw(const InkLaw& law, const QString& where);

// The share of a tone's density that shows where the film's area has grown by `stretch`.
double thinned(const InkTone& tone, double stretch);

// None where one of the words is no finite number.
std::optional<std::vector<double>> finiteNumbers(const QStringList& words);

} // namespace dipwright
