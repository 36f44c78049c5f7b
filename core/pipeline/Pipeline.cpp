#include "pipeline/Pipeline.h"

#include "accuracy/correction/SheetCorrection.h"
#include "artwork/EditArtwork.h"
#include "artwork/PaintArtwork.h"
#include "base/ColourNote.h"
#include "base/Error.h"
#include "base/WideGamut.h"
#include "film/FilmGrid.h"
#include "marks/SurfaceMask.h"
#include "model/TextureNotes.h"
#include "parallel/Tasks.h"
#include "pipeline/FilmRefinement.h"
#include "pipeline/JobCradles.h"
#include "pipeline/JobSheet.h"
#include "pipeline/JobTolerances.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/LawChanges.h"
#include "pipeline/ModelNotes.h"
#include "pipeline/PrintedBody.h"
#include "pipeline/SheetMemory.h"
#include "pipeline/SolverChoice.h"
#include "project/DipKeys.h"
#include "project/Profiles.h"
#include "results/Results.h"
#include "sheet/page/SheetLayout.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/Separation.h"
#include "texture/Chessboard.h"
#include "texture/StretchPlane.h"

#include <QCoreApplication>
#include <QScopeGuard>

#include <algorithm>
#include <new>
#include <utility>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

// Progress at which each step begins or ends, as a fraction of the job's time. Measured roughly on
// a film of 120 × 170 points.
constexpr double fieldDone = 0.1;
constexpr double lawsBegin = 0.3;        // if laws are varied
constexpr double tolerancesBegin = 0.15; // if tolerances are computed
constexpr double cradlesBegin = 0.6;
constexpr double dipsDone = 0.7; // as a fraction of the time after the field
// Share of the time for an immersion's dips that the first dip takes, if its film may be refined.
constexpr double firstDip = 0.3;
constexpr double sharesDone = 0.75;
constexpr double proofDone = 0.97;
constexpr double draftTolerance = 1; // of a draft's texture, pixels
// Pixels along the side of one view.
constexpr double proofTile = 640;
constexpr int coverageTile = 560;
constexpr double picturesDone = 0.8;

// The context that all steps of one run share.
struct Run {
    const Project& project;
    const SolverRegistry& registry;
    const JobOptions& options;
    const JobResult* previous; // may be null
    CancelToken user;
    std::shared_ptr<const ZonedBody> zones;       // null: no zones are marked
    std::shared_ptr<const SurfaceMask> mask;      // null: nothing is masked
    std::shared_ptr<const SeparateBodies> bodies; // null: one body
    // For each immersion, whether this run has refined its film, so that nothing made from the
    // earlier film is taken over.
    std::vector<char> isRefined = {};
    // Whether all dips are taken over from a solver that is not the one chosen here. None is then
    // refined, so that no result mixes solvers.
    bool isDippedElsewhere = false;

    JudgedSurface surface() const { return {zones.get(), mask.get(), bodies.get()}; }
    const ImmersionResult* earlier(std::size_t number) const {
        return previous && number < previous->immersions.size() && !isRefined[number]
                   ? &previous->immersions[number]
                   : nullptr;
    }
    // The earlier sheet of an immersion. If dips share the body, it depends on all films.
    const ImmersionResult* earlierSheet(std::size_t number, const TextureInputs& inputs) const {
        return inputs.share && !earlierTogether() ? nullptr : earlier(number);
    }
    // The earlier result, from which the parts that depend on all films are reused. Null if a film
    // has been refined.
    const JobResult* earlierTogether() const {
        return std::count(isRefined.begin(), isRefined.end(), true) > 0 ? nullptr : previous;
    }
};

// Tells whether the earlier film can be taken over. A film that was refined for other limits
// cannot.
bool hasDipped(const ImmersionResult* earlier, const DipInputs& inputs) {
    return earlier &&
           (earlier->inputs.texture.dip == inputs ||
            (earlier->refinement == 1 && beginAlike(earlier->inputs.texture.dip, inputs)));
}

// Tells whether the film is refined as far as its settings allow.
bool refines(const Run& run, const DipInputs& inputs) {
    return inputs.refinement && run.options.refines;
}

// Tells whether the numerical error has to be estimated from coarser dips.
bool isToBeJudged(const Run& run, const ImmersionResult* earlier, const DipInputs& inputs) {
    return (run.options.estimatesNumericalError || refines(run, inputs)) &&
           !(hasDipped(earlier, inputs) && earlier->numericalError);
}

