// Which paint depends on film that tore, found no rest or was let go of: what "marked" means, for
// the report, the maps, the proof and the views alike.
#pragma once

#include "dip/LaidFilm.h"

#include <QString>

#include <array>
#include <optional>

namespace dipwright {

// The gravest first.
inline constexpr std::array<solver::PointMark, 3> filmMarks{
    solver::PointMark::Torn, solver::PointMark::Unbalanced, solver::PointMark::LetGo};

// Of a piece of film with these solver::PointMark bits; nothing where it has none.
std::optional<solver::PointMark> gravestMark(std::uint8_t marks);
// The bits of all film that paints, together.
std::uint8_t paintedMarks(const LaidFilm& laid);

// How much of a body is painted by marked film, mm² of the body.
struct MarkedArea {
    double any = 0;
    std::array<double, filmMarks.size()> each{}; // in the order of filmMarks; film may have several

    void add(std::uint8_t marks, double area);
    void add(const MarkedArea& other);
    double of(solver::PointMark mark) const;
};

// For the user: "Film that tore".
QString markText(solver::PointMark mark);
// "247 mm², 2.5 % of what is painted, depend on marked film. Film let go of: 247 mm²", of a body
// that is painted on `paintedArea` mm²; empty where nothing is marked.
QString markedText(const MarkedArea& marked, double paintedArea);

} // namespace dipwright
