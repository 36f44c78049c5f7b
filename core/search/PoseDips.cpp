#include "search/PoseDips.h"

#include "dip/FilmUnderBody.h"
#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace dipwright {
namespace {

constexpr int fewestPoints = 8;
constexpr std::size_t batchSize = 32;
// Films of one batch whose fine cells would lie over nearly the same are made alike, so that a
// device that dips alike films together can: sides are moved out to multiples of this share of the
// body's longest edge.
constexpr double alikeShare = 1.0 / 6;

// The same film with so many cells along the body, and never finer than its own.
FilmSettings coarseFilm(FilmSettings film, const TriangleMesh& mesh, double cells) {
    const double own =
        film.resolution == FilmResolution::Points ? film.width.value() / (film.columns - 1) : 0;
    const double spacing = std::max(own, longestEdgeOf(mesh) / cells);
    if (solver::isProductionFilm(film.lattice, film.support)) {
        film.resolution = FilmResolution::Cell;
        film.cell = Millimetres(spacing);
        return film;
    }
    film.resolution = FilmResolution::Points;
    const auto points = [&](Millimetres length) {
        return std::max(int(std::lround(length.value() / spacing)) + 1, fewestPoints);
    };
    film.columns = points(film.width);
    film.rows = points(film.height);
    return film;
}

Eigen::AlignedBox2d roundedOut(const Eigen::AlignedBox2d& box, double step) {
    return {Eigen::Vector2d(((box.min() / step).array().floor() * step).matrix()),
            Eigen::Vector2d(((box.max() / step).array().ceil() * step).matrix())};
}

// Places in the batch, those of alike films one after the other.
std::vector<std::size_t> alikeTogether(const std::vector<solver::DipSetup>& setups) {
    std::vector<std::size_t> order(setups.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    const auto size = [&](std::size_t item) {
        const solver::FilmGrid& film = setups[item].film;
        return std::tie(film.columns, film.rows, film.columnPlaces, film.rowPlaces);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t one, std::size_t other) { return size(one) < size(other); });
    return order;
}

} // namespace

PoseDips::PoseDips(const SearchSubject& subject, const JudgedBody& body,
                   const solver::SolverModule& module, const DipDetail& detail,
                   const Progress& progress)
    : subject_(subject), body_(body), module_(module), cancelSwitch_(progress.cancelSwitch),
      isJobs_(std::isinf(detail.cells)), film_(subject.film), process_(subject.process) {
    const TriangleMesh& mesh = subject.model->mesh;
    if (!isJobs_) {
        film_ = coarseFilm(subject.film, mesh, detail.cells);
    }
    process_.contactTravel = std::max(process_.contactTravel, detail.travel);
    field_ = cachedDistanceField(mesh, std::min(subject.fieldResolution, detail.field), progress);
}

std::vector<std::shared_ptr<const JudgedPose>>
PoseDips::dip(const std::vector<Immersion>& immersions,
              const std::function<void(std::size_t)>& batchDone) const {
    std::vector<std::shared_ptr<const JudgedPose>> judged(immersions.size());
    for (std::size_t begin = 0; begin < immersions.size(); begin += batchSize) {
        const std::size_t end = std::min(begin + batchSize, immersions.size());
        dipBatch(immersions, begin, end, judged);
        batchDone(end);
    }
    return judged;
}

solver::DipSetup PoseDips::setupOf(const PosedBody& body, const Immersion& immersion) const {
    if (isJobs_ || !isGraded(film_)) {
        return dipSetup(body, *field_, immersion, film_, process_);
    }
    const Underside underside = undersideOf(body, process_);
    const Eigen::Vector2d further = Eigen::Vector2d::Constant(drawIn(underside));
    const Eigen::AlignedBox2d wanted(underside.shadow.min() - further,
                                     underside.shadow.max() + further);
    const double step = alikeShare * longestEdgeOf(subject_.model->mesh);
    const solver::FilmGrid grid =
        gradedFilm(film_, roundedOut(wanted, step), 0, film_.cell, immersion.offset);
    return dipSetup(body, *field_, immersion, film_, grid, process_);
}

void PoseDips::dipBatch(const std::vector<Immersion>& immersions, std::size_t begin,
                        std::size_t end,
                        std::vector<std::shared_ptr<const JudgedPose>>& judged) const {
    cancelSwitch_.throwIfCancelled();
    std::vector<std::shared_ptr<const PosedBody>> bodies(end - begin);
    std::vector<solver::DipSetup> setups(end - begin);
    parallelFor(std::size_t(0), setups.size(), [&](std::size_t index) {
        const Immersion& immersion = immersions[begin + index];
        bodies[index] = std::make_shared<const PosedBody>(posedBody(*subject_.model, immersion));
        setups[index] = setupOf(*bodies[index], immersion);
    });
    const std::vector<std::size_t> order = alikeTogether(setups);
    std::vector<solver::BatchItem> items(setups.size());
    for (std::size_t item = 0; item < items.size(); ++item) {
        items[item].setup = std::move(setups[order[item]]);
    }
    simulateDips(items, module_, [this] { return cancelSwitch_.isCancelled(); });
    parallelFor(std::size_t(0), items.size(), [&](std::size_t item) {
        const Immersion& immersion = immersions[begin + order[item]];
        const solver::DipSetup& setup = items[item].setup;
        DippedFilm film = dippedFilm(items[item], immersion);
        JudgedPose pose;
        pose.immersion = immersion;
        if (isStable(film, setup.motion.travel)) {
            pose =
                body_.judged(*layFilm(bodies[order[item]], std::move(film), process_), immersion);
        }
        judged[begin + order[item]] = std::make_shared<const JudgedPose>(std::move(pose));
    });
}

} // namespace dipwright