// Tells whether the earlier result has all dips of the project as the solver chosen then simulated
// them, and nothing else is wanted that has to be simulated: the wanted solver may stand for
// another one here than on the computer where the dips were simulated.
bool hasAllDips(const Run& run, const QString& wantedSolver) {
    const JobResult* previous = run.previous;
    if (!previous || previous->wantedSolver != wantedSolver ||
        previous->immersions.size() != run.project.immersions.size() || run.options.variesLaws ||
        run.options.computesTolerances) {
        return false;
    }
    for (std::size_t number = 0; number < previous->immersions.size(); ++number) {
        const ImmersionResult& earlier = previous->immersions[number];
        const DipInputs wanted = dipInputs(run.project, number, previous->chosenSolver);
        const bool isFineEnough =
            !refines(run, wanted) || earlier.inputs.texture.dip.refinement == wanted.refinement;
        if (!isFineEnough || !hasDipped(&earlier, wanted) || isToBeJudged(run, &earlier, wanted)) {
            return false;
        }
    }
    return true;
}

// Chooses the solver. If it is another one than the earlier result's, or is missing, but the
// earlier result has all dips, these stay, and nothing is simulated.
SolverChoice solverOf(Run& run, const QString& wanted) {
    const bool hasAll = hasAllDips(run, wanted);
    try {
        SolverChoice choice = chooseSolver(wanted, run.registry, run.user);
        if (!hasAll || choice.solver.id == run.previous->chosenSolver) {
            return choice;
        }
    } catch (const Error&) {
        if (!hasAll) {
            throw;
        }
    }
    run.isDippedElsewhere = true;
    return {run.previous->immersions.front().solver, {}, run.user};
}

// Returns the body's distance field; null if no dip needs it and the earlier result has none.
std::shared_ptr<const DistanceField> fieldOf(const Run& run, const std::vector<SheetInputs>& inputs,
                                             const Progress& progress) {
    const FieldInputs wanted = fieldInputs(run.project);
    if (run.previous && run.previous->field && run.previous->fieldInputs == wanted) {
        return run.previous->field;
    }
    for (std::size_t number = 0; number < inputs.size(); ++number) {
        const ImmersionResult* earlier = run.earlier(number);
        const DipInputs& dip = inputs[number].texture.dip;
        if (!hasDipped(earlier, dip) || isToBeJudged(run, earlier, dip)) {
            return cachedDistanceField(wanted.model->mesh, wanted.resolution, progress);
        }
    }
    return nullptr;
}

// Returns the model with its artwork.
std::shared_ptr<const TexturedMesh> paintedOf(const Run& run, const PaintInputs& inputs,
                                              const Progress& progress) {
    if (run.previous && run.previous->painted && run.previous->paintInputs == inputs) {
        return run.previous->painted;
    }
    return painted(inputs.model, inputs.artwork.inColours(), texelFor(run.project.sheet.resolution),
                   progress);
}

std::shared_ptr<const PosedBody> bodyOf(const Run& run, std::size_t number,
                                        const BodyInputs& inputs) {
    const ImmersionResult* earlier = run.earlier(number);
    if (earlier && earlier->inputs.texture.dip.body == inputs) {
        return earlier->body;
    }
    return std::make_shared<const PosedBody>(
        posedBody(inputs.model->mesh, run.project.immersions[number], run.project.process));
}

// Simulates the dip and fills in the laid film.
void dip(ImmersionResult& result, const Run& run, std::size_t number, const DistanceField& field,
         SolverChoice& solver, const Progress& progress) {
    FilmObserver observer;
    if (run.options.observer) {
        observer = [&](const FilmFrame& frame) { run.options.observer(number, frame); };
    }
    DippedFilm film = withFallback(solver, run.registry, [&](const solver::SolverModule& module) {
        return simulateDip(*result.body, field, result.immersion, filmOf(result, run.project),
                           run.project.process, module, progress, observer);
    });
    result.solver = solver.solver;
    result.solverNotes = std::exchange(solver.notes, {});
    progress(1, Text::tr("Locating the film on the part"));
    result.laid = layFilm(result.body, std::move(film), run.project.process);
}

// Measures coverage and read-back error of a newly dipped or cached film. If only the body's
// appearance has changed, measures the read-back error alone.
void measure(ImmersionResult& result, const ImmersionResult* earlier, const Run& run) {
    const bool isLaidAnew = !result.coverage;
    const bool isMaskedAnew =
        earlier && earlier->inputs.texture.masks != result.inputs.texture.masks;
    run.user.throwIfCancelled();
    if (isLaidAnew || isMaskedAnew) {
        result.coverage = std::make_shared<const Coverage>(
            coverage(*result.laid, run.mask.get(), run.project.process.overhang));
    }
    run.user.throwIfCancelled();
    if (!run.options.draftPictures && (isLaidAnew || earlier->appearance != result.appearance)) {
        result.readBack = readBackError(*result.laid, *result.laid, *result.appearance);
    }
}

