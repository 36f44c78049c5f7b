#include "accuracy/error/NumericalErrorEstimate.h"

#include "base/Error.h"
#include "geometry/FinerFields.h"
#include "parallel/ParallelFor.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Certainty)
};

constexpr double fitSafety = 1.5; // for the slope of a line that is fitted to three films or more
constexpr std::size_t leastFilms = 3, mostFilms = 4; // for a fit
// Films whose cells differ by a smaller share count as one film. If the refinement halved the
// cells, these are the film before it and the film with double cells.
constexpr double sameCell = 0.01;
// The error of the dip's own steps, divided by the move between films with steps of twice and four
// times the length (first order).
constexpr float stepErrorShare = 0.5F;
constexpr int leastCells = 4; // per side; fewer cells give no meaningful comparison

// Doubling the cells also doubles the steps, because the production film's steps are given in
// cells.
FilmSettings withDoubleSpacing(FilmSettings film) {
    film.refinement /= 2;
    return film;
}

ProcessSettings withDoubleTimeStep(ProcessSettings process) {
    process.timeStep = Seconds(2 * process.timeStep.value());
    return process;
}

ProcessSettings withDoubleStep(ProcessSettings process) {
    process.contactTravel *= 2;
    return withDoubleTimeStep(std::move(process));
}

// A film to compare with, and the cell of the dip's own film divided by its cell.
struct ComparedFilm {
    const LaidFilm* laid;
    double inverseCell;
};

// Returns `own` and the films with other cells.
std::vector<ComparedFilm> filmsToFit(const LaidFilm& own, const CoarserFilms& coarser,
                                     const FilmsBefore& before) {
    std::vector<ComparedFilm> films;
    for (const LaidFilm* film :
         {&own, coarser.doubleSpacing.get(), &before.own, before.doubleSpacing}) {
        if (film) {
            const double inverseCell =
                own.film().grid.leastSpacing() / film->film().grid.leastSpacing();
            if (std::ranges::none_of(films, [&](const ComparedFilm& other) {
                    return std::abs(other.inverseCell / inverseCell - 1) < sameCell;
                })) {
                films.push_back({film, inverseCell});
            }
        }
    }
    return films;
}

// Where a film has a place of the body: the place on the flat film times `inverseCell`.
struct FilmSample {
    double inverseCell;
    Eigen::Vector2d scaled;
};

// Fits the place x(h) = x(0) + a h to the samples, weighted by 1 / h², where h is the cell in own
// cells: a line over 1 / h with the intercept a. Returns the error at h = 1 in mm.
double fittedError(const FilmSample* begin, const FilmSample* end) {
    const auto count = double(end - begin);
    double meanInverse = 0;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const FilmSample* sample = begin; sample != end; ++sample) {
        meanInverse += sample->inverseCell / count;
        mean += sample->scaled / count;
    }
    double spread = 0;
    Eigen::Vector2d finest = Eigen::Vector2d::Zero(); // x(0)
    for (const FilmSample* sample = begin; sample != end; ++sample) {
        const double offset = sample->inverseCell - meanInverse;
        spread += offset * offset;
        finest += offset * (sample->scaled - mean);
    }
    finest /= spread;
    const Eigen::Vector2d slope = mean - finest * meanInverse; // a
    double squares = 0;
    for (const FilmSample* sample = begin; sample != end; ++sample) {
        squares += (sample->scaled - finest * sample->inverseCell - slope).squaredNorm();
    }
    const double freedom = 2 * (count - 2); // of two directions
    return fitSafety * slope.norm() + std::sqrt(squares / freedom);
}

// Returns the error of `own` at a place; none if too few of `films` paint the place.
std::optional<float> fittedError(const SurfacePoint& place,
                                 const std::vector<ComparedFilm>& films) {
    std::array<FilmSample, mostFilms> samples;
    std::size_t count = 0;
    for (const ComparedFilm& film : films) {
        if (const std::optional<FilmPlace> found = film.laid->place(place)) {
            samples[count++] = {film.inverseCell, found->rest.cast<double>() * film.inverseCell};
        }
    }
    return count < leastFilms
               ? std::nullopt
               : std::optional(float(fittedError(samples.data(), samples.data() + count)));
}

SheetChange scaled(SheetChange change, double share) {
    Distribution& distance = change.distance;
    for (double* value :
         {&distance.minimum, &distance.mean, &distance.percentile95, &distance.maximum}) {
        *value *= share;
    }
    change.paintedOnce *= share;
    return change;
}

} // namespace

CoarserDips::CoarserDips(PosedDip dip, const DistanceField& field, const FilmSettings& film,
                         const ProcessSettings& process, const Progress& progress)
    : dip_(std::move(dip)), process_(process) {
    const PosedBody& body = *dip_.body;
    const double cell = dipGrid(body, dip_.immersion, film, process).leastSpacing();
    const FilmSettings coarse = withDoubleSpacing(film);
    const ProcessSettings slow = withDoubleTimeStep(process);
    const solver::FilmGrid grid = dipGrid(body, dip_.immersion, coarse, slow);
    if (std::min(grid.columns, grid.rows) <= leastCells) {
        failure_ =
            Text::tr("the film has too few points to be compared with a film of half as many");
        return;
    }
    field_.emplace(body, fieldAtLevel(field, coarserFieldLevel(field, cell), progress));
    for (const ProcessSettings& steps : {slow, withDoubleStep(slow)}) {
        items_.emplace_back().setup = dipSetup(body, *field_, dip_.immersion, coarse, grid, steps);
    }
}

