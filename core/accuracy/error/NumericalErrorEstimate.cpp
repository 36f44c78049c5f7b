#include "accuracy/error/NumericalErrorEstimate.h"

#include "base/Error.h"
#include "parallel/ParallelFor.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Certainty)
};

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

void throwIf(bool isCancelled) {
    if (isCancelled) {
        throw Cancelled();
    }
}

float largest(float a, float b) {
    return a < 0 || b < 0 ? std::min(a, b) : std::max(a, b);
}

std::vector<float> largest(std::vector<float> a, const std::vector<float>& b) {
    std::transform(a.begin(), a.end(), b.begin(), a.begin(),
                   [](float one, float other) { return largest(one, other); });
    return a;
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

CoarserFilms coarserFilms(const std::shared_ptr<const PosedBody>& body, const DistanceField& field,
                          const Immersion& immersion, const FilmSettings& film,
                          const ProcessSettings& process, const solver::SolverModule& module,
                          const std::function<bool()>& isCancelled) {
    const FilledField filled(*body, field);
    CoarserFilms coarser;
    std::vector<solver::BatchItem> dips(2);
    dips[0].setup =
        dipSetup(*body, filled, immersion, withDoubleSpacing(film), withDoubleTimeStep(process));
    if (std::min(dips[0].setup.film.columns, dips[0].setup.film.rows) <= leastCells) {
        coarser.failure =
            Text::tr("the film has too few points to be compared with a film of half as many");
        return coarser;
    }
    dips[1].setup = dipSetup(*body, filled, immersion, film, withDoubleStep(process));
    try {
        simulateDips(dips, module, isCancelled);
    } catch (const Error& error) {
        coarser.failure = error.message();
        return coarser;
    }
    std::vector<std::shared_ptr<const LaidFilm>> laid;
    for (const solver::BatchItem& dip : dips) {
        DippedFilm dipped = dippedFilm(dip, immersion);
        if (!isStable(dipped, dip.setup.motion.travel) || !hasLaidFilm(dipped)) {
            coarser.failure = Text::tr("the film with coarser cells does not follow the part");
            return coarser;
        }
        laid.push_back(layFilm(body, std::move(dipped), process));
        throwIf(isCancelled());
    }
    coarser.doubleSpacing = laid[0];
    coarser.doubleStep = laid[1];
    return coarser;
}

SheetChange NumericalErrorEstimate::halfSpacing() const {
    return scaled(doubleSpacing, halfSpacingShare);
}

SheetChange NumericalErrorEstimate::halfStep() const {
    return scaled(doubleStep, halfStepShare);
}

NumericalErrorEstimate estimateNumericalError(const LaidFilm& own, const CoarserFilms& coarser) {
    NumericalErrorEstimate estimate;
    estimate.failure = coarser.failure;
    if (!coarser.failure.isEmpty()) {
        return estimate;
    }
    const std::vector<SurfacePoint> places = comparedPlaces(own.body().mesh);
    const std::vector<float> spacing = sheetMoves(own, *coarser.doubleSpacing, places);
    const std::vector<float> step = sheetMoves(own, *coarser.doubleStep, places);
    estimate.doubleSpacing = sheetChange(spacing);
    estimate.doubleStep = sheetChange(step);
    estimate.offBy = sheetChange(largest(spacing, step)).distance;

    const std::vector<SurfacePoint>& points = own.contact().surface;
    estimate.pointErrors = largest(sheetMoves(own, *coarser.doubleSpacing, points),
                                   sheetMoves(own, *coarser.doubleStep, points));
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