QImage chessboardOf(const FilmSettings& film, QSize pixels) {
    solver::FilmGrid printed = filmGrid(film); // the squares have their true size on the sheet
    printed.width = film.width.value();
    printed.depth = film.height.value();
    return chessboard(printed, chessSquare, pixels);
}

// Returns a white layer of even tint under all ink of a picture. For pictures that were not made
// for a body.
QImage evenWhite(const QImage& picture, double tint) {
    const QImage pixels = picture.convertToFormat(QImage::Format_RGBA8888);
    QImage white(pixels.size(), QImage::Format_Grayscale8);
    for (int y = 0; y < white.height(); ++y) {
        const uchar* pixel = pixels.constScanLine(y);
        uchar* row = white.scanLine(y);
        for (int x = 0; x < white.width(); ++x, pixel += 4) {
            const bool hasInk = pixel[3] != 0 && (pixel[0] & pixel[1] & pixel[2]) != 255;
            row[x] = hasInk ? uchar(std::lround(255 * tint)) : 0;
        }
    }
    return white;
}

// Returns functions that make the body's appearance in each of the artwork's spot colours. They
// keep references to the arguments.
std::vector<SpotAppearance> spotPlates(const TextureInputs& inputs, const Progress& progress) {
    std::vector<SpotAppearance> plates;
    for (const ArtworkLayer& layer : inputs.paint.artwork.spots()) {
        plates.emplace_back([&inputs, &progress, spot = layer.spot] {
            return paintSpot(*inputs.paint.model, inputs.paint.artwork, spot,
                             texelFor(inputs.resolution), progress);
        });
    }
    return plates;
}

// Returns the picture for the film: the reverse texture of `colours`, or the picture that replaces
// the reverse texture.
ReverseTexture textureOf(const LaidFilm& laid, const BodyColours* colours,
                         const TextureInputs& inputs, std::optional<PaintShare> share,
                         const Run& run, const Progress& progress) {
    const FilmSettings& film = inputs.dip.film;
    const QSize pixels = sheetPixels(film.width, film.height, inputs.resolution);
    if (inputs.isReversed()) {
        ReverseTextureOptions options{pixels,   inputs.bleed.value(), inputs.ink, std::move(share),
                                      run.mask, inputs.white};
        if (run.options.draftPictures) {
            options.tolerance = draftTolerance * film.width.value() / pixels.width();
        }
        options.returnsWanted = inputs.isPerInk();
        options.spots = spotPlates(inputs, progress);
        return reverseTexture(laid, *colours, options, progress);
    }
    ReverseTexture picture;
    picture.image =
        inputs.chessboard
            ? chessboardOf(film, pixels)
            : (isWide(inputs.filmImage) ? inputs.filmImage
                                        : inputs.filmImage.convertToFormat(QImage::Format_RGBA8888))
                  .scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    if (!inputs.filmInks.isNull()) {
        picture.wanted = picture.image;
        picture.stretch = unstretched(pixels);
        picture.inks = inkPlanes(inputs.filmInks).each([&](const QImage& plane) {
            return plane.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                .convertToFormat(QImage::Format_RGBA8888);
        });
    }
    if (inputs.white > 0) {
        picture.white = evenWhite(picture.image, inputs.white);
    }
    return picture;
}

// The coarser films of one immersion, dipped in parallel with the job.
struct Comparison {
    CoarserFilms films;
    Tasks dips; // declared after `films`: its destructor waits before `films` is destroyed
    bool isWanted = false;
};

// Starts the coarser dips. Keeps references to all arguments except the result and the solver's id.
void compare(Comparison& comparison, const Run& run, const ImmersionResult& result,
             const DistanceField& field, const QString& solver, const CancelToken& left) {
    comparison.dips.run([&, solver, body = result.body, immersion = result.immersion,
                         film = filmOf(result, run.project)] {
        const auto isCancelled = [&] { return left.isCancelled() || run.user.isCancelled(); };
        // Without runIsolated(), a parallel loop of this task could start another task that waits
        // for this task.
        runIsolated([&] {
            CoarserDips dips({body, immersion}, field, film, run.project.process,
                             Progress{nullptr, run.user});
            CoarserDips::simulate({&dips}, run.registry.module(solver), isCancelled);
            comparison.films = dips.laid();
        });
    });
}

// The solver and the comparison for the dips of one immersion.
struct Dipping {
    SolverChoice& solver;
    Comparison& comparison;
    const CancelToken& left;
};

