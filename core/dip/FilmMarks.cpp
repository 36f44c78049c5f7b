#include "dip/FilmMarks.h"

#include "base/NumberText.h"

#include <QCoreApplication>

#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Dip)
};

QString squareMillimetres(double area) {
    return Text::tr("%1 mm²").arg(numberText(area, area < 10 ? 1 : 0));
}

} // namespace

std::optional<solver::PointMark> mostSeriousMark(std::uint8_t marks) {
    const auto* gravest = std::find_if(filmMarks.begin(), filmMarks.end(),
                                       [&](solver::PointMark mark) { return has(marks, mark); });
    return gravest == filmMarks.end() ? std::nullopt : std::optional(*gravest);
}

std::uint8_t paintedMarks(const LaidFilm& laid) {
    std::uint8_t marks = 0;
    for (std::uint32_t triangle = 0; triangle < laid.triangles().size(); ++triangle) {
        if (laid.contact().reaches(triangle)) {
            marks |= laid.marks(triangle);
        }
    }
    return marks;
}

void MarkedArea::add(std::uint8_t marks, double area) {
    any += marks != 0 ? area : 0;
    for (std::size_t mark = 0; mark < filmMarks.size(); ++mark) {
        each[mark] += has(marks, filmMarks[mark]) ? area : 0;
    }
}

void MarkedArea::add(const MarkedArea& other) {
    any += other.any;
    for (std::size_t mark = 0; mark < filmMarks.size(); ++mark) {
        each[mark] += other.each[mark];
    }
}

double MarkedArea::of(solver::PointMark mark) const {
    return each[std::size_t(std::find(filmMarks.begin(), filmMarks.end(), mark) -
                            filmMarks.begin())];
}

QString markText(solver::PointMark mark) {
    switch (mark) {
    case solver::PointMark::Torn:
        return Text::tr("Torn film");
    case solver::PointMark::Unbalanced:
        return Text::tr("Film that did not converge");
    case solver::PointMark::LetGo:
        return Text::tr("Released film");
    }
    return {};
}

QString markedText(const MarkedArea& marked, double paintedArea) {
    if (!(marked.any > 0)) {
        return {};
    }
    constexpr double clearly = 1.001;
    QStringList causes;
    double sum = 0;
    for (std::size_t mark = 0; mark < filmMarks.size(); ++mark) {
        if (marked.each[mark] > 0) {
            sum += marked.each[mark];
            causes.append(Text::tr("%1: %2").arg(markText(filmMarks[mark]),
                                                 squareMillimetres(marked.each[mark])));
        }
    }
    if (sum > clearly * marked.any) {
        causes.append(Text::tr("some places have several causes"));
    }
    const double percent = 100 * marked.any / paintedArea;
    return Text::tr("%1 of the painted area (%2 %) is painted by film that tore, was released or "
                    "did not converge. %3.")
        .arg(squareMillimetres(marked.any), numberText(percent, percent < 10 ? 1 : 0),
             causes.join(QStringLiteral("; ")));
}

} // namespace dipwright
