#include "pipeline/Pipeline.h"

#include "accuracy/correction/SheetCorrection.h"
#include "artwork/EditArtwork.h"
#include "artwork/PaintArtwork.h"
#include "base/ColourNote.h"
#include "base/Error.h"
#include "base/WideGamut.h"
#include "film/FilmGrid.h"
#include "model/TextureNotes.h"
#include "parallel/Tasks.h"
#include "pipeline/JobCradles.h"
#include "pipeline/JobSheet.h"
#include "pipeline/JobTolerances.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/LawChanges.h"
#include "pipeline/ModelNotes.h"
#include "pipeline/PrintedBody.h"
#include "pipeline/SheetMemory.h"
#include "pipeline/SolverChoice.h"
#include "project/Profiles.h"
#include "results/Results.h"
#include "sheet/prepress/PrinterColour.h"
#include "sheet/prepress/Separation.h"
#include "texture/Chessboard.h"
#include "texture/StretchPlane.h"

#include <QCoreApplication>
#include <QScopeGuard>

#include <algorithm>
#include <utility>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

// Shares of the time of a job, roughly as measured on a film of 120 × 170 points.
constexpr double fieldDone = 0.1;
constexpr double lawsBegin = 0.3;        // where they are varied
constexpr double tolerancesBegin = 0.15; // where they are told
constexpr double cradlesBegin = 0.6;
constexpr double dipsDone = 0.7; // of what follows the field
constexpr double sharesDone = 0.75;
constexpr double proofDone = 0.97;
constexpr int coverageTile = 560; // pixels of each side of the body
constexpr double picturesDone = 0.8;

// What all steps of one run are given.
struct Run {
    const Project& project;
    const SolverRegistry& registry;
    const JobOptions& options;
    const JobResult* previous; // may be null
    CancelToken user;
    std::shared_ptr<const ZonedBody> zones; // null: none are marked

    const ImmersionResult* earlier(std::size_t number) const {
        return previous && number < previous->immersions.size() ? &previous->immersions[number]
                                                                : nullptr;
    }
};

bool hasDipped(const ImmersionResult* earlier, const DipInputs& inputs) {
    return earlier && earlier->inputs.texture.dip == inputs;
}

// Whether coarser films are to be dipped as well.
bool isToBeJudged(const Run& run, const ImmersionResult* earlier, const DipInputs& inputs) {
    return run.options.estimatesCertainty && !(hasDipped(earlier, inputs) && earlier->certainty);
}

// Null where nothing is dipped anew and the earlier result has none.
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

// The model as it is to look.
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
        posedBody(inputs.model->mesh, run.project.immersions[number]));
}

// Fills in the film on the body.
void dip(ImmersionResult& result, const Run& run, std::size_t number, const DistanceField& field,
         SolverChoice& solver, const Progress& progress) {
    FilmObserver observer;
    if (run.options.observer) {
        observer = [&](const FilmFrame& frame) { run.options.observer(number, frame); };
    }
    DippedFilm film = withFallback(solver, run.registry, [&](const solver::SolverModule& module) {
        return simulateDip(*result.body, field, result.immersion, run.project.film,
                           run.project.process, module, progress, observer);
    });
    result.solver = solver.solver;
    result.solverNotes = std::exchange(solver.notes, {});
    progress(1, Text::tr("Finding the film on the body"));
    result.laid = layFilm(result.body, std::move(film), run.project.process);
}

// What is not measured yet: the coverage of film that was just dipped, or taken over from dips that
// were kept; the sheet read back of that, and of a body that looked otherwise before.
void measure(ImmersionResult& result, const ImmersionResult* earlier, const CancelToken& user) {
    const bool isLaidAnew = !result.coverage;
    user.throwIfCancelled();
    if (isLaidAnew) {
        result.coverage = std::make_shared<const Coverage>(coverage(*result.laid));
    }
    user.throwIfCancelled();
    if (isLaidAnew || earlier->appearance != result.appearance) {
        result.readBack = readBackError(*result.laid, *result.laid, *result.appearance);
    }
}

QImage chessboardOf(const FilmSettings& film, QSize pixels) {
    solver::FilmGrid printed = filmGrid(film); // the squares are measured on the sheet
    printed.width = film.width.value();
    printed.depth = film.height.value();
    return chessboard(printed, chessSquare, pixels);
}