// Simulates a dip, if `isDipped` is false, and the coarser dips, if they are wanted. On a CPU they
// run at the same time. On a GPU they run afterwards, because one GPU cannot run both at the same
// time. `field` may be null if no dip is simulated.
void dipAndCompare(ImmersionResult& now, bool isDipped, const Run& run, std::size_t number,
                   const DistanceField* field, const Dipping& dipping, const Progress& progress) {
    const bool isBeside = dipping.solver.solver.deviceKind != QLatin1String("gpu");
    const auto compareNow = [&] {
        compare(dipping.comparison, run, now, *field, dipping.solver.solver.id, dipping.left);
    };
    if (dipping.comparison.isWanted && isBeside) {
        compareNow();
    }
    if (!isDipped) {
        dip(now, run, number, *field, dipping.solver, progress);
    }
    if (dipping.comparison.isWanted && !isBeside) {
        compareNow();
    }
}

// Waits for the coarser dips.
std::shared_ptr<const CoarserFilms> coarserFilms(Comparison& comparison, const Run& run) {
    comparison.dips.wait();
    run.user.throwIfCancelled();
    return std::make_shared<const CoarserFilms>(std::exchange(comparison.films, {}));
}

// Waits for the coarser dips and estimates the numerical error, if it is wanted.
void judge(ImmersionResult& now, const Run& run, Comparison& comparison,
           const std::optional<FilmsBefore>& before = {}) {
    if (std::exchange(comparison.isWanted, false)) {
        now.coarser = coarserFilms(comparison, run);
        now.numericalError = std::make_shared<const NumericalErrorEstimate>(
            estimateNumericalError(*now.laid, *now.coarser, before));
    }
}

// Repeats the dip of `now` with smaller cells. Throws Error if the solver fails or the film cannot
// be judged.
ImmersionResult finerDip(const ImmersionResult& now, double refinement, const Run& run,
                         std::size_t number, const DistanceField& field, const Dipping& dipping,
                         const Progress& progress) {
    ImmersionResult next;
    next.immersion = now.immersion;
    next.body = now.body;
    next.appearance = now.appearance;
    next.refinement = refinement;
    dipping.comparison.isWanted = true;
    dipAndCompare(next, false, run, number, &field, dipping, progress);
    std::shared_ptr<const CoarserFilms> before = now.coarser;
    if (!before) { // dips them again, with the solver that may have taken over
        dipping.comparison.dips.wait();
        Comparison again;
        compare(again, run, now, field, dipping.solver.solver.id, dipping.left);
        before = coarserFilms(again, run);
    }
    if (!before->failure.isEmpty()) {
        throw Error(before->failure, now.immersion.name);
    }
    judge(next, run, dipping.comparison, FilmsBefore{*now.laid, before->doubleSpacing.get()});
    if (!next.numericalError->failure.isEmpty()) {
        throw Error(next.numericalError->failure, next.immersion.name);
    }
    if (now.numericalError->isKnown() && !next.numericalError->isKnown()) {
        throw Error(Text::tr("a film with coarser cells does not follow the part"),
                    next.immersion.name);
    }
    next.solverNotes = now.solverNotes + next.solverNotes;
    return next;
}

// Repeats the dip with smaller cells while that may make its sheet good enough to print. If such a
// dip fails, keeps the previous film.
void refine(ImmersionResult& now, Run& run, std::size_t number, JobResult& job,
            const Dipping& dipping, const Progress& progress) {
    judge(now, run, dipping.comparison);
    SolverChoice solver = dipping.solver; // a failure here must not change the other dips' solver
    const Dipping finer{solver, dipping.comparison, dipping.left};
    const auto next = [&] {
        const Verdict verdict = numericalVerdict(*now.laid, now.numericalError.get(), run.surface(),
                                                 run.project.tolerance);
        return nextRefinement(now, verdict, run.project.film);
    };
    double done = 0;
    while (const auto refinement = next()) {
        job.field = distanceFieldOf(job, progress.silent()); // null if the first film was cached
        const double nextDone = done + (1 - done) / 2;
        const auto fail = [&](const QString& why) {
            dipping.comparison.isWanted = false;
            now.refinementFailure = why;
        };
        try {
            now = finerDip(now, *refinement, run, number, *job.field, finer,
                           progress.part(done, nextDone));
        } catch (const Error& error) {
            return fail(error.message());
        } catch (const std::bad_alloc&) {
            return fail(Text::tr("there is too little memory"));
        }
        done = nextDone;
        run.isRefined[number] = true;
    }
}

