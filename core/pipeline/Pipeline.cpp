#include "pipeline/Pipeline.h"

#include "base/Error.h"
#include "dip/Coverage.h"
#include "pipeline/JobSheet.h"
#include "pipeline/SolverChoice.h"
#include "texture/Chessboard.h"

#include <QCoreApplication>
#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

// Shares of the time of a job, roughly as measured on a film of 120 × 170 points.
constexpr double fieldDone = 0.1;
constexpr double immersionsDone = 0.85;
constexpr double dipDone = 0.7; // of an immersion
constexpr double contactDone = 0.8;
constexpr double textureDone = 0.9;

// Which solver computes is told by the solver itself, and a change from "auto" to its name is none.
ProcessSettings dipInputs(ProcessSettings process) {
    process.solver.clear();
    return process;
}

class Job {
public:
    Job(const Project& project, const SolverRegistry& registry, const JobOptions& options,
        const JobResult* previous)
        : project_(project), registry_(registry), options_(options), previous_(previous) {}

    JobResult run(const Progress& progress) {
        if (!project_.model) {
            throw Error(Text::tr("The project has no model, import one first"), project_.name);
        }
        result_.project = project_;
        result_.options = options_;
        result_.options.observer = nullptr;
        if (const QString expiry = expiryWarning(project_.profiles.film); !expiry.isEmpty()) {
            result_.notes.append(expiry);
        }
        chooseSolver(options_.solver.isEmpty() ? project_.process.solver : options_.solver);
        if (sameModel() && previous_->project.fieldResolution == project_.fieldResolution) {
            result_.field = previous_->field;
        }
        const double share = (immersionsDone - fieldDone) / double(project_.immersions.size());
        for (std::size_t index = 0; index < project_.immersions.size(); ++index) {
            const double begin = fieldDone + share * double(index);
            runImmersion(index, progress.part(0, fieldDone), progress.part(begin, begin + share));
        }
        result_.coverageTotal = coverageTotal(progress);
        makeProof(progress.part(immersionsDone, 1));
        return std::move(result_);
    }

private:
    bool sameModel() const { return previous_ && previous_->project.model == project_.model; }

    // The earlier result of this immersion's place, if it is of the same model.
    const ImmersionResult* earlier(std::size_t index) const {
        return sameModel() && index < previous_->immersions.size() ? &previous_->immersions[index]
                                                                   : nullptr;
    }

    // Where the GPU is not there that a solver needs, the CPU takes over.
    void chooseSolver(const QString& id) {
        try {
            registry_.module(id); // loads it, or throws the reason why it cannot run
            result_.solver = registry_.info(id);
        } catch (const Error& error) {
            const std::optional<SolverInfo> wanted = registry_.found(id);
            if (!wanted) {
                throw;
            }
            result_.solver = *wanted;
            if (!fallBackFrom(error)) {
                throw;
            }
        }
    }

    void runImmersion(std::size_t index, const Progress& fieldProgress, const Progress& progress) {
        const ImmersionResult* old = earlier(index);
        ImmersionResult now;
        now.immersion = project_.immersions[index];
        if (old && old->immersion.rotation == now.immersion.rotation) {
            now.body = old->body;
        } else {
            now.body = std::make_shared<PosedBody>(posedBody(*project_.model, now.immersion));
        }
        if (old && sameDip(*old, now)) {
            now.laid = old->laid;
            now.coverage = old->coverage;
            now.registration = old->registration;
        } else {
            locate(now, dip(index, now, fieldProgress, progress.part(0, dipDone)),
                   progress.part(dipDone, contactDone));
        }
        if (old && sameTexture(*old, now)) {
            now.texture = old->texture;
        } else {
            now.texture = std::make_shared<ReverseTexture>(
                texture(now, progress.part(contactDone, textureDone)));
        }
        now.sheet = jobSheet(project_, now.immersion, now.texture->image);
        if (edgeIsOnBody(*now.laid)) {
            result_.notes.append(Text::tr("%1: the film's edge ends up on the body; take a larger "
                                          "film, or place the body further from the edge")
                                     .arg(now.immersion.name));
        }
        result_.immersions.push_back(std::move(now));
    }

    bool sameDip(const ImmersionResult& old, const ImmersionResult& now) const {
        return old.body == now.body && old.immersion.offset == now.immersion.offset &&
               previous_->project.film == project_.film &&
               previous_->project.fieldResolution == project_.fieldResolution &&
               dipInputs(previous_->project.process) == dipInputs(project_.process) &&
               previous_->solver.id == result_.solver.id;
    }

