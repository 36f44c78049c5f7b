#include "search/PoseDips.h"

#include "accuracy/error/NumericalErrorEstimate.h"
#include "accuracy/verdict/FinerFilm.h"
#include "dip/Dip.h"
#include "dip/FilmUnderBody.h"
#include "dip/TankFit.h"
#include "parallel/ParallelFor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace dipwright {
namespace {

constexpr int fewestPoints = 8;
constexpr std::size_t mostInBatch = 32, fewestInBatch = 2;
// A batch of large films is smaller, so that the search reports its progress more often.
constexpr std::size_t pointsInBatch = 100'000;
// The time of one dip is proportional to dipOverhead plus its points to the power of 1.5, times
// jobSteps for the job's shorter steps. Measured on nine models (docs/pose-search.md).
constexpr double dipOverhead = 7.5e4, jobSteps = 1.8;
// Time of a dip with its verdict, relative to the dip alone.
constexpr double withVerdict = 1.4;
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

QString tankFaultsOf(const SearchSubject& subject, const TriangleMesh& posed,
                     const solver::BodyPath& path, const Immersion& immersion) {
    return tankFaults(subject.tank, subject.process, immersion, posed, path)
        .join(QStringLiteral(". "));
}

PoseFilms::PoseFilms(const SearchSubject& subject, const DipDetail& detail)
    : subject_(subject), areJobs_(std::isinf(detail.cells)),
      film_(areJobs_ ? subject.film : coarseFilm(subject.film, subject.model->mesh, detail.cells)) {
}

// Whether the search chooses the films, so that it can make them equal.
bool PoseFilms::areChosen() const {
    return !areJobs_ && isGraded(film_);
}

// Returns the part of the film that needs fine cells.
Eigen::AlignedBox2d PoseFilms::fineCellsOf(const PosedBody& body) const {
    const Underside underside = undersideOf(body, subject_.process);
    const Eigen::Vector2d further = Eigen::Vector2d::Constant(drawIn(underside));
    const Eigen::AlignedBox2d wanted(underside.shadow.min() - further,
                                     underside.shadow.max() + further);
    return roundedOut(wanted, alikeShare * longestEdgeOf(subject_.model->mesh));
}

solver::FilmGrid PoseFilms::gridOf(const PosedBody& body, const Immersion& immersion) const {
    return areChosen()
               ? gradedFilm(film_, fineCellsOf(body), 0, film_.cell, immersion.offset)
               : filmUnderBody(film_, undersideOf(body, subject_.process), immersion.offset);
}

double PoseFilms::cost(const PosedBody& body, const Immersion& immersion) const {
    const auto points = double(gridOf(body, immersion).pointCount());
    return dipOverhead + (areJobs_ ? jobSteps * withVerdict : 1) * std::pow(points, 1.5);
}

PoseDips::PoseDips(const SearchSubject& subject, const JudgedBody& body,
                   const solver::SolverModule& module, const DipDetail& detail,
                   const Progress& progress)
    : subject_(subject), body_(body), module_(module), cancelToken_(progress.cancelToken),
      films_(subject, detail), process_(subject.process) {
    const TriangleMesh& mesh = subject.model->mesh;
    if (films_.areJobs() && !subject.tolerance.marks.empty()) {
        auto zones = std::make_unique<ZonedBody>(subject.model);
        zones->setMarks(subject.tolerance.marks);
        zones_ = std::move(zones);
    }
    process_.contactTravel = std::max(process_.contactTravel, detail.travel);
    field_ = cachedDistanceField(mesh, std::min(subject.fieldResolution, detail.field), progress);
}

void PoseDips::dip(const std::vector<Immersion>& immersions,
                   std::vector<std::shared_ptr<const JudgedPose>>& judged,
                   const std::function<void(std::size_t)>& batchDone, std::size_t first) const {
    const std::vector<std::size_t> order = orderedByFilm(immersions);
    const std::size_t batch = batchSizeFor(immersions);
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        end = std::min(begin + (begin == 0 ? std::min(batch, first) : batch), order.size());
        dipBatch(immersions, {order.begin() + std::ptrdiff_t(begin), end - begin}, judged);
        batchDone(end);
    }
}

