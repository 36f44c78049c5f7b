#include "accuracy/verdict/FinerFilm.h"

#include "dip/FilmUnderBody.h"

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

using Kind = VerdictReason::Kind;

// The next cell if the verdict proposes none, as a share of the present one.
constexpr double withoutProposal = 0.5;
constexpr double million = 1e6;
// A number of doublings that exceeds a whole number by less than this counts as whole.
constexpr double almostWhole = 0.01;
// The numbers of columns and rows are rounded, so a film may get slightly more points.
constexpr double roundedLines = 1.02;

bool isNumerical(Kind kind) {
    switch (kind) {
    case Kind::NothingAlike:
    case Kind::OffBy:
    case Kind::OffByMuch:
    case Kind::Step:
    case Kind::FarOffPlaces:
    case Kind::UnknownError:
    case Kind::Border:
    case Kind::Unbalanced:
        return true;
    default:
        return false;
    }
}

bool isTooLarge(const VerdictReason& reason) {
    return reason.advice > Advice::Print && isNumerical(reason.kind);
}

} // namespace

std::optional<double> wantedCell(const Verdict& verdict, const DippedFilm& film) {
    if (std::none_of(verdict.reasons.begin(), verdict.reasons.end(), isTooLarge)) {
        return std::nullopt;
    }
    const double own = film.grid.leastSpacing();
    std::optional<double> proposed;
    for (const VerdictReason& reason : verdict.reasons) {
        if (reason.kind == Kind::OffBy && reason.most > 0) {
            proposed = std::min(proposed.value_or(reason.most), reason.most);
        }
    }
    return proposed.value_or(withoutProposal * own);
}

std::optional<double> neededCell(const Verdict& verdict, const DippedFilm& film, double offBy,
                                 const FilmSettings& settings) {
    if (const std::optional<double> printable = wantedCell(verdict, film)) {
        return printable;
    }
    return settings.wantedError && offBy > settings.wantedError->value()
               ? std::optional(film.grid.leastSpacing() * settings.wantedError->value() / offBy)
               : std::nullopt;
}

double cellToSet(double cell) {
    return std::floor(100 * cell) / 100;
}

double smallestCell(const DippedFilm& film, const FilmSettings& settings) {
    const auto points = double(film.grid.pointCount());
    const auto steps = double(std::max<std::int64_t>(film.steps, 1));
    const double byWork = std::cbrt(points * steps / (settings.work * million));
    const double byPoints = roundedLines * std::sqrt(points / maximumFilmGrid);
    return film.grid.leastSpacing() * std::max(byWork, byPoints);
}

std::optional<double> finerCell(double wanted, const DippedFilm& film,
                                const FilmSettings& settings) {
    if (!isRefinable(settings)) {
        return std::nullopt;
    }
    const double own = film.grid.leastSpacing();
    const auto doublings = [own](double cell) { return 3 * std::log2(own / cell); };
    const double taken =
        std::min(std::max(1.0, std::ceil(doublings(wanted) - almostWhole)),
                 std::floor(doublings(smallestCell(film, settings)) + almostWhole));
    return taken < 1 ? std::nullopt : std::optional(own * std::exp2(-taken / 3));
}

std::optional<double> nextRefinement(const Verdict& verdict, const DippedFilm& film, double offBy,
                                     double refinement, const FilmSettings& settings) {
    const std::optional<double> needed = neededCell(verdict, film, offBy, settings);
    const std::optional<double> cell = needed ? finerCell(*needed, film, settings) : std::nullopt;
    return cell ? std::optional(refinement * film.grid.leastSpacing() / *cell) : std::nullopt;
}

Verdict afterRefinement(Verdict verdict, const DippedFilm& film, const FilmSettings& settings) {
    const std::optional<double> wanted = wantedCell(verdict, film);
    const std::optional<double> cell = wanted ? finerCell(*wanted, film, settings) : std::nullopt;
    if (!cell || *cell > (1 + almostWhole) * *wanted) {
        return verdict;
    }
    ReasonList expected;
    for (const VerdictReason& reason : verdict.reasons) {
        if (!isTooLarge(reason)) {
            expected.add(reason);
        }
    }
    expected.add({Kind::Refined, Advice::Print, *cell});
    return std::move(expected).verdict();
}

} // namespace dipwright
