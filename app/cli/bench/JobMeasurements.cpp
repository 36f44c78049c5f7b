#include "cli/bench/Measurements.h"
#include "model/TexturedMesh.h"

#include "base/Bytes.h"
#include "base/Error.h"
#include "base/Png.h"
#include "geometry/Shapes.h"
#include "pipeline/JobSheet.h"
#include "pipeline/Pipeline.h"
#include "pipeline/WriteResults.h"
#include "results/Results.h"
#include "sheet/prepress/SheetFiles.h"

#include <QTemporaryDir>

namespace dipwright::cli {
namespace {

// Makes a sphere of about 50,000 triangles.
constexpr int fieldSphereRings = 159;
constexpr int fieldSphereSegments = 158;

// A finished dip of the turtle, from which its sheet can be computed repeatedly.
class DippedTurtle {
public:
    DippedTurtle(const BenchSolver& solver, std::size_t immersions, const Progress& progress)
        : project_(BenchBodies::turtle()) {
        project_.immersions.resize(immersions);
        JobOptions options;
        options.solver = solver.id;
        job_ = runJob(project_, solver.registry, options, nullptr, progress);
    }

    const Project& project() const { return project_; }
    const JobResult& job() const { return job_; }
    const ImmersionResult& immersion() const { return job_.immersions.front(); }

    ReverseTexture texture(double dpi) const {
        const QSize pixels =
            sheetPixels(project_.film.width, project_.film.height, DotsPerInch(dpi));
        return reverseTexture(*immersion().laid, *immersion().appearance,
                              {pixels, project_.sheet.bleed.value(), project_.ink}, {});
    }

