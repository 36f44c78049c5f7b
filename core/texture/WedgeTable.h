// Reads and writes a step wedge's readings as a table (docs/files-and-commands.md, "Profiles").
#pragma once

#include "texture/InkLaw.h"

#include <QByteArray>
#include <array>
#include <vector>

namespace dipwright {

// The tones of a wedge page, as densities.
inline constexpr std::array wedgeTones{0.05, 0.1,  0.2, 0.3,  0.45, 0.6,  0.75,
                                       0.9,  1.05, 1.2, 1.35, 1.5,  1.75, 2.0};
inline constexpr qint64 mostWedgeBytes = 1 << 20;

// Reads a table with the heading ink,nominal,flat,across,down,shown and one line per reading. `ink`
// is cyan, magenta, yellow, black, white, or grey; grey stands for the first three together.
// `nominal` is the density that the wedge page specifies, `flat` the density of unstretched film.
// `across` and `down` are the lengths in mm of the page's two rulers on the stretched film; `shown`
// is the density there. Throws Error that names the line.
std::vector<WedgeReading> readWedge(const QByteArray& table, const QString& where);
// A row of the wedge page: the first `tones` of wedgeTones in one ink.
struct WedgeInk {
    FilmInk ink = FilmInk::Cyan;
    std::size_t tones = wedgeTones.size();
};
// Returns a table to fill in, with `stretches` lines per patch of the page.
QByteArray blankWedge(const std::vector<WedgeInk>& rows, int stretches);

} // namespace dipwright