// The picture for the film: the body's texture reversed, or what is to be on it instead.
// Under all colour of a picture that was not made for a body, of one tint.
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

// Returns how the body looks in each of the artwork's spot inks. Keeps references to its arguments.
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

ReverseTexture textureOf(const LaidFilm& laid, const SurfaceAppearance& appearance,
                         const TextureInputs& inputs, std::optional<PaintShare> share,
                         const Progress& progress) {
    const FilmSettings& film = inputs.dip.film;
    const QSize pixels = sheetPixels(film.width, film.height, inputs.resolution);
    if (inputs.isReversed()) {
        ReverseTextureOptions options{pixels, inputs.bleed.value(), inputs.ink, std::move(share),
                                      inputs.white};
        options.keepsWanted = inputs.isPerInk();
        options.spots = spotPlates(inputs, progress);
        return reverseTexture(laid, appearance, options, progress);
    }
    ReverseTexture picture;
    picture.image =
        inputs.chessboard
            ? chessboardOf(film, pixels)
            : (isWide(inputs.filmImage) ? inputs.filmImage
                                        : inputs.filmImage.convertToFormat(QImage::Format_RGBA8888))
                  .scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    if (inputs.white > 0) {
        picture.white = evenWhite(picture.image, inputs.white);
    }
    return picture;
}

// The films that one immersion's is to be compared with, dipped beside everything else.
struct Comparison {
    CoarserFilms films;
    Tasks dips; // after what they fill in: they are waited for before it goes
    bool isWanted = false;
};

// Begins it and keeps references to all but the result and the solver's id.
void compare(Comparison& comparison, const Run& run, const ImmersionResult& result,
             const DistanceField& field, const QString& solver, const CancelToken& left) {
    comparison.dips.run([&, solver, body = result.body, immersion = result.immersion] {
        const auto isCancelled = [&] { return left.isCancelled() || run.user.isCancelled(); };
        // Else its own loops might take up the piece of work that waits for it.
        undisturbed([&] {
            comparison.films =
                coarserFilms(body, field, immersion, run.project.film, run.project.process,
                             run.registry.module(solver), isCancelled);
        });
    });
}

// The first part of an immersion's work: up to the film on the body. Coarser films are dipped
// beside it on the processor; on a GPU, which it would have to share with them, after it.
ImmersionResult dippedImmersion(const Run& run, std::size_t number, const SheetInputs& inputs,
                                const JobResult& job, SolverChoice& solver, Comparison& comparison,
                                const CancelToken& left, const Progress& progress) {
    const DistanceField* field = job.field.get();
    const ImmersionResult* earlier = run.earlier(number);
    const bool isDipped = hasDipped(earlier, inputs.texture.dip);
    const bool isBeside = solver.solver.deviceKind != QLatin1String("gpu");
    comparison.isWanted = isToBeJudged(run, earlier, inputs.texture.dip);
    ImmersionResult now;
    if (isDipped) {
        now = *earlier;
    }
    now.immersion = run.project.immersions[number];
    now.body = bodyOf(run, number, inputs.texture.dip.body);
    now.appearance = job.painted;
    if (comparison.isWanted && isBeside) {
        compare(comparison, run, now, *field, solver.solver.id, left);
    }
    if (!isDipped) {
        dip(now, run, number, *field, solver, progress);
    }
    if (comparison.isWanted && !isBeside) {
        compare(comparison, run, now, *field, solver.solver.id, left);
    }
    now.inputs = inputs;
    return now;
}

// How the dips share the body out; null where they do not.
std::shared_ptr<const BodyShare> shareOf(const Run& run, const TexturedMesh& model,
                                         const std::vector<ImmersionResult>& immersions,
                                         const Progress& progress) {
    const std::optional<ShareInputs>& inputs = immersions.front().inputs.texture.share;
    if (!inputs) {
        return nullptr;
    }
    if (run.previous && run.previous->share &&
        run.previous->immersions.front().inputs.texture.share == inputs) {
        return run.previous->share;
    }
    return std::make_shared<const BodyShare>(shareBody(
        model, {immersions[0].laid, immersions[1].laid}, inputs->settings, inputs->ink, progress));
}