void CoarserDips::simulate(const std::vector<CoarserDips*>& coarser,
                           const solver::SolverModule& module,
                           const std::function<bool()>& isCancelled) {
    std::vector<solver::BatchItem> all;
    for (CoarserDips* dips : coarser) {
        std::move(dips->items_.begin(), dips->items_.end(), std::back_inserter(all));
    }
    QString failure;
    try {
        simulateDips(all, module, isCancelled);
    } catch (const Error& error) {
        failure = error.message();
    }
    auto next = all.begin();
    for (CoarserDips* dips : coarser) {
        const auto end = next + std::ptrdiff_t(dips->items_.size());
        std::move(next, end, dips->items_.begin());
        next = end;
        dips->field_.reset();
        dips->failure_ = dips->failure_.isEmpty() ? failure : dips->failure_;
    }
}

CoarserFilms CoarserDips::laid() const {
    if (!failure_.isEmpty()) {
        return {nullptr, nullptr, failure_};
    }
    const auto lay = [&](const solver::BatchItem& item) -> std::shared_ptr<const LaidFilm> {
        DippedFilm dipped = dippedFilm(item, dip_.immersion);
        if (!isStable(dipped, item.setup.motion.travel) || !dipped.adheresAnywhere()) {
            return nullptr;
        }
        return layFilm(dip_.body, std::move(dipped), process_);
    };
    return {lay(items_[0]), lay(items_[1]), {}};
}

bool NumericalErrorEstimate::isKnown() const {
    return failure.isEmpty() && doubleSpacing.painted > 0 && doubleStep.painted > 0;
}

SheetChange NumericalErrorEstimate::halfSpacing() const {
    return scaled(doubleSpacing, halfSpacingShare);
}

SheetChange NumericalErrorEstimate::halfStep() const {
    return scaled(doubleStep, halfStepShare);
}

NumericalErrorEstimate estimateNumericalError(const LaidFilm& own, const CoarserFilms& coarser,
                                              const std::optional<FilmsBefore>& before) {
    NumericalErrorEstimate estimate;
    estimate.failure = coarser.failure;
    if (!coarser.failure.isEmpty()) {
        return estimate;
    }
    using Places = std::vector<SurfacePoint>;
    const auto moves = [](const LaidFilm* from, const LaidFilm* to, const Places& places) {
        return from && to ? sheetMoves(*from, *to, places)
                          : std::vector<float>(places.size(), -1.0F);
    };
    const auto spacingMoves = [&](const Places& places) {
        return moves(&own, coarser.doubleSpacing.get(), places);
    };
    const auto stepMoves = [&](const Places& places) {
        return moves(coarser.doubleSpacing.get(), coarser.doubleStep.get(), places);
    };
    const auto least = float(leastErrorCells * own.film().grid.leastSpacing());
    const auto films = before ? filmsToFit(own, coarser, *before) : std::vector<ComparedFilm>();
    // The film with the longest steps may not paint a place; its move there is negative.
    const auto errorsOf = [&](const std::vector<float>& spacing, const std::vector<float>& step,
                              const Places& places) {
        std::vector<float> errors = spacing;
        parallelFor(std::size_t(0), places.size(), [&](auto i) {
            if (spacing[i] >= 0) {
                const std::optional<float> fitted = fittedError(places[i], films);
                errors[i] = std::max({fitted.value_or(spacing[i]),
                                      fitted ? stepErrorShare * step[i] : step[i], least});
            }
        });
        return errors;
    };
    const Places places = comparedPlaces(own.body());
    const std::vector<float> spacing = spacingMoves(places), step = stepMoves(places);
    estimate.doubleSpacing = sheetChange(spacing);
    estimate.doubleStep = sheetChange(step);
    estimate.offBy = sheetChange(errorsOf(spacing, step, places)).distance;

    const Places& points = own.contact().surface;
    estimate.pointErrors = errorsOf(spacingMoves(points), stepMoves(points), points);
    for (std::size_t point = 0; point < points.size(); ++point) {
        float& offBy = estimate.pointErrors[point];
        if (offBy < 0) {
            offBy = points[point].isValid() ? std::numeric_limits<float>::quiet_NaN() : 0;
        }
    }
    return estimate;
}

std::vector<float> numericalErrorAt(const NumericalErrorEstimate& estimate, const LaidFilm& own,
                                    const std::vector<SurfacePoint>& places) {
    std::vector<float> offBy(places.size(), 0);
    parallelFor(std::size_t(0), estimate.pointErrors.empty() ? 0 : places.size(), [&](auto i) {
        if (const std::optional<FilmPlace> place = own.place(places[i])) {
            for (const std::uint32_t corner : own.triangles()[place->triangle]) {
                offBy[i] = std::fmax(offBy[i], estimate.pointErrors[corner]); // fmax ignores NaN
            }
        }
    });
    return offBy;
}

} // namespace dipwright