std::size_t PoseDips::batchSizeFor(const std::vector<Immersion>& immersions) const {
    if (immersions.empty()) {
        return mostInBatch;
    }
    const PosedBody body =
        posedBody(subject_.model->mesh, immersions.front(), subject_.process, searchedAirCells);
    return std::clamp(pointsInBatch / films_.gridOf(body, immersions.front()).pointCount(),
                      fewestInBatch, mostInBatch);
}

// Returns the immersions' indices, ordered so that equal films follow each other.
std::vector<std::size_t> PoseDips::orderedByFilm(const std::vector<Immersion>& immersions) const {
    std::vector<std::size_t> order(immersions.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    if (!films_.areChosen()) {
        return order;
    }
    std::vector<std::array<double, 6>> films(immersions.size());
    parallelFor(std::size_t(0), films.size(), [&](std::size_t index) {
        const Immersion& immersion = immersions[index];
        const Eigen::AlignedBox2d box = films_.fineCellsOf(
            posedBody(subject_.model->mesh, immersion, subject_.process, searchedAirCells));
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
    return dipSetup(body, field, immersion, films_.film(), films_.gridOf(body, immersion),
                    process_);
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
            posedBody(subject_.model->mesh, immersion, subject_.process, searchedAirCells));
        fields[item].emplace(*bodies[item], *field_);
        items[item].setup = setupOf(*bodies[item], *fields[item], immersion);
    });
    simulateDips(items, module_, [this] { return cancelToken_.isCancelled(); });
    std::vector<std::shared_ptr<const LaidFilm>> laid(items.size());
    std::vector<JudgedPose> poses(items.size());
    parallelFor(std::size_t(0), items.size(), [&](std::size_t item) {
        const Immersion& immersion = immersions[batch[item]];
        const solver::DipSetup& setup = items[item].setup;
        DippedFilm film = dippedFilm(items[item], immersion);
        poses[item].immersion = immersion;
        if (isStable(film, setup.motion.travel)) {
            laid[item] = layFilm(bodies[item], std::move(film), process_);
            poses[item] = body_.judged(*laid[item], immersion);
        }
        poses[item].tankFaults =
            tankFaultsOf(subject_, bodies[item]->mesh, bodies[item]->path, immersion);
    });
    if (films_.areJobs()) {
        addVerdicts(poses, bodies, laid);
    }
    for (std::size_t item = 0; item < items.size(); ++item) {
        judged[batch[item]] = std::make_shared<const JudgedPose>(std::move(poses[item]));
    }
}

// Judges dips as the job would, but for their ink. Films that the job would refine are not refined
// here: the verdict is the one to be expected. `laid` is null for a dip that failed.
void PoseDips::addVerdicts(std::vector<JudgedPose>& poses,
                           const std::vector<std::shared_ptr<const PosedBody>>& bodies,
                           const std::vector<std::shared_ptr<const LaidFilm>>& laid) const {
    std::vector<PosedDip> dips;
    std::vector<std::size_t> places; // of `dips` in `poses`
    for (std::size_t place = 0; place < poses.size(); ++place) {
        if (laid[place]) {
            dips.push_back({bodies[place], poses[place].immersion});
            places.push_back(place);
        } else {
            ReasonList reasons;
            reasons.add({VerdictReason::Kind::Unpainted, Advice::DoNotPrint});
            poses[place].verdict = std::move(reasons).verdict();
        }
    }
    const std::vector<CoarserFilms> coarser =
        coarserFilms(dips, *field_, films_.film(), process_, module_,
                     [this] { return cancelToken_.isCancelled(); });
    for (std::size_t dip = 0; dip < dips.size(); ++dip) {
        const LaidFilm& own = *laid[places[dip]];
        const NumericalErrorEstimate error = estimateNumericalError(own, coarser[dip]);
        const SurfaceMask* mask = subject_.mask.get();
        const Coverage covered = coverage(own, mask);
        poses[places[dip]].verdict = afterRefinement(
            verdict({own, covered, &error, 0, zones_.get(), poses[places[dip]].tankFaults, mask},
                    subject_.tolerance, subject_.verdict),
            own.film(), subject_.film);
    }
}

} // namespace dipwright
