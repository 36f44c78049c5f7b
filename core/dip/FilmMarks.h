// Defines "marked" film: film that tore, did not converge or was released. The report, the maps,
// the proof and the views all use this definition.
#pragma once

#include "dip/LaidFilm.h"

#include <QString>

#include <array>
#include <optional>

namespace dipwright {

// The marks that count, the most serious first.
inline constexpr std::array<solver::PointMark, 3> filmMarks{
    solver::PointMark::Torn, solver::PointMark::Unbalanced, solver::PointMark::LetGo};

// Returns the most serious of the marks in these solver::PointMark bits; nothing if there are none.
std::optional<solver::PointMark> mostSeriousMark(std::uint8_t marks);
// Returns the bitwise or of the marks of all film that paints.
std::uint8_t paintedMarks(const LaidFilm& laid);

// The area of the body that marked film paints, mm².
struct MarkedArea {
    double any = 0; // area of film with at least one mark
    // Area of each mark, in the order of filmMarks. The areas may overlap, as film can have several
    // marks.
    std::array<double, filmMarks.size()> each{};

    void add(std::uint8_t marks, double area);
    void add(const MarkedArea& other);
    double of(solver::PointMark mark) const;
};

// Returns the name of a mark for the user, such as "Torn film".
QString markText(solver::PointMark mark);
// Returns a text such as "247 mm² of the painted area (2.5 %) is painted by film that tore, was
// released or did not converge. Released film: 247 mm²."; empty if nothing is marked. `paintedArea`
// is the painted area of the body, mm².
QString markedText(const MarkedArea& marked, double paintedArea);

} // namespace dipwright
