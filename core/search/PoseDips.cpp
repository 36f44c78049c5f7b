#include "search/PoseDips.h"

#include "accuracy/verdict/FinerFilm.h"
#include "base/Error.h"
#include "dip/AirPockets.h"
#include "dip/Dip.h"
#include "dip/FilmUnderBody.h"
#include "dip/TankFit.h"
#include "film/FilmGrid.h"
#include "geometry/FinerFields.h"
#include "parallel/ParallelFor.h"
#include "parallel/Tasks.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <new>
#include <utility>

namespace dipwright {
namespace {

constexpr int fewestPoints = 8;
constexpr std::size_t mostInBatch = 32, fewestInBatch = 2;
// A batch of large films is smaller, so that the search reports its progress more often.
constexpr std::size_t pointsInBatch = 100'000;
// The time of a coarse dip is proportional to dipOverhead plus its points to the power of 1.5.
// Measured on nine models (docs/pose-search.md).
constexpr double dipOverhead = 7.5e4;
// The time of the job's dip is longer by two factors: the ratio of the numbers of steps to the
// power of stepsPower (twice as many steps take 1.8 times as long), and withVerdict.
constexpr double stepsPower = 0.85, withVerdict = 1.4;

// The borders of the fine cells are moved outwards to multiples of this share of the body's longest
// edge. So most poses that are tilted in refinement get the same film, and are compared by the body
// alone.
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

FilmSettings refinedFilm(FilmSettings film, double refinement) {
    film.refinement *= refinement;
    return film;
}

// Returns the refinement of a film that follows `before`; 1 if there is none.
double refinementAfter(const JobFilms* before) {
    return before ? *before->next : 1;
}

// Returns a dip whose film will not be refined further.
std::shared_ptr<const JudgedPose> withoutRefinement(JudgedPose dip) {
    JobFilms films = *dip.films;
    films.next.reset();
    dip.verdict = films.verdict;
    dip.films = std::make_shared<const JobFilms>(std::move(films));
    return std::make_shared<const JudgedPose>(std::move(dip));
}

// Returns the refined dip of `before`; null if it tells less than `before`.
std::shared_ptr<const JudgedPose> usableRefinement(const JudgedPose& before, JudgedPose refined) {
    const JobFilms* films = refined.films.get();
    if (!films || !films->coarser->failure.isEmpty() ||
        (before.films->error->isKnown() && !films->error->isKnown())) {
        return nullptr;
    }
    refined.predicted = before.predicted;
    refined.doublings = before.doublings;
    return std::make_shared<const JudgedPose>(std::move(refined));
}

// Whether the sheet cannot be printed, and the job would not repeat the dip.
bool isFinallyRefused(const std::shared_ptr<const JudgedPose>& dip) {
    return !dip->isRepeated() && dip->verdict.advice > Advice::Print;
}

// Calls `work` and returns the exception that it throws; null if it throws none.
std::exception_ptr failureOf(const std::function<void()>& work) {
    try {
        work();
    } catch (...) {
        return std::current_exception();
    }
    return nullptr;
}

} // namespace

std::vector<TankFault> tankFaultsOf(const SearchSubject& subject, const TriangleMesh& posed,
                                    const solver::BodyPath& path, const Immersion& immersion) {
    return tankFaults(subject.tank, subject.film, subject.process, immersion, posed, path);
}

PoseFilms::PoseFilms(const SearchSubject& subject, const DipDetail& detail)
    : subject_(subject), areJobs_(std::isinf(detail.cells)),
      film_(areJobs_ ? subject.film : coarseFilm(subject.film, subject.model->mesh, detail.cells)) {
    if (!areJobs_ && isGraded(film_)) {
        query_ = std::make_unique<const SurfaceQuery>(subject.model->mesh);
    }
}

PosedBody PoseFilms::posed(const Immersion& immersion) const {
    return posedBody(subject_.model->mesh, immersion, subject_.process,
                     areJobs_ ? airCells : searchedAirCells);
}

solver::FilmGrid PoseFilms::gridOf(const PosedBody& body, const Immersion& immersion,
                                   double refinement) const {
    return query_ ? gradedGrid(immersion)
                  : filmUnderBody(refinedFilm(film_, refinement),
                                  undersideOf(body, subject_.process), immersion.offset);
}

solver::FilmGrid PoseFilms::gradedGrid(const Immersion& immersion) const {
    const TriangleMesh& mesh = subject_.model->mesh;
    const Underside underside = undersideOf(mesh, *query_, immersion, subject_.process);
    const Eigen::Vector2d further = Eigen::Vector2d::Constant(drawIn(underside));
    const Eigen::AlignedBox2d needed(underside.shadow.min() - further,
                                     underside.shadow.max() + further);
    return gradedFilm(film_, roundedOut(needed, alikeShare * longestEdgeOf(mesh)), 0, film_.cell,
                      immersion.offset);
}

std::size_t PoseFilms::pointsFor(const Immersion& immersion) const {
    return query_ ? gradedGrid(immersion).pointCount()
                  : gridOf(posed(immersion), immersion).pointCount();
}

double PoseFilms::cost(const PosedBody& body, const Immersion& immersion) const {
    const auto points = double(gridOf(body, immersion).pointCount());
    const double travel = subject_.process.contactTravel;
    const double steps = std::max(travel, coarseDetail.travel) / travel;
    return dipOverhead +
           (areJobs_ ? withVerdict * std::pow(steps, stepsPower) : 1) * std::pow(points, 1.5);
}

double PoseFilms::cellUnder(const PosedBody& body) const {
    if (!isGraded(film_)) {
        return filmGrid(film_).leastSpacing();
    }
    return film_.resolution == FilmResolution::Cell
               ? film_.cell.value()
               : automaticCell(undersideOf(body, subject_.process), film_).value();
}

int fieldResolution(const SearchSubject& subject, const DipDetail& detail) {
    return std::min(subject.fieldResolution, detail.field);
}

PoseDips::PoseDips(const SearchSubject& subject, const JudgedBody& body,
                   const solver::SolverModule& module, const DipDetail& detail,
                   std::shared_ptr<const DistanceField> field, const CancelToken& cancelToken)
    : subject_(subject), body_(body), module_(module), cancelToken_(cancelToken),
      films_(subject, detail), process_(subject.process), residual_(detail.residual),
      field_(std::move(field)) {
    if (detail.predicts) {
        jobFilms_ = std::make_unique<const PoseFilms>(subject, jobDetail);
    }
    process_.contactTravel = std::max(process_.contactTravel, detail.travel);
}

void PoseDips::dip(const std::vector<Immersion>& immersions,
                   std::vector<std::shared_ptr<const JudgedPose>>& judged,
                   const std::function<void(std::size_t)>& batchDone, std::size_t first) const {
    const std::vector<Range> all = batches(immersions, first);
    std::size_t done = 0;
    Batch before, present, next; // `before` is simulated, but not judged
    const auto finish = [&](Batch& batch) {
        judge(immersions, batch, judged);
        done += batch.items.size();
        batch = {};
    };
    for (std::size_t number = 0; number < all.size(); ++number) {
        if (number == 0) {
            cancelToken_.throwIfCancelled();
            present = setUp(immersions, all.front());
        }
        Tasks aside;
        aside.run([&] { finish(before); });
        if (number + 1 < all.size() && !cancelToken_.isCancelled()) {
            aside.run([&] { next = setUp(immersions, all[number + 1]); });
        }
        const std::exception_ptr ofSolver = failureOf([&] {
            cancelToken_.throwIfCancelled();
            simulate(immersions, present);
        });
        const std::exception_ptr ofOthers = failureOf([&] { aside.wait(); });
        if (ofSolver || ofOthers) {
            failureOf([&] { // a failure here must not hide the first
                finish(before);
                if (!ofSolver) {
                    finish(present);
                }
            });
            std::rethrow_exception(ofSolver ? ofSolver : ofOthers);
        }
        before = std::exchange(present, std::exchange(next, {}));
        if (number == 0 || number + 1 == all.size()) { // the first results are wanted early
            finish(before);
        }
        batchDone(done);
    }
}

std::vector<PoseDips::Range> PoseDips::batches(const std::vector<Immersion>& immersions,
                                               std::size_t first) const {
    std::vector<Range> batches;
    if (immersions.empty()) {
        return batches;
    }
    const std::size_t most = std::clamp(pointsInBatch / films_.pointsFor(immersions.front()),
                                        fewestInBatch, mostInBatch);
    for (std::size_t begin = 0, size = std::min(most, first); begin < immersions.size();
         begin += size, size = most) {
        batches.push_back({begin, std::min(begin + size, immersions.size())});
    }
    return batches;
}

PoseDips::Batch PoseDips::setUp(const std::vector<Immersion>& immersions, Range range,
                                std::vector<const JobFilms*> before) const {
    Batch batch;
    batch.first = range.first;
    const std::size_t count = range.last - range.first;
    batch.before = std::move(before);
    batch.before.resize(count, nullptr);
    batch.bodies.resize(count);
    batch.fields.resize(count);
    batch.items.resize(count);
    batch.coarser.resize(count);
    std::vector<solver::FilmGrid> grids(count);
    parallelFor(std::size_t(0), count, [&](std::size_t item) {
        const Immersion& immersion = immersions[range.first + item];
        batch.bodies[item] = std::make_shared<const PosedBody>(films_.posed(immersion));
        grids[item] =
            films_.gridOf(*batch.bodies[item], immersion, refinementAfter(batch.before[item]));
    });
    buildFields(grids);
    parallelFor(std::size_t(0), count, [&](std::size_t item) {
        const Immersion& immersion = immersions[range.first + item];
        const PosedBody& body = *batch.bodies[item];
        const FilmSettings film = refinedFilm(films_.film(), refinementAfter(batch.before[item]));
        batch.fields[item].emplace(
            body, fieldForFilm(*field_, grids[item], Progress{nullptr, cancelToken_}));
        batch.items[item].setup =
            dipSetup(body, *batch.fields[item], immersion, film, grids[item], process_);
        batch.items[item].setup.settings.residual = residual_;
        if (films_.areJobs()) {
            batch.coarser[item] =
                std::make_unique<CoarserDips>(PosedDip{batch.bodies[item], immersion}, *field_,
                                              film, process_, Progress{nullptr, cancelToken_});
        }
    });
    return batch;
}

// Builds the distance fields for these films. All cores build each field; in a parallel loop, other
// threads would wait for it.
void PoseDips::buildFields(const std::vector<solver::FilmGrid>& grids) const {
    const Progress progress{nullptr, cancelToken_};
    for (const solver::FilmGrid& grid : grids) {
        fieldForFilm(*field_, grid, progress);
        if (films_.areJobs()) {
            fieldAtLevel(*field_, coarserFieldLevel(*field_, grid.leastSpacing()), progress);
        }
    }
}

// A dip that failed gets no coarser dips, which could fail in the solver and with them the coarser
// dips of the whole batch.
void PoseDips::simulate(const std::vector<Immersion>& immersions, Batch& batch) const {
    const auto isCancelled = [this] { return cancelToken_.isCancelled(); };
    simulateDips(batch.items, module_, isCancelled);
    batch.fields.clear(); // only the solver needs them; a batch that waits to be judged is smaller
    std::vector<CoarserDips*> coarser;
    for (std::size_t item = 0; item < batch.items.size(); ++item) {
        const solver::BatchItem& dip = batch.items[item];
        if (batch.coarser[item] &&
            isStable(dippedFilm(dip, immersions[batch.first + item]), dip.setup.motion.travel)) {
            coarser.push_back(batch.coarser[item].get());
        }
    }
    CoarserDips::simulate(coarser, module_, isCancelled);
}

void PoseDips::judge(const std::vector<Immersion>& immersions, Batch& batch,
                     std::vector<std::shared_ptr<const JudgedPose>>& judged) const {
    parallelFor(std::size_t(0), batch.items.size(), [&](std::size_t item) {
        const std::size_t place = batch.first + item;
        judged[place] =
            std::make_shared<const JudgedPose>(judgedDip(batch, item, immersions[place]));
    });
}

JudgedPose PoseDips::judgedDip(Batch& batch, std::size_t item, const Immersion& immersion) const {
    const std::shared_ptr<const PosedBody>& body = batch.bodies[item];
    DippedFilm film = dippedFilm(batch.items[item], immersion);
    JudgedPose pose;
    pose.immersion = immersion;
    std::shared_ptr<const LaidFilm> laid; // null if the dip failed
    if (isStable(film, batch.items[item].setup.motion.travel) &&
        (!films_.areJobs() || isAccepted(film, *body, immersion, subject_.film, process_))) {
        laid = layFilm(body, std::move(film), process_);
        pose = body_.judged(*laid, immersion);
    }
    pose.tankFaults = tankFaultsOf(subject_, body->mesh, body->path, immersion);
    if (laid && films_.areJobs()) {
        judgeAsJob(pose, std::move(laid), batch.coarser[item]->laid(), batch.before[item]);
    } else if (laid && jobFilms_) {
        pose.jobCell = jobFilms_->cellUnder(*body);
        pose.verdict =
            verdictOf(*laid, coverage(*laid, subject_.mask.get()), nullptr, pose.tankFaults);
    } else if (!laid) {
        ReasonList reasons;
        reasons.add({VerdictReason::Kind::Unpainted, Advice::DoNotPrint});
        pose.verdict = std::move(reasons).verdict();
    }
    return pose;
}

void PoseDips::judgeAsJob(JudgedPose& pose, std::shared_ptr<const LaidFilm> laid,
                          CoarserFilms coarser, const JobFilms* before) const {
    const DippedFilm& film = laid->film();
    std::optional<FilmsBefore> filmsBefore;
    if (before) {
        filmsBefore.emplace(FilmsBefore{*before->own, before->coarser->doubleSpacing.get()});
    }
    const auto error = std::make_shared<const NumericalErrorEstimate>(
        estimateNumericalError(*laid, coarser, filmsBefore));
    JobFilms films;
    films.refinement = refinementAfter(before);
    const Coverage covered = coverage(*laid, subject_.mask.get(), subject_.process.overhang);
    films.verdict = verdictOf(*laid, covered, error.get(), pose.tankFaults);
    films.tornBareShare = covered.tornBareShare();
    if (error->failure.isEmpty()) {
        films.next = nextRefinement(films.verdict, film, error->offBy.percentile95,
                                    films.refinement, subject_.film);
    }
    pose.pale = body_.pale(*laid);
    pose.verdict = films.verdict;
    if (error->isKnown()) { // otherwise nobody knows what refinement would gain
        pose.verdict = afterRefinement(std::move(pose.verdict), film, subject_.film);
        pose.doublings = neededDoublings(pose.verdict, film);
    }
    films.own = std::move(laid);
    films.coarser = std::make_shared<const CoarserFilms>(std::move(coarser));
    films.error = error;
    pose.films = std::make_shared<const JobFilms>(std::move(films));
}

std::vector<std::shared_ptr<const JudgedPose>>
PoseDips::withFinalFilms(std::vector<std::shared_ptr<const JudgedPose>> dips,
                         const std::function<void()>& roundDone) const {
    for (;;) {
        std::vector<std::shared_ptr<const JudgedPose>> open;
        std::copy_if(dips.begin(), dips.end(), std::back_inserter(open),
                     [](const auto& dip) { return dip->isRepeated(); });
        if (open.empty()) {
            return dips;
        }
        const std::vector<std::shared_ptr<const JudgedPose>> finer = refined(open);
        for (std::size_t each = 0; each < open.size(); ++each) {
            std::replace(dips.begin(), dips.end(), open[each],
                         finer[each] ? finer[each] : withoutRefinement(*open[each]));
        }
        roundDone();
        if (std::any_of(dips.begin(), dips.end(), isFinallyRefused)) {
            return dips;
        }
    }
}

std::vector<std::shared_ptr<const JudgedPose>>
PoseDips::refined(const std::vector<std::shared_ptr<const JudgedPose>>& dips) const {
    std::vector<std::shared_ptr<const JudgedPose>> result(dips.size());
    std::vector<Immersion> immersions;
    std::vector<const JobFilms*> before;
    for (const std::shared_ptr<const JudgedPose>& dip : dips) {
        immersions.push_back(dip->immersion);
        before.push_back(dip->films.get());
    }
    try {
        Batch batch = setUp(immersions, {0, dips.size()}, std::move(before));
        simulate(immersions, batch);
        judge(immersions, batch, result);
    } catch (const Error&) {
        return refinedAlone(dips);
    } catch (const std::bad_alloc&) {
        return refinedAlone(dips);
    }
    for (std::size_t each = 0; each < dips.size(); ++each) {
        result[each] = usableRefinement(*dips[each], *result[each]);
    }
    return result;
}

std::vector<std::shared_ptr<const JudgedPose>>
PoseDips::refinedAlone(const std::vector<std::shared_ptr<const JudgedPose>>& dips) const {
    std::vector<std::shared_ptr<const JudgedPose>> result(dips.size());
    for (std::size_t each = 0; each < dips.size() && dips.size() > 1; ++each) {
        result[each] = refined({dips[each]}).front();
    }
    return result;
}

// Judges a dip as the job would, but for its ink and torn film. Without an estimate of the
// numerical error, the other reasons alone count.
Verdict PoseDips::verdictOf(const LaidFilm& laid, const Coverage& covered,
                            const NumericalErrorEstimate* error,
                            const std::vector<TankFault>& tankFaults) const {
    return verdict({laid, covered, error, 0, body_.surface(subject_.mask.get()), tankFaults},
                   subject_.tolerance, subject_.verdict);
}

} // namespace dipwright
