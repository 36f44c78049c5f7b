// Measures the film on users' models. Prints the table of docs/film-model.md, "Models", one line
// per dip.
//
//   models_bench [points=COLUMNSxROWS | automatic] [unrefined | work=MILLIONS] [found | foundonly]
//   [turned] [quarter] [unchecked] [times] [shift=MM] [set=PATH:VALUE,…] [keep=FOLDER]
//   [solver=ID] [against=ID] JOB.dipw …
//
// unrefined: keeps the first cells; no dip is repeated with smaller ones. work: film.work_million.
// turned: measures the first dip also turned by 35°, 20° and −15°, a pose that nobody chose.
// found: measures the job's own poses and the two poses that a pose search finds; foundonly: only
// those. keep: also writes them as projects into a folder.
// quarter: also moves of the sheet with a quarter of the cell, for sheets with the verdict "print".
// set: sets fields of the projects, as PATH:VALUE,PATH:VALUE.
// unchecked: leaves out half the step and half the cell.
// times: prints only how long each dip takes if it runs alone: the median of three, in seconds and
// relative to the first line.
// shift: prints only how far the sheet moves if the part is shifted so far along X on the water
// (mean, 95th percentile and largest, mm). What exceeds the shift itself is noise.
// against: also dips with another solver, and prints how many pixels of the sheets differ.
// The times of dips in the table are in seconds and relative to the first line; the coarser films
// of the verdict may run at the same time. A verdict is wrong if it says "print", but the full
// check moves the sheet by more than the reported numerical error.

#include "Bench.h"
#include "base/Error.h"
#include "pipeline/JobSearch.h"
#include "pipeline/Pipeline.h"
#include "pipeline/SheetNumericalError.h"
#include "project/ProjectStore.h"
#include "texture/ReverseTexture.h"

#include <QDir>
#include <QGuiApplication>

#include <algorithm>
#include <array>

using namespace dipwright;