    DippedFilm dip(std::size_t index, const ImmersionResult& now, const Progress& fieldProgress,
                   const Progress& progress) {
        if (!result_.field) {
            result_.field =
                cachedDistanceField(project_.model->mesh, project_.fieldResolution, fieldProgress);
        }
        FilmObserver observer;
        if (options_.observer) {
            observer = [this, index](const FilmFrame& frame) { options_.observer(index, frame); };
        }
        const auto simulate = [&] {
            return simulateDip(*now.body, *result_.field, now.immersion, project_.film,
                               project_.process, registry_.module(result_.solver.id), progress,
                               observer);
        };
        try {
            return simulate();
        } catch (const Error& error) {
            if (!fallBackFrom(error)) {
                throw;
            }
            return simulate();
        }
    }

    // Puts the best CPU solver in the place of a GPU solver that failed; false if there is none, or
    // where it was not a GPU solver.
    bool fallBackFrom(const Error& error) {
        const QString failed = result_.solver.name;
        if (result_.solver.deviceKind != QLatin1String("gpu")) {
            return false;
        }
        const std::optional<SolverInfo> best = bestCpuSolver(registry_);
        if (!best) {
            return false;
        }
        chooseSolver(best->id);
        result_.notes.append(
            Text::tr("%1 failed and %2 took over: %3").arg(failed, best->name, error.sentence()));
        return true;
    }

    void locate(ImmersionResult& now, DippedFilm film, const Progress& progress) const {
        progress(0, Text::tr("Finding the film on the body"));
        now.laid = layFilm(now.body, std::move(film), project_.process);
        progress(0.4, Text::tr("Measuring the coverage"));
        now.coverage = std::make_shared<Coverage>(coverage(*now.laid));
        progress(0.6, Text::tr("Measuring the registration"));
        now.registration = registrationError(*now.laid, *now.laid);
    }

    double coverageTotal(const Progress& progress) const {
        if (result_.immersions.size() == 1) {
            return result_.immersions.front().coverage->share;
        }
        std::vector<std::shared_ptr<const LaidFilm>> films;
        for (const ImmersionResult& immersion : result_.immersions) {
            films.push_back(immersion.laid);
        }
        return coverageTogether(films, progress);
    }

    bool sameTexture(const ImmersionResult& old, const ImmersionResult& now) const {
        const Project& before = previous_->project;
        return old.laid == now.laid && before.sheet.resolution == project_.sheet.resolution &&
               before.sheet.bleed == project_.sheet.bleed && before.ink == project_.ink &&
               previous_->options.chessboard == options_.chessboard &&
               previous_->options.filmImage == options_.filmImage;
    }

    ReverseTexture texture(const ImmersionResult& now, const Progress& progress) const {
        const QSize pixels =
            sheetPixels(project_.film.width, project_.film.height, project_.sheet.resolution);
        if (!options_.chessboard && options_.filmImage.isNull()) {
            return reverseTexture(*now.laid, {pixels, project_.sheet.bleed.value(), project_.ink},
                                  progress);
        }
        ReverseTexture picture;
        if (options_.chessboard) {
            solver::FilmGrid printed =
                now.laid->film().grid; // the squares are measured on the sheet
            printed.width = project_.film.width.value();
            printed.depth = project_.film.height.value();
            picture.image = chessboard(printed, chessSquare, pixels);
        } else {
            picture.image = options_.filmImage.convertToFormat(QImage::Format_RGBA8888)
                                .scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        }
        return picture;
    }

    bool sameProof() const {
        if (!sameModel() || previous_->immersions.size() != result_.immersions.size()) {
            return false;
        }
        const auto same = [](const ImmersionResult& a, const ImmersionResult& b) {
            return a.laid == b.laid && a.texture == b.texture;
        };
        return std::equal(result_.immersions.begin(), result_.immersions.end(),
                          previous_->immersions.begin(), same);
    }

    void makeProof(const Progress& progress) {
        if (sameProof()) {
            result_.proof = previous_->proof;
            return;
        }
        std::vector<WornFilm> films;
        for (const ImmersionResult& now : result_.immersions) {
            films.push_back({now.laid, now.texture->image});
        }
        ProofOptions options;
        const bool reversed = !options_.chessboard && options_.filmImage.isNull();
        options.compensatedInk = reversed && project_.ink.compensate;
        result_.proof = proofPicture(*project_.model, films, options, progress);
    }

    const Project& project_;
    const SolverRegistry& registry_;
    const JobOptions& options_;
    const JobResult* previous_;
    JobResult result_;
};

} // namespace

JobResult runJob(const Project& project, const SolverRegistry& registry, const JobOptions& options,
                 const JobResult* previous, const Progress& progress) {
    return Job(project, registry, options, previous).run(progress);
}

} // namespace dipwright
