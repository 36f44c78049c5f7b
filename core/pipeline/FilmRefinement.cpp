#include "pipeline/FilmRefinement.h"

#include "accuracy/verdict/FinerFilm.h"
#include "base/NumberText.h"
#include "dip/FilmUnderBody.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

constexpr double almostEqual = 1.00001; // film points' errors are floats

QString millimetresText(double length) {
    return numberText(length, 2);
}

// Returns neededCell() of a dip whose numerical error was estimated.
std::optional<double> neededCell(const ImmersionResult& dip, const Verdict& verdict,
                                 const FilmSettings& settings) {
    return neededCell(verdict, dip.laid->film(), dip.numericalError->offBy.percentile95, settings);
}

// Returns the smallest numerical error that a reason of the verdict allows, mm.
double leastAllowedError(const Verdict& verdict) {
    double least = std::numeric_limits<double>::infinity();
    for (const VerdictReason& reason : verdict.reasons) {
        const bool limitsError = reason.kind == VerdictReason::Kind::OffBy ||
                                 reason.kind == VerdictReason::Kind::OffByMuch ||
                                 reason.kind == VerdictReason::Kind::Step;
        least = limitsError ? std::min(least, reason.limit) : least;
    }
    return least;
}

} // namespace

std::optional<double> nextRefinement(const ImmersionResult& dip, const Verdict& verdict,
                                     const FilmSettings& settings) {
    if (!dip.numericalError || !dip.refinementFailure.isEmpty()) {
        return std::nullopt;
    }
    return nextRefinement(verdict, dip.laid->film(), dip.numericalError->offBy.percentile95,
                          dip.refinement, settings);
}

FilmSettings filmOf(const ImmersionResult& dip, const Project& project) {
    FilmSettings film = project.film;
    film.refinement *= dip.refinement;
    return film;
}

QStringList refinementRemarks(const JobResult& result) {
    QStringList remarks;
    for (const ImmersionResult& dip : result.immersions) {
        if (dip.refinement > 1) {
            remarks.append(Text::tr("%1: the film's cells were reduced to %2 mm.")
                               .arg(dip.immersion.name,
                                    millimetresText(dip.laid->film().grid.leastSpacing())));
        }
    }
    return remarks;
}

QStringList refinementNotes(const JobResult& result) {
    QStringList notes = refinementRemarks(result);
    const FilmSettings& settings = result.project.film;
    for (const ImmersionResult& dip : result.immersions) {
        const DippedFilm& film = dip.laid->film();
        const double own = film.grid.leastSpacing();
        if (!dip.refinementFailure.isEmpty()) {
            notes.append(Text::tr("%1: the dip could not be repeated with smaller cells: %2")
                             .arg(dip.immersion.name, dip.refinementFailure));
            continue;
        }
        const auto cell =
            dip.numericalError ? neededCell(dip, dip.verdict, settings) : std::nullopt;
        if (!cell || !isRefinable(settings) || dip.finer) {
            continue;
        }
        const double finer = own / *cell;
        // Such a film would have too many points, or its least error would be too large.
        if (double(film.grid.pointCount()) * finer * finer > maximumFilmGrid ||
            leastErrorCells * *cell > almostEqual * leastAllowedError(dip.verdict)) {
            continue;
        }
        const double work =
            double(film.grid.pointCount()) * double(film.steps) / 1e6 * std::pow(finer, 3);
        if (work > settings.work) {
            const bool isPrintable = !wantedCell(dip.verdict, film);
            notes.append(
                (isPrintable
                     ? Text::tr(
                           "%1: the sheet can be printed, but its numerical error is above the "
                           "wanted error. Cells of %2 mm might reach it, with about %3 million "
                           "points × steps; the project allows %4 million (Film > Work limit).")
                     : Text::tr("%1: cells of %2 mm might be small enough to print the sheet, but "
                                "would need about %3 million points × steps; the project allows "
                                "%4 million. Raise this limit (Film > Work limit), or turn the "
                                "part."))
                    .arg(dip.immersion.name, millimetresText(cellToSet(*cell)), numberText(work, 0),
                         numberText(settings.work, 0)));
        }
    }
    return notes;
}

} // namespace dipwright
