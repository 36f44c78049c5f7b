#include "pipeline/JobCost.h"

#include "pipeline/JobTraveller.h"

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

constexpr double perThousand = 1e-3; // m in a mm

// Returns the time from the waiting height over the film back to this height.
Seconds motionTime(const DipMotion& motion) {
    return motion.path.empty() ? motionPoints(motion).back().time : motionPoses(motion).back().time;
}

std::vector<InkOfSheet> inksOf(const ImmersionResult& dip,
                               const std::optional<PrinterProfile>& printer) {
    const InkCosts costs = printer ? printer->costs : InkCosts();
    std::vector<InkOfSheet> inks;
    for (const InkArea& ink : dip.inks) {
        const auto process = std::size_t(std::max(ink.process, 0));
        const std::size_t spot = ink.isWhite ? 0 : 1;
        inks.push_back(
            ink.process >= 0
                ? InkOfSheet{ink.ink, ink.area, costs.laydown[process], costs.price[process]}
                : InkOfSheet{ink.ink, ink.area, costs.spotLaydown[spot], costs.spotPrice[spot]});
    }
    return inks;
}

bool isSame(QSizeF a, QSizeF b) {
    constexpr double most = 1; // mm
    return std::abs(a.width() - b.width()) <= most && std::abs(a.height() - b.height()) <= most;
}

// Returns the film of one sheet. Its length is along the web.
FilmAmount sheetFilm(const FilmSettings& film, FeedDirection feed) {
    const auto [narrow, wide] =
        std::minmax({film.width.value() * perThousand, film.height.value() * perThousand});
    return {narrow * wide, feed == FeedDirection::ShortEdgeFirst ? wide : narrow, 1};
}

} // namespace

OrderCost jobCost(const JobResult& result, const ProjectProfiles& profiles, int parts,
                  const std::optional<FilmAmount>& packed) {
    const std::optional<FilmProfile>& film = profiles.film;
    OrderToCost order;
    order.parts = parts;
    order.sheet = sheetFilm(result.project.film, film ? film->feed : FeedDirection::ShortEdgeFirst);
    order.packed = packed;
    order.film = film ? film->costs : FilmCosts();
    order.work = profiles.tank ? profiles.tank->costs : WorkCosts();
    for (std::size_t number = 0; number < result.immersions.size(); ++number) {
        const ImmersionResult& immersion = result.immersions[number];
        DipCosts dip;
        dip.inks = inksOf(immersion, profiles.printer);
        dip.motion = motionTime(jobMotion(result, number));
        if (film) {
            dip.soak = film->soakTime;
            dip.activator = film->activatorTime;
            dip.flash = film->flashTime;
            dip.drying = film->dryingTime;
        }
        order.areInksEstimated = order.areInksEstimated || areEstimated(immersion.inks);
        order.dips.push_back(std::move(dip));
    }
    return costOf(order);
}

std::vector<OrderCost> jobCosts(const JobResult& result, const Project& project) {
    std::vector<OrderCost> costs{jobCost(result, project.profiles, 1)};
    if (project.partsToMake > 1) {
        costs.push_back(jobCost(result, project.profiles, project.partsToMake));
    }
    return costs;
}

JobResult withCostsOf(JobResult result, const Project& project) {
    ProjectProfiles& profiles = result.project.profiles;
    if (profiles.printer && project.profiles.printer) {
        profiles.printer->costs = project.profiles.printer->costs;
    }
    if (profiles.film && project.profiles.film) {
        profiles.film->costs = project.profiles.film->costs;
    }
    if (profiles.tank && project.profiles.tank) {
        profiles.tank->costs = project.profiles.tank->costs;
    }
    result.project.partsToMake = project.partsToMake;
    return result;
}

bool tellsCost(const std::vector<OrderCost>& costs) {
    return costs.size() > 1 || costs.front().hasPrices();
}

FilmAmount filmOf(const PackedFilms& films, QSizeF sheet) {
    const QSizeF size = films.settings.film.size;
    FilmAmount amount;
    amount.haveSheetPrice =
        !films.settings.film.isRoll && (isSame(size, sheet) || isSame(size, sheet.transposed()));
    for (const PlannedFilm& film : films.plan.films) {
        const double width = film.size.width() * perThousand;
        const double height = film.size.height() * perThousand;
        const auto [narrow, wide] = std::minmax({width, height});
        const bool isShortFirst = films.settings.feed == FeedDirection::ShortEdgeFirst;
        amount.squareMetres += width * height;
        amount.rollMetres += films.settings.film.isRoll ? height : isShortFirst ? wide : narrow;
        amount.sheets += 1;
    }
    return amount;
}

} // namespace dipwright