    Sheet sheet(double dpi) const {
        Project project = project_;
        project.sheet.resolution = DotsPerInch(dpi);
        return jobSheet(project, project.immersions.front(), {texture(dpi).image});
    }

private:
    Project project_;
    JobResult job_;
};

TimedRow sheetRow(const QString& what, int dpi, const Statistics& seconds) {
    return {QStringLiteral("%1, A4, %2 dpi").arg(what).arg(dpi),
            {{"what", what}, {"dpi", dpi}},
            seconds};
}

// While this object exists, distance fields are cached in an empty folder and therefore built
// again.
class EmptyFieldCache {
public:
    EmptyFieldCache() : before_(qgetenv(variable)) {
        qputenv(variable, folder_.path().toLocal8Bit());
    }
    ~EmptyFieldCache() { before_.isNull() ? qunsetenv(variable) : qputenv(variable, before_); }
    EmptyFieldCache(const EmptyFieldCache&) = delete;
    EmptyFieldCache& operator=(const EmptyFieldCache&) = delete;

private:
    static constexpr const char* variable = "DIPWRIGHT_CACHE";
    QTemporaryDir folder_;
    QByteArray before_;
};

} // namespace

std::vector<TimedRow> measureFields(int runs, int finest, const Progress& progress) {
    constexpr int coarsest = 64;
    const TriangleMesh sphere = sphereMesh(35, fieldSphereRings, fieldSphereSegments);
    const auto triangles = qint64(sphere.triangles.size());
    std::vector<TimedRow> results;
    for (int samples = coarsest; samples <= finest; samples *= 2) {
        progress(double(samples - coarsest) / finest, QStringLiteral("Building fields"));
        const Progress quiet{nullptr, progress.cancelToken};
        const Statistics seconds = timed(runs, [&] { buildDistanceField(sphere, samples, quiet); });
        results.push_back(
            {QStringLiteral("%1 samples, %2 triangles").arg(cubed(samples)).arg(triangles),
             {{"samples", samples}, {"triangles", triangles}},
             seconds});
    }
    return results;
}

std::vector<TimedRow> measureSheets(const BenchSolver& solver, const std::vector<int>& resolutions,
                                    const Progress& progress) {
    const DippedTurtle turtle(solver, 1, progress.part(0, 0.5));
    std::vector<TimedRow> results;
    for (const int dpi : resolutions) {
        progress(0.5 + 0.5 * double(results.size()) / (3 * double(resolutions.size())),
                 QStringLiteral("Making sheets"));
        results.push_back(sheetRow(QStringLiteral("reverse texture"), dpi,
                                   timed(solver.runs, [&] { turtle.texture(dpi); })));
        const Sheet sheet = turtle.sheet(dpi);
        const auto timedWrite = [&](const auto& write) {
            return timed(solver.runs, [&] { bytesOf(write); });
        };
        results.push_back(
            sheetRow(QStringLiteral("sheet as PNG"), dpi,
                     timedWrite([&](QIODevice& device) { writeSheetPng(sheet, device); })));
        results.push_back(
            sheetRow(QStringLiteral("sheet as PDF"), dpi,
                     timedWrite([&](QIODevice& device) { writeSheetPdf(sheet, device); })));
    }
    return results;
}

std::vector<TimedRow> measureParts(const BenchSolver& solver, const Progress& progress) {
    const DippedTurtle turtle(solver, 2, progress.part(0, 0.5));
    const Project& project = turtle.project();
    const TexturedMesh& model = *project.model;
    const ImmersionResult& dipped = turtle.immersion();
    const LaidFilm& laid = *dipped.laid;
    std::vector<std::shared_ptr<const LaidFilm>> films;
    std::vector<FilmAppearance> appearances;
    for (const ImmersionResult& immersion : turtle.job().immersions) {
        films.push_back(immersion.laid);
        appearances.push_back({immersion.laid, immersion.texture->image});
    }
    const auto stage = proofStage(model, fineBody(model.mesh));
    constexpr int mapEdge = 1600;
    const QString nowhere;
    const std::vector<std::pair<QString, std::function<void()>>> parts{
        {QStringLiteral("finding the solvers"), [] { SolverRegistry().solvers(); }},
        {QStringLiteral("reading the project"), [] { BenchBodies::turtle(); }},
        {QStringLiteral("distance field"),
         [&] { buildDistanceField(model.mesh, project.fieldResolution, {}); }},
        {QStringLiteral("body in its pose"),
         [&] { posedBody(model.mesh, dipped.immersion, project.process); }},
        {QStringLiteral("film on the body"),
         [&] { layFilm(dipped.body, laid.film(), project.process); }},
        {QStringLiteral("coverage"), [&] { coverage(laid); }},
        {QStringLiteral("coverage by both immersions"), [&] { coverageTogether(films, {}); }},
        {QStringLiteral("reading back"), [&] { readBackError(laid, laid, model); }},
        {QStringLiteral("reverse texture"),
         [&] { turtle.texture(project.sheet.resolution.value()); }},
        {QStringLiteral("sheet and its job number"),
         [&] { jobSheet(project, dipped.immersion, {dipped.texture->image}); }},
        {QStringLiteral("sheet as PNG"),
         [&] { bytesOf([&](QIODevice& device) { writeSheetPng(dipped.sheet, device); }); }},
        {QStringLiteral("sheet as PDF"),
         [&] { bytesOf([&](QIODevice& device) { writeSheetPdf(dipped.sheet, device); }); }},
        {QStringLiteral("map of the stretch as PNG"),
         [&] { pngBytes(stretchMap(laid, mapEdge), nowhere); }},
        {QStringLiteral("film as VTK file"), [&] { filmVtp(laid, model); }},
        {QStringLiteral("body as VTK file"),
         [&] { bodyVtp(*dipped.body, model, *dipped.coverage); }},
        {QStringLiteral("stage of the proof"), [&] { proofStage(model, fineBody(model.mesh)); }},
        {QStringLiteral("proof"), [&] { proofPicture(*stage, appearances, {}, {}); }},
        {QStringLiteral("proof as PNG"), [&] { pngBytes(turtle.job().proof, nowhere); }}};
    std::vector<TimedRow> results;
    for (const auto& [name, work] : parts) {
        progress(0.5 + 0.5 * double(results.size()) / double(parts.size()), name);
        results.push_back({name, {{"part", name}}, timed(solver.runs, work)});
    }
    return results;
}

std::vector<TimedRow> measureRun(const BenchSolver& solver, const Progress& progress) {
    const Project turtle = BenchBodies::turtle();
    JobOptions options;
    options.solver = solver.id;
    double done = 0;
    const Statistics seconds = timed(solver.runs, [&] {
        const EmptyFieldCache cache;
        const QTemporaryDir folder;
        if (!folder.isValid()) {
            throw Error(QStringLiteral("There is no space for temporary files; free some"),
                        folder.path());
        }
        const Progress part = progress.part(done, done + 1.0 / solver.runs);
        runAndWrite(turtle, solver.registry, options, nullptr,
                    folder.filePath(QStringLiteral("results")), part);
        done += 1.0 / solver.runs;
    });
    const int immersions = int(turtle.immersions.size());
    return {{QStringLiteral("the turtle's %1 dips, from project to files").arg(immersions),
             {{"project", turtle.name}, {"immersions", immersions}},
             seconds}};
}

} // namespace dipwright::cli
