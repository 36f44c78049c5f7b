#include "accuracy/error/NumericalErrorEstimate.h"

#include "base/Error.h"
#include "geometry/FinerFields.h"
#include "parallel/ParallelFor.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Certainty)
};

// Safety factor for an error that is fitted to three or more films (P. J. Roache, Perspective: a
// method for uniform reporting of grid refinement studies, J. Fluids Eng. 116 (1994)).
constexpr double fitSafety = 1.25;
constexpr std::size_t leastFilms = 3; // for a fit with a standard deviation
// The move from double steps to the coarser film's own leaves half of itself at the dip's steps.
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

bool hasLaidFilm(const DippedFilm& film) {
    return std::find(film.states.begin(), film.states.end(), solver::PointState::Adhered) !=
           film.states.end();
}

// The places of one body's point on the flat films, as weighted samples of a line over the cell.
struct FilmSample {
    double cell = 1; // relative to the smallest
    Eigen::Vector2d rest;
};

// Returns where each film with its cell relative to `own` has the place; films that do not paint
// the place are left out.
std::vector<FilmSample> samplesAt(const SurfacePoint& place, const LaidFilm& own,
                                  const std::vector<const LaidFilm*>& films) {
    std::vector<FilmSample> samples;
    const double ownCell = own.film().grid.leastSpacing();
    for (const LaidFilm* film : films) {
        if (const std::optional<FilmPlace> found = film->place(place)) {
            samples.push_back(
                {film->film().grid.leastSpacing() / ownCell, found->rest.cast<double>()});
        }
    }
    return samples;
}

// Returns the error of the sample with the cell 1 by the line that is fitted to all samples, mm.
double fittedError(const std::vector<FilmSample>& samples) {
    double weights = 0, meanCell = 0;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const FilmSample& sample : samples) {
        const double weight = 1 / (sample.cell * sample.cell);
        weights += weight;
        meanCell += weight * sample.cell;
        mean += weight * sample.rest;
    }
    meanCell /= weights;
    mean /= weights;
    double spread = 0;
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();
    for (const FilmSample& sample : samples) {
        const double weight = 1 / (sample.cell * sample.cell), offset = sample.cell - meanCell;
        spread += weight * offset * offset;
        slope += weight * offset * (sample.rest - mean);
    }
    slope /= spread;
    double squares = 0; // of the deviations, relative to the cell
    for (const FilmSample& sample : samples) {
        const Eigen::Vector2d line = mean + slope * (sample.cell - meanCell);
        squares += (sample.rest - line).squaredNorm() / (sample.cell * sample.cell);
    }
    const double directions = 2, freedom = directions * double(samples.size() - 2);
    return fitSafety * slope.norm() + std::sqrt(squares / freedom);
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
        if (!isStable(dipped, item.setup.motion.travel) || !hasLaidFilm(dipped)) {
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
    std::vector<const LaidFilm*> films;
    if (before) {
        for (const LaidFilm* film :
             {&own, coarser.doubleSpacing.get(), &before->own, before->doubleSpacing}) {
            if (film) {
                films.push_back(film);
            }
        }
    }
    const auto errorsOf = [&](const std::vector<float>& spacing, const std::vector<float>& step,
                              const Places& places) {
        std::vector<float> errors = spacing;
        parallelFor(std::size_t(0), places.size(), [&](auto i) {
            if (spacing[i] < 0) {
                return;
            }
            const std::vector<FilmSample> samples = samplesAt(places[i], own, films);
            errors[i] = samples.size() < leastFilms
                            ? std::max(spacing[i], step[i])
                            : std::max(float(fittedError(samples)), stepErrorShare * step[i]);
            errors[i] = std::max(errors[i], least);
        });
        return errors;
    };
    const Places places = comparedPlaces(own.body().mesh);
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