// Does the first part of an immersion's work, up to the laid film.
ImmersionResult dippedImmersion(Run& run, std::size_t number, const SheetInputs& inputs,
                                JobResult& job, const Dipping& dipping, const Progress& progress) {
    const ImmersionResult* earlier = run.earlier(number);
    const DipInputs& wanted = inputs.texture.dip;
    const bool isDipped = hasDipped(earlier, wanted);
    dipping.comparison.isWanted = isToBeJudged(run, earlier, wanted);
    ImmersionResult now;
    if (isDipped) {
        now = *earlier;
        if (earlier->inputs.texture.dip != wanted) { // other limits may need other cells
            now.refinementFailure.clear();
        }
    }
    now.immersion = run.project.immersions[number];
    now.body = bodyOf(run, number, wanted.body);
    now.appearance = job.painted;
    const bool isRefinable = refines(run, wanted) && !run.isDippedElsewhere;
    dipAndCompare(now, isDipped, run, number, job.field.get(), dipping,
                  progress.part(0, isRefinable ? firstDip : 1));
    if (isRefinable) {
        refine(now, run, number, job, dipping, progress.part(firstDip, 1));
    }
    now.inputs = inputs;
    return now;
}

// Returns how the dips share the body; null if they do not share the body.
std::shared_ptr<const BodyShare> shareOf(const Run& run, const ShareStage* stage,
                                         const std::vector<ImmersionResult>& immersions,
                                         const Progress& progress) {
    const std::optional<ShareInputs>& inputs = immersions.front().inputs.texture.share;
    if (!inputs) {
        return nullptr;
    }
    const JobResult* previous = run.earlierTogether();
    if (previous && previous->share &&
        previous->immersions.front().inputs.texture.share == inputs) {
        return previous->share;
    }
    return std::make_shared<const BodyShare>(shareBody(
        *stage, {immersions[0].laid, immersions[1].laid}, inputs->settings, inputs->ink, progress));
}

// Does the second part: the picture on the film. `share` is null if the dips do not share the body.
void paint(ImmersionResult& now, const Run& run, std::size_t number, const JobResult& job,
           const Progress& progress) {
    const ImmersionResult* earlier = run.earlierSheet(number, now.inputs.texture);
    if (!earlier || earlier->inputs.texture != now.inputs.texture) {
        now.texture = std::make_shared<const ReverseTexture>(textureOf(
            *now.laid, job.colours.get(), now.inputs.texture,
            job.share ? std::optional(job.share->of(number)) : std::nullopt, run, progress));
    }
}

// Returns the images printed on the film, corrected for the repeating error of earlier parts if the
// project asks for it.
PrintedFilm printedFilm(const ReverseTexture& texture, const RepeatingError* repeating,
                        const SheetInputs& inputs, const Project& project) {
    PrintedFilm film{texture.image,   texture.white, texture.wanted,
                     texture.stretch, texture.inks,  texture.spots};
    if (!repeating) {
        return film;
    }
    const DenseError error(*repeating, project.film.width, project.film.height);
    const auto moved = [&](const QImage& picture) {
        return correctedImage(picture, error, inputs.correction->strength);
    };
    const auto movedTints = [&](const QImage& tints) {
        return correctedTints(tints, error, inputs.correction->strength);
    };
    film.colours = moved(film.colours);
    film.white = film.white.isNull() ? film.white : movedTints(film.white);
    std::transform(film.spots.begin(), film.spots.end(), film.spots.begin(), movedTints);
    if (!film.wanted.isNull()) {
        film.stretch = stretchOfPicture(moved(pictureOfStretch(film.stretch, film.wanted)));
        film.wanted = moved(film.wanted);
        film.inks = film.inks.each([&](const QImage& plane) {
            return correctedImage(plane, error, inputs.correction->strength, Resampling::Nearest);
        });
    }
    return film;
}

// Fills in where the inks of the project's printer do not suffice and, except in drafts, how much
// ink the sheet takes.
void measureInks(ImmersionResult& now, const std::optional<PrinterProfile>& printer, bool isDraft) {
    std::optional<PrinterColour> colour;
    PrintCorrection correction;
    if (printer && !printer->iccProfile.isEmpty()) {
        colour.emplace(*printer, printer->name);
        correction.colour = &*colour;
        correction.totalInk = printer->totalInk;
    }
    now.inkShortfall = now.sheet.wanted && colour && colour->isCmyk()
                           ? std::optional(inkShortfall(now.sheet, correction))
                           : std::nullopt;
    now.lostPlates = lostPlates(now.sheet, colour && colour->isCmyk());
    now.inks = isDraft ? std::vector<InkArea>() : inkAreas(now.sheet, correction);
}

