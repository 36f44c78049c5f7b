#include "pipeline/FilmRefinement.h"

#include "accuracy/verdict/FinerFilm.h"
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

// A number of doublings that exceeds a whole number by less than this counts as whole.
constexpr double almostWhole = 0.01;

QString millimetresText(double length) {
    return QLocale().toString(length, 'f', 2);
}

} // namespace

std::optional<double> nextRefinement(const ImmersionResult& dip, const Project& project,
                                     const ZonedBody* zones) {
    if (!dip.numericalError || dip.cannotBeRefined) {
        return std::nullopt;
    }
    const DippedFilm& film = dip.laid->film();
    const std::optional<double> cell =
        finerCell(numericalVerdict(*dip.laid, dip.numericalError.get(), zones, project.tolerance),
                  film, project.film);
    if (!cell) {
        return std::nullopt;
    }
    const double doublings = 3 * std::log2(film.grid.leastSpacing() / *cell); // of the work
    const double allowed =
        3 * std::log2(film.grid.leastSpacing() / smallestCell(film, project.film));
    const double taken = std::min(std::max(1.0, std::ceil(doublings - almostWhole)),
                                  std::floor(allowed + almostWhole));
    return taken < 1 ? std::nullopt : std::optional(dip.refinement * std::exp2(taken / 3));
}

FilmSettings filmOf(const ImmersionResult& dip, const Project& project) {
    FilmSettings film = project.film;
    film.refinement *= dip.refinement;
    return film;
}

QStringList refinementNotes(const JobResult& result) {
    QStringList notes;
    const FilmSettings& settings = result.project.film;
    for (const ImmersionResult& dip : result.immersions) {
        const DippedFilm& film = dip.laid->film();
        const double own = film.grid.leastSpacing();
        if (dip.refinement > 1) {
            notes.append(Text::tr("%1: the film's cells were reduced to %2 mm.")
                             .arg(dip.immersion.name, millimetresText(own)));
        }
        const auto cell = dip.numericalError ? wantedCell(dip.verdict, film) : std::nullopt;
        if (cell && isRefinable(settings) && !dip.finer && *cell < smallestCell(film, settings)) {
            const double work = double(film.grid.pointCount()) * double(film.steps) / 1e6 *
                                std::pow(own / *cell, 3);
            notes.append(
                Text::tr("%1: cells of %2 mm might be small enough to print the sheet, but "
                         "would need about %3 million points × steps; the project allows "
                         "%4 million. Raise this limit (Film > Work limit), or turn the "
                         "part.")
                    .arg(dip.immersion.name, millimetresText(*cell),
                         QLocale().toString(work, 'f', 0),
                         QLocale().toString(settings.work, 'f', 0)));
        }
    }
    return notes;
}

} // namespace dipwright