// The second: the picture that the film wears. `share`: null where it is not shared with others.
void paint(ImmersionResult& now, const Run& run, std::size_t number, const BodyShare* share,
           const Progress& progress) {
    const ImmersionResult* earlier = run.earlier(number);
    if (!earlier || earlier->inputs.texture != now.inputs.texture) {
        now.texture = std::make_shared<const ReverseTexture>(
            textureOf(*now.laid, *now.appearance, now.inputs.texture,
                      share ? std::optional(share->of(number)) : std::nullopt, progress));
    }
}

// What stands on the film, with what repeats in the parts before taken off, where that is wanted.
PrintedFilm printedFilm(const ReverseTexture& texture, const SheetInputs& inputs,
                        const Project& project, std::size_t number) {
    PrintedFilm film{texture.image, texture.white, texture.wanted, texture.stretch, texture.spots};
    if (!inputs.correction) {
        return film;
    }
    const RepeatingError error(*inputs.correction, int(number) + 1);
    const auto moved = [&](const QImage& picture) {
        return correctedImage(picture, project.film.width, project.film.height, error,
                              inputs.correction->strength);
    };
    const auto movedTints = [&](const QImage& tints) {
        return moved(tints.convertToFormat(QImage::Format_RGBA8888))
            .convertToFormat(QImage::Format_Grayscale8);
    };
    film.colours = moved(film.colours);
    film.white = film.white.isNull() ? film.white : movedTints(film.white);
    std::transform(film.spots.begin(), film.spots.end(), film.spots.begin(), movedTints);
    if (!film.wanted.isNull()) {
        film.wanted = moved(film.wanted);
        film.stretch = stretchOfPicture(moved(pictureOfStretch(film.stretch)));
    }
    return film;
}

std::optional<double> shortfallOf(const Sheet& sheet,
                                  const std::optional<PrinterProfile>& printer) {
    if (!sheet.wanted || !printer || printer->iccProfile.isEmpty()) {
        return std::nullopt;
    }
    const PrinterColour colour(printer->iccProfile, printer->intent, printer->blackPoint,
                               printer->name);
    PrintCorrection correction{.colour = &colour};
    correction.totalInk = printer->totalInk;
    return colour.isCmyk() ? std::optional(inkShortfall(sheet, correction)) : std::nullopt;
}

// The rest: what is measured of the film, its sheet, and the verdict on that.
void finish(ImmersionResult& now, const Run& run, std::size_t number, Comparison& comparison) {
    const ImmersionResult* earlier = run.earlier(number);
    Tasks measuring;
    measuring.run([&] { measure(now, earlier, run.user); });
    if (!earlier || earlier->inputs != now.inputs) {
        run.user.throwIfCancelled();
        const PrintedFilm film = printedFilm(*now.texture, now.inputs, run.project, number);
        run.user.throwIfCancelled();
        now.sheet = jobSheet(run.project, now.immersion, film, run.user);
        run.user.throwIfCancelled();
        now.inkShortfall = shortfallOf(now.sheet, run.project.profiles.printer);
    }
    measuring.wait();
    if (comparison.isWanted) {
        comparison.dips.wait();
        run.user.throwIfCancelled();
        now.certainty = std::make_shared<const CertaintyEstimate>(
            certaintyEstimate(*now.laid, std::exchange(comparison.films, {})));
    }
    now.verdict = dipVerdict(now, run.project, run.zones.get());
    if (run.options.finished) {
        run.options.finished(number, now);
    }
}

// Fills in how much each sheet depends on the laws of ours.
void varyLaws(JobResult& result, const Run& run, SolverChoice& solver, const Progress& progress) {
    const auto field = result.field ? result.field
                                    : cachedDistanceField(result.fieldInputs.model->mesh,
                                                          result.fieldInputs.resolution, progress);
    for (std::size_t number = 0; number < result.immersions.size(); ++number) {
        ImmersionResult& immersion = result.immersions[number];
        progress(double(number) / double(result.immersions.size()), Text::tr("Varying the laws"));
        immersion.laws = withFallback(solver, run.registry, [&](const auto& module) {
            return lawChanges(run.project, immersion.immersion, immersion.body, *immersion.laid,
                              *field, module, progress.cancelToken);
        });
    }
}