// Does the last part: measurements of the film, its sheet, and the verdict.
void finish(ImmersionResult& now, const Run& run, std::size_t number, Comparison& comparison) {
    Tasks measuring;
    measuring.run([&] { measure(now, run.earlier(number), run); });
    const ImmersionResult* earlier = run.earlierSheet(number, now.inputs.texture);
    const bool isDraft = run.options.draftPictures.has_value();
    if (!earlier || earlier->inputs != now.inputs) {
        run.user.throwIfCancelled();
        std::optional<RepeatingError> repeating;
        if (now.inputs.correction) {
            repeating.emplace(*now.inputs.correction, int(number) + 1);
        }
        now.unusualCorrection = repeating ? unusualErrorNote(*repeating) : QString();
        const PrintedFilm film =
            printedFilm(*now.texture, repeating ? &*repeating : nullptr, now.inputs, run.project);
        run.user.throwIfCancelled();
        now.sheet = jobSheet(run.project, now.immersion, film, run.user);
        if (now.sheet.wanted) {
            now.sheet.wanted->settings = now.inputs.texture.printedInk();
        }
        now.sheet.passes = now.inputs.texture.printedInk().printedPasses();
        run.user.throwIfCancelled();
        measureInks(now, run.project.profiles.printer, isDraft);
        now.coveredPicture =
            isDraft || !now.inputs.texture.isReversed() ? QString() : coveredPictureNote(now.sheet);
    }
    measuring.wait();
    judge(now, run, comparison);
    now.verdict = dipVerdict(now, run.project, run.surface());
    now.finer =
        run.options.refines ? std::nullopt : nextRefinement(now, now.verdict, run.project.film);
    if (!now.finer) {
        now.coarser.reset();
    }
    if (run.options.finished) {
        run.options.finished(number, now);
    }
}

// Fills in how much each sheet depends on the assumed laws.
void varyLaws(JobResult& result, const Run& run, SolverChoice& solver, const Progress& progress) {
    const auto field = distanceFieldOf(result, progress);
    for (std::size_t number = 0; number < result.immersions.size(); ++number) {
        ImmersionResult& immersion = result.immersions[number];
        progress(double(number) / double(result.immersions.size()),
                 Text::tr("Dipping with varied film laws"));
        immersion.laws = withFallback(solver, run.registry, [&](const auto& module) {
            Project refined = run.project;
            refined.film = filmOf(immersion, run.project);
            return lawChanges(refined, immersion.immersion, immersion.body, *immersion.laid, *field,
                              module, progress.cancelToken);
        });
    }
}

double coverageTotal(const std::vector<ImmersionResult>& immersions, const SurfaceMask* mask,
                     const Progress& progress) {
    if (immersions.size() == 1) {
        return immersions.front().coverage->share;
    }
    std::vector<std::shared_ptr<const LaidFilm>> films;
    for (const ImmersionResult& immersion : immersions) {
        films.push_back(immersion.laid);
    }
    return coverageTogether(films, progress, mask);
}

bool hasProofOf(const JobResult* previous, const std::vector<SheetInputs>& inputs) {
    return previous && std::equal(inputs.begin(), inputs.end(), previous->immersions.begin(),
                                  previous->immersions.end(),
                                  [](const SheetInputs& now, const ImmersionResult& earlier) {
                                      return now.texture == earlier.inputs.texture &&
                                             now.baseColour == earlier.inputs.baseColour &&
                                             now.settings.white == earlier.inputs.settings.white;
                                  });
}

// Tells whether the dips have been renamed since the earlier coverage picture was drawn.
bool hasOldNames(const JobResult* previous, const std::vector<SheetInputs>& inputs) {
    return previous && previous->share &&
           !std::equal(inputs.begin(), inputs.end(), previous->immersions.begin(),
                       previous->immersions.end(),
                       [](const SheetInputs& now, const ImmersionResult& earlier) {
                           return now.immersion == earlier.inputs.immersion;
                       });
}

// Returns the proof, with the white layer if `white` is true.
QImage proofOf(const JobResult& result, bool white, double scale, const Progress& progress) {
    const std::vector<ImmersionResult>& immersions = result.immersions;
    const SheetInputs& inputs = immersions.front().inputs;
    ProofOptions options;
    options.tile = (QSizeF(proofTile, proofTile) * scale).toSize();
    options.ink = inputs.texture.printedInk();
    options.ground = groundOf(inputs.settings, inputs.baseColour);
    return proofPicture(*result.proofStage, filmAppearances(immersions, white), options, progress);
}

// Returns the coverage picture; null if the dips do not share the body.
QImage coverageOf(const JobResult& result, const Progress& progress) {
    if (!result.share) {
        return {};
    }
    std::vector<SharedFilm> films;
    for (const ImmersionResult& immersion : result.immersions) {
        films.push_back({immersion.laid, immersion.immersion.name});
    }
    return coveragePicture(*result.proofStage, *result.share, films, coverageTile, progress);
}

// Tells whether the proof would look different without the white layer.
bool showsWhite(const SheetInputs& inputs) {
    return inputs.texture.white > 0 && !inputs.baseColour.isEmpty();
}

