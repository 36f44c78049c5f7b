#include "pipeline/RunUntilPrint.h"

#include "dip/FilmUnderBody.h"
#include "pipeline/Pipeline.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

using Kind = VerdictReason::Kind;

constexpr double mostOfCell = 0.9; // the next cell is at most this share of the last one
// The next cell if the verdict proposes none, as a share of the last one.
constexpr double withoutProposal = 0.5;
constexpr double firstShare = 0.2; // progress after the first run, 0 … 1

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

// Returns the cell, in mm, with which the dip may be printed; none if smaller cells do not help.
std::optional<double> nextCell(const ImmersionResult& dip) {
    const double own = dip.laid->film().grid.leastSpacing();
    bool isTooCoarse = false;
    std::optional<double> proposed;
    for (const VerdictReason& reason : dip.verdict.reasons) {
        isTooCoarse |= reason.advice > Advice::Print && isNumerical(reason.kind);
        if (reason.kind == Kind::OffBy && reason.most > 0) {
            proposed = std::min(proposed.value_or(reason.most), reason.most);
        }
    }
    if (!isTooCoarse) {
        return std::nullopt;
    }
    return proposed ? std::min(*proposed, mostOfCell * own) : withoutProposal * own;
}

// Returns the smallest cell that a dip needs.
std::optional<double> nextCell(const JobResult& result) {
    std::optional<double> cell;
    for (const ImmersionResult& dip : result.immersions) {
        if (const auto next = nextCell(dip)) {
            cell = std::min(cell.value_or(*next), *next);
        }
    }
    return cell;
}

// Returns the work of the largest dip with such cells. Points grow with the square, steps in
// proportion, because steps are given in cells.
double workWith(const JobResult& result, double cell) {
    double most = 0;
    for (const ImmersionResult& dip : result.immersions) {
        const DippedFilm& film = dip.laid->film();
        const double finer = film.grid.leastSpacing() / cell;
        most = std::max(most, double(film.grid.pointCount()) * double(film.steps) * finer * finer *
                                  finer);
    }
    return most;
}

QString millions(double work) {
    return QLocale().toString(work / 1e6, 'f', work < 10e6 ? 1 : 0);
}

} // namespace

JobResult runUntilPrint(const Project& project, const SolverRegistry& registry,
                        const JobOptions& options, double work, const Progress& progress) {
    JobResult result = runJob(project, registry, options, nullptr, progress.part(0, firstShare));
    double done = firstShare;
    std::optional<double> used;
    std::optional<double> cell = nextCell(result);
    while (cell && isGraded(result.project.film) && workWith(result, *cell) <= work) {
        Project finer = result.project;
        finer.film.resolution = FilmResolution::Cell;
        finer.film.cell = Millimetres(*cell);
        const double next = done + (1 - done) / 2;
        result = runJob(finer, registry, options, &result, progress.part(done, next));
        done = next;
        used = cell;
        cell = nextCell(result);
    }
    const QLocale locale;
    if (used) {
        result.notes.append(Text::tr("The film's cells were reduced to %1 mm.")
                                .arg(locale.toString(*used, 'f', 2)));
    }
    if (cell && !isGraded(result.project.film)) {
        result.notes.append(Text::tr("The number of film points is fixed, so the film was not "
                                     "refined; set Film > Resolution to cells."));
    } else if (cell) {
        result.notes.append(
            Text::tr("With cells of %1 mm, the sheets might be good enough to print. A dip would "
                     "then need %2 million points × steps; at most %3 million are allowed. Raise "
                     "this limit, or turn the part.")
                .arg(locale.toString(*cell, 'f', 2), millions(workWith(result, *cell)),
                     millions(work)));
    }
    return result;
}

} // namespace dipwright