double coverageTotal(const std::vector<ImmersionResult>& immersions, const Progress& progress) {
    if (immersions.size() == 1) {
        return immersions.front().coverage->share;
    }
    std::vector<std::shared_ptr<const LaidFilm>> films;
    for (const ImmersionResult& immersion : immersions) {
        films.push_back(immersion.laid);
    }
    return coverageTogether(films, progress);
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

// Whether the picture of who paints what is lettered with other names than it is to be.
bool hasOldNames(const JobResult* previous, const std::vector<SheetInputs>& inputs) {
    return previous && previous->share &&
           !std::equal(inputs.begin(), inputs.end(), previous->immersions.begin(),
                       previous->immersions.end(),
                       [](const SheetInputs& now, const ImmersionResult& earlier) {
                           return now.immersion == earlier.inputs.immersion;
                       });
}

// `white`: as printed, else as it were without that plate.
QImage proofOf(const ProofStage& stage, const std::vector<ImmersionResult>& immersions, bool white,
               const Progress& progress) {
    const SheetInputs& inputs = immersions.front().inputs;
    ProofOptions options;
    options.ink = inputs.texture.printedInk();
    options.ground = groundOf(inputs.settings, inputs.baseColour);
    return proofPicture(stage, filmAppearances(immersions, white), options, progress);
}

// Null where the dips do not share the body out.
QImage coverageOf(const ProofStage& stage, const JobResult& result, const Progress& progress) {
    if (!result.share) {
        return {};
    }
    std::vector<SharedFilm> films;
    for (const ImmersionResult& immersion : result.immersions) {
        films.push_back({immersion.laid, immersion.immersion.name});
    }
    return coveragePicture(stage, *result.share, films, coverageTile, progress);
}

// Whether the proof would be another without the white layer.
bool showsWhite(const SheetInputs& inputs) {
    return inputs.texture.white > 0 && !inputs.baseColour.isEmpty();
}

// Fills in the proofs and the picture of who paints what, or takes them over where the earlier
// result has the same; the stage is not needed then.
void showTogether(JobResult& result, const Run& run, const ProofStage* stage, bool hasProof,
                  bool hasCoverage, const Progress& progress) {
    const std::vector<ImmersionResult>& immersions = result.immersions;
    const Progress proofs = progress.part(picturesDone, proofDone);
    result.proof = hasProof ? run.previous->proof : proofOf(*stage, immersions, true, proofs);
    if (showsWhite(immersions.front().inputs)) {
        result.proofWithoutWhite = hasProof ? run.previous->proofWithoutWhite
                                            : proofOf(*stage, immersions, false, proofs.silent());
    }
    result.coverage = hasCoverage ? run.previous->coverage
                                  : coverageOf(*stage, result, progress.part(proofDone, 1));
}

// Fills in the immersions and what is told of them together. One film is dipped after the other;
// what follows a dip goes on beside the next one, for which the solver does not need, or cannot
// use, all of the processor; but where the dips share the body out, the pictures wait for the last
// of them. The proof waits for the pictures and for no sheet.
void runImmersions(JobResult& result, const Run& run, const std::vector<SheetInputs>& inputs,
                   SolverChoice& solver, const Progress& progress) {
    std::vector<ImmersionResult>& immersions = result.immersions;
    immersions.resize(inputs.size());
    const bool hasProof = hasProofOf(run.previous, inputs);
    const bool hasCoverage = hasProof && !hasOldNames(run.previous, inputs);
    // Before the tasks that use them: with an exception these are waited for first.
    CancelToken left; // with an exception: the comparisons are not finished
    std::shared_ptr<const ProofStage> stage;
    std::vector<Comparison> comparisons(inputs.size());
    Tasks sheets;
    Tasks pictures; // each begins a sheet
    const auto leave = qScopeGuard([&left] { left.cancel(); });
    if (!hasProof || !hasCoverage) {
        pictures.run([&] {
            run.user.throwIfCancelled();
            stage = proofStage(*run.project.model);
        });
    }
    const auto beginPicture = [&](std::size_t number) {
        pictures.run([&, number] {
            paint(immersions[number], run, number, result.share.get(), progress.silent());
            sheets.run(
                [&, number] { finish(immersions[number], run, number, comparisons[number]); });
        });
    };
    const bool isShared = inputs.front().texture.share.has_value();
    const double part = dipsDone / double(inputs.size());
    for (std::size_t number = 0; number < inputs.size(); ++number) {
        const double begin = part * double(number);
        undisturbed([&] {
            immersions[number] =
                dippedImmersion(run, number, inputs[number], result, solver, comparisons[number],
                                left, progress.part(begin, begin + part));
        });
        if (!isShared) {
            beginPicture(number);
        }
    }
    if (isShared) {
        undisturbed([&] {
            result.share =
                shareOf(run, *result.painted, immersions, progress.part(dipsDone, sharesDone));
        });
        for (std::size_t number = 0; number < inputs.size(); ++number) {
            beginPicture(number);
        }
    }
    progress(sharesDone, Text::tr("Reversing the texture"));
    pictures.wait();
    undisturbed([&] { showTogether(result, run, stage.get(), hasProof, hasCoverage, progress); });
    sheets.wait();
    result.coverageTotal = coverageTotal(immersions, progress);
}

QStringList notesOf(const JobResult& result) {
    QStringList notes;
    if (const QString expiry = expiryWarning(result.project.profiles.film); !expiry.isEmpty()) {
        notes.append(expiry);
    }
    const PosedBody& body = *result.immersions.front().body;
    if (const QString note = thinPartNote(result.project, body.mesh, body.query); !note.isEmpty()) {
        notes.append(note);
    }
    constexpr double hardlyAnything = 0.01; // of the body
    if (result.coverageTotal < hardlyAnything && isInsideOut(*result.project.model)) {
        notes.append(insideOutNote());
    }
    notes += fontWarnings(result.project.artwork);
    notes += colourNotes(*result.project.model) + colourNotes(result.project.artwork);
    for (const ImmersionResult& immersion : result.immersions) {
        notes += immersion.solverNotes;
    }
    if (result.share && betterLast(*result.share) == std::size_t(0)) {
        const QLocale locale;
        const auto& [first, second] = result.share->joinStretch;
        notes.append(Text::tr("%1 is better dipped after %2: along the join its film is drawn out "
                              "%3 times and that of %2 %4 times, and the last film lies off so "
                              "many times as far on the body as on the water")
                         .arg(result.immersions[0].immersion.name,
                              result.immersions[1].immersion.name, locale.toString(first, 'f', 2),
                              locale.toString(second, 'f', 2)));
    }
    return notes;
}

} // namespace

