#include "search/PoseDips.h"

#include "dip/Dip.h"
#include "dip/FilmUnderBody.h"
#include "parallel/ParallelFor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace dipwright {
namespace {

constexpr int fewestPoints = 8;
constexpr std::size_t batchSize = 32;
constexpr int searchedAirCells = 48; // number of air grid cells along the body's longest edge
// The borders of the fine cells are moved outwards to multiples of this share of the body's longest
// edge. Many films of a batch then become equal, and a device can simulate their dips together.
constexpr double alikeShare = 1.0 / 6;

// Returns the film with `cells` cells along the body, but never with finer cells than the job's
// film.
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

} // namespace

PoseDips::PoseDips(const SearchSubject& subject, const JudgedBody& body,
                   const solver::SolverModule& module, const DipDetail& detail,
                   const Progress& progress)
    : subject_(subject), body_(body), module_(module), cancelToken_(progress.cancelToken),
      isJobs_(std::isinf(detail.cells)), film_(subject.film), process_(subject.process) {
    const TriangleMesh& mesh = subject.model->mesh;
    if (!isJobs_) {
        film_ = coarseFilm(subject.film, mesh, detail.cells);
    }
    process_.contactTravel = std::max(process_.contactTravel, detail.travel);
    field_ = cachedDistanceField(mesh, std::min(subject.fieldResolution, detail.field), progress);
}

void PoseDips::dip(const std::vector<Immersion>& immersions,
                   std::vector<std::shared_ptr<const JudgedPose>>& judged,
                   const std::function<void(std::size_t)>& batchDone) const {
    const std::vector<std::size_t> order = orderedByFilm(immersions);
    for (std::size_t begin = 0; begin < order.size(); begin += batchSize) {
        const std::size_t end = std::min(begin + batchSize, order.size());
        dipBatch(immersions, {order.begin() + std::ptrdiff_t(begin), end - begin}, judged);
        batchDone(end);
    }
}

// Whether the search chooses the films, so that it can make them equal.
bool PoseDips::choosesFilms() const {
    return !isJobs_ && isGraded(film_);
}

// Returns the part of the film that needs fine cells.
Eigen::AlignedBox2d PoseDips::fineCellsOf(const PosedBody& body) const {
    const Underside underside = undersideOf(body, process_);
    const Eigen::Vector2d further = Eigen::Vector2d::Constant(drawIn(underside));
    const Eigen::AlignedBox2d wanted(underside.shadow.min() - further,
                                     underside.shadow.max() + further);
    return roundedOut(wanted, alikeShare * longestEdgeOf(subject_.model->mesh));
}

// Returns the immersions' indices, ordered so that equal films follow each other.
std::vector<std::size_t> PoseDips::orderedByFilm(const std::vector<Immersion>& immersions) const {
    std::vector<std::size_t> order(immersions.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    if (!choosesFilms()) {
        return order;
    }
    std::vector<std::array<double, 6>> films(immersions.size());
    parallelFor(std::size_t(0), films.size(), [&](std::size_t index) {
        const Immersion& immersion = immersions[index];
        const Eigen::AlignedBox2d box =
            fineCellsOf(posedBody(subject_.model->mesh, immersion, searchedAirCells));
        films[index] = {box.min().x(),
                        box.min().y(),
                        box.max().x(),
                        box.max().y(),
                        immersion.offset[0].value(),
                        immersion.offset[1].value()};
    });
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t one, std::size_t other) { return films[one] < films[other]; });
    return order;
}

solver::DipSetup PoseDips::setupOf(const PosedBody& body, const FilledField& field,
                                   const Immersion& immersion) const {
    if (!choosesFilms()) {
        return dipSetup(body, field, immersion, film_, process_);
    }
    const solver::FilmGrid grid =
        gradedFilm(film_, fineCellsOf(body), 0, film_.cell, immersion.offset);
    return dipSetup(body, field, immersion, film_, grid, process_);
}

void PoseDips::dipBatch(const std::vector<Immersion>& immersions,
                        std::span<const std::size_t> batch,
                        std::vector<std::shared_ptr<const JudgedPose>>& judged) const {
    cancelToken_.throwIfCancelled();
    std::vector<std::shared_ptr<const PosedBody>> bodies(batch.size());
    std::vector<std::optional<FilledField>> fields(batch.size());
    std::vector<solver::BatchItem> items(batch.size());
    parallelFor(std::size_t(0), items.size(), [&](std::size_t item) {
        const Immersion& immersion = immersions[batch[item]];
        bodies[item] = std::make_shared<const PosedBody>(
            posedBody(subject_.model->mesh, immersion, searchedAirCells));
        fields[item].emplace(*bodies[item], *field_);
        items[item].setup = setupOf(*bodies[item], *fields[item], immersion);
    });
    simulateDips(items, module_, [this] { return cancelToken_.isCancelled(); });
    parallelFor(std::size_t(0), items.size(), [&](std::size_t item) {
        const Immersion& immersion = immersions[batch[item]];
        const solver::DipSetup& setup = items[item].setup;
        DippedFilm film = dippedFilm(items[item], immersion);
        JudgedPose pose;
        pose.immersion = immersion;
        if (isStable(film, setup.motion.travel)) {
            pose = body_.judged(*layFilm(bodies[item], std::move(film), process_), immersion);
        }
        judged[batch[item]] = std::make_shared<const JudgedPose>(std::move(pose));
    });
}

} // namespace dipwright
