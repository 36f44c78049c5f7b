// A step wedge's readings as a table (docs/files-and-commands.md, "Profiles").
#pragma once

#include "texture/InkLaw.h"

#include <QByteArray>

namespace dipwright {

// The tones that a wedge page has, as densities.
inline constexpr std::array wedgeTones{0.05, 0.1,  0.2, 0.3,  0.45, 0.6,  0.75,
                                       0.9,  1.05, 1.2, 1.35, 1.5,  1.75, 2.0};
inline constexpr qint64 mostWedgeBytes = 1 << 20;

// A line for each reading after one with the columns' names: ink,nominal,flat,across,down,shown.
// `ink` is cyan, magenta, yellow, black, white, or grey for the first three at once; the three in
// the middle are the density that the page asked for, the one that unstretched film shows, and the
// lengths in mm that the page's two rulers have on the stretched film; the last is the density
// shown there. Throws Error naming the line.
std::vector<WedgeReading> readWedge(const QByteArray& table, const QString& where);
// Such a table for cyan, magenta and yellow, with black where `black`, with the readings still to
// be filled in.
QByteArray blankWedge(int stretches, bool black = false);

} // namespace dipwright
