#include "cli/bench/Measurements.h"

#include "base/Bytes.h"
#include "base/Error.h"
#include "geometry/Shapes.h"
#include "pipeline/JobSheet.h"
#include "pipeline/Pipeline.h"
#include "pipeline/WriteResults.h"
#include "sheet/SheetFiles.h"

#include <QTemporaryDir>

namespace dipwright::cli {
namespace {

// A sphere of 50,000 triangles, near enough.
constexpr int fieldSphereRings = 159;
constexpr int fieldSphereSegments = 158;

// What computing the sheet again takes, once the dip is there.
class DippedTurtle {
public:
    DippedTurtle(const BenchSolver& solver, const Progress& progress)
        : project_(BenchBodies::turtle()) {
        project_.immersions.resize(1);
        JobOptions options;
        options.solver = solver.id;
        job_ = runJob(project_, solver.registry, options, nullptr, progress);
    }

    ReverseTexture texture(double dpi) const {
        const ImmersionResult& dipped = job_.immersions.front();
        const QSize pixels =
            sheetPixels(project_.film.width, project_.film.height, DotsPerInch(dpi));
        return reverseTexture(*dipped.laid, {pixels, project_.sheet.bleed.value(), project_.ink},
                              {});
    }

    Sheet sheet(double dpi) const {
        Project project = project_;
        project.sheet.resolution = DotsPerInch(dpi);
        return jobSheet(project, project.immersions.front(), texture(dpi).image);
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

// For as long as it lives, distance fields are kept in an empty folder, and so built anew.
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
        const Progress quiet{nullptr, progress.cancelSwitch};
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
    const DippedTurtle turtle(solver, progress.part(0, 0.5));
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

std::vector<TimedRow> measureRun(const BenchSolver& solver, const Progress& progress) {
    const Project turtle = BenchBodies::turtle();
    JobOptions options;
    options.solver = solver.id;
    double done = 0;
    const Statistics seconds = timed(solver.runs, [&] {
        const EmptyFieldCache cache;
        const QTemporaryDir folder;
        if (!folder.isValid()) {
            throw Error(QStringLiteral("There is no room for temporary files; free some"),
                        folder.path());
        }
        const Progress part = progress.part(done, done + 1.0 / solver.runs);
        runAndWrite(turtle, solver.registry, options, folder.filePath(QStringLiteral("results")),
                    part);
        done += 1.0 / solver.runs;
    });
    const int immersions = int(turtle.immersions.size());
    return {{QStringLiteral("the turtle's %1 immersions, from project to files").arg(immersions),
             {{"project", turtle.name}, {"immersions", immersions}},
             seconds}};
}

} // namespace dipwright::cli
