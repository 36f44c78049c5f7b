#include "pipeline/FilmRefinement.h"

#include "dip/FilmUnderBody.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

using Kind = VerdictReason::Kind;

// The next cells are at most this share of the present ones. Less would hardly change the sheet.
constexpr double mostOfCell = 0.9;
// The next cell if the verdict proposes none, as a share of the present one.
constexpr double withoutProposal = 0.5;
constexpr double million = 1e6;

bool isNumerical(Kind kind) {
    switch (kind) {
    case Kind::OffBy:
    case Kind::OffByMuch:
    case Kind::Step:
    case Kind::FarOffPlaces:
    case Kind::Border:
    case Kind::Unbalanced:
        return true;
    default:
        return false;
    }
}

// Returns the cell, in mm, with which the sheet may be printed; none if smaller cells do not help.
std::optional<double> wantedCell(const Verdict& verdict, double own) {
    bool isTooCoarse = false;
    std::optional<double> proposed;
    for (const VerdictReason& reason : verdict.reasons) {
        isTooCoarse |= reason.advice > Advice::Print && isNumerical(reason.kind);
        if (reason.kind == Kind::OffBy && reason.most > 0) {
            proposed = std::min(proposed.value_or(reason.most), reason.most);
        }
    }
    if (!isTooCoarse) {
        return std::nullopt;
    }
    return std::min(proposed.value_or(withoutProposal * own), mostOfCell * own);
}

// Returns the smallest cell that the film's limits of work and points allow, in mm. Points grow
// with the square of the refinement; steps, which are given in cells, in proportion to it.
double smallestCell(const DippedFilm& film, double work) {
    const auto points = double(film.grid.pointCount());
    const double byWork = std::cbrt(points * double(film.steps) / (work * million));
    const double byPoints = std::sqrt(points / maximumFilmGrid);
    return film.grid.leastSpacing() * std::max(byWork, byPoints);
}

QString millimetresText(double length) {
    return QLocale().toString(length, 'f', 2);
}

} // namespace

std::optional<double> nextRefinement(const ImmersionResult& dip, const Project& project,
                                     const ZonedBody* zones) {
    if (!isRefinable(project.film) || !dip.numericalError) {
        return std::nullopt;
    }
    const DippedFilm& film = dip.laid->film();
    const double own = film.grid.leastSpacing();
    const std::optional<double> wanted = wantedCell(
        numericalVerdict(*dip.laid, dip.numericalError.get(), zones, project.tolerance), own);
    if (!wanted) {
        return std::nullopt;
    }
    const double cell = std::max(*wanted, smallestCell(film, project.film.work));
    return cell <= mostOfCell * own ? std::optional(dip.refinement * own / cell) : std::nullopt;
}

FilmSettings filmOf(const ImmersionResult& dip, const Project& project) {
    FilmSettings film = project.film;
    film.refinement *= dip.refinement;
    return film;
}

QStringList refinementNotes(const JobResult& result) {
    QStringList notes;
    for (const ImmersionResult& dip : result.immersions) {
        const DippedFilm& film = dip.laid->film();
        const double own = film.grid.leastSpacing();
        if (dip.refinement > 1) {
            notes.append(Text::tr("%1: the film's cells were reduced to %2 mm.")
                             .arg(dip.immersion.name, millimetresText(own)));
        }
        if (const auto cell = wantedCell(dip.verdict, own);
            cell && isRefinable(result.project.film) && !dip.finer) {
            const double work =
                double(film.grid.pointCount()) * double(film.steps) * std::pow(own / *cell, 3);
            notes.append(
                Text::tr("%1: cells of %2 mm might be small enough to print the sheet, but "
                         "would need about %3 million points × steps; the project allows "
                         "%4 million. Raise this limit (Film > Work limit), or turn the "
                         "part.")
                    .arg(dip.immersion.name, millimetresText(*cell),
                         QLocale().toString(work / million, 'f', 0),
                         QLocale().toString(result.project.film.work, 'f', 0)));
        }
    }
    return notes;
}

} // namespace dipwright