JobResult runJob(const Project& project, const SolverRegistry& registry, const JobOptions& options,
                 const JobResult* previous, const Progress& progress) {
    if (!project.model) {
        throw Error(Text::tr("The project has no model, import one first"), project.name);
    }
    checkSpots(project);
    checkMemory(project);
    if (const QString note = memoryNote(project); !note.isEmpty()) {
        progress(0, note);
    }
    const Run run{project, registry, options, previous, progress.cancelToken, markedZones(project)};
    JobResult result;
    result.project = project;
    result.wantedSolver = options.solver.isEmpty() ? project.process.solver : options.solver;
    SolverChoice solver = chooseSolver(result.wantedSolver, registry, progress.cancelToken);
    result.chosenSolver = solver.solver.id;
    result.notes = std::exchange(solver.notes, {});

    std::vector<SheetInputs> inputs;
    for (std::size_t number = 0; number < project.immersions.size(); ++number) {
        inputs.push_back(sheetInputs(project, options, number, result.chosenSolver));
    }
    result.fieldInputs = fieldInputs(project);
    result.paintInputs = paintInputs(project);
    result.painted = paintedOf(run, result.paintInputs, progress.part(0, fieldDone / 2));
    result.field = fieldOf(run, inputs, progress.part(fieldDone / 2, fieldDone));

    const Progress job = options.makesCradles ? progress.part(0, cradlesBegin) : progress;
    const Progress dips = options.tellsTolerances ? job.part(0, tolerancesBegin) : job;
    const double allDone = options.variesLaws ? lawsBegin : 1;
    runImmersions(result, run, inputs, solver, dips.part(fieldDone, allDone));
    if (options.variesLaws) {
        varyLaws(result, run, solver, dips.part(allDone, 1));
    }
    if (options.tellsTolerances) {
        result.tolerances = std::make_shared<const JobTolerances>(
            jobTolerances(result, project.tolerance, registry, job.part(tolerancesBegin, 1)));
    }
    if (options.makesCradles) {
        result.cradles = jobCradles(result, progress.part(cradlesBegin, 1));
    }
    result.solver = result.immersions.back().solver;
    result.notes += notesOf(result);
    if (const QString note = colourNoteText(options.filmImage, Text::tr("The picture on the film"));
        !note.isEmpty()) {
        result.notes += note;
    }
    result.verdict = togetherVerdict(result, run.zones.get());
    return result;
}

} // namespace dipwright