// Fills in the proofs and, except in drafts, the coverage picture. Takes over the pictures that the
// earlier result already has.
void showTogether(JobResult& result, const Run& run, bool hasProof, bool hasCoverage,
                  const Progress& progress) {
    const double scale = run.options.draftPictures.value_or(1);
    const Progress proofs = progress.part(picturesDone, proofDone);
    result.proof = hasProof ? run.previous->proof : proofOf(result, true, scale, proofs);
    if (showsWhite(result.immersions.front().inputs)) {
        result.proofWithoutWhite = hasProof ? run.previous->proofWithoutWhite
                                            : proofOf(result, false, scale, proofs.silent());
    }
    if (!run.options.draftPictures) {
        result.coverage =
            hasCoverage ? run.previous->coverage : coverageOf(result, progress.part(proofDone, 1));
    }
}

// Takes over the stages of an earlier result that still fit; `previous` may be null.
void takeStages(JobResult& result, const JobResult* previous) {
    if (previous && previous->project.model == result.project.model) {
        result.fine = previous->fine;
        result.proofStage = previous->proofStage;
    }
    if (previous && previous->painted == result.painted) {
        result.shareStage = previous->shareStage;
        result.colours = previous->colours;
    }
}

// Starts tasks for the stages that are missing.
void prepareStages(JobResult& result, const Run& run, const TextureInputs& inputs, Tasks& tasks) {
    if (!result.fine) {
        result.fine = fineBody(run.project.model->mesh);
    }
    if (!result.proofStage) {
        tasks.run([&] { result.proofStage = proofStage(*run.project.model, result.fine); });
    }
    if (!result.colours && inputs.isReversed()) {
        tasks.run([&] { result.colours = bodyColours(*result.painted); });
    }
    if (!result.shareStage && inputs.share) {
        tasks.run([&] { result.shareStage = shareStage(*result.painted, result.fine); });
    }
}

// Fills in the immersions and the results about all of them together. Dips run one after the other.
// The work after a dip runs at the same time as the next dip, because a solver leaves some cores
// idle. If the dips share the body, the pictures are made after the last dip. The proof is made
// after the pictures; it does not wait for the sheets.
void runImmersions(JobResult& result, Run& run, const std::vector<SheetInputs>& inputs,
                   SolverChoice& solver, const Progress& progress) {
    std::vector<ImmersionResult>& immersions = result.immersions;
    immersions.resize(inputs.size());
    // Declared before the tasks that use them, so that after an exception the tasks end before
    // these variables are destroyed.
    CancelToken left; // cancelled on an exception, so that the comparisons stop
    std::vector<Comparison> comparisons(inputs.size());
    Tasks sheets;
    Tasks pictures; // each picture starts the task of its sheet
    Tasks stages;   // preparations for pictures and shares that depend only on the body
    const auto leave = qScopeGuard([&left] { left.cancel(); });
    prepareStages(result, run, inputs.front().texture, stages);
    const auto beginPicture = [&](std::size_t number) {
        pictures.run([&, number] {
            paint(immersions[number], run, number, result, progress.silent());
            sheets.run(
                [&, number] { finish(immersions[number], run, number, comparisons[number]); });
        });
    };
    const bool isShared = inputs.front().texture.share.has_value();
    const double part = dipsDone / double(inputs.size());
    for (std::size_t number = 0; number < inputs.size(); ++number) {
        const double begin = part * double(number);
        runIsolated([&] {
            immersions[number] = dippedImmersion(run, number, inputs[number], result,
                                                 {solver, comparisons[number], left},
                                                 progress.part(begin, begin + part));
        });
        if (!isShared) {
            stages.wait();
            beginPicture(number);
        }
    }
    if (isShared) {
        stages.wait();
        runIsolated([&] {
            result.share = shareOf(run, result.shareStage.get(), immersions,
                                   progress.part(dipsDone, sharesDone));
        });
        for (std::size_t number = 0; number < inputs.size(); ++number) {
            beginPicture(number);
        }
    }
    progress(sharesDone, Text::tr("Reversing the texture"));
    pictures.wait();
    const bool hasProof = hasProofOf(run.earlierTogether(), inputs);
    const bool hasCoverage = hasProof && !hasOldNames(run.previous, inputs);
    runIsolated([&] { showTogether(result, run, hasProof, hasCoverage, progress); });
    sheets.wait();
    result.coverageTotal = coverageTotal(immersions, run.mask.get(), progress);
}

QString thinPartsOf(const JobResult& result, const JobResult* previous) {
    if (previous && previous->fieldInputs == result.fieldInputs) {
        return previous->thinParts;
    }
    const PosedBody& body = *result.immersions.front().body;
    return thinPartNote(result.project, body.mesh, body.query);
}