namespace {

struct Options {
    QStringList jobs, settings;
    int columns = 0, rows = 0; // 0: the job's own numbers
    bool isAutomatic = false, isUnrefined = false, areFound = false, isTurned = false;
    bool areOnlyFound = false, withQuarter = false, isUnchecked = false, areTimed = false;
    double shift = 0;                    // mm
    QString solver, against, work, keep; // names (ids) of solvers
};

Options parsed(int argc, char** argv) {
    bench::Arguments arguments(argc, argv);
    Options options;
    options.areOnlyFound = arguments.take("foundonly");
    options.areFound = arguments.take("found") || options.areOnlyFound;
    options.withQuarter = arguments.take("quarter");
    options.isUnchecked = arguments.take("unchecked");
    options.areTimed = arguments.take("times");
    options.work = QString::fromStdString(arguments.value("work"));
    options.keep = QString::fromStdString(arguments.value("keep"));
    options.shift = std::atof(arguments.value("shift").c_str());
    options.isTurned = arguments.take("turned");
    options.isAutomatic = arguments.take("automatic");
    options.isUnrefined = arguments.take("unrefined");
    options.solver = QString::fromStdString(arguments.value("solver"));
    options.against = QString::fromStdString(arguments.value("against"));
    std::sscanf(arguments.value("points").c_str(), "%dx%d", &options.columns, &options.rows);
    if (const std::string set = arguments.value("set"); !set.empty()) {
        options.settings = QString::fromStdString(set).split(QLatin1Char(','));
    }
    for (const std::string& job : arguments.words()) {
        options.jobs.append(QString::fromStdString(job));
    }
    return options;
}

Project withOptions(Project job, const Options& options) {
    if (!options.solver.isEmpty()) {
        job.process.solver = options.solver;
    }
    if (options.isAutomatic) {
        job.film.resolution = FilmResolution::Automatic;
    }
    if (options.isUnrefined) {
        job.film.work = 0;
    }
    for (const QString& setting : options.settings) {
        setByPath(job, setting.section(QLatin1Char(':'), 0, 0),
                  setting.section(QLatin1Char(':'), 1));
    }
    if (!options.work.isEmpty()) {
        job.film.work = options.work.toDouble();
    }
    if (options.columns > 0) {
        job.film.resolution = FilmResolution::Points;
        job.film.columns = options.columns;
        job.film.rows = options.rows;
    }
    return job;
}

Project inFoundPoses(Project job, const Options& options, const SolverRegistry& registry) {
    SearchSettings search;
    search.immersions = 2;
    const solver::SolverModule& module = registry.module(job.process.solver);
    SearchResult result;
    const bench::Elapsed time = bench::elapsed([&] {
        result = searchPoses(searchSubject(job, job.process.solver), search, module, {}, {}, {});
    });
    std::printf("%s: search of %.1f s, %.1f s of all processors\n", qPrintable(job.name),
                time.seconds, time.processors);
    job.immersions = result.ranking.front().immersions;
    for (Immersion& immersion : job.immersions) {
        immersion.name = QStringLiteral("found");
    }
    if (!options.keep.isEmpty()) {
        saveProject(job, QDir(options.keep).filePath(job.name + QStringLiteral(".dipw")));
    }
    return job;
}

Project turned(Project job) {
    job.immersions.resize(1);
    job.immersions[0].name = QStringLiteral("turned");
    job.immersions[0].rotation = {Degrees(35), Degrees(20), Degrees(-15)};
    return job;
}

// Returns the share of printed pixels in which a channel differs by more than 8 of 255.
double differingPixels(const QImage& one, const QImage& other) {
    std::size_t printed = 0, differing = 0;
    for (int row = 0; row < one.height(); ++row) {
        const uchar *a = one.constScanLine(row), *b = other.constScanLine(row);
        for (int column = 0; column < one.width(); ++column, a += 4, b += 4) {
            int most = 0;
            for (int channel = 0; channel < 4; ++channel) {
                most = std::max(most, std::abs(int(a[channel]) - int(b[channel])));
            }
            printed += a[3] > 0 || b[3] > 0;
            differing += most > 8;
        }
    }
    return printed > 0 ? double(differing) / double(printed) : 0;
}

bool isRight(const ImmersionResult& said, const DipNumericalError& check) {
    const double offBy = said.numericalError->offBy.percentile95;
    return said.verdict.advice != Advice::Print ||
           (check.halfStep.distance.percentile95 <= offBy &&
            check.halfSpacing.distance.percentile95 <= offBy);
}

double firstSeconds = 0; // dip time of the first line, s

void print(const Project& job, const ImmersionResult& said, const DipNumericalError& check,
           const ImmersionResult* other) {
    const DippedFilm& film = said.laid->film();
    firstSeconds = firstSeconds > 0 ? firstSeconds : film.wallSeconds;
    std::printf(
        "| %s, %s | %d × %d, %.2f | %lld | %lld | %.1f | %.2f s, %.1f | %.1f %% | %.3f, %.3f | "
        "%.3f, %.3f | %s, %.3f | %s |",
        qPrintable(job.name), qPrintable(said.immersion.name), film.grid.columns, film.grid.rows,
        said.refinement, static_cast<long long>(film.steps),
        static_cast<long long>(film.equilibrium.stepsWithout),
        double(film.equilibrium.linearIterations) / double(std::max<std::int64_t>(film.steps, 1)),
        film.wallSeconds, film.wallSeconds / firstSeconds,
        100 * said.coverage->marked.any / std::max(said.coverage->paintedArea, 1e-9),
        check.halfStep.distance.percentile95, check.unmarkedHalfStep.distance.percentile95,
        check.halfSpacing.distance.percentile95, check.unmarkedHalfSpacing.distance.percentile95,
        qPrintable(adviceKey(said.verdict.advice)), said.numericalError->offBy.percentile95,
        isRight(said, check) ? "right" : "WRONG");
    if (other) {
        const SheetChange change =
            sheetChange(sheetMoves(*said.laid, *other->laid, comparedPlaces(said.laid->body())));
        std::printf(" %lld, %.2f %%, %.3f |", static_cast<long long>(other->laid->film().steps),
                    100 * differingPixels(said.texture->image, other->texture->image),
                    change.distance.percentile95);
    }
    std::printf("\n");
    for (const QString& note : said.solverNotes + check.notes) {
        std::printf("%s\n", qPrintable(note));
    }
    std::fflush(stdout);
}

// Prints the verdict on one dip, and why it is not "print".
void printVerdict(const Project& job, const ImmersionResult& said) {
    const DippedFilm& film = said.laid->film();
    std::printf("%s, %s: %s after refinement by %.2f, off by %.3f mm, %.1f million, %.2f s",
                qPrintable(job.name), qPrintable(said.immersion.name),
                qPrintable(adviceKey(said.verdict.advice)), said.refinement,
                said.numericalError->offBy.percentile95,
                double(film.grid.pointCount()) * double(film.steps) / 1e6, film.wallSeconds);
    for (const VerdictReason& reason : said.verdict.reasons) {
        if (reason.advice > Advice::Print) {
            std::printf("; %s: %s", qPrintable(adviceKey(reason.advice)),
                        qPrintable(reasonText(reason, millimetres)));
        }
    }
    std::printf("\n");
}

// Returns the film of one dip on the body, without a verdict.
std::shared_ptr<const LaidFilm> laidAlone(Project job, const Immersion& immersion,
                                          const SolverRegistry& registry) {
    job.immersions = {immersion};
    JobOptions options;
    options.refines = options.estimatesNumericalError = false;
    options.draftPictures = 0.1;
    return runJob(job, registry, options, nullptr, {}).immersions.front().laid;
}

// Returns how far the sheet moves with a quarter of the cell: the 95th percentile, mm.
double quarterMove(Project job, const ImmersionResult& said, const SolverRegistry& registry) {
    job.film.refinement = 4 * said.refinement;
    return sheetChange(sheetMoves(*said.laid, *laidAlone(job, said.immersion, registry),
                                  comparedPlaces(said.laid->body())))
        .distance.percentile95;
}

void printShifted(const Project& job, double shift, const SolverRegistry& registry) {
    for (const Immersion& immersion : job.immersions) {
        Immersion shifted = immersion;
        shifted.offset[0] = shifted.offset[0] + Millimetres(shift);
        const auto own = laidAlone(job, immersion, registry);
        const Distribution moved = sheetChange(sheetMoves(*own, *laidAlone(job, shifted, registry),
                                                          comparedPlaces(own->body())))
                                       .distance;
        std::printf("%s, %s: %.4f, %.4f, %.4f mm\n", qPrintable(job.name),
                    qPrintable(immersion.name), moved.mean, moved.percentile95, moved.maximum);
        std::fflush(stdout);
    }
}

void printTimes(const Project& job, const SolverRegistry& registry) {
    for (const Immersion& immersion : job.immersions) {
        std::array<double, 3> seconds{};
        for (double& each : seconds) {
            each = laidAlone(job, immersion, registry)->film().wallSeconds;
        }
        std::nth_element(seconds.begin(), seconds.begin() + 1, seconds.end());
        firstSeconds = firstSeconds > 0 ? firstSeconds : seconds[1];
        std::printf("%s, %s: %.3f s, %.2f\n", qPrintable(job.name), qPrintable(immersion.name),
                    seconds[1], seconds[1] / firstSeconds);
        std::fflush(stdout);
    }
}

void judge(const Project& job, const Options& options, const SolverRegistry& registry) {
    if (options.areTimed) {
        printTimes(job, registry);
        return;
    }
    if (options.shift != 0) {
        printShifted(job, options.shift, registry);
        return;
    }
    const JobResult said = runJob(job, registry, {}, nullptr, {});
    for (const ImmersionResult& dip : said.immersions) {
        printVerdict(job, dip);
        if (options.withQuarter && dip.verdict.advice == Advice::Print) {
            std::printf("%s, %s: a quarter of the cell moves it by %.3f mm\n", qPrintable(job.name),
                        qPrintable(dip.immersion.name), quarterMove(job, dip, registry));
        }
    }
    std::fflush(stdout);
    if (options.isUnchecked) {
        return;
    }
    std::optional<JobResult> other;
    if (!options.against.isEmpty()) {
        JobOptions otherwise;
        otherwise.solver = options.against;
        other = runJob(job, registry, otherwise, nullptr, {});
    }
    const std::vector<DipNumericalError> check = sheetNumericalError(job, registry, {}, &said);
    for (std::size_t number = 0; number < check.size(); ++number) {
        print(job, said.immersions[number], check[number],
              other ? &other->immersions[number] : nullptr);
    }
}

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen"); // maps contain text
    const QGuiApplication application(argc, argv);
    const Options options = parsed(argc, argv);
    const SolverRegistry registry;
    std::printf("| model, pose | points, refinement | steps | without | iterations | dip | marked "
                "| half the "
                "step: all, unmarked | half the cell | verdict, off by | |%s\n",
                options.against.isEmpty() ? "" : " other solver: steps, pixels, p95 in mm |");
    for (const QString& file : options.jobs) {
        try {
            const Project job = withOptions(loadProject(file), options);
            if (!options.areOnlyFound) {
                judge(job, options, registry);
            }
            if (options.isTurned) {
                judge(turned(job), options, registry);
            }
            if (options.areFound) {
                judge(inFoundPoses(job, options, registry), options, registry);
            }
        } catch (const Error& error) {
            std::printf("%s: %s\n", qPrintable(file), qPrintable(error.sentence()));
        }
    }
    return 0;
}
