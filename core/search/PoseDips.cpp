#include "search/PoseDips.h"

#include "dip/FilmUnderBody.h"
#include "parallel/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

constexpr int coarseField = 64;
constexpr double cellsAlongBody = 20; // of the coarse film, along the longest edge of the box
constexpr double coarseTravel = 0.5;  // cells that the contact line travels in one step
constexpr int fewestPoints = 8;
constexpr std::size_t batchSize = 16;

// The same film with cells as large as the search can do with, and never finer than its own.
FilmSettings coarseFilm(FilmSettings film, const TriangleMesh& mesh) {
    const double own =
        film.resolution == FilmResolution::Points ? film.width.value() / (film.columns - 1) : 0;
    const double spacing = std::max(own, longestEdgeOf(mesh) / cellsAlongBody);
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

} // namespace

PoseDips::PoseDips(const SearchSubject& subject, const JudgedBody& body,
                   const solver::SolverModule& module, Film film, const Progress& progress)
    : subject_(subject), body_(body), module_(module), cancelSwitch_(progress.cancelSwitch),
      film_(film == Film::Own ? subject.film : coarseFilm(subject.film, subject.model->mesh)),
      process_(subject.process) {
    if (film == Film::Coarse) {
        process_.contactTravel = std::max(process_.contactTravel, coarseTravel);
    }
    field_ = cachedDistanceField(
        subject.model->mesh, film == Film::Own ? subject.fieldResolution : coarseField, progress);
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

void PoseDips::dipBatch(const std::vector<Immersion>& immersions, std::size_t begin,
                        std::size_t end,
                        std::vector<std::shared_ptr<const JudgedPose>>& judged) const {
    cancelSwitch_.throwIfCancelled();
    std::vector<std::shared_ptr<const PosedBody>> bodies(end - begin);
    std::vector<solver::BatchItem> items(end - begin);
    parallelFor(begin, end, [&](std::size_t index) {
        const std::size_t item = index - begin;
        bodies[item] =
            std::make_shared<const PosedBody>(posedBody(*subject_.model, immersions[index]));
        items[item].setup = dipSetup(*bodies[item], *field_, immersions[index], film_, process_);
    });
    simulateDips(items, module_, [this] { return cancelSwitch_.isCancelled(); });
    parallelFor(begin, end, [&](std::size_t index) {
        const solver::BatchItem& item = items[index - begin];
        DippedFilm film = dippedFilm(item, immersions[index]);
        if (isStable(film, item.setup.motion.travel)) {
            judged[index] = std::make_shared<const JudgedPose>(body_.judged(
                *layFilm(bodies[index - begin], std::move(film), process_), immersions[index]));
        } else {
            judged[index] =
                std::make_shared<const JudgedPose>(JudgedPose{immersions[index], {}, 0, 0});
        }
    });
}

} // namespace dipwright