QStringList notesOf(const JobResult& result) {
    QStringList notes;
    constexpr double negligibleShare = 0.01; // share of the body
    if (result.coverageTotal < negligibleShare && isInsideOut(*result.project.model)) {
        notes.append(insideOutNote());
    }
    notes += colourNotes(*result.project.model) + layerNotes(result.project.artwork);
    for (const ImmersionResult& immersion : result.immersions) {
        notes += immersion.solverNotes;
    }
    if (result.share && recommendedLastDip(*result.share) == std::size_t(0)) {
        const QLocale locale;
        const auto& [first, second] = result.share->seamStretch;
        notes.append(Text::tr("%1 should be dipped after %2. Along the seam, the film's stretch is "
                              "%3 for %1 and %4 for %2. A placement error of the second film grows "
                              "with its stretch.")
                         .arg(result.immersions[0].immersion.name,
                              result.immersions[1].immersion.name, locale.toString(first, 'f', 2),
                              locale.toString(second, 'f', 2)));
    }
    return notes;
}

} // namespace

std::shared_ptr<const DistanceField> distanceFieldOf(const JobResult& result,
                                                     const Progress& progress) {
    return result.field ? result.field
                        : cachedDistanceField(result.fieldInputs.model->mesh,
                                              result.fieldInputs.resolution, progress);
}

JobResult runJob(const Project& project, const SolverRegistry& registry, const JobOptions& options,
                 const JobResult* previous, const Progress& progress) {
    if (!project.model) {
        throw Error(Text::tr("The project has no model; import one first"), project.name);
    }
    checkSpots(project);
    const Printed printed = options.printsTexture() ? Printed::Texture : Printed::WholeFilm;
    checkMemory(project, printed);
    if (const QString note = memoryNote(project, printed); !note.isEmpty()) {
        progress(0, note);
    }
    Run run{project,
            registry,
            options,
            previous,
            progress.cancelToken,
            markedZones(project.model, project.tolerance.marks),
            surfaceMask(project.model, project.masks, previous ? previous->mask : nullptr),
            separateBodies(*project.model)};
    run.isRefined.resize(project.immersions.size());
    JobResult result;
    result.project = project;
    result.mask = run.mask;
    result.bodies = run.bodies;
    result.wantedSolver = options.solver.isEmpty() ? project.process.solver : options.solver;
    SolverChoice solver = solverOf(run, result.wantedSolver);
    result.chosenSolver = run.isDippedElsewhere ? previous->chosenSolver : solver.solver.id;
    result.notes = std::exchange(solver.notes, {});

    std::vector<SheetInputs> inputs;
    for (std::size_t number = 0; number < project.immersions.size(); ++number) {
        inputs.push_back(sheetInputs(project, options, number, result.chosenSolver));
    }
    if (std::any_of(inputs.begin(), inputs.end(),
                    [](const SheetInputs& dip) { return dip.correction.has_value(); })) {
        requirePossibleErrors(partsDippedAlike(project), project.film.width, project.film.height,
                              project.name);
    }
    result.fieldInputs = fieldInputs(project);
    result.paintInputs = paintInputs(project);
    result.painted = paintedOf(run, result.paintInputs, progress.part(0, fieldDone / 2));
    result.field = fieldOf(run, inputs, progress.part(fieldDone / 2, fieldDone));
    takeStages(result, previous);

    const Progress job = options.makesCradles ? progress.part(0, cradlesBegin) : progress;
    const Progress dips = options.computesTolerances ? job.part(0, tolerancesBegin) : job;
    const double allDone = options.variesLaws ? lawsBegin : 1;
    runImmersions(result, run, inputs, solver, dips.part(fieldDone, allDone));
    if (options.variesLaws) {
        varyLaws(result, run, solver, dips.part(allDone, 1));
    }
    if (options.computesTolerances) {
        result.tolerances = std::make_shared<const JobTolerances>(
            jobTolerances(result, project.tolerance, registry, job.part(tolerancesBegin, 1)));
    }
    if (options.makesCradles) {
        result.cradles = jobCradles(result, progress.part(cradlesBegin, 1));
    }
    result.solver = result.immersions.back().solver;
    result.notes += notesOf(result);
    if (options.refines || !options.draftPictures) {
        result.notes += refinementNotes(result);
    }
    if (const QString note = colourNoteText(options.filmImage, Text::tr("The picture on the film"));
        !note.isEmpty()) {
        result.notes += note;
    }
    result.thinParts = thinPartsOf(result, previous);
    result.verdict = allDipsVerdict(result, run.zones.get());
    return result;
}

} // namespace dipwright
