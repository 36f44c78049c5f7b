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

// Largest factor for the move from a film with slightly larger cells. Such a move is mostly noise:
// the sheet depends on where the grid's points happen to lie (docs/film-validation.md, "The
// verdict").
constexpr double mostLeft = 2;
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

// Returns the larger move of each place. Where the steps were not compared, because the film with
// the longest steps does not paint the place, the move with double cells counts alone.
std::vector<float> largest(std::vector<float> spacing, const std::vector<float>& step) {
    std::transform(spacing.begin(), spacing.end(), step.begin(), spacing.begin(),
                   [](float one, float other) { return one < 0 ? one : std::max(one, other); });
    return spacing;
}

// Returns the error of the film `before` at a place that it paints, in mm. Infinite unless it is
// known at all three corners of the film triangle there.
float errorBefore(const FilmBefore& before, const SurfacePoint& place) {
    const std::optional<FilmPlace> found = before.laid.place(place);
    constexpr float unknown = std::numeric_limits<float>::infinity();
    if (!found || before.error.pointErrors.empty()) {
        return unknown;
    }
    float error = 0;
    for (const std::uint32_t corner : before.laid.triangles()[found->triangle]) {
        const float own = before.error.pointErrors[corner];
        error = std::isnan(own) ? unknown : std::max(error, own);
    }
    return error;
}

// Returns the error that the move from the film before leaves at each place, or what sheetMoves()
// returns for places that are not painted by both.
std::vector<float> errorsLeft(const LaidFilm& own, const FilmBefore& before,
                              const std::vector<SurfacePoint>& places) {
    std::vector<float> left = sheetMoves(own, before.laid, places);
    const auto factor = float(std::min(1 / (before.ratio - 1), mostLeft));
    parallelFor(std::size_t(0), left.size(), [&](auto place) {
        float& move = left[place];
        if (move > 0) {
            move = std::min(factor * move, std::max(move, errorBefore(before, places[place])));
        }
    });
    return left;
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
                                              const std::optional<FilmBefore>& before) {
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
    const auto errorsOf = [&](const std::vector<float>& spacing, const std::vector<float>& step,
                              const Places& places) {
        std::vector<float> errors = largest(spacing, step);
        if (before) {
            errors = largest(std::move(errors), errorsLeft(own, *before, places));
        }
        for (float& error : errors) {
            error = error < 0 ? error : std::max(error, least);
        }
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
